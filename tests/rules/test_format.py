"""Every C++ and C file is as clang-format, in the version of the tree's configuration, makes it."""

import re
import shutil
import subprocess
import unittest

from tree import ROOMS, ROOT, InSmallTree, TestCase, name_of, sources

VERSION = 14  # Debian 12's; another version breaks lines elsewhere

FILES_AT_A_TIME = 50


def unformatted(root, files):
    """Files that the format of `root` would change."""
    found = set()
    for first in range(0, len(files), FILES_AT_A_TIME):
        result = subprocess.run(
            ["clang-format", "--style=file", "--dry-run", "--ferror-limit=1",
             *map(str, files[first:first + FILES_AT_A_TIME])],
            capture_output=True, text=True, check=True)
        found.update(re.findall(r"^(\S+?):\d+:\d+: (?:warning|error)", result.stderr, re.MULTILINE))
    return sorted(found)


class Rules(TestCase):
    def test_version_of_clang_format(self):
        version = subprocess.run(["clang-format", "--version"], capture_output=True, text=True, check=True).stdout
        self.assertIn(f"version {VERSION}.", version)

    def test_every_file_is_formatted(self):
        files = [path for folder in ROOMS + ["tests"] for path in sources(ROOT, folder)]
        self.assertGreater(len(files), 200)
        self.assert_none(unformatted(ROOT, files))  # `clang-format -i` mends them


class Checker(InSmallTree):
    """The check sees what it is for."""

    def test_unformatted_file_is_seen(self):
        shutil.copy(ROOT / ".clang-format", self.root)
        good = self.write("fitting/good.cc", "int f()\n{\n  f();\n  return 1;\n}\n")
        bad = self.write("fitting/bad.cc", "int f() {\n  f();\n  return 1;\n}\n")
        self.assertEqual([name_of(self.root, self.root / name) for name in unformatted(self.root, [good, bad])],
                         ["fitting/bad.cc"])


if __name__ == "__main__":
    unittest.main(verbosity=2)
