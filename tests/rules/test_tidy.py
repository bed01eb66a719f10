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


def compiled_files(root, build):
    """Production files that the build compiles."""
    entries = json.loads(read(build / "compile_commands.json"))
    compiled = {pathlib.Path(entry["file"]).resolve() for entry in entries}
    return [path for room in ROOMS for path in sources(root, room, {".cc"}) if path in compiled]


def without_precompiled(build, target):
    """Writes into the folder `target` the build's commands without GCC's precompiled headers."""
    entries = json.loads(read(build / "compile_commands.json"))
    for entry in entries:
        entry["command"] = re.sub(r"-Winvalid-pch|-include \S*/cmake_pch\.hxx", "", entry["command"])
    (target / "compile_commands.json").write_text(json.dumps(entries), encoding="utf-8")


def findings(build, path):
    """What clang-tidy says of one file and of the tree's headers in it."""
    less = [] if ALL_FILES else [f"--checks=-{SLOW_CHECK}"]
    result = subprocess.run(["clang-tidy", "--quiet", "--extra-arg=-w", *less, "-p", str(build), str(path)],
                            capture_output=True, text=True, check=False)
    found = re.findall(r"^\S+:\d+:\d+: (?:warning|error): .*$", result.stdout, re.MULTILINE)
    return found or ([result.stderr] if result.returncode else [])


class Rules(TestCase):
    def test_nothing_is_found(self):
        files = [path for path in compiled_files(ROOT, BUILD) if ALL_FILES or not knows_dealii(ROOT, path)]
        self.assertGreater(len(files), 30)
        with tempfile.TemporaryDirectory() as folder, \
                concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            commands = pathlib.Path(folder)
            without_precompiled(BUILD, commands)
            found = sorted(set(sum(pool.map(lambda path: findings(commands, path), files), [])))
        self.assert_none(found)


class Checker(InSmallTree):
    """The check sees what it is for."""

    def test_finding_is_seen(self):
        (self.root / ".clang-tidy").write_text(read(ROOT / ".clang-tidy"), encoding="utf-8")
        path = self.write("fitting/bad.cc", "double half(int n)\n{\n  return 0.5 + n / 2;\n}\n")
        self.write("compile_commands.json", json.dumps(
            [{"directory": str(self.root), "file": str(path), "command": f"g++ -std=c++17 -c {path}"}]))
        self.assertEqual([name_of(self.root, path) for path in compiled_files(self.root, self.root)],
                         ["fitting/bad.cc"])
        self.assertEqual(len(findings(self.root, path)), 1)

    def test_precompiled_headers_are_left_out(self):
        (self.root / "bare").mkdir()
        self.write("compile_commands.json", json.dumps(
            [{"directory": "/b", "file": "a.cc",
              "command": "g++ -Winvalid-pch -include /b/CMakeFiles/x.dir/cmake_pch.hxx -Ifolder -c a.cc"}]))
        without_precompiled(self.root, self.root / "bare")
        entry, = json.loads(read(self.root / "bare" / "compile_commands.json"))
        self.assertEqual(entry["command"].split(), ["g++", "-Ifolder", "-c", "a.cc"])

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
