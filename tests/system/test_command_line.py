"""The command line: documents, messages and exit codes that need no computation of a curve."""

import array
import base64
import csv
import json
import math
import re
import shutil
import subprocess
import zlib

import program
from program import BAD_INPUT, FILE, SUCCESS, USAGE

TYPE_1 = ["--E", "10GPa", "--nu", "0.15", "--phi", "25", "--sigma-c", "15MPa"]
TYPE_2 = ["--E", "10GPa", "--nu", "0.25", "--phi", "35", "--sigma-c", "25MPa"]


def with_value(option, value):
    """Type 1 with one option changed."""
    options = list(TYPE_1) + ["--radius", "0.1", "--force-max", "100"]
    options[options.index(option) + 1] = value
    return options


TYPE_1_DOCUMENT = {"criterion": "drucker-prager", "E": 1e10, "nu": 0.15, "phi_deg": 25,
                   "sigma_c": 15e6, "flow_stress_ratio": 1, "dilation_deg": 25, "hardening": 0}


class Yield(program.TestCase):
    def test_table_3(self):
        # Wang et al. (2018), table 3, to all printed digits; its approach is per sphere, ours mutual.
        for options, force, approach_mm in [(TYPE_1, 9.056, 0.00164), (TYPE_2, 84.450, 0.00706)]:
            found = self.document("yield", *options)["yield"]
            self.assertAlmostEqual(found["force"], force, delta=0.0005)
            self.assertAlmostEqual(found["approach"] / 2 * 1e3, approach_mm, delta=0.000005)

    def test_mutual_approach(self):
        # eq (13) for table 3's materials; half a unit of the last digit
        self.assertAlmostEqual(self.document("yield", *TYPE_1)["yield"]["approach"], 3.2792e-6,
                               delta=0.5e-10)
        self.assertAlmostEqual(self.document("yield", *TYPE_2)["yield"]["approach"], 14.129e-6,
                               delta=0.5e-9)

    def test_document(self):
        found = self.document("yield", *TYPE_1)
        self.assertEqual(found["material"], TYPE_1_DOCUMENT)
        self.assertEqual(found["scene"], {"radius": 0.1, "force_max": 100})
        self.assertLessEqual({"force", "approach", "pressure", "depth_over_contact_radius",
                              "ring_force"}, set(found["yield"]))

    def test_suffixes_change_nothing(self):
        plain = self.document("yield", "--E", "1e10", "--nu", ".15", "--phi", "25", "--sigma-c",
                              "15e6", "--radius", "0.1", "--force-max", "100")
        suffixed = self.document("yield", "--E", "10 GPa", "--nu", "0.15", "--phi", "25deg",
                                 "--sigma-c", "15MPa", "--radius", "100mm", "--force-max", "0.1kN")
        self.assertEqual(plain, suffixed)

    def test_text_has_units(self):
        text = self.succeed("yield", *TYPE_1).stdout
        self.assertIn("9.056 N", text)
        self.assertIn("3.2792 um", text)

    def test_values_out_of_range(self):
        for option, values in {
                "--nu": ["0.5", "0.7", "-0.1", "nan", "0.2Pa"],
                "--phi": ["90", "120", "-1", "inf"],
                "--E": ["0", "-10GPa", "nan", "inf", "1e400", "10GN", "ten", ""],
                "--sigma-c": ["0", "-5MPa", "nan"],
                "--radius": ["0", "-1mm", "inf", "1Pa"],
                "--force-max": ["0", "-100N", "nan"]}.items():
            for value in values:
                with self.subTest(option=option, value=value):
                    self.fail_with(BAD_INPUT, "yield", *with_value(option, value))

    def test_message_names_option_and_text(self):
        message = self.fail_with(BAD_INPUT, "yield", *with_value("--E", "10GN"))
        self.assertIn("E: '10GN'", message)
        message = self.fail_with(BAD_INPUT, "yield", *with_value("--nu", "0.5"))
        self.assertRegex(message, "Poisson.*0.5")

    def test_missing_material(self):
        self.assertIn("sigma-c", self.fail_with(BAD_INPUT, "yield", *TYPE_1[:-2]))

    def test_standard_output_that_cannot_be_written(self):
        with open("/dev/full", "w", encoding="utf-8") as full:
            result = subprocess.run([program.PROGRAM, "yield", *TYPE_1], stdout=full,
                                    stderr=subprocess.PIPE, check=False)
        self.assertEqual(result.returncode, FILE)


class YieldSurface(program.TestCase):
    ROCK = ["--phi", "30", "--sigma-c", "10MPa"]

    def points(self, *arguments):
        points = self.document("yield-surface", *arguments)["points"]
        self.assertTrue(points)
        return points

    def test_cone(self):
        # alpha = 2 sin(phi)/(sqrt(3)(3 - sin(phi))), k = sigma_c (1 - sqrt(3) alpha)/sqrt(3)
        alpha = 0.4 / math.sqrt(3)
        k = 10e6 * 0.6 / math.sqrt(3)
        for plane in ["meridional", "deviatoric"]:
            for p in self.points(*self.ROCK, "--plane", plane, "--points", 7, "--pressure", "20MPa"):
                self.assertAlmostEqual((p["sqrt_j2_Pa"] + alpha * p["i1_Pa"]) / k, 1, places=9)
                self.assertAlmostEqual(p["i1_Pa"], -3 * p["pressure_Pa"], places=3)

    def test_pyramid_and_cylinder(self):
        # sigma_max (1 + sin(phi)) - sigma_min (1 - sin(phi)) = (1 - sin(phi)) sigma_c
        for p in self.points("--criterion", "mohr-coulomb", *self.ROCK, "--plane", "deviatoric"):
            stresses = [p[f"sigma_{i}_Pa"] for i in (1, 2, 3)]
            self.assertAlmostEqual((1.5 * max(stresses) - 0.5 * min(stresses)) / 5e6, 1, places=8)
        for p in self.points("--criterion", "von-mises", "--yield-stress", "6MPa"):
            self.assertAlmostEqual(p["sqrt_j2_Pa"] * math.sqrt(3) / 6e6, 1, places=9)

    def test_csv_is_the_document(self):
        lines = self.succeed("yield-surface", *self.ROCK, "--points", 3).stdout.splitlines()
        points = self.points(*self.ROCK, "--points", 3)
        self.assertEqual(lines[0].split(","), list(points[0]))
        self.assertEqual(len(lines), 1 + len(points))
        self.assertAlmostEqual(float(lines[-1].split(",")[3]) / points[-1]["sqrt_j2_Pa"], 1, places=10)

    def test_elastic_constants_have_no_part_in_it(self):
        self.assertEqual(self.points(*self.ROCK), self.points(*self.ROCK, "--E", "3GPa", "--nu", "0.4"))

    def test_bad_input(self):
        for arguments, word in [(["--plane", "octahedral"], "octahedral"), (["--pressure", "5N"], "5N"),
                                (["--pressure", "-1MPa"], "pressure"), (["--points", "1"], "points"),
                                (["--plane", "deviatoric", "--pressure", "-6MPa"], "-5 MPa"),
                                (["--hardening", "-1"], "hardening")]:
            with self.subTest(arguments=arguments):
                self.assertIn(word, self.fail_with(BAD_INPUT, "yield-surface", *self.ROCK, *arguments))
        self.assertIn("sigma-c", self.fail_with(BAD_INPUT, "yield-surface", "--phi", "30"))


class Solve(program.TestCase):
    COARSE = ["--resolution", "12", "--step-tolerance", "1e-2"]

    def test_document_and_files(self):
        found = self.document("solve", *TYPE_1, *self.COARSE, "--output", "new/results")
        self.assertEqual(found["material"], TYPE_1_DOCUMENT)
        self.assertEqual(found["scene"], {"radius": 0.1, "force_max": 100})
        self.assertEqual(found["status"], "converged")
        for part, names in {
                "yield": "force approach pressure depth_over_contact_radius ring_force",
                "fit": "a b m n r2_loading r2_unloading rmse_loading rmse_unloading",
                "published_convention": "a m approach_yield",
                "peak": "force approach contact_radius pressure",
                "cost": "dofs steps newton_iterations wall_seconds peak_memory_bytes"}.items():
            for name in names.split():
                with self.subTest(part=part, name=name):
                    self.assertGreater(found[part][name], 0)
        self.assertEqual(set(found["fit"]["standard_error"]), set("abmn"))
        self.assertGreater(found["residual_approach"], 0)

        fit, published = found["fit"], found["published_convention"]
        # the approach at yield is per sphere in the published convention
        self.assertAlmostEqual(published["a"], fit["a"] * 2 ** -fit["b"], places=12)
        self.assertAlmostEqual(published["m"], fit["m"] * 2 ** -fit["n"], places=12)
        self.assertAlmostEqual(published["approach_yield"] / found["yield"]["approach"], 0.5,
                               places=12)
        # landing on the peak force is promised to 1e-6
        self.assertAlmostEqual(found["peak"]["force"], 100, delta=1e-4)

        results = self.directory / "new" / "results"
        self.assertEqual(json.loads((results / "result.json").read_text(encoding="utf-8")), found)
        self.assertEqual(len(list(results.glob("*.vtu"))), 2)
        self.assertTrue((results / "profile.csv").read_text(encoding="utf-8").startswith(
            "radius_m,pressure_Pa\n"))
        curve = (results / "curve.csv").read_text(encoding="utf-8").splitlines()
        self.assertTrue(curve[0].startswith("branch,approach_m,force_N,"))
        branches = [line.split(",")[0] for line in curve[1:]]
        self.assertEqual(set(branches), {"loading", "unloading"})

    def test_points_and_plastic_zone(self):
        found = self.document("solve", *TYPE_1, *self.COARSE, "--output", "results")
        with open(self.directory / "results" / "points.csv", newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        points = [{key: float(text) for key, text in row.items() if key != "branch"} for row in rows]
        for point in points:
            s1, s2, s3 = (point[f"principal_{i}_Pa"] for i in (1, 2, 3))
            self.assertGreaterEqual(s1, s2)
            self.assertGreaterEqual(s2, s3)
            trace = point["stress_rr_Pa"] + point["stress_zz_Pa"] + point["stress_tt_Pa"]
            self.assertAlmostEqual(s1 + s2 + s3, trace, delta=1e-3 + 1e-9 * abs(s3))
            mises = math.sqrt(((s1 - s2) ** 2 + (s2 - s3) ** 2 + (s3 - s1) ** 2) / 2)
            self.assertAlmostEqual(point["mises_stress_Pa"], mises, delta=1e-3 + 1e-9 * mises)
        self.assertLessEqual({row["branch"] for row in rows}, {"elastic", "regular", "apex"})
        self.assertIn("regular", {row["branch"] for row in rows})

        # The last loading point of the curve is the state of the points.
        with open(self.directory / "results" / "curve.csv", newline="", encoding="utf-8") as file:
            peak = [row for row in csv.DictReader(file) if row["branch"] == "loading"][-1]
        volume = sum(p["volume_m3"] for p in points if p["plastic_strain"] > 0)
        self.assertAlmostEqual(volume / float(peak["plastic_volume_m3"]), 1, delta=0.05)

        zone, flow = found["plastic_zone"], found["flow_zone"]
        self.assertGreater(zone["core"]["volume"], 0)
        self.assertTrue(zone["elastic_cap"])
        self.assertLessEqual(flow["core"]["volume"], zone["core"]["volume"])
        self.assertLess(zone["axis_depth_min"], zone["axis_depth_max"])

    @staticmethod
    def fields(path):
        """The arrays of a VTU file by name: single precision, in one block of zlib, behind a header of 16 bytes."""
        entry = r'<DataArray type="Float32" Name="(\w+)"[^>]*format="binary">\s*([^<\s]+)\s*</DataArray>'
        found = re.findall(entry, path.read_text(encoding="utf-8"))
        return {name: array.array("f", zlib.decompress(base64.b64decode(content[24:]))) for name, content in found}

    def test_fields_have_no_negative_stress_or_strain(self):
        self.succeed("solve", *TYPE_1, *self.COARSE, "--output", "fields")
        for state in ["peak", "released"]:
            arrays = self.fields(self.directory / "fields" / f"{state}.vtu")
            for name in ["mises_stress", "plastic_strain"]:
                self.assertGreaterEqual(min(arrays[name]), 0)
                self.assertGreaterEqual(min(arrays[f"{name}_of_cell"]), 0)
                self.assertGreater(max(arrays[f"{name}_of_cell"]), 0)
                self.assertLess(max(arrays[f"{name}_of_cell"]), 1.01 * max(arrays[name]))
            self.assertIn("pressure_of_cell", arrays)

    def test_closed_form_has_no_plastic_zone(self):
        found = self.document("solve", "--E", "10GPa", "--nu", "0.2", "--phi", "30", "--sigma-c", "1GPa")
        self.assertIsNone(found["plastic_zone"])
        self.assertIsNone(found["flow_zone"])

    def test_large_contact_is_warned_of(self):
        # Hertz: a/R = 0.19, where small strain ends at 0.1
        result = self.succeed("solve", "--E", "1GPa", "--nu", "0.2", "--phi", "30", "--sigma-c",
                              "10GPa", "--radius", "10mm", "--force-max", "1kN", *self.COARSE)
        self.assertIn("warning", result.stderr)
        self.assertNotIn("warning", self.succeed("solve", *TYPE_1, *self.COARSE).stderr)

    def test_steps_that_only_the_smooth_extrapolation_makes_a_curve_of_are_warned_of(self):
        def solve(steps):
            return self.document("solve", "--E", "10GPa", "--nu", "0.4", "--phi", "2", "--sigma-c", "15MPa",
                                 "--load-level", "8000", "--resolution", "8", "--surface-halvings", "0",
                                 "--loading-steps", steps)
        rough, fine = solve(64), solve(256)
        self.assertIn("load step", rough["warnings"])
        # within what is stated, which is of the force and of the approach some four fifths
        self.assertLess(abs(rough["peak"]["approach"] / fine["peak"]["approach"] - 1), rough["step_error"])


class Usage(program.TestCase):
    def test_misuse(self):
        for arguments in [[], ["solv"], ["yield", "--youngs", "3"], ["yield", "--E"], ["export"],
                          ["export", "some.h5"], ["sweep"], ["yield", *TYPE_1, "surplus"]]:
            with self.subTest(arguments=arguments):
                result = self.run_program(*arguments)
                self.assertEqual(result.returncode, USAGE, result.stderr)
                self.assertEqual(result.stdout, "")
                self.assertNotEqual(result.stderr, "")

    def test_help_and_version(self):
        for command in ["yield", "yield-surface", "solve", "sweep", "fit", "export"]:
            self.assertIn(command, self.succeed("--help").stdout)
            self.assertIn("--json", self.succeed(command, "--help").stdout)
        version = self.run_program("--version")
        self.assertEqual(version.returncode, SUCCESS)
        for word in ["dpcontact ", "deal.II 9.", "gmsh 4.", "GSL 2."]:
            self.assertIn(word, version.stdout)


class StartsAtOnce(program.TestCase):
    """What solves, and the libraries that take half a second to load, are in dpcontact-solver."""

    def test_large_libraries_are_not_loaded(self):
        loaded = subprocess.run(["ldd", program.PROGRAM], capture_output=True, text=True, check=True).stdout
        self.assertIn("libstdc++", loaded)
        for library in ["deal.ii", "petsc", "trilinos", "gmsh", "libOT", "cholmod"]:
            self.assertNotIn(library, loaded)

    def test_alone(self):
        alone = shutil.copy(program.PROGRAM, self.directory)
        scene = [*TYPE_1, "--radius", "0.1", "--force-max", "100"]

        def run(*arguments):
            return subprocess.run([alone, *arguments], capture_output=True, text=True, check=False)

        lookup = run("lookup", *scene, "--json")
        self.assertEqual(lookup.returncode, SUCCESS, lookup.stderr)
        self.assertEqual(json.loads(lookup.stdout), self.document("lookup", *scene))
        parameters = self.write("case.prm", "set E = 10GPa\n")
        for arguments, what in [(["solve", *scene], "solve"), (["sweep", "--help"], "sweep"),
                                (["yield", "--parameter-file", parameters], "--parameter-file"),
                                (["lookup", *scene, "--method", "kriging"], "method kriging")]:
            with self.subTest(arguments=arguments):
                result = run(*arguments)
                self.assertEqual(result.returncode, FILE)
                self.assertEqual(result.stdout, "")
                self.assertRegex(result.stderr, f"^dpcontact: error: {what} needs the solver, but "
                                                ".*/dpcontact-solver cannot be started: No such file")

    def test_the_solver_takes_arguments_and_streams_over(self):
        result = self.run_program("sweep", "a b.prm", "--dry-run", "--database", "rows.h5")
        self.assertEqual(result.returncode, FILE)
        self.assertIn("a b.prm", result.stderr)


class Criteria(program.TestCase):
    PYRAMID = ["--criterion", "mohr-coulomb", "--E", "10GPa", "--nu", "0.38", "--phi", "27.8"]
    METAL = ["--criterion", "von-mises", "--E", "193GPa", "--nu", "0.3"]

    def test_strength_by_either_name(self):
        # C = (1 - sin phi)/(2 cos phi) sigma_c and sigma_Y = 3 (1 - sin phi)/(3 - sin phi) sigma_c
        sine, cosine = math.sin(math.radians(27.8)), math.cos(math.radians(27.8))
        pyramid = self.document("yield", *self.PYRAMID, "--sigma-c", "10.61MPa")["material"]
        self.assertAlmostEqual(pyramid["cohesion"], (1 - sine) / (2 * cosine) * 10.61e6, delta=1)
        self.assertIsNone(pyramid["tension_cutoff"])
        same = self.document("yield", *self.PYRAMID, "--cohesion", str(pyramid["cohesion"]))
        self.assertAlmostEqual(same["material"]["sigma_c"], 10.61e6, delta=1)

        metal = self.document("yield", "--criterion", "von-mises", "--E", "10GPa", "--nu", "0.38",
                              "--phi", "27.8", "--sigma-c", "10.61MPa")
        self.assertAlmostEqual(metal["material"]["sigma_c"],
                               3 * (1 - sine) / (3 - sine) * 10.61e6, delta=1)
        self.assertEqual(metal["material"]["phi_deg"], 0)
        by_stress = self.document("yield", "--criterion", "von-mises", "--E", "10GPa", "--nu", "0.38",
                                  "--yield-stress", str(metal["material"]["sigma_c"]))
        self.assertEqual(by_stress["yield"], metal["yield"])

    def test_first_yield(self):
        # On the axis the cone and the pyramid agree; on the ring, in pure shear, the tau of each.
        cone = self.document("yield", *self.PYRAMID[2:], "--sigma-c", "10.61MPa")["yield"]
        rounded = self.document("yield", *self.PYRAMID[2:], "--sigma-c", "10.61MPa",
                                "--flow-stress-ratio", "0.778")["yield"]
        pyramid = self.document("yield", *self.PYRAMID, "--sigma-c", "10.61MPa")["yield"]
        cut = self.document("yield", *self.PYRAMID, "--sigma-c", "10.61MPa", "--tension-cutoff",
                            "1MPa")["yield"]
        for other in rounded, pyramid, cut:
            self.assertAlmostEqual(other["force"] / cone["force"], 1, places=12)
        self.assertAlmostEqual(rounded["ring_pressure"] / cone["ring_pressure"],
                               2 / (1 + 1 / 0.778), places=12)
        self.assertAlmostEqual(cut["ring_pressure"], 3 * 1e6 / (1 - 2 * 0.38), delta=1)
        sine = math.sin(math.radians(27.8))
        self.assertAlmostEqual(pyramid["ring_pressure"],
                               3 * (1 - sine) / 2 * 10.61e6 / (1 - 2 * 0.38), delta=1)

    def test_what_a_criterion_does_not_have(self):
        strength = ["--sigma-c", "10MPa"]
        for arguments, words in [
                ([*TYPE_1, "--criterion", "tresca"], ["criterion", "tresca", "mohr-coulomb"]),
                ([*TYPE_1, "--cohesion", "3MPa"], ["cohesion", "mohr-coulomb", "drucker-prager"]),
                ([*TYPE_1, "--tension-cutoff", "1MPa"], ["tension-cutoff", "drucker-prager"]),
                ([*TYPE_1, "--yield-stress", "1MPa"], ["yield-stress", "von-mises"]),
                ([*self.PYRAMID, *strength, "--hardening", "1MPa"], ["hardening", "mohr-coulomb"]),
                ([*self.PYRAMID, *strength, "--flow-stress-ratio", "0.9"], ["flow-stress-ratio"]),
                ([*self.PYRAMID, *strength, "--cohesion", "1MPa"], ["cohesion", "sigma-c"]),
                ([*self.METAL, "--yield-stress", "1MPa", "--dilation", "0"], ["dilation"]),
                ([*self.METAL, "--yield-stress", "1MPa", "--phi", "10"], ["phi", "von-mises"]),
                ([*self.METAL], ["phi is missing"])]:
            with self.subTest(arguments=arguments):
                message = self.fail_with(BAD_INPUT, "yield", *arguments)
                for word in words:
                    self.assertIn(word, message)

    def test_values_out_of_range(self):
        for option, value, words in [("--flow-stress-ratio", "0.7", "0.778"),
                                     ("--flow-stress-ratio", "1.1", "at most 1"),
                                     ("--dilation", "30", "at most the friction angle"),
                                     ("--dilation", "-1", "at least 0"),
                                     ("--hardening", "-1MPa", "at least 0")]:
            with self.subTest(option=option, value=value):
                self.assertIn(words, self.fail_with(BAD_INPUT, "yield", *TYPE_1, option, value))
        self.assertIn("T0", self.fail_with(BAD_INPUT, "yield", *self.PYRAMID, "--sigma-c", "1MPa",
                                           "--tension-cutoff", "-1MPa"))

    def test_families_of_other_laws_are_refused(self):
        path = self.write("rocks.prm", "set E = 10GPa\nset nu = 0.2\nset phi = 30\n"
                          "set sigma-c = 10MPa\nset criterion = mohr-coulomb\n")
        self.assertEqual(len(self.document("sweep", path, "--dry-run")["rows"]), 1)
        self.assertIn("mode = direct",
                      self.fail_with(BAD_INPUT, "sweep", path, "--mode", "families", "--dry-run"))

    def test_a_sweep_takes_lists(self):
        path = self.write("rocks.prm", "set E = 10GPa\nset nu = 0.2\nset phi = 30\n"
                          "set sigma-c = 10MPa\nset dilation = 0, 15, 30\n"
                          "set flow-stress-ratio = 0.778, 1\n")
        rows = self.document("sweep", path, "--dry-run")["rows"]
        self.assertEqual([(row["material"]["flow_stress_ratio"], row["material"]["dilation_deg"])
                          for row in rows],
                         [(k, psi) for k in (0.778, 1) for psi in (0, 15, 30)])


class ParameterFiles(program.TestCase):
    ENTRIES = "set E = 10GPa\nset nu = 0.15\nset phi = 25\nset sigma-c = 15MPa\n"

    def test_same_as_options_which_override_it(self):
        path = self.write("rock.prm", self.ENTRIES)
        self.assertEqual(self.document("yield", "--parameter-file", path),
                         self.document("yield", *TYPE_1))
        self.assertEqual(self.document("yield", "--parameter-file", path, "--nu", "0.2"),
                         self.document("yield", *with_value("--nu", "0.2")))

    def test_misspelt_and_ill_typed_entries(self):
        for line in ["set sigma_c = 15MPa", "set nu = many", "nu = 0.1"]:
            path = self.write("rock.prm", self.ENTRIES + line + "\n")
            for command in [["yield", "--parameter-file"], ["solve", "--parameter-file"], ["sweep"]]:
                with self.subTest(line=line, command=command):
                    self.assertIn("rock.prm:5: ", self.fail_with(BAD_INPUT, *command, path))

    def test_missing_file(self):
        for command in [["yield", "--parameter-file"], ["sweep"]]:
            self.assertIn("absent.prm", self.fail_with(FILE, *command, "absent.prm"))


class Sweep(program.TestCase):
    GRID = "set E = 10GPa, 20GPa\nset nu = 0.15\nset phi = 25\nset sigma-c = 15MPa, 1GPa\n"

    def test_dry_run_lists_and_touches_nothing(self):
        path = self.write("grid.prm", self.GRID)
        with self.unchanged_files():
            found = self.document("sweep", path, "--dry-run", "--jobs", 3)
        self.assertEqual(found["database"], "grid.h5")
        self.assertEqual(found["jobs"], 3)
        self.assertEqual(found["to_compute"], 4)
        self.assertEqual([(row["material"]["E"], row["material"]["sigma_c"])
                          for row in found["rows"]],
                         [(1e10, 15e6), (1e10, 1e9), (2e10, 15e6), (2e10, 1e9)])

    def test_bad_settings(self):
        path = self.write("grid.prm", self.GRID)
        for arguments in [["--jobs", "0"], ["--jobs", "-1"], ["--jobs", "two"],
                          ["--resolution", "0"], ["--step-tolerance", "-1"], ["--nu", "0.1,0.5"],
                          ["--nu", "0.1,0.10"], ["--contact", "glue"], ["--database", ""]]:
            with self.subTest(arguments=arguments), self.unchanged_files():
                self.fail_with(BAD_INPUT, "sweep", path, *arguments)


class Unwritable(program.TestCase):
    def test_output_below_a_file(self):
        self.write("plain", "kept")
        grid = self.write("grid.prm", Sweep.GRID)
        with self.unchanged_files():
            self.fail_with(FILE, "solve", *TYPE_1, "--output", "plain/results")
            self.fail_with(FILE, "solve", *TYPE_1, "--output", "plain")
            self.fail_with(FILE, "sweep", grid, "--database", "plain/table.h5")
            self.fail_with(FILE, "sweep", grid, "--database", "absent/table.h5")
            self.fail_with(BAD_INPUT, "sweep", grid, "--database", ".")

    def test_missing_database(self):
        with self.unchanged_files():
            self.fail_with(FILE, "fit", "absent.h5")
            self.fail_with(FILE, "export", "absent.h5", "--csv", "table.csv")


if __name__ == "__main__":
    program.main()
