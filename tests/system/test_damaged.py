"""Databases and tables that are not what the program wrote, given to every command that reads one."""

import hashlib
import pathlib
import random
import shutil
import subprocess

import grids
import program
from program import CORRUPT, FILE, INCOMPLETE, MISMATCH, SUCCESS

TABLES = pathlib.Path(__file__).resolve().parents[2] / "database"
ROCK = ["--E", "10GPa", "--nu", "0.15", "--phi", "25", "--sigma-c", "15MPa"]
DRIVER = ["--density", "2600", "--velocity", "0.1"]

# Every command that opens a database, which stands in for {}.
OF_DATABASE = ["fit {}", "fit {} --write", "export {} --csv out.csv", "compare {} good.h5", "compare good.h5 {}",
               "check {}", "validate {}", "table {} --csv out.csv",
               "lookup --method kriging --database {} --E 10GPa --nu .2 --phi 25 --sigma-c 20MPa",
               "evaluate --rows {}", "sweep grid.prm --database {}"]
OF_UNIVERSAL = ["check {}", "lookup --database {}", "evaluate --universal {}", "evaluate --held-out-only --universal {}",
                "validate good.h5 --table {}", "collide --table {}"]
OF_ROWS = ["check {}", "export {} --json-table out.json", "lookup --method kriging --database {}", "evaluate --rows {}"]


def sign(path):
    """A digest that fits whatever stands there."""
    digest = hashlib.sha256(path.read_bytes()).hexdigest()
    path.with_name(path.name + ".sha256").write_text(f"{digest}  {path.name}\n", encoding="utf-8")


class Damaged(grids.TestCase):
    def setUp(self):
        super().setUp()
        self.write("grid.prm", grids.GRID)
        self.succeed("sweep", "grid.prm", "--database", "good.h5")

    def words(self, command, name):
        words = command.format(name).split()
        if words[0] in ("lookup", "collide") and "--E" not in words:
            words += ROCK
        return words + (DRIVER if words[0] == "collide" else [])

    def refuse(self, words, *parts):
        """One line that says what is wrong, nothing on standard output, no file touched."""
        with self.subTest(" ".join(words)), self.unchanged_files():
            result = self.run_program(*words)
            self.assertEqual(result.returncode, CORRUPT, result.stderr)
            self.assertEqual(result.stdout, "")
            errors = [line for line in result.stderr.splitlines() if line.startswith("dpcontact: error: ")]
            self.assertEqual(len(errors), 1, result.stderr)
            for part in parts:
                self.assertIn(part, errors[0])

    def copies(self, source, name):
        """(path, part of the message) of each way in which a digest does not hold, one at a time."""
        path = self.directory / name
        digest = path.with_name(f"{name}.sha256")
        content = source.read_bytes()
        shutil.copy(source.with_name(f"{source.name}.sha256"), digest)
        altered = bytearray(content)
        altered[len(altered) // 2] ^= 1
        path.write_bytes(altered)
        yield name, "truncated or altered: its SHA-256 is"
        path.write_bytes(content[:len(content) // 3])
        yield name, "truncated or altered: its SHA-256 is"
        path.write_bytes(b"")
        yield name, "truncated or altered: its SHA-256 is"
        path.write_bytes(content)
        digest.write_text("no digest\n", encoding="utf-8")
        yield name, f"{name}.sha256 is damaged"
        digest.unlink()
        yield name, f"{name}.sha256 is missing"

    def test_every_command_refuses_a_digest_that_does_not_hold(self):
        for source, commands in [(self.directory / "good.h5", OF_DATABASE), (TABLES / "universal.csv", OF_UNIVERSAL),
                                 (TABLES / "wang2018.csv", OF_ROWS)]:
            for i, (name, message) in enumerate(self.copies(source, f"bad{source.suffix}")):
                # Altered and without a digest: by all commands; the others by two of them.
                for command in commands if i in (0, 4) else commands[:2]:
                    self.refuse(self.words(command, name), name, message)

    def test_foreign_files_with_a_digest_that_fits(self):
        header = b"\x89HDF\r\n\x1a\n"
        for content in [header + bytes(4000), b"", b"plain text\n", (TABLES / "universal.csv").read_bytes()]:
            path = self.directory / "bad.h5"
            path.write_bytes(content)
            sign(path)
            for command in OF_DATABASE if content.startswith(header) else OF_DATABASE[:2]:
                self.refuse(self.words(command, path.name), "bad.h5 is not a database of this program")

    def test_a_sweep_writes_a_damaged_database_again_from_its_rows(self):
        before = self.table("good.h5")
        content = bytearray((self.directory / "good.h5").read_bytes())
        content[100:200] = bytes(100)
        (self.directory / "good.h5").write_bytes(content)
        result = self.succeed("sweep", "grid.prm", "--database", "good.h5")
        self.assertIn("assembling it again", result.stderr)
        self.assertEqual(self.table("good.h5"), before)

    def test_altered_databases_with_a_digest_that_fits(self):
        """Refused with a documented code, or read as the same numbers."""
        self.succeed("export", "good.h5", "--csv", "good.csv")
        whole = (self.directory / "good.h5").read_bytes()
        numbers = grids.read_table(self.directory / "good.csv")
        draw = random.Random(20184)
        path = self.directory / "bad.h5"
        refused = 0
        for _ in range(12):
            content = bytearray(whole)
            at, length = draw.randrange(len(whole)), draw.randrange(1, 2000)
            how = draw.choice(["flip", "noise", "zeros", "cut"])
            if how == "flip":
                content[at] ^= 1 << draw.randrange(8)
            elif how == "cut":
                del content[at:]
            else:
                size = len(content[at:at + length])
                content[at:at + length] = draw.randbytes(size) if how == "noise" else bytes(size)
            path.write_bytes(content)
            sign(path)
            with self.subTest(f"{how} of {length} at {at}"):
                exported = self.run_program("export", "bad.h5", "--csv", "bad.csv")
                checked = self.run_program("check", "bad.h5")
                if exported.returncode == SUCCESS:
                    self.assertEqual(grids.read_table(self.directory / "bad.csv"), numbers)
                    self.assertIn(checked.returncode, (SUCCESS, INCOMPLETE), checked.stderr)
                else:
                    refused += 1
                    for result in exported, checked:
                        self.assertIn(result.returncode, (CORRUPT, MISMATCH), result.stderr)
                        self.assertTrue(result.stderr.startswith("dpcontact: error: "), result.stderr)
        self.assertGreater(refused, 5)

    def test_a_table_of_wrong_numbers_with_a_digest_that_fits(self):
        """What `check` grades as an error, no command uses."""
        content = (TABLES / "universal.csv").read_text(encoding="utf-8").splitlines()
        head = next(i for i, line in enumerate(content) if not line.startswith("#"))
        names = content[head].split(",")
        readers = [command for command in OF_UNIVERSAL if command not in ("check {}", "evaluate --universal {}")]
        for name, wrong in [("m", "-1"), ("approach", "1e9"), ("n", "15"), ("m_law", "-1"), ("n_law", "15"),
                            ("n_law", "1e308"), ("nu", "0.7"), ("rmse_loading", "1e308")]:
            lines = list(content)
            cells = lines[head + 500].split(",")
            cells[names.index(name)] = wrong
            lines[head + 500] = ",".join(cells)
            path = self.write("bad.csv", "\n".join(lines) + "\n")
            sign(path)
            for command in readers:
                self.refuse(self.words(command, "bad.csv"), "bad.csv")
            self.assertIn(self.run_program("check", "bad.csv").returncode, (CORRUPT, INCOMPLETE))

    def test_an_excerpt_of_a_table_is_judged_by_what_it_has(self):
        """Without its title and comments a table has nothing but its numbers; these must still be a contact's."""
        content = (TABLES / "universal.csv").read_text(encoding="utf-8").splitlines()
        lines = [line for line in content if not line.startswith("#")]
        path = self.write("bad.csv", "\n".join(lines) + "\n")
        sign(path)
        self.assertIn("an excerpt", self.succeed("check", "bad.csv").stdout)
        self.succeed(*self.words("collide --table {}", "bad.csv"))
        cells = lines[500].split(",")
        cells[lines[0].split(",").index("n_law")] = "15"
        lines[500] = ",".join(cells)
        path.write_text("\n".join(lines) + "\n", encoding="utf-8")
        sign(path)
        for command in "check {}", "collide --table {}", "validate good.h5 --table {}":
            self.refuse(self.words(command, "bad.csv"), "n_law must be from 0.9 to 1.7")

    def alter(self, dataset, place, factor):
        """Multiplies a number of good.h5 in bad.h5, by HDF5's own means, and signs it."""
        shutil.copy(self.directory / "good.h5", self.directory / "bad.h5")
        # Debian's interpreter has h5py.
        subprocess.run(["/usr/bin/python3", "-c", f"import h5py; h5py.File('bad.h5', 'r+')['{dataset}'][{place}] *= {factor}"],
                       cwd=self.directory, check=True)
        sign(self.directory / "bad.h5")

    def test_a_database_of_wrong_numbers_with_a_digest_that_fits(self):
        self.succeed("check", "good.h5")
        for dataset, place, factor in [("rows/n", 0, 10), ("rows/plastic_volume_m3", 0, 1e300),
                                       ("rows/m_standard_error", 0, 10), ("rows/force_yield_N", 0, 10),
                                       ("curves/0/loading/force", 5, 3)]:
            self.alter(dataset, place, factor)
            self.assertEqual(self.run_program("check", "bad.h5").returncode, INCOMPLETE)
            for command in "validate {}", "table {} --csv out.csv", "lookup --method kriging --database {}", \
                           "evaluate --rows {}":
                self.refuse(self.words(command, "bad.h5"), "bad.h5", "`dpcontact check` lists what is wrong")

    def test_held_out_curves_that_are_none(self):
        for content in ["", "[1", "{}", "[]", "{\"curves\": 3}"]:
            path = self.write("held.json", content)
            self.refuse(["evaluate", "--held-out-only", "--held-out", path.name], "held")

    def test_a_missing_database_is_a_file_that_cannot_be_read(self):
        for command in OF_DATABASE[:-1]:
            self.assertIn("absent.h5", self.fail_with(FILE, *self.words(command, "absent.h5")))


if __name__ == "__main__":
    program.main()
