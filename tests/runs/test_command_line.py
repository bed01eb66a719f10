"""The command line: documents, messages and exit codes that need no computation of a curve."""

import subprocess

import program
from program import BAD_INPUT, FILE, SUCCESS, USAGE

TYPE_1 = ["--E", "10GPa", "--nu", "0.15", "--phi", "25", "--sigma-c", "15MPa"]
TYPE_2 = ["--E", "10GPa", "--nu", "0.25", "--phi", "35", "--sigma-c", "25MPa"]


def with_value(option, value):
    """Type 1 with one option changed."""
    options = list(TYPE_1) + ["--radius", "0.1", "--force-max", "100"]
    options[options.index(option) + 1] = value
    return options


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
        self.assertEqual(found["material"],
                         {"E": 1e10, "nu": 0.15, "phi_deg": 25, "sigma_c": 15e6})
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
        for command in ["yield", "solve", "sweep", "fit", "export"]:
            self.assertIn(command, self.succeed("--help").stdout)
            self.assertIn("--json", self.succeed(command, "--help").stdout)
        version = self.run_program("--version")
        self.assertEqual(version.returncode, SUCCESS)
        for word in ["dpcontact ", "deal.II 9.", "gmsh 4.", "GSL 2."]:
            self.assertIn(word, version.stdout)


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
            self.fail_with(FILE, "sweep", grid, "--database", ".")

    def test_missing_database(self):
        with self.unchanged_files():
            self.fail_with(FILE, "fit", "absent.h5")
            self.fail_with(FILE, "export", "absent.h5", "--csv", "table.csv")


if __name__ == "__main__":
    program.main()
