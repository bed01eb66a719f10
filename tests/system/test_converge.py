"""The convergence study of one material, coarse enough for seconds."""

import program
from program import BAD_INPUT

MATERIAL = ["--E", "10GPa", "--nu", "0.2", "--phi", "30", "--sigma-c", "10MPa"]
COARSE = ["--resolution", "10", "--loading-steps", "32", "--domain-radius", "60"]


class Converge(program.TestCase):
    def test_every_source_is_varied_and_judged(self):
        found = self.document("converge", *MATERIAL, *COARSE)
        studies = {study["source"]: study for study in found["studies"]}
        self.assertEqual(list(studies), ["mesh", "step", "contact", "far_field", "finite_radius"])
        self.assertEqual([level["level"] for level in studies["mesh"]["levels"]], ["5", "10", "20"])
        self.assertEqual([level["level"] for level in studies["step"]["levels"]], ["16", "32", "64"])
        for source, study in studies.items():
            for name in "abmn":
                with self.subTest(f"{source} of {name}"):
                    self.assertEqual(found["studied"][name][source], study["error"][name])
                    self.assertGreaterEqual(study["error"][name], 0)
                    if source in ("mesh", "step"):  # the level asked for is the second
                        asked, finest = (study["levels"][k][name] for k in (1, 2))
                        self.assertAlmostEqual(asked, found["coefficients"][name], delta=1e-9)
                        self.assertGreaterEqual(study["error"][name], abs(asked - finest) - 1e-15)
        with self.subTest("what is varied matters as it should"):
            mesh, contact = (found["studied"]["m"][source] for source in ("mesh", "contact"))
            self.assertGreater(mesh, 10 * contact)
            self.assertGreater(contact, 0)
        with self.subTest("totals are sums"):
            for errors in (*found["studied"].values(), *found["estimate"].values()):
                parts = sum(value for source, value in errors.items() if source != "total")
                self.assertAlmostEqual(errors["total"], parts, delta=1e-12)

    def test_elastic_scene_is_closed_form(self):
        found = self.document("converge", *MATERIAL[:-1], "1GPa")
        self.assertEqual(found["studies"], [])
        self.assertEqual(found["studied"]["a"]["mesh"], 0)
        self.assertIsNone(found["studied"]["a"]["finite_radius"])

    def test_bad_input(self):
        self.fail_with(BAD_INPUT, "converge", *MATERIAL, "--loading-steps", "33")


if __name__ == "__main__":
    program.main()
