"""dpcontact solve in space: linear solvers, processes of mpirun, checkpoints, second bodies."""

import json
import os
import signal
import subprocess
import time

import program
from program import BAD_INPUT, CORRUPT, MISMATCH, SUCCESS

ROCK = ["--E", "10GPa", "--nu", "0.15", "--phi", "25", "--sigma-c", "15MPa"]
# Small, but yielding: 8 loading and 4 unloading steps after a run of half as many.
SMALL = ["solve", *ROCK, "--geometry", "sector", "--sector-angle", "90", "--element", "brick",
         "--resolution", "4", "--domain-radius", "30", "--loading-steps", "16",
         "--extrapolation", "off"]
NUMBERS = ["a", "b", "m", "n"]


class Space(program.TestCase):
    def launch(self, *arguments):
        environment = {**os.environ, "OMPI_ALLOW_RUN_AS_ROOT": "1",
                       "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}
        return subprocess.run(["mpirun", "--oversubscribe", *arguments], stdin=subprocess.DEVNULL,
                              capture_output=True, text=True, cwd=self.directory, env=environment,
                              timeout=600)

    def ranks(self, n, *arguments):
        return self.launch("-np", str(n), program.PROGRAM, *arguments)

    def test_ranks_given_different_scenes_end(self):
        one = [program.PROGRAM, *SMALL]
        for theirs, word in (
                ([*one, "--force-max", "90N"], "inputs/scene/force_max is 100.0 on rank 0 and 90.0 on rank 1"),
                (["32" if word == "16" else word for word in one],
                 "inputs/options/loading-steps is 16 on rank 0 and 32 on rank 1"),
                ([*one, "--output", "out"], "output")):
            with self.subTest(word):
                result = self.launch("-np", "1", *one, ":", "-np", "1", *theirs)
                self.assertEqual(result.returncode, BAD_INPUT, result.stderr)
                self.assertIn(word, result.stderr)
                self.assertIn("were not given the same", result.stderr)
                self.assertFalse((self.directory / "out").exists())

    def expect_same(self, one, other, relative):
        for name in NUMBERS:
            self.assertAlmostEqual(one["fit"][name] / other["fit"][name], 1, delta=relative)
        self.assertAlmostEqual(one["peak"]["approach"] / other["peak"]["approach"], 1,
                               delta=relative)
        self.assertAlmostEqual(one["residual_approach"] / other["residual_approach"], 1,
                               delta=10 * relative)  # a small difference of large numbers
        self.assertLessEqual(abs(one["cost"]["newton_iterations"] -
                                 other["cost"]["newton_iterations"]),
                             .02 * one["cost"]["newton_iterations"])

    def test_sector_and_disc_agree_with_axisymmetry(self):
        """Within the sum of the stated errors, of which the step's is common to all."""
        steps = ["--loading-steps", "16", "--extrapolation", "off"]
        elastic = ["--E", "10GPa", "--nu", "0.25", "--phi", "35", "--sigma-c", "30MPa",
                   "--closed-form", "off"]
        sector = ["--geometry", "sector", "--resolution", "4"]
        disc = ["--geometry", "disc", "--element", "brick", "--resolution", "4"]
        for rock in [ROCK, elastic]:
            plane = self.document("solve", *rock, *steps)
            for geometry in [sector, disc]:
                with self.subTest(rock=rock, geometry=geometry):
                    space = self.document("solve", *rock, *geometry, *steps)
                    for name in NUMBERS:
                        parts = [result["error"][name] for result in (plane, space)]
                        self.assertLessEqual(
                            abs(space["fit"][name] - plane["fit"][name]),
                            sum(part["mesh"] + part["contact"] + part["far_field"]
                                for part in parts), name)
                    # Measured: .1 % by four quadratic elements, 1.8 % by four bricks.
                    self.assertAlmostEqual(
                        space["peak"]["approach"] / plane["peak"]["approach"], 1,
                        delta=2e-3 if geometry is sector else 2.5e-2)
                    self.assertGreater(space["axisymmetry_deviation"], 0)
                    self.assertLess(space["axisymmetry_deviation"], .02)

    def test_processes_and_linear_solvers_agree(self):
        alone = {kind: self.document(*SMALL, "--linear-solver", kind)
                 for kind in ["direct", "iterative"]}
        self.assertGreater(alone["direct"]["residual_approach"],
                           .03 * alone["direct"]["peak"]["approach"])
        for name in NUMBERS:
            self.assertAlmostEqual(alone["iterative"]["fit"][name] / alone["direct"]["fit"][name],
                                   1, delta=1e-7)
        for kind, n in [("direct", 2), ("iterative", 2), ("iterative", 4)]:
            with self.subTest(kind=kind, n=n):
                result = self.ranks(n, *SMALL, "--linear-solver", kind, "--json")
                self.assertEqual(result.returncode, SUCCESS, result.stderr)
                other = json.loads(result.stdout)
                self.assertEqual(other["linear_solver"]["processes"], n)
                self.assertEqual(other["linear_solver"]["iterations"] > 0, kind == "iterative")
                self.expect_same(alone[kind], other, 1e-8)
                # One process says how far they are, in a log as well.
                self.assertEqual(result.stderr.count("unloading 100 %"), 2)

    def test_a_killed_run_goes_on(self):
        undisturbed = self.document(*SMALL)
        kept = self.directory / "kept"
        command = [program.PROGRAM, *SMALL, "--checkpoint", str(kept), "--json"]
        for _ in range(3):
            before = kept.read_bytes() if kept.exists() else b""
            process = subprocess.Popen(command, stdout=subprocess.DEVNULL,
                                       stderr=subprocess.DEVNULL)
            while process.poll() is None and not (kept.exists() and kept.read_bytes() != before):
                time.sleep(.01)
            process.send_signal(signal.SIGKILL)
            process.wait()
        self.assertTrue(kept.exists())

        message = self.fail_with(MISMATCH, *SMALL[:-2], "--extrapolation", "on", "--checkpoint",
                                 kept)
        self.assertIn("extrapolation", message)
        content = kept.read_bytes()
        kept.write_bytes(content[:-1])
        self.fail_with(CORRUPT, *SMALL, "--checkpoint", kept)
        kept.write_bytes(content)

        resumed = json.loads(self.succeed(*SMALL, "--checkpoint", kept, "--json").stdout)
        self.expect_same(undisturbed, resumed, 1e-12)
        self.assertFalse(kept.exists())

    def test_two_bodies(self):
        two = self.document(*SMALL, "--radius-2", "0.1m")
        self.expect_same(self.document(*SMALL), two, 1e-5)  # contact: 1e-6 of the approach
        rigid = self.document(*SMALL, "--radius-2", "flat", "--E-2", "rigid")
        self.assertEqual(rigid["scene"]["second"], {"radius": "flat", "rigid": True})

    def test_what_does_not_go_together_is_refused(self):
        self.assertIn("serendipity", self.fail_with(BAD_INPUT, "solve", *ROCK, "--geometry",
                                                     "sector", "--element", "serendipity"))
        self.assertIn("nu-2", self.fail_with(BAD_INPUT, *SMALL, "--E-2", "rigid", "--nu-2", ".2"))
        self.assertIn("sector-angle", self.fail_with(BAD_INPUT, "solve", *ROCK, "--geometry",
                                                      "sector", "--sector-angle", "30"))
        result = self.ranks(2, "solve", *ROCK)
        self.assertEqual(result.returncode, BAD_INPUT, result.stderr)
        self.assertIn("axisymmetric", result.stderr)


if __name__ == "__main__":
    program.main()
