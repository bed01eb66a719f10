"""dpcontact validate and collide, end to end; the program is the first argument."""

import csv
import hashlib
import json
import math
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

PROGRAM = None
TABLE = pathlib.Path(__file__).resolve().parents[1] / "database" / "contact_law" / "contact_law_table.csv"


def run(directory, *words):
    return subprocess.run([PROGRAM, *map(str, words)], cwd=directory, capture_output=True, text=True, check=False)


class Validate(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.directory = cls.temporary.name
        grid = pathlib.Path(cls.directory) / "grid.prm"
        grid.write_text("set E = 10GPa\nset nu = 0.15\nset phi = 25\nset sigma-c = 15MPa, 80MPa\n"
                        "set resolution = 20\n", encoding="utf-8")
        result = run(cls.directory, "sweep", grid, "--database", "rows.h5")
        assert result.returncode == 0, result.stderr

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def test_rows_by_both_laws(self):
        result = run(self.directory, "validate", "rows.h5", "--table", TABLE, "--json", "--csv", "report.csv",
                     "--loading-bound", 0.003, "--unloading-bound", 0.005, "--residual-bound", 0.005,
                     "--restitution-bound", 0.002)
        self.assertEqual(result.returncode, 0, result.stderr)
        document = json.loads(result.stdout)
        self.assertTrue(document["within_bounds"])
        rows = {(row["law"], row["material"]["sigma_c"]): row["errors"] for row in document["rows"]}
        self.assertEqual(len(rows), 4)
        for (law, strength), errors in rows.items():
            with self.subTest(law=law, strength=strength):
                # The row's is the power law's misfit, the universal's that and a coarse table's interpolation.
                self.assertLess(errors["loading_rms"], 2e-3)
                self.assertLess(errors["unloading_rms"], 2e-3)
                self.assertLess(errors["residual_approach"], 2e-3)
                self.assertAlmostEqual(errors["restitution"], errors["law_restitution"], delta=2e-3)
                self.assertLessEqual(errors["restitution"], 1 + 1e-4)
                self.assertEqual([leg["end_force"] for leg in errors["legs"]], [1, 0])
        self.assertLess(rows["universal", 15e6]["restitution"], 0.99)
        with open(pathlib.Path(self.directory) / "report.csv", encoding="utf-8") as file:
            report = list(csv.DictReader(line for line in file if not line.startswith("#")))
        self.assertEqual(len(report), 4)
        self.assertEqual(list(report[0])[:14], [
            "path", "law", "criterion", "E_Pa", "nu", "phi_deg", "sigma_c_Pa", "flow_stress_ratio", "dilation_deg",
            "hardening_Pa", "tension_cutoff_Pa", "radius_m", "force_max_N", "load_level"])
        self.assertEqual(report[0]["criterion"], "drucker-prager")
        self.assertEqual(float(report[0]["dilation_deg"]), 25)
        for line in report:
            errors = rows[line["law"], float(line["sigma_c_Pa"])]
            self.assertTrue(math.isclose(float(line["unloading_rms"]), errors["unloading_rms"], rel_tol=1e-8))

    def test_a_bound_that_is_exceeded(self):
        result = run(self.directory, "validate", "rows.h5", "--table", TABLE, "--loading-bound", 1e-9)
        self.assertEqual(result.returncode, 8)
        self.assertIn("universal law exceeds a bound", result.stderr)

    def test_a_history_that_no_fit_has_seen(self):
        result = run(self.directory, "validate", "--table", TABLE, "--histories", 1, "--seed", 3, "--load-level-max",
                     30, "--resolution", 16, "--step-tolerance", 0.01, "--json")
        self.assertEqual(result.returncode, 0, result.stderr)
        universal, = [row for row in json.loads(result.stdout)["rows"] if row["law"] == "universal"]
        ends = [leg["end_force"] for leg in universal["errors"]["legs"]]
        self.assertEqual(ends.count(0), 2)
        self.assertAlmostEqual(max(ends), 1, places=9)
        # Loading, partial release, reload, release, up to the old peak and beyond it, and so on.
        self.assertEqual(len(ends), 12)
        # Coarse mesh and steps: 1 %, of which 0.2 % is the law's with default ones.
        self.assertLess(universal["errors"]["loading_rms"], 0.01)
        self.assertLess(universal["errors"]["unloading_rms"], 0.01)

    def test_what_is_wrong_is_named(self):
        directory = pathlib.Path(self.directory)
        content = (directory / "grid.prm").read_bytes()
        (directory / "signed.prm").write_bytes(content)
        (directory / "signed.prm.sha256").write_text(f"{hashlib.sha256(content).hexdigest()}  signed.prm\n", encoding="utf-8")
        for words, code, message in [
                ((), 3, "give a DATABASE, --histories, or both"),
                (("rows.h5", "--table", "nowhere.csv"), 4, "nowhere.csv"),
                (("nowhere.h5",), 4, "nowhere.h5"),
                (("rows.h5", "--table", "grid.prm"), 7, "grid.prm is not a database or table"),
                (("rows.h5", "--table", "signed.prm"), 7, "the header lacks the column")]:
            with self.subTest(words):
                result = run(self.directory, "validate", *words)
                self.assertEqual(result.returncode, code, result.stderr)
                self.assertIn(message, result.stderr)


class Collide(unittest.TestCase):
    ROCK = ("--E", "10GPa", "--nu", 0.15, "--phi", 25, "--sigma-c", "15MPa", "--radius", "50mm", "--density", 2600)

    def collide(self, *words):
        return run(".", "collide", *self.ROCK, *words)

    def test_both_laws(self):
        result = self.collide("--velocity", 0.02, "--table", TABLE, "--json")
        self.assertEqual(result.returncode, 0, result.stderr)
        universal = json.loads(result.stdout)
        self.assertAlmostEqual(universal["rebound_velocity"], 0.02 * universal["restitution"], places=12)
        # The row of this load level (F/F_y about 15), from dpcontact solve.
        row = json.loads(self.collide("--velocity", 0.02, "--row", "1.02063,1.46819,1.22718,1.45927", "--json").stdout)
        self.assertAlmostEqual(row["peak_overlap"] / universal["peak_overlap"], 1, delta=3e-3)
        self.assertAlmostEqual(row["restitution"], universal["restitution"], delta=5e-3)

    def test_what_is_wrong_is_named(self):
        for words, message in [(("--velocity", 1), "give --table"),
                               (("--velocity", -1, "--table", TABLE), "velocity is -1"),
                               (("--velocity", 1, "--row", "1,1.5,-1,1.5"), "m is -1"),
                               (("--velocity", 1, "--table", TABLE, "--hardening", "1GPa"), "leave the other parameters out")]:
            with self.subTest(words):
                result = self.collide(*words)
                self.assertEqual(result.returncode, 3, result.stderr)
                self.assertIn(message, result.stderr)


if __name__ == "__main__":
    PROGRAM = os.path.abspath(sys.argv.pop(1))
    unittest.main(verbosity=2)
