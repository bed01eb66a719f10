"""A sweep over MPI ranks: the rows of one process, whatever happens on the way."""

import contextlib
import json
import os
import random
import signal
import subprocess
import time

import grids
import program
from grids import FAMILIES, GRID, SLOW_GRID
from program import BAD_INPUT, FILE, INCOMPLETE, MISMATCH


class Ranks(grids.TestCase):
    def setUp(self):
        super().setUp()
        self.grid = self.write("grid.prm", GRID)

    def command(self, ranks, *arguments):
        return ["mpirun", "--oversubscribe", "--bind-to", "none", "-np", str(ranks),
                program.PROGRAM, "sweep", *map(str, arguments)]

    def options(self):
        as_root = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}
        return {"stdin": subprocess.DEVNULL, "text": True, "cwd": self.directory,
                "env": os.environ | as_root}

    def run_ranks(self, ranks, *arguments):
        return subprocess.run(self.command(ranks, *arguments), capture_output=True, check=False,
                              **self.options())

    def check_like_one_process(self, content):
        grid = self.write("grid.prm", content)
        self.succeed("sweep", grid, "--jobs", "1", "--database", "one.h5")
        result = self.run_ranks(2, grid, "--database", "two.h5", "--json")
        self.assertEqual(result.returncode, 0, result.stderr)
        document = json.loads(result.stdout)  # by one rank only
        self.assertGreater(document["rows"], 0)
        self.assertEqual(document["computed"], document["rows"])
        self.assertIn("by 2 MPI ranks", result.stderr)
        self.assertEqual(result.stderr.count("converged in"), document["rows"])
        self.assertEqual(self.table("two.h5"), self.table("one.h5"))
        self.assertEqual(self.rows("two.h5"), self.rows("one.h5"))

    def test_direct_rows_are_those_of_one_process(self):
        self.check_like_one_process(GRID)

    def test_families_are_those_of_one_process(self):
        self.check_like_one_process(FAMILIES)

    def kill_during(self, lines, delay):
        """Kills launcher and ranks of a sweep after so many lines of its log and a moment."""
        with subprocess.Popen(self.command(2, self.grid, "--database", "stormy.h5"),
                              stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
                              **self.options()) as process:
            for _ in range(lines):
                process.stderr.readline()
            time.sleep(delay)
            self.assertIsNone(process.poll())
            for found in grids.processes_of(f"{self.directory}"):
                with contextlib.suppress(ProcessLookupError):
                    os.kill(int(found), signal.SIGKILL)
        grids.wait_for_end(f"{self.directory}")

    def test_kill_and_resume(self):
        self.write("grid.prm", SLOW_GRID)
        self.succeed("sweep", self.grid, "--jobs", "1", "--database", "calm.h5")
        self.kill_during(1, random.Random(5).uniform(0, 0.2))
        self.kill_during(2, 0)
        stored = self.stored_rows("stormy.h5")
        self.assertIn(len(stored), range(1, 6))  # some of the six, not all

        result = self.run_ranks(3, self.grid, "--database", "stormy.h5")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn(f"{len(stored)} done before", result.stderr)
        self.assertEqual({path: path.read_bytes() for path in stored}, stored)
        self.assertEqual(self.rows("stormy.h5"), self.rows("calm.h5"))

        with self.subTest("one process finds nothing to do"), self.unchanged_files():
            self.assertEqual(
                self.document("sweep", self.grid, "--database", "stormy.h5")["computed"], 0)

    def test_errors_are_said_once(self):
        self.succeed("sweep", self.grid, "--jobs", "1", "--database", "one.h5")
        for code, text, *arguments in (
                (BAD_INPUT, "jobs", self.grid, "--database", "two.h5", "--jobs", "2"),
                (BAD_INPUT, "shard", self.grid, "--database", "two.h5", "--shard", "3/2"),
                (FILE, "absent.prm", "absent.prm", "--database", "two.h5"),
                (MISMATCH, "stored 12, now 13", self.grid, "--database", "one.h5",
                 "--resolution", "13")):
            with self.subTest(text), self.unchanged_files():
                result = self.run_ranks(2, *arguments)
                self.assertEqual(result.returncode, code, result.stderr)
                self.assertIn(text, result.stderr)
                self.assertEqual(result.stderr.count("dpcontact: error:"), 1, result.stderr)

    def test_ranks_given_different_grids_end(self):
        """Orders are numbers of cases: one grid's must not be taken for another's."""
        other = self.write("other.prm", GRID.replace("200MPa", "300MPa"))
        self.assertNotEqual(other.read_text(encoding="utf-8"), GRID)
        ranks = [program.PROGRAM, "sweep", self.grid, "--database", "two.h5"]
        for theirs, words in (
                ([program.PROGRAM, "sweep", other, "--database", "two.h5"],
                 ["cases/", "200000000.0 on rank 0 and 300000000.0 on rank 1"]),
                ([*ranks, "--resolution", "13"], ["settings/", "12 on rank 0 and 13 on rank 1"]),
                ([program.PROGRAM, "sweep", self.grid, "--database", "three.h5"],
                 ["two.h5", "three.h5"])):
            with self.subTest(words[0]):
                result = subprocess.run(
                    ["mpirun", "--oversubscribe", "--bind-to", "none", "-np", "1", *map(str, ranks),
                     ":", "-np", "1", *map(str, theirs)],
                    capture_output=True, check=False, timeout=300, **self.options())
                self.assertEqual(result.returncode, BAD_INPUT, result.stderr)
                for word in ["were not given the same", *words]:
                    self.assertIn(word, result.stderr)
                self.assertFalse((self.directory / "two.h5").exists())

    def test_failed_rows(self):
        # no number of steps meets that tolerance
        grid = self.write("failing.prm", GRID.replace("= 1e-2", "= 1e-9").replace("= 12", "= 8"))
        result = self.run_ranks(2, grid, "--database", "two.h5")
        self.assertEqual(result.returncode, INCOMPLETE, result.stderr)
        self.assertEqual(self.run_program("sweep", grid, "--jobs", "2", "--database",
                                          "one.h5").returncode, INCOMPLETE)
        rows = self.rows("two.h5")
        rows.pop("settings.json")
        self.assertEqual(sorted(row["status"] for row in rows.values()),
                         ["converged"] * 2 + ["failed"] * 2)
        self.assertEqual(rows, {name: self.rows("one.h5")[name] for name in rows})


if __name__ == "__main__":
    program.main()
