"""Mistakes that new users make: every one is refused or warned of, with what was understood."""

import json

import grids
import program
from program import BAD_INPUT, CORRUPT, INCOMPLETE, SUCCESS, USAGE

ROCK = {"E": "10GPa", "nu": "0.15", "phi": "25", "sigma-c": "15MPa"}

# What is typed instead, and what the warning says; the answer is given all the same.
WARNED = [
    ({"E": "15MPa", "sigma-c": "10GPa"}, "swapped"),
    ({"E": "30000GPa", "force-max": "1mN"}, "Young's modulus E is 30000 GPa"),
    ({"sigma-c": "4GPa"}, "sigma_c/E is 0.4"),
    ({"phi": "0.61"}, "in degrees, not in radians"),
    ({"radius": "5"}, "sphere radius R is 5 m"),
    ({"force-max": "0.1mN"}, "far from yield"),
    ({"force-max": "1e-9"}, "far from yield"),
    ({"radius": "0.3mm", "force-max": "4.8N", "sigma-c": "100MPa"}, "small strain is left behind"),
]

# What is refused, with words of the message.
REFUSED = [
    ({"E": "10"}, ["E = 10 Pa", "is the unit of one of them, or of E, wrong"]),
    ({"E": "10GPA"}, ["'10GPA' is not a pressure in Pa, kPa, MPa or GPa"]),
    ({"E": "10 G"}, ["not a pressure"]),
    ({"E": "1,5GPa"}, ["'1,5GPa'"]),
    ({"E": "-10GPa"}, ["-10000000000", "greater than 0"]),
    ({"E": "10N"}, ["not a pressure"]),
    ({"nu": "0.5"}, ["less than 0.5"]),
    ({"nu": "15%"}, ["not a number"]),
    ({"nu": "15"}, ["less than 0.5"]),
    ({"nu": "-0.1"}, ["at least 0"]),
    ({"phi": "90"}, ["less than 90"]),
    ({"phi": "25rad"}, ["not an angle"]),
    ({"phi": "25 degrees"}, ["not an angle"]),
    ({"sigma-c": "15"}, ["is the unit of F_max, R or sigma_c wrong", "sigma_c = 15 Pa"]),
    ({"sigma-c": "0"}, ["greater than 0"]),
    ({"radius": "1um"}, ["more than the sphere's R = 1 um"]),
    ({"radius": "0"}, ["greater than 0"]),
    ({"radius": "10m m"}, ["not a length"]),
    ({"force-max": "100kg"}, ["not a force"]),
    ({"force-max": "1e300"}, ["F_max"]),
    ({"force-max": "nan"}, ["force-max"]),
    ({"load-level": "1e300"}, ["more than the sphere's R"]),
    ({"load-level": "10", "force-max": "3N"}, ["load-level and force-max"]),
    ({"phi": "20,30"}, ["not an angle"]),
]


class Plausibility(program.TestCase):
    def lookup(self, changes, *more):
        words = []
        for name, value in {**ROCK, **changes}.items():
            words += [f"--{name}={value}"]
        return self.run_program("lookup", *words, *more)

    def test_doubtful_inputs_are_warned_of(self):
        for changes, words in WARNED:
            with self.subTest(changes):
                result = self.lookup(changes)
                self.assertEqual(result.returncode, SUCCESS, result.stderr)
                self.assertIn("dpcontact: warning: ", result.stderr)
                self.assertIn(words, result.stderr)
                document = json.loads(self.lookup(changes, "--json").stdout)
                self.assertIn(words, document["warnings"])
        self.assertEqual(self.lookup({}).stderr, "")
        self.assertEqual(json.loads(self.lookup({}, "--json").stdout)["warnings"], "")

    def test_impossible_inputs_are_refused(self):
        for changes, words in REFUSED:
            with self.subTest(changes):
                result = self.lookup(changes)
                self.assertEqual(result.returncode, BAD_INPUT, result.stderr)
                self.assertEqual((result.stdout, len(result.stderr.splitlines())), ("", 1))
                for word in words:
                    self.assertIn(word, result.stderr)

    def test_inputs_as_understood_are_said_also_where_it_fails(self):
        message = self.fail_with(BAD_INPUT, "lookup", "--E=10GPa", "--nu=0.15", "--phi=60", "--sigma-c=15MPa")
        self.assertIn("(understood: E = 10 GPa, nu = 0.15, phi = 60°, sigma_c = 15 MPa, R = 100 mm, F_max = 100 N)",
                      message)

    def test_every_command_judges(self):
        rock = [f"--{name}={value}" for name, value in {**ROCK, "phi": "0.5"}.items()]
        coarse = ["--resolution=8", "--step-tolerance=1e-1"]
        grid = self.write("grid.prm", "".join(f"set {word[2:].replace('=', ' = ')}\n" for word in rock + coarse))
        for words in [["yield", *rock], ["solve", *rock, *coarse], ["lookup", *rock],
                      ["yield-surface", *rock[1:]],
                      ["collide", *rock, "--density=2650kg/m3", "--velocity=1", "--row=1,1.4,1.2,1.4"],
                      ["sweep", grid, "--database", "doubtful.h5"], ["sweep", grid, "--dry-run"]]:
            with self.subTest(words):
                result = self.run_program(*words)
                self.assertEqual(result.returncode, SUCCESS, result.stderr)
                self.assertIn("in degrees, not in radians", result.stderr)
        found = self.document("check", "doubtful.h5")
        self.assertEqual((found["errors"], found["warnings"]), (0, 1), found)
        self.assertIn("1 of 1 were computed with a warning", found["findings"][0]["what"])
        self.assertIn("in degrees, not in radians", found["findings"][0]["what"])
        self.succeed("export", "doubtful.h5", "--csv", "doubtful.csv")
        self.assertIn("in degrees, not in radians", (self.directory / "doubtful.csv").read_text(encoding="utf-8"))

    def test_a_grid_is_answered_where_it_can_be(self):
        result = self.lookup({"E": "(10, 20)GPa", "phi": "25, 60"}, "--csv", "laws.csv", "--json")
        self.assertEqual(result.returncode, INCOMPLETE, result.stderr)
        self.assertIn("2 of 4 cases are not answered, as E = 10 GPa, nu = 0.15, phi = 60°", result.stderr)
        found = json.loads(result.stdout)
        self.assertEqual((found["rows"], found["answered"], found["refused"]), (4, 2, 2))
        rows = grids.read_table(self.directory / "laws.csv")
        self.assertEqual([row["status"][:8] for row in rows], ["answered", "phi = 60"] * 2)
        self.assertEqual([bool(row["a"]) for row in rows], [True, False] * 2)
        for row in rows:
            self.assertGreater(float(row["force_yield_N"]), 0)

    def test_what_nothing_yields_in_is_hertz(self):
        self.assertIn("nothing yields: Hertz", self.lookup({"force-max": "3N"}).stdout)
        for criterion in ["mohr-coulomb", "von-mises", "drucker-prager"]:
            with self.subTest(criterion):
                found = self.document("solve", "--criterion", criterion, *[f"--{n}={v}" for n, v in ROCK.items()],
                                      "--load-level=1e-3")
                for name, value in zip("abmn", [1, 1.5, 1, 1.5]):
                    self.assertAlmostEqual(found["fit"][name], value, delta=1e-13)
                self.assertTrue(found["elastic"])

    def test_words_that_are_nearly_right(self):
        for words, hint in [(["solv"], "did you mean solve?"), (["Solve"], "did you mean solve?"),
                            ([], "a command is missing"), (["frobnicate"], "there is no command 'frobnicate'"),
                            (["solve", "--sigma_c", "3MPa"], "did you mean --sigma-c?"),
                            (["solve", "--E"], "--E needs a value"),
                            (["lookup", "--phi", "3", "--phi", "4"], "--phi is given more than once"),
                            (["collide", "--force-max", "3N"], "collide has no option --force-max")]:
            with self.subTest(words):
                message = self.fail_with(USAGE, *words)
                self.assertIn(hint, message)
        self.assertIn("Usage: dpcontact", self.succeed("help").stdout)
        self.assertIn("Usage: dpcontact solve", self.succeed("help", "solve").stdout)

    def test_a_file_of_another_kind(self):
        self.write("measured.csv", "delta,F\n1e-6,3\n")
        for command in ["fit", "check", "export"]:
            with self.subTest(command):
                words = ["--csv", "out.csv"] if command == "export" else []
                self.assertIn("measured.csv is not a database or table that dpcontact wrote",
                              self.fail_with(CORRUPT, command, "measured.csv", *words))

    def test_help_marks_what_is_required(self):
        text = self.succeed("lookup", "--help").stdout
        for words in ["Young's modulus, as 10GPa [required]", "[required without yield-stress]",
                      "radius of each sphere [100 mm]"]:
            self.assertIn(words, " ".join(text.split()))


if __name__ == "__main__":
    program.main()
