"""Tables, CSV files and the plot."""

import csv
import math
import os
import statistics

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

from laws import COEFFICIENTS  # noqa: E402
from reference import doubt  # noqa: E402

CURVE_COLUMNS = ["material", "series", "options", "failure", "processor_seconds", "wall_seconds", "runs",
                 "law_error", "coefficient_error", "step_error", "dofs", "steps", "newton_iterations",
                 "cut_backs", "peak_memory_bytes"]
PARTS_OF_ITERATION = [("factorise", 1), ("solve", 2), ("assemble", 1), ("residual", 1)]
ONCE = ["mesh", "discretisation", "system", "cores", "fit"]
STAGES = ["factorise", "solve", "assemble", "residual", "rest after a step", "core", "mesh",
          "discretisation", "elastic stiffness", "fit", "other"]
# Series of the plot that the defaults belong to as well.
REFINED = ("resolution", "surface halvings", "step tolerance")
# Below this an error is one of rounding and has no place on a logarithmic axis.
LEAST_ERROR = 1e-7


def percent(value):
    if value == 0:
        return "0"
    return f"{100 * value:.2g} %" if value < 0.995 else f"{100 * value:.0f} %"


def time_text(seconds):
    return f"{seconds:.2f}" if seconds < 10 else f"{seconds:.1f}"


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    return "\n".join(lines + ["| " + " | ".join(map(str, row)) + " |" for row in rows]) + "\n"


def exponent(xs, ys):
    """Slope of the straight line through log y over log x."""
    return statistics.linear_regression([math.log(x) for x in xs], [math.log(y) for y in ys]).slope


class Pages:
    def __init__(self, directory):
        self.directory = directory
        self.sections = {}
        directory.mkdir(parents=True, exist_ok=True)

    def note(self, key, title, text):
        """A section; one that is written again replaces itself, so that a killed run leaves what it has."""
        self.sections[key] = f"## {title}\n\n{text}"
        self.write("")

    def write(self, end):
        text = "\n\n".join(["# Speed against error", *self.sections.values()])
        (self.directory / "summary.md").write_text(text + "\n" + end, encoding="utf-8")

    def finish(self, seconds):
        self.write(f"\nMeasured by `runs/benchmark` in {seconds:.0f} s.\n")

    def csv(self, name, head, rows):
        with open(self.directory / f"{name}.csv", "w", newline="", encoding="utf-8") as file:
            writer = csv.writer(file)
            writer.writerow(head)
            writer.writerows(rows)

    # Whole curves.

    def curve_tables(self, rows, stored):
        self.csv("curves", CURVE_COLUMNS, [[row.get(c, "") for c in CURVE_COLUMNS] for row in rows])
        text = ("`law`: largest difference of the fitted law's force from the reference's over both branches, over the "
                "peak force; `a, b, m, n`: largest relative difference of a coefficient. Seconds are the processor's, "
                "without the program's start-up; `time` is their ratio to the defaults' of the same material.\n")
        for material in dict.fromkeys(row["material"] for row in rows):
            text += "\n" + self.curve_table(material, [r for r in rows if r["material"] == material],
                                            stored[material])
        self.note("curves", "Whole curves", text)
        self.plot(rows, stored)

    def curve_table(self, material, rows, reference):
        level = reference["scene"]["force_max"] / reference["yield"]["force"]
        text = f"**{material}** (Λ = {level:.3g}, `{reference['command'].split(' --resolution')[0].removesuffix(' --json')}`)"
        if reference["witnesses"]:
            law, coefficient = doubt(reference)
            text += (f". Other fine meshes differ from the reference by up to {percent(law)} in the law and "
                     f"{percent(coefficient)} in a coefficient (`runs/benchmarks/benchmark_reference.json`): smaller errors say "
                     "nothing.")
        head = ["options", "law", "a, b, m, n", "s", "time", "DoFs", "steps", "Newton", "ms / Newton", "MB"]
        default = rows[0]["processor_seconds"]
        lines = []
        for row in rows:
            if row["failure"]:
                lines.append([f"`{row['options']}`", f"failed: {row['failure']}", "", time_text(row["processor_seconds"]),
                              "", "", "", "", "", ""])
                continue
            iterations = row["newton_iterations"]
            lines.append([
                row["options"] if row["options"] == "defaults" else f"`{row['options']}`",
                percent(row["law_error"]), percent(row["coefficient_error"]), time_text(row["processor_seconds"]),
                f"{row['processor_seconds'] / default:.2f}" if default > 0.02 else "",
                row["dofs"], row["steps"], iterations,
                f"{1e3 * row['processor_seconds'] / iterations:.2f}" if iterations else "",
                f"{row['peak_memory_bytes'] / 1e6:.0f}"])
        return text + "\n\n" + table(head, lines)

    def plot(self, rows, stored):
        materials = [m for m in dict.fromkeys(row["material"] for row in rows) if stored[m]["witnesses"]]
        figure, axes = plt.subplots(2, 2, figsize=(11, 8.5), squeeze=False)
        series = list(dict.fromkeys(row["series"] for row in rows))
        markers = "*os^vDPXh<>"
        for axis, material in zip(axes.flat, materials):
            for k, name in enumerate(series):
                picked = [row for row in rows if row["material"] == material and not row["failure"] and
                          (row["series"] == name or (name in REFINED and row["series"] == "defaults"))]
                points = [(row["processor_seconds"], max(row["law_error"], LEAST_ERROR)) for row in picked]
                if len(points) > (name in REFINED):
                    axis.plot(*zip(*(sorted(points) if name in REFINED else points)), label=name,
                              marker=markers[k % len(markers)], color=f"C{k % 10}", linewidth=1,
                              linestyle="-" if name in REFINED or name == "penalty" else "",
                              markersize=13 if name == "defaults" else 6, zorder=3 if name == "defaults" else 2)
            axis.axhspan(LEAST_ERROR / 10, doubt(stored[material])[0], color="0.9", label="doubt about reference")
            axis.set(xscale="log", yscale="log", title=material,
                     xlabel="processor time of a curve (s)", ylabel="error of the law (of the peak force)")
            low = min((row["law_error"] for row in rows if row["material"] == material and not row["failure"]),
                      default=1e-5)
            axis.set_ylim(bottom=max(LEAST_ERROR, min(low, doubt(stored[material])[0]) / 2))
            axis.grid(True, which="both", color="0.93", zorder=0)
            axis.xaxis.set_major_formatter("{x:g}")
            axis.xaxis.set_minor_formatter(lambda x, _: f"{x:g}" if f"{x:e}"[0] in "25" else "")
        for axis in list(axes.flat)[len(materials):]:
            axis.set_visible(False)
        handles = {}
        for axis in axes.flat:
            handles.update({label: h for h, label in zip(*axis.get_legend_handles_labels())})
        figure.legend(handles.values(), handles.keys(), loc="lower center", ncol=5, frameon=False)
        figure.tight_layout(rect=(0, 0.07, 1, 1))
        for suffix in ("png", "svg"):
            figure.savefig(self.directory / f"error_against_time.{suffix}", dpi=150)
        plt.close(figure)

    def cost_against_size(self, rows):
        lines, numbers, slopes = [], [], []
        for material in dict.fromkeys(row["material"] for row in rows):
            picked = sorted((row for row in rows if row["material"] == material and not row["failure"] and
                             row["series"] in ("defaults", "resolution") and row["newton_iterations"]),
                            key=lambda row: row["dofs"])
            for row in picked:
                per_iteration = row["processor_seconds"] / row["newton_iterations"]
                numbers.append([material, row["dofs"], row["newton_iterations"], per_iteration, row["processor_seconds"]])
                lines.append([material, row["dofs"], row["newton_iterations"], f"{1e3 * per_iteration:.2f}",
                              f"{1e6 * per_iteration / row['dofs']:.2f}", time_text(row["processor_seconds"])])
            if len(picked) > 2:
                dofs = [row["dofs"] for row in picked]
                slopes.append(f"{material} {exponent(dofs, [r['processor_seconds'] / r['newton_iterations'] for r in picked]):.2f} and "
                              f"{exponent(dofs, [r['processor_seconds'] for r in picked]):.2f}")
        head = ["material", "DoFs", "Newton", "ms / Newton", "µs / Newton / DoF", "s / curve"]
        self.csv("cost_against_size", ["material", "dofs", "newton_iterations", "seconds_per_iteration", "seconds"], numbers)
        text = table(head, lines)
        if slopes:
            text += "\nExponents in the DoFs, an iteration's and a curve's: " + "; ".join(slopes) + ".\n"
        self.note("size", "Cost against size", text)

    # Parts of a curve.

    def kernel_tables(self, kernels):
        self.csv("kernels", ["kernel", "resolution", "condensed", "processor_seconds", "unknowns"],
                 [[*(list(key) + ["", ""])[:3], seconds, int(line["unknowns"]) if "unknowns" in line else ""]
                  for key, (seconds, line) in kernels.items()])
        meshes = sorted({key[1] for key in kernels if key[0] == "mesh"})
        names = [name for name, _ in PARTS_OF_ITERATION]
        lines = []
        for resolution in meshes:
            for condensed in (1, 0):
                whole, line = kernels[("newton_iteration", resolution, condensed)]
                shares = [count * kernels[(name, resolution, condensed)][0] / whole
                          for name, count in PARTS_OF_ITERATION]
                lines.append([resolution, "core at the peak" if condensed else "whole body", int(line["unknowns"]),
                              f"{1e3 * whole:.2f}", *(f"{100 * share:.0f} %" for share in shares),
                              f"{100 * sum(shares):.0f} %"])
        text = ("One Newton iteration at the peak of the plastic material (Λ = 392), processor time: the share of one "
                "factorisation, two solutions, one assembly and one residual, each measured alone.\n\n" +
                table(["elements across a", "solved for", "unknowns", "ms", *names, "sum"], lines))
        lines = []
        for name in ONCE:
            cells = [kernels.get((name, r), kernels.get((name, r, 1), kernels.get((name,))))[0] for r in meshes]
            lines.append([name, *(f"{1e3 * seconds:.1f}" for seconds in cells)])
        text += ("\nWhat a curve does once (`system`: elastic stiffness and the smallest core; `cores`: all others up to "
                 "the peak's; `fit`: of one curve, whatever its mesh), ms:\n\n" + table(["", *map(str, meshes)], lines))
        points = [f"{key[1]} {1e9 * seconds:.0f} ns" for key, (seconds, _) in kernels.items() if key[0] == "material_point"]
        text += "\nMaterial update and tangent of one point: " + ", ".join(points) + ".\n"
        self.note("kernels", "Parts", text)

    def law_table(self, law):
        self.csv("law", ["case", "nanoseconds"], list(law.items()))
        lines = [[name, f"{value:.1f}", f"{100 * value / law['hertz']:.0f} %"]
                 for name, value in law.items() if name != "construction"]
        self.note("law", "The contact law", "Processor time of a call, median of nine:\n\n" +
                  table(["", "ns", "of a Hertz call"], lines) +
                  f"\nA universal law is made in {1e-3 * law['construction']:.0f} µs.\n")

    def profile_table(self, profiles):
        lines, numbers = [], []
        for name, profile in profiles:
            share = profile["share"]
            lines.append([name, profile["samples"], *(f"{100 * share.get(s, 0):.1f} %" for s in STAGES),
                          f"{100 * profile['share_in_pilots']:.1f} %"])
            numbers.append([name, profile["samples"], *(share.get(s, 0) for s in STAGES), profile["share_in_pilots"],
                            profile["share_of_cut_stacks"]])
        self.csv("profile", ["curve", "samples", *STAGES, "pilots", "cut_stacks"], numbers)
        text = ("Share of the processor time of whole curves, sampled by its timer and booked on the deepest of these "
                "stages in the stack (`solve` includes both right-hand sides; `core`: making cores, with condensation; "
                "the load path of the pilots is in the other columns too).\n\n")
        # One column a curve reads better than one a stage.
        columns = list(zip(*lines))
        heads = ["samples", *STAGES, "of all, pilots' paths"]
        text += table(["", *columns[0]], [[head, *column] for head, column in zip(heads, columns[1:])])
        self.note("profile", "Where a curve's time goes", text)

    # Sweeps.

    def scaling_tables(self, seconds, idle_loads):
        names = list(seconds)
        self.csv("scaling", ["round", *names], [[k + 1, *values] for k, values in enumerate(zip(*seconds.values()))])

        def spread(values):
            return f"{statistics.median(values):.2f} ({min(values):.2f} … {max(values):.2f})"

        def ratio(over, under):
            return [a / b for a, b in zip(seconds[over], seconds[under])]

        text = ("Wall seconds of fresh sweeps, median and range of the rounds; ratios are of one round each. Others' load "
                f"while this was measured (processor seconds not ours, per second): {spread(idle_loads)}, of {os.cpu_count()} "
                "cores: two workers can have what that leaves.\n\n")
        text += table(["materials, one worker", "s", "s / material"],
                      [[k, spread(seconds[name]), spread([s / k for s in seconds[name]])]
                       for k, name in ((2, "2 materials"), (4, "4 materials"), (8, "one worker"))])
        text += "\n" + table(["8 materials", "s", "faster than one worker"],
                             [["one worker", spread(seconds["one worker"]), ""],
                              ["two workers", spread(seconds["two workers"]), spread(ratio("one worker", "two workers"))],
                              ["two sweeps of one worker and 4 materials", spread(seconds["two sweeps"]),
                               spread(ratio("one worker", "two sweeps"))]])
        text += ("\nThroughput of two workers over that of two independent sweeps: "
                 f"{spread(ratio('two sweeps', 'two workers'))}.\n")
        self.note("scaling", "Workers", text)

    def family_table(self, results):
        seconds = {mode: value[0] for mode, value in results.items()}
        rows = {mode: {(r["E_Pa"], r["sigma_c_Pa"]): r for r in value[1]} for mode, value in results.items()}
        numbers = []
        for key, direct in rows["direct"].items():
            other = rows["families"][key]
            numbers.append([*key, direct["load_level"],
                            *(float(other[c]) / float(direct[c]) - 1 for c in COEFFICIENTS)])
        self.csv("families", ["E_Pa", "sigma_c_Pa", "load_level", *(f"difference_{c}" for c in COEFFICIENTS)], numbers)
        lines = [[c, *(percent(x) for x in (statistics.median(d), max(d)))]
                 for c, d in ((c, [abs(row[3 + k]) for row in numbers]) for k, c in enumerate(COEFFICIENTS))]
        text = (f"18 materials of one (ν, φ) with two workers: direct {seconds['direct']:.1f} s, by families "
                f"{seconds['families']:.1f} s ({seconds['direct'] / seconds['families']:.2f} times faster).\n\n" +
                table(["relative difference of", "median", "largest"], lines))
        self.note("families", "Families against direct", text)
