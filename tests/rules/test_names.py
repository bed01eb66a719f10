"""How tests are called, and that each is built.

Files are SUBJECT_test.cc or test_SUBJECT.py, suites are in CamelCase, headers stand in tests/support.
"""

import re
import unittest

from tree import ROOT, InSmallTree, TestCase, name_of, read, sources

# Programs that a test runs.
# Programs and libraries that tests start.
HELPERS = {"tests/database/fuzz_readers.cc", "tests/database/rows/write_sample.cc",
           "tests/meshing/traps.cc", "tests/runs/interface/fuzz_readers.cc",
           "tests/support/failing_calls.cc"}

SUITE = re.compile(r"^\s*(?:TYPED_)?TEST(?:_[FP])?\(\s*(\w+)", re.MULTILINE)


def misnamed_files(root):
    found = []
    for name in (name_of(root, path) for path in sources(root, "tests")):
        if name.endswith(".h"):
            right = name.startswith("tests/support/")
        else:
            right = name in HELPERS or re.search(r"_test\.cc?$", name)
        if not right:
            found.append(f"{name}: neither SUBJECT_test.cc nor a header in tests/support")
    return found


def forgotten_tests(root):
    """Tests whose subject is no word of the CMakeLists.txt of their folder below tests/."""
    found = []
    for path in sources(root, "tests", {".cc", ".c", ".py"}):
        subject = re.fullmatch(r"test_(\w+)\.py|(\w+)_test\.cc?", path.name)
        if subject:
            lists = root / "tests" / path.relative_to(root / "tests").parts[0] / "CMakeLists.txt"
            word = subject[1] or subject[2]
            if not re.search(rf"(?<![a-z_]){word}(?:_test\.cc?)?(?![a-z_])|test_{word}\.py", read(lists)):
                found.append(name_of(root, path) + f": not in {name_of(root, lists)}")
    return found


def misnamed_suites(root):
    return [f"{name_of(root, path)}: suite {suite} is not in CamelCase"
            for path in sources(root, "tests") for suite in SUITE.findall(read(path))
            if not re.fullmatch(r"([A-Z][A-Za-z0-9]*)", suite)]


class Rules(TestCase):
    def test_files(self):
        self.assertGreater(len(sources(ROOT, "tests", {".cc"})), 40)
        self.assert_none(misnamed_files(ROOT))

    def test_each_is_built(self):
        self.assert_none(forgotten_tests(ROOT))

    def test_suites(self):
        self.assert_none(misnamed_suites(ROOT))


class Checker(InSmallTree):
    """The checks see what they are for."""

    def test_misnamed_files_are_seen(self):
        for name in ("tests/fitting/good_test.cc", "tests/support/good.h"):
            self.write(name, "")
        self.assertEqual(misnamed_files(self.root), [])
        for name in ("tests/fitting/test_bad.cc", "tests/fitting/bad.h"):
            self.write(name, "")
        self.assertEqual(len(misnamed_files(self.root)), 2)

    def test_forgotten_test_is_seen(self):
        self.write("tests/fitting/CMakeLists.txt", "dpcontact_test(SOURCES part/listed_test.cc)\n")
        self.write("tests/fitting/part/listed_test.cc", "")
        self.assertEqual(forgotten_tests(self.root), [])
        self.write("tests/fitting/part/unlisted_test.cc", "")
        self.write("tests/fitting/test_other.py", "")
        self.assertEqual(len(forgotten_tests(self.root)), 2)

    def test_misnamed_suite_is_seen(self):
        self.write("tests/fitting/a_test.cc", "TEST(GoodSuite, is_good)\n{\n}\n\n  TEST_F(bad_suite, is_bad)\n")
        self.assertEqual(len(misnamed_suites(self.root)), 1)


if __name__ == "__main__":
    unittest.main(verbosity=2)
