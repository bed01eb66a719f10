"""What contact in space costs: against axisymmetry, by linear solver and size, by processes."""

import json
import os
import subprocess

import measure
import report

ROCK = "--E 10GPa --nu 0.15 --phi 25 --sigma-c 15MPa"
STEPS = "--loading-steps 16"  # of all, so that only mesh and element differ

CURVES = [f"--resolution {r}" for r in (10, 20, 40)] + [
    "--element quadratic --resolution 6",
    "--geometry sector --resolution 4",
    "--geometry sector",
    "--geometry sector --sector-angle 90 --resolution 4",
    "--geometry sector --element brick --resolution 8",
    "--geometry sector --element brick --resolution 16",
    "--geometry disc --element brick --resolution 6",
]

# Geometry, element, resolution, level, far boundary: steps of growing size.
SIZES = ["sector brick 8 0 200", "sector brick 16 0 200", "sector brick 32 0 200", "sector quadratic 4 0 200",
         "sector quadratic 6 0 200", "sector brick 8 1 200"]
LARGEST_DIRECT = 31000  # unknowns that the direct solver is timed with

# Strong: one scene by one and two processes. Weak: half of the quarter by one, the quarter by two.
SCALED = "sector brick 8 1 200 iterative"


def steps(case, processes=1, angle=90):
    """What dpcontact_space prints for a case."""
    launcher = ["mpirun", "--oversubscribe", "-np", str(processes)] if processes > 1 else []
    environment = {**os.environ, "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}
    command = [*launcher, str(measure.BUILD / "dpcontact_space"), *case.split(), str(angle)]
    return json.loads(subprocess.run(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                     stderr=subprocess.DEVNULL, env=environment, check=True).stdout)


def total(result, key):
    return sum(step[key] for step in result["steps"])


def per_solve(result):
    return total(result, "linear_iterations") / total(result, "linear_solves")


def per_newton(result):
    return total(result, "seconds") / total(result, "newton_iterations")


def curves(pages, reference):
    lines, rows = [], []
    for options in CURVES:
        measure.say(f"space: {options}")
        row = measure.curve(ROCK, f"{options} {STEPS}", reference, 1, 0)
        rows.append([options, *(row.get(c, "") for c in ("law_error", "coefficient_error", "processor_seconds",
                                                         "dofs", "newton_iterations", "peak_memory_bytes", "failure"))])
        pages.csv("space_curves", ["options", "law_error", "coefficient_error", "processor_seconds", "dofs",
                                   "newton_iterations", "peak_memory_bytes", "failure"], rows)
        if row["failure"]:
            lines.append([f"`{options}`", f"failed: {row['failure']}", "", "", "", ""])
            continue
        lines.append([f"`{options}`", report.percent(row["law_error"]), report.percent(row["coefficient_error"]),
                      report.time_text(row["processor_seconds"]), row["dofs"],
                      f"{row['peak_memory_bytes'] / 1e6:.0f}"])
    return (f"Type 1, `{STEPS}`; errors from the reference of the axisymmetric curves.\n\n" +
            report.table(["options", "law", "a, b, m, n", "s", "DoFs", "MB"], lines))


def linear_solvers(pages):
    lines, rows = [], []
    for case in SIZES:
        for solver in ("iterative", "direct"):
            if solver == "direct" and rows[-1][2] > LARGEST_DIRECT:
                continue
            measure.say(f"space: steps, {case} {solver}")
            result = steps(f"{case} {solver}")
            rows.append([case, solver, result["unknowns"], per_solve(result), per_newton(result),
                         total(result, "newton_iterations"), result["memory_bytes"], result["elastic_error"]])
            lines.append([case, solver, result["unknowns"],
                          f"{per_solve(result):.1f}" if solver == "iterative" else "",
                          report.time_text(per_newton(result)), f"{result['memory_bytes'] / 1e6:.0f}",
                          report.percent(abs(result["elastic_error"]))])
            pages.csv("space_linear_solvers", ["case", "solver", "unknowns", "iterations_per_solve",
                                               "seconds_per_newton", "newton_iterations", "memory_bytes",
                                               "elastic_error"], rows)
    return ("An elastic and a plastic step of a quarter (`build/dpcontact_space`); two solutions a Newton iteration.\n\n" +
            report.table(["mesh", "solver", "unknowns", "iterations / solve", "s / Newton", "MB", "error of Hertz's approach"],
                         lines))


def processes(pages):
    cases = {"quarter, 1": (1, 90), "quarter, 2": (2, 90), "eighth, 1": (1, 45)}
    results = {}
    for name, (n, angle) in cases.items():
        measure.say(f"space: {SCALED}, {name} processes")
        results[name] = steps(SCALED, n, angle)
    pages.csv("space_processes", ["case", "unknowns", "seconds_per_newton", "iterations_per_solve", "memory_bytes"],
              [[name, r["unknowns"], per_newton(r), per_solve(r), r["memory_bytes"]] for name, r in results.items()])
    one, two, half = results.values()
    return (f"`{SCALED}`: {one['unknowns']} unknowns by one process {per_newton(one):.2f} s a Newton iteration, by two "
            f"{per_newton(two):.2f} (strong scaling, {100 * per_newton(one) / per_newton(two) / 2:.0f} % of twice as fast), "
            f"iterations a solve {per_solve(one):.1f} and {per_solve(two):.1f}. Half of it ({half['unknowns']} unknowns) by one "
            f"{per_newton(half):.2f} (weak scaling: {100 * per_newton(half) / per_newton(two):.0f} %).\n")


def measure_all(pages, reference):
    text = curves(pages, reference) + "\n"
    pages.note("space", "In space", text)
    text += linear_solvers(pages) + "\n"
    pages.note("space", "In space", text)
    pages.note("space", "In space", text + processes(pages))
