"""runs/figures on the parts that need the fewest solves."""

import csv
import pathlib
import subprocess
import tempfile
import unittest

SCRIPT = pathlib.Path(__file__).resolve().parents[2] / "runs" / "figure_scripts" / "run.py"


class Figures(unittest.TestCase):
    def run_figures(self, directory):
        # matplotlib is Debian's, for Debian's python3
        run = subprocess.run(["/usr/bin/python3", "-B", str(SCRIPT), "--only", "figure_4", "--only", "figures_11_12",
                              "--output", str(directory)], stdin=subprocess.DEVNULL, capture_output=True, text=True)
        self.assertEqual(run.returncode, 0, run.stderr)
        return run.stdout + run.stderr

    def test_pictures_tables_and_summary(self):
        with tempfile.TemporaryDirectory() as name:
            directory = pathlib.Path(name)
            self.assertIn("2 solves computed", self.run_figures(directory))
            for figure in "figure_4", "figure_11", "figure_12":
                self.assertEqual((directory / f"{figure}.png").read_bytes()[:8], b"\x89PNG\r\n\x1a\n")
                self.assertTrue(list(directory.glob(f"{figure}*.csv")), figure)
            with open(directory / "summary.csv", newline="", encoding="utf-8") as file:
                summary = {(row["figure"], row["quantity"]): row for row in csv.DictReader(file)}
            # Table 4 of the paper: the errors of eq (19) against its own finite elements, whose a and m
            # differ from ours by up to 1 %.
            compared = 0
            for (figure, quantity), row in summary.items():
                if "error of eq (19)" in quantity:
                    compared += 1
                    self.assertAlmostEqual(float(row["ours"]), float(row["theirs"]), delta=1.5, msg=quantity)
            self.assertEqual(compared, 8)
            # A second run keeps the solves and every row.
            before = (directory / "summary.csv").read_text(encoding="utf-8")
            self.assertIn("0 solves computed", self.run_figures(directory))
            self.assertEqual((directory / "summary.csv").read_text(encoding="utf-8"), before)


if __name__ == "__main__":
    unittest.main()
