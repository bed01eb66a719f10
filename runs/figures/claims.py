"""Section 3.4: that no tensile principal stress occurs, and that sigma_2 = sigma_3 always."""

import numpy

from pages import COLOURS
from sandstone import rock
from solves import need

CASES = {
    "sandstone, sigma_c 6.72 MPa": rock("6.72MPa"),
    "sandstone, sigma_c 10.61 MPa": rock("10.61MPa"),
    "type 1": "--E 10GPa --nu 0.15 --phi 25 --sigma-c 15MPa",
    "E 10, nu .1, phi 20, sigma_c 5": "--E 10GPa --nu 0.1 --phi 20 --sigma-c 5MPa",
    "E 30, nu .3, phi 40, sigma_c 5": "--E 30GPa --nu 0.3 --phi 40 --sigma-c 5MPa",
}
SHARE = 0.05 # of the Mises stress: from here on two principal stresses count as different


LABELS = dict(zip(CASES, [
    "sandstone, $\\sigma_c$ = 6.72 MPa", "sandstone, $\\sigma_c$ = 10.61 MPa", "type 1",
    "$E$ = 10 GPa, $\\nu$ = .1, $\\varphi$ = 20°, $\\sigma_c$ = 5 MPa", "$E$ = 30 GPa, $\\nu$ = .3, $\\varphi$ = 40°, $\\sigma_c$ = 5 MPa"]))


def near_surface(points, values, peak, width=0.05):
    """(r/a, largest value over p0) of the points less than 0.1 a deep, in rings of `width` a."""
    a = peak["contact_radius"]
    layer = (points["depth_m"] < 0.1 * a) & (points["radius_m"] < 3 * a)
    ring = (points["radius_m"][layer] / (width * a)).astype(int)
    found = [(width * (k + 0.5), values[layer][ring == k].max() / peak["pressure"]) for k in numpy.unique(ring)]
    return tuple(map(numpy.array, zip(*found)))


def section_3_4(pages, solves):
    results = dict(zip(CASES, solves.all([f"{options} --force-max 100N" for options in CASES.values()])))
    table = {key: [] for key in ("material", "largest_principal_stress_MPa", "over_p0", "over_sigma_c", "at_radius_over_a", "at_depth_over_a",
                                 "tensile_share_of_plastic_volume", "unequal_share_of_plastic_volume", "unequal_share_of_flowing_volume",
                                 "unequal_share_weighted_by_plastic_strain", "median_difference_over_mises")}
    figure, (left, right) = pages.figure("section_3_4", width=10.5, height=4.2, columns=2)
    series = {}
    for colour, (name, result) in zip(COLOURS, results.items()):
        document, points = need(result), result.table("points")
        peak = document["peak"]
        tension = points["principal_1_Pa"]
        at = int(numpy.argmax(tension))
        # The paper counts compression positive: its sigma_2 and sigma_3 are the two least compressive.
        difference = (points["principal_1_Pa"] - points["principal_2_Pa"]) / points["mises_stress_Pa"]
        volume, strain = points["volume_m3"], points["plastic_strain"]
        plastic, flowing = strain > 0, points["branch"] != "elastic"
        unequal = difference > SHARE

        def share(what, where, weight):
            return float(weight[where & what].sum() / weight[where].sum())

        order = numpy.argsort(difference[plastic])
        cumulated = numpy.cumsum(volume[plastic][order]) / volume[plastic].sum()
        values = (tension[at] / 1e6, tension[at] / peak["pressure"], tension[at] / document["material"]["sigma_c"],
                  points["radius_m"][at] / peak["contact_radius"], points["depth_m"][at] / peak["contact_radius"],
                  share(tension > 0, plastic, volume), share(unequal, plastic, volume), share(unequal, flowing, volume),
                  share(unequal, plastic, volume * strain), float(numpy.interp(0.5, cumulated, difference[plastic][order])))
        table["material"].append(name)
        for key, value in zip(list(table)[1:], values):
            table[key].append(float(value))
        right.plot(difference[plastic][order], cumulated, color=colour, label=LABELS[name])
        series.update({f"difference_over_mises_{name}": difference[plastic][order], f"share_of_plastic_volume_{name}": cumulated})

        r, s = near_surface(points, tension, peak)
        left.plot(r, s, color=colour, label=LABELS[name])
        series.update({f"radius_over_a_{name}": r, f"largest_principal_stress_over_p0_{name}": s})

        pages.summarise("section 3.4", f"largest principal stress over largest pressure, over sigma_c ({name})", f"{values[1]:.3f}, {values[2]:.3f}",
                        "no tensile principal stress", "contradicts" if values[0] > 0 else "agrees",
                        f"at r = {values[3]:.2f} a, depth {values[4]:.3f} a: outside the contact's edge the surface is stretched radially, in Hertz's field "
                        "by (1 - 2 nu) p0/3")
        pages.summarise("section 3.4", f"share of the plastic volume where sigma_2 and sigma_3 differ by over {SHARE:.0%} of the Mises stress ({name})",
                        f"{values[6]:.1%}", "sigma_2 = sigma_3 always", "contradicts" if values[6] > 0.01 else "agrees",
                        f"they are equal on the axis only; half of the plastic volume differs by over {values[9]:.0%}; weighted by plastic strain "
                        f"the share is {values[8]:.1%}")
    left.axhline(0, color="0.4", linewidth=0.8)
    left.axvline(1, color="0.4", linewidth=0.8, linestyle=":")
    left.set_ylim(-0.3, None)
    left.set(xlabel="$r/a$", ylabel="largest principal stress over $p_0$", xlim=(0, 2.1), title="less than $0.1a$ deep, 100 N (tension > 0)")
    right.axvline(SHARE, color="0.4", linewidth=0.8, linestyle=":")
    right.set(xlabel="$|\\sigma_2 - \\sigma_3|$ over Mises stress", ylabel="share of the plastic volume below", xlim=(0, 1), ylim=(0, 1),
              title="plastic volume, 100 N")
    left.legend(fontsize=7, loc="lower left")
    right.legend(fontsize=7, loc="lower right")
    pages.save(figure, "section_3_4")
    pages.csv("section_3_4", series)
    pages.csv("section_3_4_table", table, ["principal stresses tension positive, at the quadrature points at 100 N"])
