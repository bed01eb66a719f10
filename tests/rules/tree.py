"""The tree that the rules are about: its rooms, their order, and the files in them."""

import pathlib
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]

# A room includes itself and the rooms to its left.
ROOMS = ["meshing", "solver", "fitting", "database", "runs"]

# The same for the sub-folders of a room. Those of one inner list do not include each other.
SUBFOLDERS = {
    "solver": [["laws"], ["problem"], ["parallel"], ["discretisation", "closed_form"], ["system"],
               ["output"], ["path"]],
    "database": [["files"], ["rows"], ["tables"], ["contact_law"]],
    "runs": [["interface"], ["sweep"], ["studies"], ["commands"], ["benchmarks", "dem"]],
}

SOURCES = {".h", ".cc", ".c"}


def sources(root, folder, suffixes=frozenset(SOURCES)):
    """The files below `folder` whose names end so, in order of their paths."""
    return [path for path in sorted((root / folder).rglob("*"))
            if path.is_file() and path.suffix in suffixes and "__pycache__" not in path.parts]


def production_sources(root, suffixes=frozenset(SOURCES)):
    return [path for room in ROOMS for path in sources(root, room, suffixes)]


def name_of(root, path):
    return path.relative_to(root).as_posix()


def read(path):
    return path.read_text(encoding="utf-8")


class TestCase(unittest.TestCase):
    def assert_none(self, violations):
        if violations:
            self.fail("\n".join(violations))


class InSmallTree(unittest.TestCase):
    """Tests of a check, in a tree that holds every folder and one blameless header in each."""

    def setUp(self):
        directory = tempfile.TemporaryDirectory()
        self.addCleanup(directory.cleanup)
        self.root = pathlib.Path(directory.name).resolve()
        for room in ROOMS:
            for folder in [""] + [name for equals in SUBFOLDERS.get(room, []) for name in equals]:
                if folder or room not in SUBFOLDERS:
                    self.write(f"{room}/{folder}/good.h", "#include <vector>\n")

    def write(self, name, text):
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
        return path
