"""Every parameter file of runs/ is understood by the program, the first argument."""

import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

RUNS = pathlib.Path(__file__).resolve().parents[2] / "runs"
PROGRAM = None


def dry_run(path):
    with tempfile.TemporaryDirectory() as directory:
        result = subprocess.run([PROGRAM, "sweep", path, "--dry-run", "--json"], cwd=directory,
                                capture_output=True, text=True, check=False)
    assert result.returncode == 0, result.stderr
    return json.loads(result.stdout)


class ParameterFiles(unittest.TestCase):
    def test_every_file_is_valid(self):
        files = sorted(RUNS.rglob("*.prm"))
        self.assertTrue(files)
        for path in files:
            with self.subTest(path.name):
                self.assertTrue(dry_run(path)["rows"])

    def test_grid_of_the_paper(self):
        rows = dry_run(RUNS / "wang2018.prm")["rows"]
        self.assertEqual(len(rows), 162)
        materials = {tuple(row["material"][name] for name in ("E", "nu", "phi_deg", "sigma_c")) for row in rows}
        self.assertEqual(materials, {(e * 1e9, nu, phi, strength * 1e6)
                                     for e in (10, 20, 30) for nu in (.1, .2, .3)
                                     for phi in (20, 30, 40)
                                     for strength in (5, 10, 20, 30, 40, 50)})
        self.assertEqual({tuple(row["scene"].values()) for row in rows}, {(0.1, 100)})


if __name__ == "__main__":
    PROGRAM = os.path.abspath(sys.argv.pop(1))
    unittest.main(verbosity=2)
