"""Figures 7 to 10: a, b, m, n over the material space at E = 10 GPa, by every method of `dpcontact lookup`."""

import csv
import subprocess

import numpy

from force_displacement import TYPES, options
from pages import COLOURS
from solves import PROGRAM, need

NUMBERS = {"a": "7", "b": "8", "m": "9", "n": "10"}
# The paper draws natural neighbours; similarity is the universal table, finite elements but for .03 %.
METHODS = {"similarity": ("similarity", "-", 0), "natural-neighbour": ("natural neighbours", "-", 1), "kriging": ("Kriging", "--", 2),
           "regression": ("eq (19), 162 rows", "-.", 3), "table-2": ("eq (19), table 2", ":", 4)}
AXES = {"nu": [round(.1 + .025 * i, 3) for i in range(9)], "phi": [20 + 2.5 * i for i in range(9)],
        "sigma-c": [5 + 2.5 * i for i in range(19)]}
SOME_REFUSED = 8  # exit code; where a method has no possible law its line has a gap
LABELS = {"nu": "$\\nu$", "phi": "$\\varphi$ (°)", "sigma-c": "$\\sigma_c$ (MPa)"}
COLUMN = {"a": "a_published", "b": "b", "m": "m_published", "n": "n"}
# Table 4: unsigned errors in per cent of interpolation for type 1.
TABLE_4 = {"a": 1.92, "b": .50, "m": 9.31, "n": .75}
# Section 4.3: "the ratio of the variance to the minimum value" over the samples of E = 10 GPa.
SPAN = {"a": 29, "m": 238}


def look_up(pages, method):
    """{coefficient: values over (nu, phi, sigma_c)}; the table that it comes from stays beside the pictures."""
    file = pages.directory / f"figures_7_10_{method}.csv"
    lists = {"nu": AXES["nu"], "phi": AXES["phi"], "sigma-c": [f"{value}MPa" for value in AXES["sigma-c"]]}
    command = [str(PROGRAM), "lookup", "--method", method, "--E", "10GPa", "--csv", str(file)]
    for name, values in lists.items():
        command += [f"--{name}", ",".join(map(str, values))]
    run = subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True, text=True, check=False)
    if run.returncode not in (0, SOME_REFUSED):
        raise SystemExit(f"figures: {' '.join(command)}: {run.stderr}")
    with open(file, newline="", encoding="utf-8") as stream:
        rows = list(csv.DictReader(line for line in stream if not line.startswith("#")))
    shape = [len(values) for values in AXES.values()]
    return {name: numpy.array([float(row[column] or "nan") for row in rows]).reshape(shape) for name, column in COLUMN.items()}


def figures_7_10(pages, solves):
    tables = dict(zip(METHODS, solves.each(lambda method: look_up(pages, method), METHODS)))
    material = TYPES["type 1"]
    document = need(solves(options(material)))
    computed = {"a": document["published_convention"]["a"], "b": document["fit"]["b"],
                "m": document["published_convention"]["m"], "n": document["fit"]["n"]}
    place = tuple(list(values).index(at) for values, at in zip(AXES.values(), material[1:]))
    for name in NUMBERS:
        draw(pages, name, {method: values[name] for method, values in tables.items()}, place, computed[name])
        summarise(pages, name, {method: values[name] for method, values in tables.items()}, place, computed[name])


def draw(pages, name, tables, place, computed):
    """(a) the interpolated space, cut at type 1; (b) the same along each axis through it, by every method."""
    number, values = NUMBERS[name], tables["natural-neighbour"]
    symbol = f"${name}$" + (", $\\delta_y$ of one sphere" if name in "am" else "")
    figure, space, *lines = pages.space_and_lines(len(AXES))
    grid = numpy.meshgrid(*AXES.values(), indexing="ij")
    colours = pages.colours(values)
    for axis, at in enumerate(place):
        cut = [slice(None)] * 3
        cut[axis] = at
        space.plot_surface(*(g[tuple(cut)] for g in grid), facecolors=colours.to_rgba(values[tuple(cut)]), rstride=1, cstride=1,
                           shade=False, alpha=.9)
    space.set(**{f"{letter}label": LABELS[axis] for letter, axis in zip("xyz", AXES)}, title="natural neighbours, cuts through type 1")
    space.set(xticks=(.1, .2, .3), yticks=(20, 30, 40), zticks=(10, 20, 30, 40, 50))
    space.tick_params(labelsize=8)
    space.view_init(elev=24, azim=-52)
    figure.colorbar(colours, ax=space, shrink=.75, pad=.02, location="left", label=symbol)
    series = {}
    for k, (axis, at, axes) in enumerate(zip(AXES, AXES.values(), lines)):
        line = tuple(slice(None) if i == k else index for i, index in enumerate(place))
        series[f"{axis} ({'MPa' if axis == 'sigma-c' else 'degrees' if axis == 'phi' else '1'})"] = at
        for method, (label, style, colour) in METHODS.items():
            axes.plot(at, tables[method][line], style, color=COLOURS[colour], label=label)
            series[f"{name} over {axis}, {label}"] = tables[method][line]
        axes.plot([at[place[k]]], [computed], "o", color="k", fillstyle="none", markersize=8, label="FE, type 1")
        axes.set(xlabel=LABELS[axis], title=f"along {LABELS[axis].split(' (')[0]}")
    lines[-1].legend(fontsize=7)
    pages.save(figure, f"figure_{number}")
    pages.csv(f"figure_{number}", series, ["E = 10 GPa; each axis through type 1 (nu .15, phi 25 degrees, sigma_c 15 MPa); R = 100 mm, F_max = 100 N",
                                           "in the paper's convention: delta_y of one sphere"])


def summarise(pages, name, tables, place, computed):
    number = NUMBERS[name]
    for method, (label, _, _) in METHODS.items():
        error = 100 * abs(float(tables[method][place]) / computed - 1)
        theirs = TABLE_4[name] if method == "natural-neighbour" else ""
        why = {"natural-neighbour": "how theirs scales the axes and discretises the space is not printed",
               "similarity": "from the universal table"}.get(method, "")
        pages.summarise(number, f"type 1: error of {label} in {name} against our FE, %", error, theirs,
                        f"{error - theirs:+.2g} points" if theirs else "", why)
    nodes = tables["natural-neighbour"][::4, ::4][:, :, [0, 2, 6, 10, 14, 18]]
    if name in SPAN:
        pages.summarise(number, f"{name} of the 54 materials of E = 10 GPa: (largest - least)/least, %",
                        100 * float(nodes.max() / nodes.min() - 1), SPAN[name], "",
                        "theirs is called the ratio of the variance to the minimum; span over minimum is what comes near")
    else:
        pages.summarise(number, f"{name} of the 54 materials of E = 10 GPa: least, largest",
                        f"{nodes.min():.4g}, {nodes.max():.4g}", "below 1.5", f"largest {100 * (nodes.max() / 1.5 - 1):+.2g} % of 1.5",
                        "1.5 where nothing yields, and rounding of a fit next to it")
