"""The hard cases: each converges within the limits, or ends with the message that it must end with."""

import program
from program import BAD_INPUT

# What must be among the cases, by the beginnings of their names.
THEMES = ["load-level-0.01", "load-level-1e+05", "friction-angle-0", "friction-angle-60",
          "poisson-ratio-0", "poisson-ratio-0.49", "von-mises-0.499", "apex", "flow-stress-ratio-0.778",
          "mohr-coulomb-edges", "mohr-coulomb-cutoff", "isochoric", "single-step", "penalty-1e0",
          "penalty-1e8", "elements-4", "elements-128", "ten-cycles", "higher-reload",
          "near-zero-load", "nanometre-grain", "planet", "distorted-mesh", "out-of-reach"]


class HardCases(program.TestCase):
    def test_every_case(self):
        cases = self.document("hard-cases")
        names = [case["case"] for case in cases]
        self.assertEqual(len(names), len(set(names)))
        for theme in THEMES:
            self.assertTrue(any(name.startswith(theme) for name in names), theme)
        errors = solved = 0
        for case in cases:
            with self.subTest(case=case["case"], found=case["found"], outcome=case["outcome"]):
                self.assertTrue(case["as_expected"])
                checks = case["checks"]
                if case["expected_error"]:
                    errors += 1
                    self.assertIn(case["expected_error"], case["outcome"])
                    continue
                self.assertEqual(case["outcome"], "converged")
                # Newton's tolerance is 1e-10; the rest is the rounding of a stiff contact's gap.
                self.assertLess(checks["residual"], 1e-7)
                self.assertLess(checks["yield_excess"], 1e-8)
                self.assertLess(checks["penetration"], 1.0001e-6)
                if case["newton_iterations"] > 0:
                    solved += 1
                    self.assertGreater(checks["largest_work"], 0)
                    self.assertLess(checks["energy_error"] / checks["largest_work"], 1e-6)
                    self.assertLess(case["cut_backs"], 5)
        self.assertLess(errors, 5)
        self.assertGreaterEqual(solved, 20)

    def test_table(self):
        lines = self.succeed("hard-cases", "apex", "near-zero-load").stdout.splitlines()
        self.assertEqual(len(lines), 4)
        for word in ["case", "outcome", "Newton", "cuts", "residual", "yield", "contact", "energy"]:
            self.assertIn(word, lines[0].split())
        self.assertTrue(lines[1].startswith("apex") and "converged" in lines[1])
        self.assertTrue(lines[3].startswith("2 of 2 cases as expected"))

    def test_unknown_case(self):
        self.assertIn("'apexx'", self.fail_with(BAD_INPUT, "hard-cases", "apexx"))


class Steps(program.TestCase):
    """Halving the load steps changes no coefficient by more than its stated step error."""

    TYPE_1 = ["--E", "10GPa", "--nu", "0.15", "--phi", "25", "--sigma-c", "15MPa"]
    WEAK = ["--E", "10GPa", "--nu", "0.1", "--phi", "20", "--sigma-c", "5MPa"]

    def test_step_independence(self):
        for material in [self.TYPE_1,
                         self.WEAK,
                         [*self.TYPE_1, "--dilation", "12.5"],
                         [*self.TYPE_1, "--flow-stress-ratio", "0.778"],
                         [*self.TYPE_1, "--hardening", "1GPa"],
                         [*self.TYPE_1, "--criterion", "von-mises"],
                         [*self.TYPE_1, "--criterion", "mohr-coulomb"],
                         [*self.TYPE_1, "--criterion", "mohr-coulomb", "--tension-cutoff", "1MPa"]]:
            found = self.document("solve", *material)
            halved = self.document("solve", *material, "--loading-steps",
                                   2 * found["used"]["loading-steps"])
            for name in "abmn":
                with self.subTest(material=material, coefficient=name):
                    change = abs(halved["fit"][name] - found["fit"][name])
                    self.assertLessEqual(change, found["error"][name]["step"])
            # Backward Euler's dissipation leaves a gap that falls at least in proportion to the step.
            self.assertLess(found["checks"]["energy_gap"], 5e-3)
            self.assertLess(halved["checks"]["energy_gap"], 0.6 * found["checks"]["energy_gap"])


if __name__ == "__main__":
    program.main()
