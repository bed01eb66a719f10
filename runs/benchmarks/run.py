"""What runs/benchmark measures; see there."""

import argparse
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "studies"))

import measure  # noqa: E402
import reference  # noqa: E402
import report  # noqa: E402
import space  # noqa: E402

# name: options of dpcontact solve. `elastic` has a closed form, the others a stored reference.
MATERIALS = {
    "type 1": "--E 10GPa --nu 0.15 --phi 25 --sigma-c 15MPa",
    "frictional": "--E 30GPa --nu 0.3 --phi 40 --sigma-c 5MPa",
    "plastic": "--E 10GPa --nu 0.1 --phi 20 --sigma-c 5MPa",
    "most plastic": "--E 30GPa --nu 0.1 --phi 20 --sigma-c 5MPa",
    "elastic": "--E 10GPa --nu 0.2 --phi 30 --sigma-c 1GPa",
}
ROCKS = ("type 1", "frictional", "plastic")
ALL = ROCKS + ("most plastic",)

# (series, options of dpcontact solve, materials). The first is what the others are compared with.
VARIANTS = [
    ("defaults", "", ALL + ("elastic",)),
    ("resolution", "--resolution 10", ALL),
    ("resolution", "--resolution 20", ALL),
    ("resolution", "--resolution 80", ROCKS),
    ("surface halvings", "--surface-halvings 0", ("most plastic",)),
    ("surface halvings", "--surface-halvings 1", ROCKS),
    ("surface halvings", "--surface-halvings 2", ROCKS),
    ("step tolerance", "--step-tolerance 2e-2", ALL),
    ("step tolerance", "--step-tolerance 8e-3", ALL),
    ("step tolerance", "--step-tolerance 1e-3", ("plastic",)),
    ("step tolerance", "--step-tolerance 1e-4", ("type 1", "frictional")),
    ("element", "--element quadratic", ROCKS),
    ("element", "--element linear", ROCKS),
    ("savings off", "--condensation off", ALL),
    ("savings off", "--predictor off", ROCKS),
    ("extrapolation off", "--extrapolation off --step-tolerance 2e-2", ROCKS),
    ("extrapolation off", "--extrapolation off --step-tolerance 8e-3", ("plastic",)),
    ("extrapolation off", "--extrapolation off --step-tolerance 1e-3", ("frictional",)),
    ("extrapolation off", "--extrapolation off --step-tolerance 2e-4", ("type 1",)),
    ("penalty", "--contact penalty --penalty-stiffness 1e2", ROCKS),
    ("penalty", "--contact penalty --penalty-stiffness 1e3", ROCKS),
    ("penalty", "--contact penalty --penalty-stiffness 1e4", ROCKS),
    ("penalty", "--contact penalty --penalty-stiffness 1e5", ROCKS),
    ("penalty", "--contact penalty --penalty-stiffness 1e6", ROCKS),
    ("published mesh", "--mesh published", ALL),
    ("closed form off", "--closed-form off", ("elastic",)),
]

# Quick curves are repeated; the median counts.
REPEATS, ENOUGH_SECONDS = 3, 1.2

# E, nu, phi, sigma-c (GPa, degrees, MPa) and resolution of the curves whose time is broken down.
PROFILES = [("type 1", "10 0.15 25 15", 40), ("plastic", "10 0.1 20 5", 40)]

# Eight materials of middling cost; their first two, four and eight; and two halves.
SWEEP = {"nu": ".2", "phi": "30", "E": ("20GPa", "30GPa"), "sigma-c": ("8MPa", "11MPa", "14MPa", "17MPa")}
SWEEP_REPEATS = 3

# One (nu, phi) family of the paper's grid.
FAMILY = {"nu": ".2", "phi": "30", "E": ("10GPa", "20GPa", "30GPa"),
          "sigma-c": ("5MPa", "10MPa", "20MPa", "30MPa", "40MPa", "50MPa")}


def curves(pages):
    stored = reference.load(MATERIALS)
    rows = []
    todo = [(m, series, options) for m in MATERIALS
            for series, options, materials in VARIANTS if m in materials]
    for done, (material, series, options) in enumerate(todo):
        measure.say(f"curve {done + 1} of {len(todo)}: {material} {options}")
        row = measure.curve(MATERIALS[material], options, stored[material], REPEATS, ENOUGH_SECONDS)
        row.update(material=material, series=series, options=options or "defaults")
        rows.append(row)
        pages.curve_tables(rows, stored)
    pages.cost_against_size(rows)


def kernels(pages):
    measure.say("kernels: Google Benchmark, about a quarter of a minute")
    pages.kernel_tables(measure.kernels())


def profile(pages):
    rows = []
    for material, constants, resolution in PROFILES:
        measure.say(f"profile: {material}, {resolution} elements across a")
        rows.append((f"{material}, {resolution}", measure.profile(constants, resolution)))
    pages.profile_table(rows)


def scaling(pages):
    moduli, strengths = SWEEP["E"], SWEEP["sigma-c"]
    grids = {2: (moduli[:1], strengths[::3]), 4: (moduli, strengths[::3]), 8: (moduli, strengths)}
    halves = ((moduli, strengths[::3]), (moduli, strengths[1:3]))

    def grid(values):
        return dict(SWEEP, **{"E": values[0], "sigma-c": values[1]})

    seconds = {name: [] for name in ("2 materials", "4 materials", "one worker", "two workers", "two sweeps")}
    others = []
    for k in range(SWEEP_REPEATS):
        others.append(measure.others_load())
        measure.say(f"scaling: sweeps of 2, 4 and 8 materials, round {k + 1} of {SWEEP_REPEATS}")
        seconds["2 materials"].append(measure.sweeps([grid(grids[2])], jobs=1))
        seconds["4 materials"].append(measure.sweeps([grid(grids[4])], jobs=1))
        seconds["one worker"].append(measure.sweeps([grid(grids[8])], jobs=1))
        seconds["two workers"].append(measure.sweeps([grid(grids[8])], jobs=2))
        seconds["two sweeps"].append(measure.sweeps([grid(half) for half in halves], jobs=1))
    pages.scaling_tables(seconds, others)


def families(pages):
    if not measure.has_modes():
        measure.say("families: skipped, this dpcontact sweep has no --mode")
        pages.note("families", "Families against direct", "Skipped: this `dpcontact sweep` has no `--mode`.")
        return
    results = {}
    for mode in ("direct", "families"):
        measure.say(f"families: {mode}, 18 materials")
        results[mode] = measure.mode(FAMILY, mode)
    pages.family_table(results)


def law(pages):
    measure.say("law: the contact law's calls")
    pages.law_table(measure.law())


def in_space(pages):
    space.measure_all(pages, reference.load(MATERIALS)["type 1"])


PARTS = {"curves": curves, "kernels": kernels, "profile": profile, "scaling": scaling, "families": families,
         "law": law, "space": in_space}


def main():
    parser = argparse.ArgumentParser(prog="runs/benchmark", description=__doc__)
    parser.add_argument("--reference", action="store_true", help="compute the stored references anew")
    parser.add_argument("--only", choices=PARTS, action="append", help="one part, may be repeated")
    arguments = parser.parse_args()
    if arguments.reference:
        reference.compute(MATERIALS)
        return
    clock = measure.Clock()
    pages = report.Pages(measure.OUTPUT)
    for name, part in PARTS.items():
        if name in (arguments.only or PARTS):
            part(pages)
    pages.finish(clock.seconds())
    measure.say(f"done in {clock.seconds():.0f} s, see {measure.OUTPUT / 'summary.md'}")


if __name__ == "__main__":
    main()
