"""Figure 4: yield surfaces, drawn from the program's own yield functions."""

import math

import numpy

from pages import COLOURS
from solves import yield_surface

DRUCKER_PRAGER = "--phi 27.8 --sigma-c 10.61MPa"
# Without the cut-off the pyramid shows; with it its tip is cut.
MOHR_COULOMB = "--criterion mohr-coulomb --phi 27.8 --cohesion 3.2MPa"
LAWS = {
    "D-P, K = 1": DRUCKER_PRAGER,
    "D-P, K = 0.778": f"{DRUCKER_PRAGER} --flow-stress-ratio 0.778",
    "M-C": MOHR_COULOMB,
    "M-C, T0 = 1 MPa": f"{MOHR_COULOMB} --tension-cutoff 1MPa",
    "V-M": "--criterion von-mises --yield-stress 6.70MPa",
}
STYLES = dict(zip(LAWS, [("-", 0), ("--", 2), ("-", 1), (":", 1), ("-", 3)]))
SECTION_PRESSURE = 2e6
LARGEST_PRESSURE = 20e6


def label(name):
    return name.replace("K =", "$K$ =").replace("T0", "$T_0$")


def figure_4(pages, _solves):
    figure, (left, right) = pages.figure("figure_4", width=10.5, height=4.6, columns=2)
    series = {}
    for name, options in LAWS.items():
        line, colour = STYLES[name]
        width = 4 if name == "D-P, K = 1" else 1.6  # others lie on it
        meridians = yield_surface(f"{options} --pressure {LARGEST_PRESSURE}")
        for angle, meridian in ((60, "compression"), (0, "extension")):
            rows = numpy.isclose(meridians["lode_angle_deg"], angle)
            i1, root = meridians["i1_Pa"][rows] / 1e6, meridians["sqrt_j2_Pa"][rows] / 1e6
            series.update({f"minus_i1_MPa_{name}_{meridian}": -i1, f"sqrt_j2_MPa_{name}_{meridian}": root})
            if name in ("D-P, K = 1", "V-M") and meridian == "extension":
                continue # the same line
            left.plot(-i1, root, line, color=COLOURS[colour], linewidth=width, alpha=1 if angle else 0.45,
                      label=label(name) + ("" if name in ("D-P, K = 1", "V-M") else f", triaxial {meridian}"))
        section = yield_surface(f"{options} --plane deviatoric --pressure {SECTION_PRESSURE} --points 721")
        x, y = section["pi_x_Pa"] / 1e6, section["pi_y_Pa"] / 1e6
        right.plot(x, y, line, linewidth=1.6 if ":" not in line else 2.2, color=COLOURS[colour], label=label(name))
        series.update({f"pi_x_MPa_{name}": x, f"pi_y_MPa_{name}": y})
    left.set(xlabel="$-I_1$ (MPa), compression positive", ylabel="$\\sqrt{J_2}$ (MPa)", ylim=(0, None), xlim=(-25, 60),
             title="(a) meridional plane")
    left.legend(fontsize=7.5, loc="upper left")
    for k, name in enumerate(("$\\sigma_1$", "$\\sigma_2$", "$\\sigma_3$")):
        angle = math.pi / 2 - 2 * math.pi * k / 3
        right.annotate("", xy=(8.3 * math.cos(angle), 8.3 * math.sin(angle)), xytext=(0, 0),
                       arrowprops={"arrowstyle": "->", "color": "0.6", "linewidth": 0.8})
        right.annotate(name, (9 * math.cos(angle), 9 * math.sin(angle)), ha="center", va="center", color="0.4")
    right.set(xlabel="MPa", ylabel="MPa", aspect="equal", xlim=(-9.8, 9.8), ylim=(-9.8, 9.8),
              title=f"(b) deviatoric plane at $p$ = {SECTION_PRESSURE / 1e6:g} MPa, tension positive")
    right.legend(fontsize=7.5, loc="upper left", bbox_to_anchor=(1.0, 1.0))
    pages.save(figure, "figure_4")
    pages.csv("figure_4", series, ["points where the program's own yield functions vanish (dpcontact yield-surface)",
                                   f"pi_x, pi_y: deviatoric plane at p = {SECTION_PRESSURE / 1e6:g} MPa"])
    check(pages)


def check(pages):
    """The implemented surfaces against the paper's equations."""
    sine = math.sin(math.radians(27.8))
    alpha = 2 * sine / (math.sqrt(3) * (3 - sine))
    k = 10.61e6 * (1 - math.sqrt(3) * alpha) / math.sqrt(3)
    cone = yield_surface(f"{DRUCKER_PRAGER} --pressure {LARGEST_PRESSURE}")
    error = float(numpy.abs(cone["sqrt_j2_Pa"] + alpha * cone["i1_Pa"] - k).max() / k)
    pages.summarise("4", "largest |sqrt(J2) + alpha I1 - k|/k of the drawn cone", error, 0, "agrees" if error < 1e-9 else "contradicts",
                    "eqs (3), (5), (6); eq (4) has the other sign of I1")
    circle, hexagon = (yield_surface(f"{options} --plane deviatoric --pressure {SECTION_PRESSURE} --points 721")
                       for options in (DRUCKER_PRAGER, MOHR_COULOMB))
    ratio = hexagon["sqrt_j2_Pa"] / circle["sqrt_j2_Pa"]
    pages.summarise("4", "M-C over D-P in the deviatoric plane: at triaxial compression, least", f"{ratio.max():.4f}, {ratio.min():.4f}",
                    "M-C within D-P, meeting at its outer corners", "agrees" if abs(ratio.max() - 1) < 1e-3 else "contradicts",
                    "with C = 3.2 MPa from eq (15), rounded: the corners meet to that rounding")
