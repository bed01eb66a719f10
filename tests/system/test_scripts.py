"""Every script of runs/ and tests/ says what it does when it is asked for help, and does nothing else."""

import os
import pathlib
import subprocess
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]


def scripts():
    places = [ROOT / "tests" / "run", *sorted((ROOT / "runs").rglob("*"))]
    return [path for path in places if path.is_file() and os.access(path, os.X_OK)]


class Scripts(unittest.TestCase):
    def test_help(self):
        found = scripts()
        self.assertGreater(len(found), 10)
        for script in found:
            with self.subTest(script.relative_to(ROOT)):
                before = sorted(ROOT.iterdir())
                result = subprocess.run([script, "--help"], stdin=subprocess.DEVNULL, capture_output=True, text=True,
                                        timeout=60, check=False)
                self.assertEqual((result.returncode, result.stderr), (0, ""))
                self.assertGreater(len(result.stdout), 50)
                self.assertNotIn("setup:", result.stdout)  # it installs and builds nothing
                self.assertEqual(sorted(ROOT.iterdir()), before)


if __name__ == "__main__":
    unittest.main(verbosity=2)
