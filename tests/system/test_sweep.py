"""A small sweep: killed and resumed, refitted, exported, damaged."""

import os
import pathlib
import random
import signal
import subprocess
import time

import grids
import program
from grids import GRID, SLOW_GRID, read_table
from program import BAD_INPUT, CORRUPT, FILE, INCOMPLETE, MISMATCH


def children_of(process):
    path = pathlib.Path(f"/proc/{process}/task/{process}/children")
    return [int(child) for child in path.read_text(encoding="utf-8").split()]


class Sweep(grids.TestCase):
    def setUp(self):
        super().setUp()
        self.grid = self.write("grid.prm", GRID)
        self.arguments = ["sweep", self.grid, "--jobs", "2", "--database"]

    def start(self, database):
        command = [program.PROGRAM, *map(str, self.arguments), database]
        return subprocess.Popen(command, cwd=self.directory, stdin=subprocess.DEVNULL,
                                stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)

    def kill_during(self, database, lines, delay):
        """Starts a sweep, kills it after so many lines of its log and a moment, while it runs."""
        with self.start(database) as process:
            for _ in range(lines):
                process.stderr.readline()
            time.sleep(delay)
            self.assertIsNone(process.poll())
            process.send_signal(signal.SIGKILL)
            process.wait()
        grids.wait_for_end(f"{self.directory}")  # the workers end with it

    def test_load_levels_instead_of_forces(self):
        grid = self.write("levels.prm", "set E = 10GPa, 20GPa\nset nu = 0.2\nset phi = 30\nset sigma-c = 20MPa\n"
                          "set radius = 3mm\nset load-level = 0.5, 5, 50\nset resolution = 12\nset step-tolerance = 1e-2\n")
        self.succeed("sweep", grid, "--database", "levels.h5")
        rows = self.table("levels.h5")
        self.assertEqual([round(float(row["load_level"]), 12) for row in rows], [.5, 5, 50] * 2)
        for row in rows:
            self.assertAlmostEqual(float(row["force_max_N"]) / float(row["force_yield_N"]) / float(row["load_level"]), 1,
                                   delta=1e-12)
        # Equal nu, phi and load level: the same law by similarity, at another F_y.
        for soft, stiff in zip(rows[:3], rows[3:]):
            self.assertNotAlmostEqual(float(soft["force_yield_N"]) / float(stiff["force_yield_N"]), 1, delta=.1)
            for name in "abmn":
                self.assertAlmostEqual(float(soft[name]) / float(stiff[name]), 1, delta=1e-6)
        message = self.fail_with(BAD_INPUT, "sweep", grid, "--force-max", "5N", "--database", "levels.h5")
        self.assertIn("load-level and force-max", message)

    def test_kill_and_resume_gives_the_same_rows(self):
        self.write("grid.prm", SLOW_GRID)
        self.succeed(*self.arguments, "calm.h5")
        calm = self.table("calm.h5")
        self.assertEqual([row["status"] for row in calm], ["converged"] * 6)

        # while the workers start, and after the first row of the second run is stored
        self.kill_during("stormy.h5", 1, random.Random(2018).uniform(0, 0.2))
        self.kill_during("stormy.h5", 2, 0)
        stored = self.stored_rows("stormy.h5")
        self.assertIn(len(stored), range(1, 6))  # some of the six, not all
        resumed = self.document(*self.arguments, "stormy.h5")
        self.assertEqual(resumed["computed"], 6 - len(stored))
        self.assertEqual({path: path.read_bytes() for path in stored}, stored)
        self.assertEqual(self.table("stormy.h5"), calm)
        self.assertEqual(self.rows("stormy.h5"), self.rows("calm.h5"))

    def test_worker_that_is_killed_fails_its_row_only(self):
        with self.start("table.h5") as process:
            process.stderr.readline()
            while not (children := children_of(process.pid)):
                time.sleep(0.001)
            os.kill(children[0], signal.SIGKILL)
            log = process.stderr.read()
        self.assertEqual(process.returncode, INCOMPLETE, log)
        rows = self.table("table.h5")
        self.assertEqual([row["status"] for row in rows].count("converged"), 3, log)
        failed = next(row for row in rows if row["status"] == "failed")
        self.assertIn("signal 9", failed["reason"])
        self.assertNotEqual(failed["force_yield_N"], "nan")

        result = self.run_program(*self.arguments, "table.h5", "--json")
        self.assertEqual(result.returncode, INCOMPLETE)
        self.assertIn('"computed": 0', result.stdout)
        self.assertEqual(self.document(*self.arguments, "table.h5", "--retry-failed")["computed"], 1)
        self.succeed(*self.arguments, "calm.h5")
        self.assertEqual(self.table("table.h5"), self.table("calm.h5"))

    def test_life_of_a_database(self):
        first = self.document(*self.arguments, "table.h5")
        self.assertEqual((first["computed"], first["converged"], first["failed"]), (4, 4, 0))
        columns = list(self.table("table.h5")[0])
        self.assertEqual(columns[:20], [
            "E_Pa", "nu", "phi_deg", "sigma_c_Pa", "radius_m", "force_max_N", "force_yield_N",
            "approach_yield_m", "pressure_yield_Pa", "contact_radius_yield_m", "yield_strength_Pa",
            "a", "b", "m", "n", "a_published", "m_published", "approach_residual_m",
            "approach_peak_m", "status"])

        with self.subTest("a second run finds nothing to do"), self.unchanged_files():
            self.assertEqual(self.document(*self.arguments, "table.h5")["computed"], 0)

        with self.subTest("other settings are refused with both values"), self.unchanged_files():
            result = self.run_program(*self.arguments, "table.h5", "--resolution", "13")
            self.assertEqual(result.returncode, MISMATCH, result.stderr)
            self.assertIn("stored 12, now 13", result.stderr)

        with self.subTest("refitting the stored curves changes nothing"):
            with self.unchanged_files():
                refit = self.document("fit", "table.h5")
            self.assertEqual(refit["largest_change"], {"a": 0, "b": 0, "m": 0, "n": 0})
            self.document("fit", "table.h5", "--write")
            with self.unchanged_files():
                self.assertEqual(self.document(*self.arguments, "table.h5")["computed"], 0)

        with self.subTest("unwritable exports leave everything as it was"):
            self.write("plain", "kept")
            with self.unchanged_files():
                self.fail_with(FILE, "export", "table.h5", "--csv", "plain/table.csv")
                self.fail_with(FILE, "export", "table.h5", "--csv", "absent/table.csv")

        self.check_truncated("table.h5")

        with self.subTest("a sweep mends a truncated database from its rows"):
            self.assertEqual(self.document(*self.arguments, "table.h5")["computed"], 0)
            self.assertEqual(len(self.table("table.h5")), 4)

    def test_families(self):
        grid = self.write("families.prm", GRID.replace("20MPa, 1GPa", "5MPa, 20MPa, 1GPa"))
        arguments = ["sweep", grid, "--jobs", "2", "--mode", "families", "--database"]
        first = self.document(*arguments, "families.h5")
        self.assertEqual((first["computed"], first["converged"]), (6, 6))
        families = self.table("families.h5")

        with self.subTest("a lost row comes back as it was"):
            row = sorted((self.directory / "families.h5.rows").glob("*.json"),
                         key=lambda path: path.name == "settings.json")[0]
            row.unlink()
            self.assertEqual(self.document(*arguments, "families.h5")["computed"], 1)
            self.assertEqual(self.table("families.h5"), families)

        with self.subTest("rows of the two modes do not mix"), self.unchanged_files():
            result = self.run_program("sweep", grid, "--database", "families.h5")
            self.assertEqual(result.returncode, MISMATCH, result.stderr)
            self.assertIn("families", result.stderr)

        with self.subTest("direct rows agree within the stated errors"):
            self.succeed("sweep", grid, "--jobs", "2", "--database", "direct.h5")
            found = self.document("compare", "direct.h5", "families.h5", "--csv", "report.csv")
            self.assertEqual((found["rows"], found["agree"]), (6, 6), found)
            report = read_table(self.directory / "report.csv")
            self.assertEqual([row["agrees"] for row in report], ["yes"] * 6)
            self.assertGreater(abs(float(report[0]["m_relative_difference"])), 0)

        with self.subTest("databases of other rows are not compared"):
            self.succeed(*self.arguments, "other.h5")
            self.fail_with(BAD_INPUT, "compare", "families.h5", "other.h5")

    def check_truncated(self, database):
        path = self.directory / database
        content = path.read_bytes()
        path.write_bytes(content[:len(content) // 2])
        with self.subTest("truncated database"), self.unchanged_files():
            self.fail_with(CORRUPT, "fit", database)
            self.fail_with(CORRUPT, "fit", database, "--write")
            self.fail_with(CORRUPT, "export", database, "--csv", f"{database}.csv")


if __name__ == "__main__":
    program.main()
