"""Rules of the house that a script can check: who may include whom, and how long a file may be."""

import pathlib
import re
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]

# A room includes itself and the rooms to its left.
ROOMS = ["meshing", "solver", "fitting", "database", "runs"]

# A curve is all that leaves the solver.
FORBIDDEN = {"fitting": ["deal.II/", "gmsh"], "database": ["deal.II/", "gmsh"], "meshing": ["gsl/"]}

# Written by the build.
GENERATED = {"git_revision.h"}

MAX_LINES = 500

# One file on purpose: a discrete-element code takes it away alone.
LONGER = {"database/contact_law.h": 950}

INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]', re.MULTILINE)


def sources(root, folder, suffixes):
    return [path for path in sorted((root / folder).rglob("*")) if path.suffix in suffixes]


def include_violations(root):
    found = []
    for position, room in enumerate(ROOMS):
        for path in sources(root, room, {".h", ".cc"}):
            for bracket, name in INCLUDE.findall(path.read_text(encoding="utf-8")):
                complaint = None
                if bracket == '"' and name not in GENERATED:
                    if not (root / name).is_file():
                        complaint = "is no path from the repository's root"
                    elif name.split("/")[0] not in ROOMS[:position + 1]:
                        complaint = f"does not belong left of {room}"
                elif any(name.startswith(prefix) for prefix in FORBIDDEN.get(room, [])):
                    complaint = f"is not for {room} to know"
                if complaint:
                    found.append(f"{path.relative_to(root)}: {name} {complaint}")
    return found


def long_files(root):
    found = []
    for folder in ROOMS + ["tests"]:
        for path in sources(root, folder, {".h", ".cc", ".py"}):
            lines = len(path.read_text(encoding="utf-8").splitlines())
            name = path.relative_to(root).as_posix()
            if lines > LONGER.get(name, MAX_LINES):
                found.append(f"{name}: {lines} lines")
    return found


class Rules(unittest.TestCase):
    def test_rooms_include_only_leftwards(self):
        self.assertTrue(sources(ROOT, "solver", {".h"}))
        self.assertEqual(include_violations(ROOT), [])

    def test_files_can_be_read_at_one_sitting(self):
        self.assertEqual(long_files(ROOT), [])


class Checker(unittest.TestCase):
    """The checks see what they are for."""

    def setUp(self):
        directory = tempfile.TemporaryDirectory()
        self.addCleanup(directory.cleanup)
        self.root = pathlib.Path(directory.name)
        for room in ROOMS:
            (self.root / room).mkdir()
            (self.root / room / "good.h").write_text("#include <vector>\n", encoding="utf-8")

    def violations_of(self, room, text):
        (self.root / room / "file.cc").write_text(text, encoding="utf-8")
        return include_violations(self.root)

    def test_leftwards_is_allowed(self):
        self.assertEqual(self.violations_of("runs", '#include "meshing/good.h"\n'), [])

    def test_rightwards_is_seen(self):
        self.assertEqual(len(self.violations_of("solver", '  # include "fitting/good.h"\n')), 1)

    def test_relative_path_is_seen(self):
        self.assertEqual(len(self.violations_of("solver", '#include "good.h"\n')), 1)

    def test_library_of_another_room_is_seen(self):
        self.assertEqual(len(self.violations_of("fitting", "#include <deal.II/fe/fe_q.h>\n")), 1)

    def test_long_file_is_seen(self):
        (self.root / "runs" / "long.cc").write_text("\n" * (MAX_LINES + 1), encoding="utf-8")
        self.assertEqual(len(long_files(self.root)), 1)


if __name__ == "__main__":
    sys.exit(unittest.main(verbosity=2))
