"""First yield of two equal spheres from the elastic stress on the axis, without the solver's formulae.

  python3 tests/verification/first_yield.py

prints F_y (N) and the mutual approach δ_y (m) of the paper's types 1 and 2 (J. Wang et al. 2018,
doi 10.1155/2018/6783791, table 3), which tests/solver/closed_form/first_yield_test.cc holds.
Sources: stress below a Hertz contact, Johnson, Contact Mechanics (1985), eq 3.45; yield, Drucker and
Prager, √J₂ + α I₁ = k with α and k from uniaxial compression and triaxial compression.
"""

from math import atan, pi, sin, radians, sqrt


def yield_measure(u, nu, alpha):
    """(√J₂ + α I₁)/p₀ on the axis at the depth u = z/a, tension positive."""
    sigma_z = -1 / (1 + u * u)
    sigma_r = -(1 + nu) * (1 - u * atan(1 / u)) + 1 / (2 * (1 + u * u))
    return abs(sigma_r - sigma_z) / sqrt(3) + alpha * (2 * sigma_r + sigma_z)


def largest(function, low, high):
    """The maximum of a function with one, by halving the bracket in thirds."""
    while high - low > 1e-9 * high:
        one, other = low + (high - low) / 3, high - (high - low) / 3
        low, high = (one, high) if function(one) < function(other) else (low, other)
    return function((low + high) / 2)


def first_yield(young, nu, phi_deg, sigma_c, radius):
    """F_y and δ_y of two equal spheres, in SI units."""
    s = sin(radians(phi_deg))
    alpha = 2 * s / (sqrt(3) * (3 - s))
    k = sigma_c * (1 / sqrt(3) - alpha)
    p0 = k / largest(lambda u: yield_measure(u, nu, alpha), 0.1, 10)
    modulus, reduced = young / (2 * (1 - nu**2)), radius / 2
    a = pi * p0 * reduced / (2 * modulus)
    return 2 / 3 * pi * a * a * p0, a * a / reduced


if __name__ == "__main__":
    for name, arguments in (("type 1", (10e9, 0.15, 25, 15e6, 0.1)), ("type 2", (10e9, 0.25, 35, 25e6, 0.1))):
        force, approach = first_yield(*arguments)
        print(f"{name}: F_y = {force:.4f} N, delta_y = {approach * 1e6:.4f}e-6 m")
