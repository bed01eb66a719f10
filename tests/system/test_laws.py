"""Differences of fitted laws (runs/studies/laws.py) on laws whose difference is known in closed form."""

import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "runs" / "studies"))
from laws import coefficient_difference, law_difference  # noqa: E402


def result(a=1.0, b=1.5, m=1.0, n=1.5, residual=0.0):
    """A law in units of N and m, δ_y = 2 m and F_y = 10 N, up to δ = 4 δ_y."""
    return {"scene": {"force_max": 80.0}, "yield": {"force": 10.0, "approach": 2.0},
            "peak": {"approach": 8.0}, "residual_approach": 2.0 * residual,
            "fit": {"a": a, "b": b, "m": m, "n": n}}


class Laws(unittest.TestCase):
    def test_equal_laws_do_not_differ(self):
        self.assertEqual(law_difference(result(), result()), 0)
        self.assertEqual(coefficient_difference(result(), result()), 0)

    def test_a_larger_coefficient_differs_most_at_the_peak(self):
        # 0.01 · 4^1.5 over F_max/F_y = 8
        self.assertAlmostEqual(law_difference(result(a=1.01), result()), 0.01, places=12)
        self.assertAlmostEqual(law_difference(result(m=0.98), result()), 0.02, places=12)

    def test_an_exponent_differs_most_inside(self):
        # x^p − x^q with p = 2, q = 1 on 0 … 1 has its extreme −1/4 at x = 1/2; here on 0 … 4, so that
        # a makes both meet at the peak: 8 ((x/4)^2 − (x/4)) over 8.
        difference = law_difference(result(a=0.5, b=2), result(a=2, b=1))
        self.assertAlmostEqual(difference, 0.25, places=12)

    def test_a_shifted_unloading_is_seen_and_starts_at_zero_force(self):
        # m x against m (x − 1): 1 over 8 everywhere beyond the residual approach.
        one, other = result(m=1, n=1, residual=1), result(m=1, n=1)
        self.assertAlmostEqual(law_difference(one, other), 1 / 8, places=12)
        self.assertAlmostEqual(law_difference(other, one), 1 / 8, places=12)

    def test_the_worst_coefficient_counts(self):
        self.assertAlmostEqual(coefficient_difference(result(b=1.53, n=1.47, m=1.01), result()), 0.02)


if __name__ == "__main__":
    unittest.main(verbosity=2)
