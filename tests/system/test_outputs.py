"""Where results go: an output is no input, its place is tried first, and old results are not mixed with new ones."""

import fcntl
import json
import os
import pathlib
import resource
import shutil
import signal
import subprocess
import tempfile
import unittest

import program
from grids import GRID
from program import BAD_INPUT, FILE, SOLVER, SUCCESS

ROOT = pathlib.Path(__file__).resolve().parents[2]
TYPE_1 = ["--E", "10GPa", "--nu", "0.15", "--phi", "25", "--sigma-c", "15MPa"]
SOLVE = ["solve", *TYPE_1, "--resolution", "8", "--step-tolerance", "1e-1"]
LOOKUP = ["lookup", *TYPE_1]
NOBODY = 65534


class Files(program.TestCase):
    def setUp(self):
        super().setUp()
        for name in ["universal.csv", "universal.csv.sha256"]:
            shutil.copy(ROOT / "database" / name, self.directory / name)
        self.lookup = [*LOOKUP, "--database", "universal.csv"]

    def refuse(self, code, words, *arguments):
        with self.subTest(arguments=arguments), self.unchanged_files():
            message = self.fail_with(code, *arguments)
            for word in words:
                self.assertIn(word, message)

    def test_an_output_is_no_input(self):
        (self.directory / "symbolic").symlink_to("universal.csv")
        os.link(self.directory / "universal.csv", self.directory / "hard")
        (self.directory / "here").symlink_to(".")
        for name in ["universal.csv", "./universal.csv", "symbolic", "hard", "here/universal.csv",
                     "universal.csv.sha256"]:
            self.refuse(BAD_INPUT, [name, "is the input universal.csv"], *self.lookup, "--csv", name)
        self.write("case.prm", "set radius = 50mm\n")
        self.refuse(BAD_INPUT, ["case.prm"], *self.lookup, "--parameter-file", "case.prm", "--csv", "case.prm")
        self.refuse(BAD_INPUT, ["case.prm"], *SOLVE, "--parameter-file", "case.prm", "--checkpoint", "case.prm")

    def test_two_databases_and_a_report(self):
        for name in ["a.h5", "b.h5"]:
            self.write(name, "")
            self.refuse(BAD_INPUT, [name], "compare", "a.h5", "b.h5", "--csv", name)
            self.refuse(BAD_INPUT, [name], "validate", "a.h5", "--table", "b.h5", "--csv", name)
            self.refuse(BAD_INPUT, [name], "table", "a.h5", "--join", "b.h5", "--csv", name)
        for option in ["--csv", "--xlsx", "--json-table", "--datacite"]:
            self.refuse(BAD_INPUT, ["a.h5"], "export", "a.h5", option, "a.h5")
        self.refuse(BAD_INPUT, ["new", "are one file"], "export", "a.h5", "--csv", "new", "--xlsx", "new")

    def test_the_database_of_a_sweep_has_a_place_and_a_name_that_says_what_it_is(self):
        self.write("grid.prm", GRID)
        (self.directory / "folder.h5").mkdir()
        for code, name, word in [(BAD_INPUT, "rows.csv", "must end in .h5"), (BAD_INPUT, "grid.prm", "must end in .h5"),
                                 (FILE, "absent/rows.h5", "No such file"), (FILE, "folder.h5", "is a directory"),
                                 (FILE, "n" * 237 + ".h5", "too long"), (FILE, "n" * 300 + ".h5", "too long")]:
            self.refuse(code, [word], "sweep", "grid.prm", "--database", name)

    def test_two_outputs_are_two_files(self):
        self.write("a.h5", "")
        for other in ["new.csv", "./new.csv", "new.csv.sha256"]:
            self.refuse(BAD_INPUT, ["new.csv", other], "table", "a.h5", "--csv", "new.csv", "--datacite", other)
        (self.directory / "out").mkdir()
        self.refuse(BAD_INPUT, ["result.json"], *SOLVE, "--output", "out", "--checkpoint", "out/result.json")

    def test_an_output_has_a_place(self):
        self.write("plain", "")
        (self.directory / "folder").mkdir()
        os.mkfifo(self.directory / "pipe")
        for name, word in [("folder", "is a directory"), ("absent/new.csv", "No such file"),
                           ("plain/new.csv", "Not a directory"), ("pipe", "no regular file"),
                           ("/dev/full", "no regular file"), ("n" * 300, "too long"),
                           ("n" * 240, "too long")]:
            self.refuse(FILE, [word], *self.lookup, "--csv", name)

    @unittest.skipUnless(os.getuid() == 0, "drops the privileges of root")
    def test_missing_permission_is_called_so(self):
        with tempfile.TemporaryDirectory() as directory:
            os.chmod(directory, 0o755)
            result = subprocess.run([program.PROGRAM, *LOOKUP, "--csv", f"{directory}/new.csv"], user=NOBODY,
                                    capture_output=True, text=True, check=False)
            self.assertEqual(result.returncode, FILE, result.stderr)
            self.assertIn("Permission denied", result.stderr)
            result = subprocess.run([program.PROGRAM, *SOLVE, "--output", f"{directory}/new"], user=NOBODY,
                                    capture_output=True, text=True, check=False)
            self.assertEqual(result.returncode, FILE, result.stderr)
            self.assertIn("Permission denied", result.stderr)
            grid = pathlib.Path(directory) / "grid.prm"
            grid.write_text(GRID, encoding="utf-8")
            result = subprocess.run([program.PROGRAM, "sweep", grid, "--database", f"{directory}/new.h5"],
                                    user=NOBODY, capture_output=True, text=True, check=False)
            self.assertEqual(result.returncode, FILE, result.stderr)
            self.assertIn("Permission denied", result.stderr)


class Results(program.TestCase):
    def names(self, directory):
        return sorted(path.name for path in (self.directory / directory).iterdir())

    def result(self, directory):
        return json.loads((self.directory / directory / "result.json").read_text(encoding="utf-8"))

    def test_old_results_are_refused_or_removed(self):
        first = self.document(*SOLVE, "--output", "out")
        written = self.names("out")
        self.assertEqual(sorted(pathlib.Path(file).name for file in first["files"]), written)
        with self.unchanged_files():
            message = self.fail_with(FILE, *SOLVE, "--output", "out")
        self.assertIn("--overwrite", message)

        for name in ["peak-2.vtu", "released.17.vtu", "peak.pvtu", ".peak.vtu.Ab12Cd.tmp"]:
            self.write(f"out/{name}", "old")  # of an earlier solve
        foreign = ["notes.txt", "peak.vtu.bak", "my-curve.csv", "peak-3.vtu"]
        for name in foreign:
            self.write(f"out/{name}", "mine")
        text = self.succeed(*SOLVE, "--output", "out", "--overwrite").stdout
        self.assertEqual(self.names("out"), sorted(written + foreign))
        for name in written:
            self.assertIn(f"out/{name}", text)
        for name in foreign:
            self.assertNotIn(f"out/{name}\n", text)
            self.assertEqual((self.directory / "out" / name).read_text(encoding="utf-8"), "mine")

    def test_a_failed_solve_says_so(self):
        # No number of steps meets that tolerance.
        weak = ["solve", "--E", "10GPa", "--nu", "0.2", "--phi", "20", "--sigma-c", "20MPa", "--resolution", "8",
                "--step-tolerance", "1e-9"]
        result = self.run_program(*weak, "--output", "out")
        self.assertEqual(result.returncode, SOLVER, result.stderr)
        found = self.result("out")
        self.assertEqual(found["status"], "failed")
        self.assertIn(found["reason"], result.stderr)
        self.assertEqual(found["material"]["E"], 1e10)
        self.assertIn("radius", found["scene"])
        self.assertIn("resolution", found["options"])

    def test_fields_are_not_written_through_links(self):
        (self.directory / "out").mkdir()
        target = self.write("target", "kept")
        self.document(*SOLVE, "--output", "out")
        (self.directory / "out" / "peak.vtu").unlink()
        (self.directory / "out" / "peak.vtu").symlink_to(target)
        self.succeed(*SOLVE, "--output", "out", "--overwrite")
        self.assertEqual(target.read_text(encoding="utf-8"), "kept")
        self.assertFalse((self.directory / "out" / "peak.vtu").is_symlink())

    def test_full_disk_is_a_file_error(self):
        def small_files():
            resource.setrlimit(resource.RLIMIT_FSIZE, (60000, 60000))  # the mesh fits, the points do not
            signal.signal(signal.SIGXFSZ, signal.SIG_DFL)
        result = self.run_program(*SOLVE, "--output", "out", preexec_fn=small_files)
        self.assertEqual(result.returncode, FILE, result.stderr)
        self.assertIn("File too large", result.stderr)
        self.assertEqual(len(result.stderr.splitlines()), 1, result.stderr)
        self.assertIn("result.json", self.names("out"))
        self.assertNotIn("points.csv", self.names("out"))
        self.assertEqual(self.result("out")["status"], "failed")


class Manners(program.TestCase):
    def solve_with(self, **variables):
        return self.run_program(*SOLVE, env={**os.environ, **variables})

    def test_nothing_is_left_in_home_or_temporary_folder(self):
        for name in ["home", "tmp"]:
            (self.directory / name).mkdir()
        result = self.solve_with(HOME=str(self.directory / "home"), TMPDIR=str(self.directory / "tmp"))
        self.assertEqual(result.returncode, SUCCESS, result.stderr)
        self.assertEqual([str(path) for path in self.directory.rglob("*") if path.name not in ("home", "tmp")], [])

    def test_what_killed_processes_left_is_removed(self):
        """And what a living one holds is not."""
        folder = self.directory / "tmp"
        folder.mkdir()
        for name in ["dpcontact-aB3dE6.msh", "dpcontact-zzzzzz.msh", "dpcontact-longer.than.ours.msh", "other.msh"]:
            (folder / name).write_text("", encoding="utf-8")
        self.write("state", "").unlink()
        left = self.write(".state.0123456789abcdef.tmp", "half a checkpoint")
        with open(folder / "dpcontact-zzzzzz.msh", encoding="utf-8") as held:
            fcntl.flock(held, fcntl.LOCK_EX)
            result = self.run_program(*SOLVE, "--checkpoint", "state", env={**os.environ, "TMPDIR": str(folder)})
        self.assertEqual(result.returncode, SUCCESS, result.stderr)
        self.assertEqual(sorted(path.name for path in folder.iterdir()),
                         ["dpcontact-longer.than.ours.msh", "dpcontact-zzzzzz.msh", "other.msh"])
        self.assertFalse(left.exists())

    def test_temporary_folder_that_is_missing_or_full(self):
        result = self.solve_with(TMPDIR=str(self.directory / "absent"))
        self.assertEqual(result.returncode, FILE, result.stderr)
        self.assertIn(str(self.directory / "absent"), result.stderr)

        result = self.run_program(*SOLVE, preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (2000, 2000)))
        self.assertEqual(result.returncode, FILE, result.stderr)
        self.assertIn("TMPDIR", result.stderr)

    def test_threads_that_are_no_number(self):
        for text in ["junk", "-1", "0", "", "2x", "99999999999"]:
            with self.subTest(text=text):
                result = self.solve_with(DEAL_II_NUM_THREADS=text)
                self.assertEqual(result.returncode, BAD_INPUT, result.stderr)
                self.assertIn(f"DEAL_II_NUM_THREADS={text}", result.stderr)
        self.assertEqual(self.solve_with(DEAL_II_NUM_THREADS="3").returncode, SUCCESS)
        self.assertEqual(self.run_program("yield", *TYPE_1, env={**os.environ, "DEAL_II_NUM_THREADS": "junk"})
                         .returncode, SUCCESS)

    def test_closed_streams(self):
        """Messages for a standard error that is closed land in no file."""
        self.write("grid.prm", "set E = 10GPa\nset nu = 0.2\nset phi = 30\nset sigma-c = 1GPa\n")
        for streams in ["2>&-", "0<&- 2>&-", "0<&- 1>&- 2>&-"]:
            with self.subTest(streams=streams):
                subprocess.run(["sh", "-c", f"'{program.PROGRAM}' sweep grid.prm --jobs 1 {streams}"], check=False,
                               stdout=subprocess.DEVNULL, cwd=self.directory)
                for path in self.directory.rglob("*"):
                    if path.name == "lock":
                        self.assertEqual(path.read_bytes(), b"")
        closed = subprocess.run(["sh", "-c", f"'{program.PROGRAM}' yield {' '.join(TYPE_1)} >&-"], check=False)
        self.assertEqual(closed.returncode, FILE)


if __name__ == "__main__":
    program.main()
