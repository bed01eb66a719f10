"""runs/figures on the parts that need the fewest solves."""

import csv
import pathlib
import subprocess
import tempfile
import unittest

SCRIPT = pathlib.Path(__file__).resolve().parents[2] / "runs" / "figures" / "all.py"


class Figures(unittest.TestCase):
    def run_figures(self, directory):
        # matplotlib is Debian's, for Debian's python3
        run = subprocess.run(["/usr/bin/python3", "-B", str(SCRIPT), "--only", "figure_4", "--only", "figures_7_10",
                              "--only", "figures_11_12", "--output", str(directory)], stdin=subprocess.DEVNULL, capture_output=True, text=True)
        self.assertEqual(run.returncode, 0, run.stderr)
        return run.stdout + run.stderr

    def check_interpolation(self, directory, summary):
        """Figures 7 to 10: errors at type 1 from the drawn lines, where all three axes meet, are the summary's."""
        for number, name in ("7", "a"), ("8", "b"), ("9", "m"), ("10", "n"):
            with open(directory / f"figure_{number}.csv", newline="", encoding="utf-8") as file:
                rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
            errors = {}
            for label in "similarity", "natural neighbours", "Kriging", "eq (19), 162 rows", "eq (19), table 2":
                at = {}
                for axis, heading, place in (("nu", "nu (1)", .15), ("phi", "phi (degrees)", 25), ("sigma-c", "sigma-c (MPa)", 15)):
                    row, = [row for row in rows if row[heading] and abs(float(row[heading]) - place) < 1e-9]
                    at[axis] = float(row[f"{name} over {axis}, {label}"])
                self.assertEqual(len(set(at.values())), 1, "the lines meet")
                errors[label] = float(summary[number, f"type 1: error of {label} in {name} against our FE, %"]["ours"])
                # Figure 11's summary holds the same finite elements.
                computed = float(summary["11", f"type 1: {name}, paper's convention, FE"]["ours"])
                self.assertAlmostEqual(errors[label], 100 * abs(at["nu"] / computed - 1), delta=2e-3)
            # The order that the paper finds, and the universal table closest of all.
            self.assertLess(errors["similarity"], .1)
            self.assertLess(errors["similarity"], errors["Kriging"])
            self.assertLess(errors["Kriging"], errors["natural neighbours"])
            self.assertLess(errors["natural neighbours"], errors["eq (19), 162 rows"])

    def test_pictures_tables_and_summary(self):
        with tempfile.TemporaryDirectory() as name:
            directory = pathlib.Path(name)
            self.assertIn("2 solves computed", self.run_figures(directory))
            for figure in "figure_4", "figure_7", "figure_8", "figure_9", "figure_10", "figure_11", "figure_12":
                self.assertEqual((directory / f"{figure}.png").read_bytes()[:8], b"\x89PNG\r\n\x1a\n")
                self.assertTrue(list(directory.glob(f"{figure}*.csv")), figure)
            with open(directory / "summary.csv", newline="", encoding="utf-8") as file:
                summary = {(row["figure"], row["quantity"]): row for row in csv.DictReader(file)}
            # Table 4 of the paper: the errors of eq (19) against its own finite elements, whose a and m
            # differ from ours by up to 1 %.
            compared = 0
            for (figure, quantity), row in summary.items():
                if "error of eq (19) with table 2" in quantity:
                    compared += 1
                    self.assertAlmostEqual(float(row["ours"]), float(row["theirs"]), delta=1.5, msg=quantity)
            self.assertEqual(compared, 8)
            self.check_interpolation(directory, summary)
            # A second run keeps the solves and every row.
            before = (directory / "summary.csv").read_text(encoding="utf-8")
            self.assertIn("0 solves computed", self.run_figures(directory))
            self.assertEqual((directory / "summary.csv").read_text(encoding="utf-8"), before)


if __name__ == "__main__":
    unittest.main()
