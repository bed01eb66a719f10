"""Figure 6: dimers of stainless steel 302, from static properties."""

import math

import numpy

from pages import COLOURS
from solves import need

# E = 2 (1 + nu) G with nu = 0.25, G = 77.2 GPa (ASM data sheet of AISI 302 at matweb.com, also the RoyMech sheet).
ELASTIC = "--E 193GPa --nu 0.25 --criterion von-mises"
# Yield and tensile strength in MPa, elongation.
GRADES = {
    "typical": (255, 585, 0.57),  # RoyMech, 302 stainless steel material properties, annealed
    "minimum": (205, 515, 0.40),  # ASTM A240/A666, type 302 annealed
}
SOURCES = [
    "AISI 302, annealed, static. E = 193 GPa, nu = 0.25: ASM data sheet of AISI 302 (matweb.com).",
    "typical: yield 255 MPa, tensile 585 MPa, elongation 57 % (RoyMech, 302 stainless steel); minimum: 205 MPa, 515 MPa, 40 % (ASTM A240/A666).",
    "Linear hardening H = (true tensile strength - yield)/(true strain - true strength/E), true strength = R_m (1 + e), true strain = ln(1 + e), "
    "e = elongation, taken as uniform: H = 1.48 GPa (typical), 1.54 GPa (minimum). A real curve hardens faster at small strain.",
    "Uncertainty: between the two grades; cold-drawn balls can be several times as strong, and rate effects of the Hopkinson bar are left out.",
]
# Equal peak forces over F_y, which goes with the radius squared; a/R stays below 0.1.
BALLS = {"9.53 mm": ("4.765mm", 500.0), "12.7 mm": ("6.35mm", 500.0 * (6.35 / 4.765)**2)}


def hardening(grade):
    """Linear hardening modulus from yield to tensile strength in true measures, Pa."""
    first, last, elongation = grade
    true_stress, true_strain = 1e6 * last * (1 + elongation), math.log1p(elongation)
    return (true_stress - 1e6 * first) / (true_strain - true_stress / 193e9)


def figure_6(pages, solves):
    cases = {(ball, grade): f"{ELASTIC} --yield-stress {values[0]}MPa --hardening {hardening(values):.5g} --radius {radius} "
                            f"--force-max {force:.6g}N --step-tolerance 1e-2"
             for ball, (radius, force) in BALLS.items() for grade, values in GRADES.items()}
    results = dict(zip(cases, solves.all(cases.values())))
    figure, (left, right) = pages.figure("figure_6", width=10.5, height=4.3, columns=2)
    series, curves = {}, {}
    for (ball, grade), result in results.items():
        document = need(result)
        colour = COLOURS[list(BALLS).index(ball)]
        line = "-" if grade == "typical" else "--"
        for branch in ("loading", "unloading"):
            curve = result.branch(branch)
            approach, force = 1e6 * curve["approach_m"], curve["force_N"]
            left.plot(approach, force, line, color=colour, linewidth=1.6 if grade == "typical" else 1,
                      label=f"{ball}, {grade} properties" if branch == "loading" else None)
            series.update({f"approach_um_{ball}_{grade}_{branch}": approach, f"force_N_{ball}_{grade}_{branch}": force})
        loading = result.branch("loading")
        x, y = loading["approach_m"] / document["yield"]["approach"], loading["force_N"] / document["yield"]["force"]
        curves[ball, grade] = x[1:], y[1:]
        right.loglog(x[1:], y[1:], line if ball == "9.53 mm" else ":", color=COLOURS[2 + list(GRADES).index(grade)],
                     linewidth=1.6 if ball == "9.53 mm" else 3.2, alpha=1 if ball == "9.53 mm" else 0.6, label=f"{ball}, {grade} properties")
        series.update({f"approach_over_delta_y_{ball}_{grade}": x, f"force_over_F_y_{ball}_{grade}": y})
    x = curves["9.53 mm", "minimum"][0]
    right.loglog(x, x**1.5, color="0.6", linewidth=1, label="Hertz")
    for (ball, (radius, _)), colour in zip(BALLS.items(), COLOURS):
        approach = numpy.linspace(0, 12, 60)
        hertz = 2 / 3 * 193e9 / (1 - 0.25**2) * math.sqrt(float(radius[:-2]) * 1e-3 / 2) * (approach * 1e-6)**1.5
        left.plot(approach, hertz, color=colour, linewidth=0.7, alpha=0.7, label=f"{ball}, Hertz")
    left.set(xlabel="mutual approach $\\delta$ (µm)", ylabel="normal force $F$ (N)", xlim=(0, None), ylim=(0, None),
             title="Steel 302 dimers, static properties")
    right.set(xlabel="$\\delta/\\delta_y$", ylabel="$F/F_y$", xlim=(0.2, None), ylim=(0.08, None), title="loading, dimensionless")
    left.legend(fontsize=7)
    right.legend(fontsize=7)
    pages.save(figure, "figure_6")
    pages.csv("figure_6", series, SOURCES)
    for grade in GRADES:
        (x, y), (u, v) = curves["9.53 mm", grade], curves["12.7 mm", grade]
        inside = (x >= u[0]) & (x <= u[-1])
        spread = float(numpy.abs(numpy.exp(numpy.interp(numpy.log(x[inside]), numpy.log(u), numpy.log(v))) / y[inside] - 1).max())
        pages.summarise("6", f"largest difference of F/F_y at equal delta/delta_y of both diameters ({grade} properties)", f"{100 * spread:.2g} %",
                        "size effect largely eliminated", "agrees" if spread < 0.02 else "contradicts",
                        "exact in the half-space setting; what is left is the reading between load steps")
    warned = [f"{ball} {grade}: {r.document['warnings']}" for (ball, grade), r in results.items() if r.document["warnings"]]
    document = results["9.53 mm", "typical"].document
    pages.summarise("6", "peak approach of the 9.53 mm dimer at 500 N, um (typical; minimum properties in figure_6.csv)",
                    1e6 * document["peak"]["approach"], "curve shape only, no numbers printed", "",
                    "static properties, no rate effects; a/R = " + f"{document['peak']['contact_radius'] / 4.765e-3:.3f}. " + "; ".join(warned))
