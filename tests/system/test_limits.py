"""What every reader refuses: input without end, nested or listed too far, and what `check` calls wrong."""

import hashlib
import json
import os
import pathlib
import resource

import grids
import program
from grids import GRID, SLOW_GRID
from program import BAD_INPUT, CORRUPT, FILE, INCOMPLETE, INTERNAL, SUCCESS

ROOT = pathlib.Path(__file__).resolve().parents[2]
TYPE_1 = ["--E", "10GPa", "--nu", "0.15", "--phi", "25", "--sigma-c", "15MPa"]
MATERIAL = "set E = 10GPa\nset nu = 0.15\nset phi = 25\nset sigma-c = 15MPa\n"
COLLIDE = ["collide", *TYPE_1, "--density", "2500", "--velocity", "1"]
HELD_OUT = ["evaluate", "--held-out-only", "--held-out"]


class ParameterFiles(program.TestCase):
    def refuse(self, code, words, content, command=("yield", "--parameter-file")):
        path = self.write("case.prm", content)
        message = self.fail_with(code, *command, path)
        self.assertLess(len(message), 5000)
        for word in words:
            self.assertIn(word, message)

    def test_includes(self):
        self.write("rest.prm", "set sigma-c = 15MPa\n")
        self.write("case.prm", MATERIAL.replace("set sigma-c = 15MPa", "include rest.prm"))
        self.assertEqual(self.document("yield", "--parameter-file", "case.prm"), self.document("yield", *TYPE_1))
        for line in ["include case.prm", "INCLUDE  \t case.prm", "incl\\\nude case.prm"]:
            self.refuse(BAD_INPUT, ["case.prm", "include itself"], MATERIAL + line + "\n")
        self.write("other.prm", "include case.prm\n")
        self.refuse(BAD_INPUT, ["other.prm", "include itself"], "include other.prm\n")
        os.mkfifo(self.directory / "pipe")
        for name, word in [("pipe", "no regular file"), ("/dev/zero", "no regular file"),
                           (".", "is a directory"), ("absent.prm", "No such file")]:
            self.refuse(FILE, [word], f"include {name}\n")
            self.refuse(FILE, [word], f"incl\\\nude {name}\n")

    def test_lines_that_go_on_keep_their_numbers(self):
        self.refuse(BAD_INPUT, ["case.prm:4: ", "nonsense"], "set E = \\\n 10GPa\n# comment\nset nonsense = 1\n")

    def test_sizes(self):
        self.refuse(BAD_INPUT, ["bytes", "16777216"], "#" * 17000000)
        self.refuse(BAD_INPUT, ["case.prm:1: "], "x" * 1000000)
        self.refuse(BAD_INPUT, ["case.prm:1: "], "set E = " + "9" * 1000000 + "x")

    def test_lists_and_grids(self):
        sweep = ("sweep", "--dry-run")
        values = ", ".join(f"{1 + i}GPa" for i in range(100001))
        self.refuse(BAD_INPUT, ["100001 values", "100000"], f"set E = {values}\n", sweep)
        self.refuse(BAD_INPUT, ["'1GPa' stands twice"],
                    MATERIAL.replace("E = 10GPa", f"E = {values.rsplit(', ', 2)[0]},1GPa"), sweep)
        axes = {"E": "{}GPa", "sigma-c": "{}MPa", "radius": "{}mm", "force-max": "{}N"}
        grid = "".join(f"set {name} = " + ",".join(unit.format(1 + i) for i in range(1000)) + "\n"
                       for name, unit in axes.items())
        self.refuse(BAD_INPUT, ["1000000 cases"], "set nu = 0.15\nset phi = 25\n" + grid, sweep)


class Inputs(program.TestCase):
    def test_what_is_no_regular_file(self):
        os.mkfifo(self.directory / "pipe")
        (self.directory / "folder").mkdir()
        self.write("one.csv", "")
        for name in ["pipe", "/dev/zero", "folder"]:
            for command in [["yield", "--parameter-file", name], ["collide", *TYPE_1, "--density", 1, "--velocity", 1,
                                                                  "--table", name],
                            ["lookup", *TYPE_1, "--database", name], ["check", name],
                            ["compare", name, "one.csv"], ["validate", name], ["table", name, "--csv", "new.csv"],
                            ["evaluate", "--universal", name], [*HELD_OUT, name]]:
                with self.subTest(command=command):
                    message = self.fail_with(FILE, *command)
                    self.assertRegex(message, "no regular file|is a directory")


class Rows(grids.TestCase):
    """What stands beside a database, altered where no digest is needed."""

    def setUp(self):
        super().setUp()
        self.grid = self.write("grid.prm", GRID)
        self.sweep = ["sweep", self.grid, "--jobs", "2", "--database", "table.h5"]
        self.succeed(*self.sweep)
        self.before = self.table("table.h5")
        self.rows = self.directory / "table.h5.rows"

    def test_brackets_without_end(self):
        for text in ["[" * 300000, "[" * 300000 + "]" * 300000, '{"content":' * 300000]:
            row = next(path for path in sorted(self.rows.glob("*.json")) if path.name != "settings.json")
            row.write_text(text, encoding="utf-8")
            self.succeed(*self.sweep)  # set aside, and taken from the database or computed again
            self.assertEqual(self.table("table.h5"), self.before)
        (self.rows / "settings.json").write_text("[" * 300000, encoding="utf-8")
        self.assertIn("nested deeper", self.fail_with(CORRUPT, *self.sweep))

    def test_pipes(self):
        row = next(path for path in sorted(self.rows.glob("*.json")) if path.name != "settings.json")
        row.unlink()
        os.mkfifo(row)
        self.assertIn("no regular file", self.run_program(*self.sweep, timeout=300).stderr)
        digest = self.directory / "table.h5.sha256"
        digest.unlink()
        os.mkfifo(digest)
        self.assertIn("no regular file", self.fail_with(FILE, "export", "table.h5", "--csv", "new.csv"))


class Memory(grids.TestCase):
    """A machine without memory says nothing about a material."""

    def test_no_row_fails_for_want_of_memory(self):
        grid = self.write("grid.prm", SLOW_GRID)
        sweep = ["sweep", grid, "--jobs", "1", "--database"]
        self.succeed(*sweep, "calm.h5")
        limits = range(300, 1000, 50)  # MiB: the program alone takes some 500 of address space
        outcomes = set()
        for limit in limits:
            size = limit << 20
            result = self.run_program(*sweep, "table.h5", timeout=300,
                                      preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (size, size)))
            outcomes.add(result.returncode)
            self.assertNotEqual(result.returncode, INCOMPLETE, result.stderr)
            for content in self.stored_rows("table.h5").values():
                self.assertIn(b'"status": "converged"', content)
        self.assertGreater(len(outcomes), 1)  # some of these limits are too low, others are not
        self.succeed(*sweep, "table.h5")
        self.assertEqual(self.table("table.h5"), self.table("calm.h5"))

    def test_lookup_by_kriging_ends(self):
        """OpenBLAS would wait for its buffer for ever."""
        outcomes = set()
        for limit in range(600, 1000, 20):
            size = limit << 20
            result = self.run_program("lookup", *TYPE_1, "--method", "kriging", timeout=300,
                                      preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (size, size)))
            outcomes.add(result.returncode)
        self.assertIn(SUCCESS, outcomes)
        self.assertIn(INTERNAL, outcomes)


class HeldOut(program.TestCase):
    def test_nested_too_deep(self):
        for text in ["[" * 300000, "[" * 300000 + "]" * 300000, '{"box":' * 100 + "1" + "}" * 100]:
            self.assertIn("nested deeper", self.fail_with(CORRUPT, *HELD_OUT, self.write("deep.json", text)))
        for text in ["", "{", '"[[[', "{} x"]:
            self.assertIn("is not JSON", self.fail_with(CORRUPT, *HELD_OUT, self.write("none.json", text)))

    def test_branches_without_points(self):
        whole = json.loads((ROOT / "runs" / "studies" / "held_out_first.json").read_text(encoding="utf-8"))
        rows = [row for row in whole["box"] if "failed" not in row][:2]
        for part in ["loading", "unloading"]:
            for branch in [[], rows[0][part][:1], {}]:
                changed = dict(whole, box=[rows[1], dict(rows[0], **{part: branch})])
                self.fail_with(CORRUPT, *HELD_OUT, self.write("held_out.json", json.dumps(changed)))
        self.fail_with(CORRUPT, *HELD_OUT, self.write("held_out.json", "[1]"))


class Verdict(program.TestCase):
    """What `check` calls wrong no reader takes."""

    def table_with(self, column, change):
        lines = (ROOT / "database" / "universal.csv").read_text(encoding="utf-8").splitlines()
        head = next(i for i, line in enumerate(lines) if not line.startswith("#"))
        cells = lines[head + 500].split(",")
        place = lines[head].split(",").index(column)
        cells[place] = repr(change(float(cells[place])))
        lines[head + 500] = ",".join(cells)
        path = self.write("table.csv", "\n".join(lines) + "\n")
        digest = hashlib.sha256(path.read_bytes()).hexdigest()
        self.write("table.csv.sha256", f"{digest}  table.csv\n")
        return path

    def test_wrong_tables(self):
        for column, change in [("n_law", lambda x: 10 * x), ("n_law", lambda x: 1e308), ("m", lambda x: 2 * x)]:
            path = self.table_with(column, change)
            with self.subTest(column=column):
                self.assertEqual(self.run_program("check", path).returncode, INCOMPLETE)
                self.fail_with(CORRUPT, *COLLIDE, "--table", path)
                self.fail_with(CORRUPT, "validate", "--histories", 1, "--table", path)
                self.fail_with(CORRUPT, "lookup", *TYPE_1, "--database", path)
                self.fail_with(CORRUPT, "evaluate", "--held-out-only", "--universal", path)
        self.succeed(*COLLIDE, "--table", self.table_with("m", lambda x: x))


if __name__ == "__main__":
    program.main()
