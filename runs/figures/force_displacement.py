"""Figures 11 and 12: force against displacement of the materials of table 3."""

import numpy

from pages import COLOURS
from solves import need

# E (GPa), nu, phi (degrees), sigma_c (MPa)
TYPES = {"type 1": (10, 0.15, 25, 15), "type 2": (10, 0.25, 35, 25)}
NUMBERS = {"type 1": "11", "type 2": "12"}
# Table 2: C0 … C6 of eq (19) for a, b, m, n, in the paper's convention (approach at yield per sphere).
TABLE_2 = {
    "a": (0.5398, 1.0279e-3, -4.7213e-2, 7.6500e-5, -6.1476e-3, 5.5848e-5, -4.4023e-3),
    "b": (1.3087, -8.7130e-4, 4.4259e-2, -7.6019e-5, 6.4120e-3, -3.8951e-5, 3.3763e-3),
    "m": (2.3104, 9.6205e-3, -2.8768e-1, 9.1244e-4, -7.1235e-2, 6.6345e-4, -4.8732e-2),
    "n": (1.2377, -1.2352e-3, 3.6574e-2, -9.5000e-5, 8.0222e-3, -7.9491e-5, 6.2875e-3),
}
# The paper's own FE: eq (19) taken back through table 4's errors.
PAPERS_FE = {"type 1": (0.3687, 1.4710, 0.4253, 1.4701), "type 2": (0.3553, 1.4951, 0.3565, 1.4930)}
# Table 4: unsigned errors in per cent of eq (19) for a, b, m, n.
TABLE_4 = {"type 1": (4.05, 0.66, 34.30, 1.47), "type 2": (3.84, 0.49, 56.37, 0.90)}
# Table 3: F_y (N), delta_y (mm, per sphere).
TABLE_3 = {"type 1": (9.06, 0.00164), "type 2": (84.45, 0.00706)}


def options(material):
    E, nu, phi, sigma_c = material
    return f"--E {E}GPa --nu {nu} --phi {phi} --sigma-c {sigma_c}MPa"


def regression(material):
    """a, b, m, n of eq (19), in the paper's convention."""
    E, nu, phi, sigma_c = material
    terms = (1, E, nu, phi**2, phi, sigma_c**2, sigma_c)
    return {name: sum(c * t for c, t in zip(constants, terms)) for name, constants in TABLE_2.items()}


def laws(law, F_y, delta_y, peak_force, peak_approach, residual=None):
    """(approach, force) of both branches of a power law; the residual approach by eq (18) unless given."""
    a, b, m, n = (law[c] for c in "abmn")
    if residual is None:
        residual = peak_approach - delta_y * (peak_force / (m * F_y))**(1 / n)
    up, down = numpy.linspace(0, peak_approach, 200), numpy.linspace(residual, peak_approach, 200)
    return (up, F_y * a * (up / delta_y)**b), (down, F_y * m * ((down - residual) / delta_y)**n)


def figures_11_12(pages, solves):
    results = dict(zip(TYPES, solves.all([options(m) for m in TYPES.values()])))
    for name, result in results.items():
        draw(pages, name, result)


def draw(pages, name, result):
    document = need(result)
    number, material = NUMBERS[name], TYPES[name]
    E, nu = 1e9 * material[0], material[1]
    F_y, delta_y, peak = document["yield"]["force"], document["yield"]["approach"], document["peak"]
    figure, axes = pages.figure(f"figure_{number}")
    series = {}

    def plot(label, up, down, style, colour, **more):
        for branch, (x, y) in (("loading", up), ("unloading", down)):
            axes.plot(1e3 * x, y, style, color=COLOURS[colour], label=label if branch == "loading" else None, **more)
            series.update({f"approach_mm_{label}_{branch}": 1e3 * x, f"force_N_{label}_{branch}": y})

    curves = [result.branch(branch) for branch in ("loading", "unloading")]
    up, down = ((curve["approach_m"], curve["force_N"]) for curve in curves)
    plot("FE", up, down, "o", 0, markersize=3, fillstyle="none", markeredgewidth=0.8)
    plot("fitted law (16), (17)", *laws(document["fit"], F_y, delta_y, peak["force"], peak["approach"], document["residual_approach"]), "-", 1)
    # In the paper's convention the approach at yield is per sphere; its law ends where it reaches the peak force.
    law = regression(material)
    end = delta_y / 2 * (peak["force"] / (law["a"] * F_y))**(1 / law["b"])
    plot("eq (19) with table 2", *laws(law, F_y, delta_y / 2, peak["force"], end), "--", 2)
    residual = end - delta_y / 2 * (peak["force"] / (law["m"] * F_y))**(1 / law["n"])
    if residual < 0:
        axes.annotate("eq (19) unloads to a negative $\\delta_{res}$", (0.02, 0.60), xycoords="axes fraction", fontsize=8, color=COLOURS[2])
    pages.summarise(number, f"{name}: residual approach, um: FE, and eq (18) with eq (19)",
                    f"{1e6 * document['residual_approach']:.3g}, {1e6 * residual:.3g}", "drawn, no number printed", "",
                    "m of eq (19) is off by what table 4 says")
    x = numpy.linspace(0, peak["approach"], 200)
    hertz = 4 / 3 * E / (2 * (1 - nu**2)) * numpy.sqrt(0.05) * x**1.5
    inside = hertz <= 1.02 * peak["force"]
    axes.plot(1e3 * x[inside], hertz[inside], ":", color="k", label="Hertz")
    series.update({"approach_mm_Hertz": 1e3 * x[inside], "force_N_Hertz": hertz[inside]})
    axes.set(xlabel="normal displacement $\\delta$, mutual (mm)", ylabel="normal force $F$ (N)", xlim=(0, None), ylim=(0, None),
             title=f"{name.capitalize()}: $E$ = {material[0]} GPa, $\\nu$ = {nu}, $\\varphi$ = {material[2]}°, $\\sigma_c$ = {material[3]} MPa")
    axes.legend(fontsize=8)
    pages.save(figure, f"figure_{number}")
    pages.csv(f"figure_{number}", series, ["delta: mutual approach. eq (19) in the paper's convention: delta_y per sphere; residual by eq (18)"])
    summarise(pages, number, name, document, law)


def summarise(pages, number, name, document, law):
    fit, published = document["fit"], document["published_convention"]
    ours = {"a": published["a"], "b": fit["b"], "m": published["m"], "n": fit["n"]}
    # Half a unit of table 3's last digit.
    pages.summarise("table 3", f"{name}: F_y, N", document["yield"]["force"], TABLE_3[name][0], "",
                    "rounding; eq (10) lacks a factor (1 + nu), restored here")
    pages.summarise("table 3", f"{name}: delta_y per sphere, mm", 1e3 * published["approach_yield"], TABLE_3[name][1], "",
                    "rounding; eq (13) gives twice this: table 3 is per sphere")
    reason = {"type 1": "their mesh is coarse; an independent computation gives .3655, 1.4735, .4275, 1.4665",
              "type 2": "nearly elastic: Hertz is .3536, 1.5, .3536, 1.5, from which theirs is off"}[name]
    for k, c in enumerate("abmn"):
        pages.summarise(number, f"{name}: {c}, paper's convention, FE", ours[c], PAPERS_FE[name][k], "",
                        reason + "; theirs is eq (19) taken back through table 4's error")
        error = 100 * abs(law[c] / ours[c] - 1)
        pages.summarise(number, f"{name}: error of eq (19) with table 2 in {c} against our FE, %", error, TABLE_4[name][k],
                        f"{error - TABLE_4[name][k]:+.2g} points", "theirs is against their own FE (table 4)")
