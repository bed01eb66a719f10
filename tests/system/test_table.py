"""What stands on a table: lookup, evaluate, check, and what export writes."""

import csv
import json
import pathlib
import shutil
import subprocess

import program
from program import BAD_INPUT, CORRUPT, INCOMPLETE, SUCCESS

DATABASE = pathlib.Path(__file__).resolve().parents[2] / "database"
TYPE_1 = ["--E", "10GPa", "--nu", "0.15", "--phi", "25", "--sigma-c", "15MPa"]
NAMES = ["a", "b", "m", "n"]

# Table 2 of Wang et al. 2018 as printed: 1, E, nu, phi^2, phi, sigma_c^2, sigma_c
TABLE_2 = {"a": (.5398, .0010279, -.047213, 7.65e-5, -.0061476, 5.5848e-5, -.0044023),
           "b": (1.3087, -.0008713, .044259, -7.6019e-5, .006412, -3.8951e-5, .0033763)}


def table(name):
    with open(DATABASE / name, encoding="utf-8") as stream:
        return list(csv.DictReader(line for line in stream if not line.startswith("#")))


class Lookup(program.TestCase):
    def lookup(self, *arguments):
        return self.document("lookup", *arguments)

    def test_a_node_of_the_universal_table_is_given_back(self):
        rows = [row for row in table("universal.csv") if 1 < float(row["load_level"]) < 5000]
        self.assertGreater(len(rows[::211]), 5)
        for row in rows[::211]:
            # Another stiffness, strength and radius than the table's: similarity.
            found = self.lookup("--E", "23GPa", "--sigma-c", "7MPa", "--radius", "3mm",
                                "--nu", row["nu"], "--phi", row["phi_deg"],
                                "--load-level", row["load_level"])
            for name in NAMES:  # the file has 16 digits
                self.assertAlmostEqual(found["fit"][name] / float(row[name]), 1, delta=1e-9)

    def test_interpolation_meets_the_rows(self):
        rows = [row for row in table("wang2018.csv") if row["nu"] == "0.2" or row["nu"] == "0.1"]
        self.assertGreater(len(rows[::17]), 5)
        for row in rows[::17]:
            material = ["--E", row["E_Pa"], "--nu", row["nu"], "--phi", row["phi_deg"],
                        "--sigma-c", row["sigma_c_Pa"]]
            # Natural neighbours give a node's own value; Kriging solves a system for it.
            for method, tolerance in [("natural-neighbour", 1e-9), ("kriging", 1e-5)]:
                found = self.lookup(*material, "--method", method)["fit"]
                for name in NAMES:
                    self.assertAlmostEqual(found[name] / float(row[name]), 1, delta=tolerance)

    def test_table_2_as_printed(self):
        found = self.lookup(*TYPE_1, "--method", "table-2")
        terms = (1, 10, .15, 25 ** 2, 25, 15 ** 2, 15)
        for name, coefficients in TABLE_2.items():
            value = sum(c * t for c, t in zip(coefficients, terms))
            if name == "b":
                self.assertAlmostEqual(found["fit"]["b"], value, delta=1e-9)
            else:
                self.assertAlmostEqual(found["published_convention"]["a"], value, delta=1e-9)

    def test_objects_are_those_of_solve(self):
        def shape(solved, found, path):
            """Every name of `found` is one of `solved`, with a value of the same kind."""
            for name, value in found.items():
                self.assertIn(name, solved, path)
                self.assertIs(type(value), type(solved[name]), path + [name])
                if isinstance(value, dict):
                    shape(solved[name], value, path + [name])

        def empty(document):
            values = document.values() if isinstance(document, dict) else document
            return any(value in (None, {}, []) or isinstance(value, (dict, list)) and empty(value)
                       for value in values)

        solved = self.document("solve", *TYPE_1)
        for method in ["similarity", "kriging", "natural-neighbour", "regression", "table-2"]:
            found = self.lookup(*TYPE_1, "--method", method, "--curve", 20)
            with self.subTest(method):
                self.assertFalse(empty(found), found)
                for name in ["material", "scene", "yield"]:
                    self.assertEqual(found[name], solved[name])
                for name in ["fit", "published_convention"]:
                    shape(solved[name], found[name], [name])
                self.assertEqual(sorted(found["published_convention"]), sorted(solved["published_convention"]))
                self.assertEqual(found["published_convention"]["approach_yield"],
                                 solved["published_convention"]["approach_yield"])
                if method == "table-2":  # the paper says nothing of its own
                    self.assertFalse([name for name in found if "uncertainty" in name and "yield" not in name])
                else:
                    for name in NAMES:
                        self.assertGreater(found["uncertainty"][name], 0)
                        self.assertGreater(found["published_uncertainty"][name], 0)
                    self.assertGreater(found["residual_approach_uncertainty"], 0)
                    self.assertGreater(found["peak"]["approach_uncertainty"], 0)
                for name in ["a", "m"]:
                    exponent = found["fit"]["b" if name == "a" else "n"]
                    self.assertAlmostEqual(found["published_convention"][name],
                                           found["fit"][name] * 2 ** -exponent, delta=1e-12)
                self.assertGreater(min(found["yield_uncertainty"].values()), 0)
                loading, unloading = (found["curve"][name] for name in ("loading", "unloading"))
                self.assertEqual((len(loading), len(unloading)), (21, 21))
                # By similarity the loading curve is the master curve, which is known better than its fit.
                tolerance = 1e-9 if method == "similarity" else 1e-6
                self.assertAlmostEqual(loading[-1]["force"] / 100, 1, delta=tolerance)
                self.assertAlmostEqual(unloading[0]["approach"] / loading[-1]["approach"], 1, delta=1e-12)
                self.assertEqual(unloading[-1]["force"], 0)
        # What both know is the same within what both say; type 1 is between the table's nodes.
        found = self.lookup(*TYPE_1)
        for name in NAMES:
            self.assertAlmostEqual(found["fit"][name], solved["fit"][name],
                                   delta=found["uncertainty"][name] + solved["error"][name]["total"])
        self.assertNotIn("curve", found)

    def test_lists_make_a_table(self):
        grid = self.write("grid.prm", "set E = 10GPa, 20GPa\nset nu = 0.15\nset phi = 25, 37\nset sigma-c = 15MPa\n")
        for method in ["similarity", "regression", "table-2"]:
            self.succeed("lookup", "--parameter-file", grid, "--method", method, "--csv", "laws.csv")
            with open(self.directory / "laws.csv", encoding="utf-8") as stream:
                rows = list(csv.DictReader(line for line in stream if not line.startswith("#")))
            self.assertEqual([(float(row["E_Pa"]), float(row["phi_deg"])) for row in rows],
                             [(1e10, 25), (1e10, 37), (2e10, 25), (2e10, 37)])
            single = self.lookup("--E", "20GPa", "--nu", "0.15", "--phi", "25", "--sigma-c", "15MPa", "--method", method)
            row = rows[2]
            self.assertEqual(row["method"], method)
            for name in NAMES:
                self.assertEqual(float(row[name]), single["fit"][name])
                uncertainty = single.get("uncertainty", {}).get(name)
                self.assertEqual(float(row[f"{name}_uncertainty"] or "nan") if uncertainty else row[f"{name}_uncertainty"],
                                 uncertainty or "")
            for column, value in [("a_published", single["published_convention"]["a"]),
                                  ("m_published", single["published_convention"]["m"]),
                                  ("force_yield_N", single["yield"]["force"]),
                                  ("approach_yield_m", single["yield"]["approach"]),
                                  ("load_level", single["load_level"]),
                                  ("approach_residual_m", single["residual_approach"])]:
                self.assertEqual(float(row[column]), value)
        self.fail_with(BAD_INPUT, "lookup", "--parameter-file", grid)  # a list is no scene
        self.fail_with(BAD_INPUT, "lookup", "--parameter-file", grid, "--csv", "laws.csv", "--curve", "9")
        self.assertIn("phi", self.fail_with(BAD_INPUT, "lookup", "--parameter-file", grid, "--phi", "60,70", "--csv", "new.csv"))
        self.assertFalse((self.directory / "new.csv").exists())

    def test_outside_the_data(self):
        for name, arguments in [("phi", ["--phi", "60"]), ("nu", ["--nu", "0.47"]),
                                ("load", ["--load-level", "20000"])]:
            values = dict(zip(TYPE_1[::2], TYPE_1[1::2]))
            values.update([arguments])
            words = [word for pair in values.items() for word in pair]
            message = self.fail_with(BAD_INPUT, "lookup", *words)
            self.assertIn(name, message)
            self.assertIn("--extrapolate", message)
            found = self.lookup(*words, "--extrapolate")
            self.assertIn("m", found["fit"])
            for known in ["uncertainty", "published_uncertainty", "uncertainty_parts"]:
                self.assertNotIn(known, found)  # as the message says
        self.assertIn("uncertainty", self.lookup(*TYPE_1, "--extrapolate"))
        message = self.fail_with(BAD_INPUT, "lookup", *TYPE_1[:-1], "80MPa", "--method", "kriging")
        self.assertIn("sigma", message)


class Join(program.TestCase):
    def sweep(self, name, phi, resolution):
        grid = self.write(f"{name}.prm", f"set E = 100GPa\nset nu = 0.1, 0.3\nset phi = {phi}\n"
                          "set sigma-c = 100Pa\nset load-level = 0.5, 2, 4, 8\n"
                          f"set resolution = {resolution}\nset step-tolerance = 1e-2\n")
        self.succeed("sweep", grid, "--mode", "families", "--database", f"{name}.h5")

    def nodes(self, name):
        with open(self.directory / name, encoding="utf-8") as stream:
            rows = csv.DictReader(line for line in stream if not line.startswith("#"))
            return [{column: float(value) for column, value in row.items()} for row in rows]

    def test_a_denser_grid_needs_only_what_is_new(self):
        self.sweep("coarse", "20, 40", 8)
        self.sweep("new", "30", 8)
        self.sweep("dense", "20, 30, 40", 8)
        self.succeed("table", "coarse.h5", "--csv", "coarse.csv")
        self.succeed("table", "new.h5", "--join", "coarse.csv", "--csv", "joined.csv")
        self.succeed("table", "dense.h5", "--csv", "dense.csv")
        joined, dense = self.nodes("joined.csv"), self.nodes("dense.csv")
        self.assertEqual(len(joined), 2 * 3 * 4)
        self.assertEqual(len(joined), len(dense))
        for one, other in zip(joined, dense):
            for column, value in one.items():
                self.assertAlmostEqual(value, other[column], delta=1e-9 + 1e-7 * abs(value))

        self.sweep("finer", "30", 10)
        message = self.fail_with(BAD_INPUT, "table", "finer.h5", "--join", "coarse.csv", "--csv",
                                 "no.csv")
        self.assertIn("settings", message)
        # A table in which nodes stand twice is none.
        self.fail_with(BAD_INPUT, "table", "coarse.h5", "--join", "coarse.csv", "--csv", "no.csv")


class Evaluate(program.TestCase):
    def test_the_papers_evaluation(self):
        found = self.document("evaluate")
        self.assertEqual(len(found["table_4"]), 2)
        for errors in found["table_4"].values():
            for name in NAMES:
                self.assertLess(errors["similarity"][name], errors["paper_interpolation"][name])
        left_out = found["leave_one_out"]
        self.assertLess(left_out["similarity"]["rms"]["m"], left_out["regression"]["rms"]["m"])

    def test_held_out_materials(self):
        """The claims on the universal table, on curves computed after it had been settled."""
        found = self.document("evaluate", "--held-out-only")["summary"]
        self.assertGreaterEqual(found["materials"], 200)
        self.assertEqual(found["failed"], 0)
        self.assertLess(found["loading"]["rms"], .003)
        self.assertEqual(found["loading"]["within"], 1)
        self.assertLess(found["unloading"]["rms"], .005)
        # of the others a power law through the peak is .4 % off itself
        self.assertGreaterEqual(found["unloading"]["within"], .985)
        self.assertLess(found["law_residual"]["rms"], .0025)
        for name in NAMES:
            with self.subTest(coefficient=name):
                self.assertGreaterEqual(found[name]["compared"], 180)
                self.assertLess(found[name]["median"], .003)
                self.assertGreaterEqual(found[name]["covered"], .9)
                self.assertLess(found[name]["median_ratio"], 4)
                # apart from the error: how well a power law describes the curve at all
                self.assertGreater(found[name]["misfit_median"], 0)

    def test_held_out_materials_are_not_those_of_the_calibration(self):
        script = program.load_script("held_out")
        calibrate = (program.STUDIES / "calibrate").read_text(encoding="utf-8")
        drawn = {}
        for name, curves in script.SETS.items():
            self.assertEqual(f'"{name}"' in calibrate, name != "verification", name)
            found = json.loads((program.STUDIES / f"{curves.name}.json").read_text(encoding="utf-8"))
            self.assertEqual(found["seed"], curves.seed, name)
            self.assertEqual(found["command"], f"runs/studies/held_out --set {name}")
            drawn[name] = [row["material"] for part in ("box", "paper") for row in found[part]]
            self.assertEqual(drawn[name], script.materials(curves.seed, curves.count) +
                             script.paper_materials(curves.seed), name)
        verified = drawn.pop("verification")
        calibrated = sum(drawn.values(), [])
        self.assertFalse([material for material in verified if material in calibrated])
        nodes = {(row["nu"], row["phi_deg"]) for row in table("universal.csv")}
        self.assertFalse([material for material in verified
                          if (str(material["nu"]), str(material["phi"])) in nodes])


class Check(program.TestCase):
    def test_shipped_tables_are_right(self):
        for name in ["universal.csv", "wang2018.csv"]:
            found = self.document("check", DATABASE / name)
            self.assertEqual((found["errors"], found["warnings"]), (0, 0), found)

    def test_a_wrong_number_is_found(self):
        copy = self.directory / "universal.csv"
        content = (DATABASE / "universal.csv").read_text(encoding="utf-8")
        copy.write_text(content, encoding="utf-8")
        digest = self.directory / "universal.csv.sha256"
        shutil.copy(DATABASE / "universal.csv.sha256", digest)
        self.succeed("check", copy)

        row = next(row for row in table("universal.csv") if float(row["load_level"]) > 100)
        for column in ["m", "m_law"]:
            wrong = content.replace(row[column], str(1.5 * float(row[column])))
            self.assertNotEqual(wrong, content)
            copy.write_text(wrong, encoding="utf-8")
            self.fail_with(CORRUPT, "check", copy)
            self.fail_with(CORRUPT, "lookup", *TYPE_1, "--database", copy)
            name = subprocess.run(["sha256sum", "universal.csv"], cwd=self.directory, text=True,
                                  capture_output=True, check=True).stdout
            digest.write_text(name, encoding="utf-8")
            result = self.run_program("check", copy)
            self.assertEqual(result.returncode, INCOMPLETE, result.stdout + result.stderr)

    def test_files_that_are_no_tables(self):
        for content in ["", "a,b\n1,2\n", "\0\1\2", "# dpcontact: universal table\n"]:
            path = self.write("wrong.csv", content)
            result = self.run_program("check", path)
            self.assertIn(result.returncode, (4, BAD_INPUT, CORRUPT), result.stderr)
            self.assertTrue(result.stderr.startswith("dpcontact: error: "), result.stderr)


class Exports(program.TestCase):
    def test_other_readers_find_the_same_numbers(self):
        grid = self.write("grid.prm", "set E = 10GPa\nset nu = 0.15\nset phi = 25\n"
                          "set sigma-c = 15MPa, 60MPa\nset resolution = 12\n"
                          "set step-tolerance = 1e-2\n")
        self.succeed("sweep", grid, "--database", "g.h5")
        self.succeed("check", "g.h5")
        self.succeed("export", "g.h5", "--csv", "g.csv", "--datapackage", "p.json", "--xlsx",
                     "g.xlsx", "--json-table", "g.json", "--datacite", "d.json")
        reader = pathlib.Path(__file__).parent / "read_exports.py"
        # Debian's python has the readers.
        result = subprocess.run(["/usr/bin/python3", str(reader), "g.h5", "g.csv", "p.json",
                                 "g.xlsx", "g.json"], cwd=self.directory, capture_output=True,
                                text=True)
        self.assertEqual(result.returncode, SUCCESS, result.stderr)
        cited = json.loads((self.directory / "d.json").read_text(encoding="utf-8"))
        self.assertEqual(cited["relatedIdentifiers"][0]["relatedIdentifier"],
                         "10.1155/2018/6783791")


if __name__ == "__main__":
    program.main()
