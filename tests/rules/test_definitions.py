"""No name has two definitions in the libraries of the rooms, which are the arguments.

Two definitions of one name are undefined behaviour that no tool need report: of an ordinary function
the linker takes the first that it meets, of an inline function any. Seen here are two ordinary ones, and
an ordinary one beside an inline one. Two different inline ones are for `runs/build odr` to compare.
"""

import collections
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

from tree import TestCase

LIBRARIES = []

ORDINARY, INLINE = set("TDBR"), set("WVu")


def definitions(library):
    """(object file, kind, name) of what a library defines for others, the names as in C++."""
    dynamic = ["--dynamic"] if library.suffix == ".so" else []
    text = subprocess.run(["nm", "--demangle", "--defined-only", *dynamic, str(library)],
                          capture_output=True, text=True, check=True).stdout
    place = library.name
    for line in text.splitlines():
        if header := re.fullmatch(r"(\S+\.o):", line):
            place = f"{library.name}({header[1]})"
        elif entry := re.fullmatch(r"[0-9a-f]* (\w) (.*)", line):
            yield place, entry[1], entry[2]


def double_definitions(libraries):
    places = collections.defaultdict(lambda: collections.defaultdict(set))
    for library in libraries:
        for place, kind, name in definitions(library):
            if name.startswith("dpcontact::") or "(" not in name:
                places[name]["ordinary" if kind in ORDINARY else "inline" if kind in INLINE else "other"].add(place)
    found = []
    for name, by_kind in sorted(places.items()):
        ordinary, inline = by_kind["ordinary"], by_kind["inline"]
        if len(ordinary) > 1 or (ordinary and inline):
            found.append(f"{name}: {', '.join(sorted(ordinary | inline))}")
    return found


class Rules(TestCase):
    def test_no_name_has_two_definitions(self):
        self.assertGreater(sum(name.startswith("dpcontact::") for library in LIBRARIES
                               for _, _, name in definitions(library)), 500)
        self.assert_none(double_definitions(LIBRARIES))


class Checker(unittest.TestCase):
    """The check sees what it is for."""

    def setUp(self):
        directory = tempfile.TemporaryDirectory()
        self.addCleanup(directory.cleanup)
        self.directory = pathlib.Path(directory.name)

    def compiled(self, name, text):
        source, result = self.directory / f"{name}.cc", self.directory / f"{name}.o"
        source.write_text(f"namespace dpcontact {{ {text} }}\n", encoding="utf-8")
        subprocess.run(["c++", "-c", str(source), "-o", str(result)], check=True)
        return result

    def test_inline_in_two_files_is_allowed(self):
        text = "inline int f() {{ return 1; }} int {0}() {{ return f(); }}"
        self.assertEqual(double_definitions([self.compiled(name, text.format(name)) for name in ("g", "h")]), [])

    def test_two_ordinary_ones_are_seen(self):
        libraries = [self.compiled(name, "int f(int) { return 1; }") for name in ("g", "h")]
        self.assertEqual(len(double_definitions(libraries)), 1)

    def test_ordinary_beside_inline_is_seen(self):
        libraries = [self.compiled("g", "int f() { return 1; }"),
                     self.compiled("h", "inline int f() { return 2; } int g() { return f(); }")]
        self.assertEqual(len(double_definitions(libraries)), 1)


if __name__ == "__main__":
    LIBRARIES = [pathlib.Path(argument) for argument in sys.argv[1:]]
    del sys.argv[1:]
    unittest.main(verbosity=2)
