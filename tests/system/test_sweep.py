"""A small sweep: killed and resumed, refitted, exported, damaged."""

import contextlib
import os
import random
import resource
import shutil
import signal
import subprocess
import time

import grids
import program
from grids import GRID, SLOW_GRID, read_table
from program import BAD_INPUT, CORRUPT, FILE, INTERNAL, MISMATCH, SUCCESS


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

    def test_worker_that_is_killed_is_replaced_and_no_row_fails(self):
        with self.start("table.h5") as process:
            process.stderr.readline()
            while not (children := grids.children_of(process.pid)):
                time.sleep(0.001)
            os.kill(children[0], signal.SIGKILL)
            log = process.stderr.read()
        self.assertEqual(process.returncode, SUCCESS, log)
        self.assertIn("signal 9", log)
        self.succeed(*self.arguments, "calm.h5")
        self.assertEqual(self.table("table.h5"), self.table("calm.h5"))

    def test_workers_that_are_killed_again_and_again_stop_the_sweep(self):
        with self.start("table.h5") as process:
            while process.poll() is None:
                with contextlib.suppress(OSError):
                    for child in grids.children_of(process.pid):
                        os.kill(child, signal.SIGKILL)
            log = process.stderr.read()
        self.assertEqual(process.returncode, INTERNAL, log)
        self.assertIn("signal 9", log)
        self.assertNotIn("failed", log)
        self.assertEqual(self.document(*self.arguments, "table.h5")["failed"], 0)
        self.succeed(*self.arguments, "calm.h5")
        self.assertEqual(self.table("table.h5"), self.table("calm.h5"))

    def test_an_interruption_says_what_is_kept(self):
        self.write("grid.prm", SLOW_GRID)
        with self.start("table.h5") as process:
            for _ in range(2):
                process.stderr.readline()
            process.send_signal(signal.SIGINT)
            log = process.stderr.read()
        self.assertEqual(process.returncode, -signal.SIGINT, log)
        self.assertIn("dpcontact: interrupted: the rows finished so far are kept in table.h5.rows, "
                      "and the same command computes the others", log)
        self.assertEqual(log.count("interrupted"), 1)  # the workers say nothing
        grids.wait_for_end(f"{self.directory}")
        self.assertEqual(self.document(*self.arguments, "table.h5")["converged"], 6)

    def test_an_interrupted_solve_says_how_to_go_on(self):
        state = self.directory / "state"
        words = ["solve", "--E=10GPa", "--nu=0.2", "--phi=20", "--sigma-c=5MPa", f"--checkpoint={state}"]
        with subprocess.Popen([program.PROGRAM, *words], stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                              stderr=subprocess.PIPE, text=True) as process:
            while process.poll() is None and not state.exists():
                time.sleep(0.01)
            process.send_signal(signal.SIGINT)
            log = process.stderr.read()
        self.assertEqual(process.returncode, -signal.SIGINT, log)
        self.assertIn(f"the state is kept in {state}, and the same command goes on from it", log)
        self.assertIn("going on from", self.succeed(*words).stderr)

    def test_a_fault_of_the_machine_is_no_failed_row(self):
        def small_files():
            resource.setrlimit(resource.RLIMIT_FSIZE, (2000, 2000))

        for options in ({"env": {**os.environ, "TMPDIR": str(self.directory / "absent")}},
                        {"preexec_fn": small_files}):
            with self.subTest(" ".join(options)):
                result = self.run_program(*self.arguments, "table.h5", **options)
                self.assertIn(result.returncode, (FILE, INTERNAL), result.stderr)
                self.assertIn("the same command computes the others", result.stderr)
                for content in self.stored_rows("table.h5").values():  # elastic rows need no mesh
                    self.assertIn(b'"status": "converged"', content)
                self.assertFalse((self.directory / "table.h5").exists())
        self.assertEqual(self.document(*self.arguments, "table.h5")["converged"], 4)

    def test_a_limit_of_processor_time_is_no_failed_row(self):
        grid = self.write("slow.prm", SLOW_GRID)

        def little_time():
            resource.setrlimit(resource.RLIMIT_CPU, (3, 100))  # SIGXCPU after 3 s, for each process by itself

        arguments = ["sweep", grid, "--jobs", "1", "--resolution", "48", "--database", "table.h5"]
        result = self.run_program(*arguments, preexec_fn=little_time)
        self.assertIn(result.returncode, (SUCCESS, INTERNAL), result.stderr)
        self.assertIn(f"signal {int(signal.SIGXCPU)}", result.stderr)
        for content in self.stored_rows("table.h5").values():
            self.assertIn(b'"status": "converged"', content)
        self.assertEqual(self.document(*arguments)["converged"], 6)

    def test_a_sweep_adds_rows(self):
        self.succeed(*self.arguments, "table.h5")
        before = self.table("table.h5")
        other = self.write("other.prm", GRID.replace("20MPa, 200MPa", "30MPa"))
        arguments = ["sweep", other, "--jobs", "2", "--database", "table.h5"]
        found = self.document(*arguments)
        self.assertEqual((found["rows"], found["computed"], found["kept"]), (2, 2, 4))
        rows = self.table("table.h5")
        self.assertEqual([row["sigma_c_Pa"] for row in rows[:2]], ["3e+07", "3e+07"])
        self.assertEqual(rows[2:], before)
        self.assertIn("4 rows of other grids kept", self.succeed(*arguments).stderr)

        with self.subTest("and takes up those of a file whose row directory is gone"):
            shutil.rmtree(self.directory / "table.h5.rows")
            self.assertEqual(self.document(*self.arguments, "table.h5")["computed"], 0)
            self.assertEqual(self.table("table.h5"), before + rows[:2])

        with self.subTest("unless they are to be replaced"):
            self.assertEqual(self.document(*arguments, "--replace")["kept"], 0)
            self.assertEqual(self.table("table.h5"), rows[:2])

    def test_refitting_refuses_rows_of_other_settings(self):
        self.succeed(*self.arguments, "table.h5")
        self.succeed(*self.arguments, "finer.h5", "--resolution", "13")
        for ending in ("", ".sha256"):
            shutil.copy(self.directory / f"finer.h5{ending}", self.directory / f"table.h5{ending}")
        with self.unchanged_files():
            for words in (["fit", "table.h5", "--write"], [*self.arguments, "table.h5"]):
                result = self.run_program(*words)
                self.assertEqual(result.returncode, MISMATCH, result.stderr)
                self.assertIn('"resolution":12', result.stderr)
                self.assertIn('"resolution":13', result.stderr)

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
        grid = self.write("families.prm", GRID.replace("20MPa, 200MPa", "5MPa, 20MPa, 200MPa"))
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
