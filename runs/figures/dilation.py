"""How a, b, m, n depend on the dilation angle."""

import statistics

from pages import COLOURS, plt
from solves import say

# E (GPa), nu, phi (degrees), sigma_c (MPa): materials of table 1, and type 1.
MATERIALS = [
    (10, 0.1, 20, 20), (10, 0.2, 20, 10), (20, 0.3, 20, 20), (10, 0.3, 20, 10), (20, 0.1, 20, 30),
    (10, 0.15, 25, 15),
    (10, 0.1, 30, 20), (10, 0.2, 30, 10), (20, 0.2, 30, 20), (30, 0.3, 30, 20), (20, 0.3, 30, 10),
    (10, 0.1, 40, 20), (10, 0.2, 40, 10), (20, 0.2, 40, 30), (30, 0.3, 40, 20), (20, 0.3, 40, 10),
]
# Half the default mesh: the changes are those of the default mesh within 0.6 points of a per cent, where both converge.
ACCURACY = "--resolution 20"
RATIOS = {"phi": 1.0, "phi/2": 0.5, "0": 0.0}
SHOWN = {"a": "$a$", "b": "$b$", "m": "$m$", "n": "$n$", "residual": "$\\delta_{res}$ (% of $\\delta_{max}$)", "peak": "$\\delta_{max}$"}
NAMES = {"residual": "the residual approach (over the peak approach)", "peak": "the peak approach"}
ANGLES = {20: ("o", 0), 25: ("D", 2), 30: ("s", 1), 40: ("^", 3)}


def options(material, ratio):
    E, nu, phi, sigma_c = material
    return f"--E {E}GPa --nu {nu} --phi {phi} --sigma-c {sigma_c}MPa {ACCURACY}" + (f" --dilation {ratio * phi:g}" if ratio < 1 else "")


def values(document):
    unit = document["yield"]["approach"]
    return {**{c: document["fit"][c] for c in "abmn"}, "residual": document["residual_approach"] / unit,
            "peak": document["peak"]["approach"] / unit}


def dilation(pages, solves):
    cases = [(material, name) for material in MATERIALS for name in RATIOS]
    results = dict(zip(cases, solves.all([options(m, RATIOS[name]) for m, name in cases])))
    columns = ["E_GPa", "nu", "phi_deg", "sigma_c_MPa", "load_level", "psi", "psi_deg", *"abmn", "residual_over_delta_y", "peak_over_delta_y",
               *(f"change_{c}_percent" for c in SHOWN), "status", "reason"]
    table = {column: [] for column in columns}
    changes = {name: {c: [] for c in SHOWN} for name in RATIOS}
    levels, failures = {}, []
    for (material, name), result in results.items():
        reference = results[material, "phi"].document
        if reference is None:
            raise SystemExit(f"figures: dilation study: associated flow failed: {result.options}: {result.failure}")
        level = levels[material] = 100 / reference["yield"]["force"]
        row = [*material, level, name, RATIOS[name] * material[2]]
        if result.document is None:
            failures.append(f"{result.options}: {result.failure}")
            row += [""] * (2 * len(SHOWN)) + ["failed", result.failure]
        else:
            found, associated = values(result.document), values(reference)
            # A residual approach next to nothing has no meaningful relative change.
            change = {c: 100 * (found[c] - associated[c]) / associated["peak" if c == "residual" else c] for c in SHOWN}
            for c in SHOWN:
                changes[name][c].append((level, material[2], change[c]))
            row += [*found.values(), *change.values(), result.document["status"], result.document["reason"]]
        for column, value in zip(columns, row):
            table[column].append(value)
    pages.csv("dilation", table, ["a, b, m, n of the consistent pair (mutual approaches); changes against psi = phi, of the residual approach over the peak approach",
                                  f"load_level: peak force 100 N over F_y; solved with {ACCURACY}"])
    draw(pages, changes)

    converged = sum(all(results[m, name].document for name in RATIOS) for m in MATERIALS)
    pages.summarise("dilation", f"materials of {len(MATERIALS)} with all three dilation angles", converged, "", "", "; ".join(failures))
    for name in ("phi/2", "0"):
        for c in SHOWN:
            found = [change for _, _, change in changes[name][c]]
            extreme = max(found, key=abs)
            pages.summarise("dilation", f"change of {NAMES.get(c, c)} from psi = phi to psi = {name}: median, largest, %",
                            f"{statistics.median(found):+.2g}, {extreme:+.2g}", "not studied (associated flow assumed)", "",
                            f"{len(found)} materials, F_max/F_y from {min(levels.values()):.3g} to {max(levels.values()):.3g}")
    say(f"dilation: {converged} of {len(MATERIALS)} materials with all three angles, {len(failures)} solves failed")


def draw(pages, changes):
    figure, grid = plt.subplots(2, 3, figsize=(11, 6.2), sharex=True, layout="constrained")
    for axes, (c, label) in zip(grid.flat, SHOWN.items()):
        for name, face in (("phi/2", "none"), ("0", None)):
            for phi, (marker, colour) in ANGLES.items():
                rows = [(level, change) for level, angle, change in changes[name][c] if angle == phi]
                if rows:
                    psi = "$\\varphi/2$" if name == "phi/2" else "0"
                    axes.plot(*zip(*rows), marker, color=COLOURS[colour], markerfacecolor=face or COLOURS[colour], markersize=5.5,
                              label=f"$\\varphi$ = {phi}°, $\\psi$ = {psi}")
        axes.axhline(0, color="0.4", linewidth=0.8)
        axes.set(xscale="log", title=label)
        axes.set_xticks([3, 10, 30, 70], ["3", "10", "30", "70"])
        axes.minorticks_off()
    for axes in grid[:, 0]:
        axes.set_ylabel("change against $\\psi = \\varphi$ (%)")
    for axes in grid[1]:
        axes.set_xlabel("load level $F_{max}/F_y$")
    handles, labels = grid[0, 0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="upper center", bbox_to_anchor=(0.5, 0), ncols=4, fontsize=8)
    pages.save(figure, "dilation")
