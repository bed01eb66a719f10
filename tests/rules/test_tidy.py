"""clang-tidy finds nothing, by the checks of .clang-tidy.

  test_tidy.py BUILD_DIRECTORY          the production files that include nothing of deal.II
  test_tidy.py BUILD_DIRECTORY --all    all production files, and the check that takes a third of the time

BUILD_DIRECTORY holds compile_commands.json. README.md in tests/ says what each takes.
"""

import concurrent.futures
import functools
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

from tree import ROOMS, ROOT, InSmallTree, TestCase, name_of, read, sources

BUILD = None
ALL_FILES = False
SLOW_CHECK = "performance-unnecessary-value-param"

INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]', re.MULTILINE)


@functools.lru_cache(maxsize=None)
def knows_dealii(root, path):
    """Whether the file, or a file of the tree that it includes, includes a header of deal.II."""
    return any(name.startswith("deal.II/") or ((root / name).is_file() and knows_dealii(root, root / name))
               for name in INCLUDE.findall(read(path)))


def compiled_units(root, build):
    """Pairs of the entry of the build's list of commands and the production files that it compiles: one,
    or those that a unity file includes."""
    production = {path.resolve() for room in ROOMS for path in sources(root, room, {".cc"})}
    units = []
    for entry in json.loads(read(build / "compile_commands.json")):
        file = pathlib.Path(entry["file"])
        names = INCLUDE.findall(read(file)) if "/Unity/" in str(file) else [file]
        units.append((entry, [path for path in map(lambda name: pathlib.Path(name).resolve(), names)
                              if path in production]))
    return [(entry, files) for entry, files in units if files]


def write_units(units, folder):
    """Writes into `folder` a file for each unit that includes what the unit compiles, and their list of
    commands."""
    commands, written = [], []
    for number, (entry, files) in enumerate(units):
        unit = folder / f"unit_{number}.cc"
        unit.write_text("".join(f'#include "{path}"\n' for path in files), encoding="utf-8")
        written.append(unit)
        commands.append({**entry, "file": str(unit),
                         "command": entry["command"].replace(entry["file"], str(unit))})
    (folder / "compile_commands.json").write_text(json.dumps(commands), encoding="utf-8")
    return written


def findings(folder, unit):
    """What clang-tidy says of the tree's files in a unit."""
    less = ["-bugprone-suspicious-include"] + ([] if ALL_FILES else [f"-{SLOW_CHECK}"])
    result = subprocess.run(["clang-tidy", "--quiet", "--extra-arg=-w", "--checks=" + ",".join(less),
                             "-p", str(folder), str(unit)], capture_output=True, text=True, check=False)
    found = re.findall(r"^\S+:\d+:\d+: (?:warning|error): .*$", result.stdout, re.MULTILINE)
    return found or ([result.stderr] if result.returncode else [])


class Rules(TestCase):
    def test_nothing_is_found(self):
        units = [(entry, [path for path in files if ALL_FILES or not knows_dealii(ROOT, path)])
                 for entry, files in compiled_units(ROOT, BUILD)]
        units = [unit for unit in units if unit[1]]
        self.assertGreater(sum(len(files) for _, files in units), 60)
        with tempfile.TemporaryDirectory() as folder, \
                concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            commands = pathlib.Path(folder)
            found = sorted(set(sum(pool.map(lambda unit: findings(commands, unit),
                                            write_units(units, commands)), [])))
        self.assert_none(found)


class Checker(InSmallTree):
    """The check sees what it is for."""

    def test_finding_is_seen_alone_and_in_a_unity_file(self):
        (self.root / ".clang-tidy").write_text(read(ROOT / ".clang-tidy"), encoding="utf-8")
        path = self.write("fitting/bad.cc", "double half(int n)\n{\n  return 0.5 + n / 2;\n}\n")
        unity = self.write("build/Unity/unity_0_cxx.cxx", f'#include "{path}"\n')
        for compiled in (path, unity):
            with self.subTest(compiled=compiled):
                self.write("compile_commands.json", json.dumps(
                    [{"directory": str(self.root), "file": str(compiled),
                      "command": f"g++ -std=c++17 -c {compiled}"}]))
                units = compiled_units(self.root, self.root)
                self.assertEqual([files for _, files in units], [[path.resolve()]])
                unit, = write_units(units, self.root)
                self.assertEqual(len(findings(self.root, unit)), 1)

    def test_dealii_is_seen_through_another_header(self):
        self.write("meshing/mesh.h", "#include <deal.II/grid/tria.h>\n")
        through = self.write("solver/path/file.cc", '#include "meshing/mesh.h"\n')
        self.assertTrue(knows_dealii(self.root, through))
        self.assertFalse(knows_dealii(self.root, self.root / "solver/path/good.h"))


if __name__ == "__main__":
    if "--all" in sys.argv:
        sys.argv.remove("--all")
        ALL_FILES = True
    BUILD = pathlib.Path(sys.argv.pop(1)).resolve()
    unittest.main(verbosity=2)
