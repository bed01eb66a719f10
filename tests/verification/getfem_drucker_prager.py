#!/usr/bin/python3
"""Independent check of strongly plastic loading-unloading curves, computed with GetFEM.

Two identical Drucker-Prager spheres pressed together to F_max and released, as the mirror half
model of getfem_half_space.py (which states model, units and sources).  Shares no code with the
solver of this repository.  For each material: delta_max/delta_y, delta_res/delta_y, the power-law
coefficients and both curves, extrapolated in load steps, refined in mesh, each with its error.

  /usr/bin/python3 tests/verification/getfem_drucker_prager.py            everything
  /usr/bin/python3 tests/verification/getfem_drucker_prager.py --case A   one material
  ... --print                                                            show the stored results

Writes getfem_results.json beside this file, run by run; a run already stored there is kept while
getfem_half_space.py is unchanged but for comments (--fresh computes all again).  Needs Debian's
python3-getfem 5.4, numpy, scipy and Debian's interpreter; single-threaded, deterministic; about
half an hour of CPU for all runs of a material (stored with each run).  Stored: A with all runs,
B and C with --runs 8 (two meshes, three step counts), which their wider errors show.
"""
import argparse
import ast
import hashlib
import json
import pathlib
import platform
import subprocess

import getfem_half_space as half_space
import numpy as np
import scipy
from scipy.interpolate import PchipInterpolator
from scipy.optimize import curve_fit

HERE = pathlib.Path(__file__).resolve().parent
RESULTS = HERE / "getfem_results.json"

# E [Pa], nu, phi [deg], sigma_c [Pa], R [m], F_max [N]
MATERIALS = {
    "A": dict(E=10e9, nu=0.1, phi=20.0, sigma_c=5e6, R=0.1, F_max=100.0),
    "B": dict(E=30e9, nu=0.1, phi=20.0, sigma_c=5e6, R=0.1, F_max=100.0),
    "C": dict(E=10e9, nu=0.1, phi=40.0, sigma_c=5e6, R=0.1, F_max=100.0),
}
# b over Hertz's contact radius, peak and residual d in b^2/R from a coarse run: these place the
# steps and the fine zone and nothing else.  box holds the plastic zone (checked in each step).
PLACING = {"A": (1.44, 0.574, 0.244, 4.0), "B": (1.52, 0.594, 0.347, 6.0),
           "C": (1.12, 0.815, 0.106, 6.0)}

# name: options; every variation is compared with the run it names.
BASE = dict(level=1, steps=40)
STEPS = [20, 40, 80, 160]
LEVELS = [0, 1, 2]
COARSE, COARSE_FINE = dict(level=0, steps=40), dict(level=0, steps=80)
VARIATIONS = {
    "release": (dict(COARSE, release=30), COARSE),
    "far": (dict(COARSE, far=400.0), COARSE),
    "penalty": (dict(COARSE, penalty=1e5), COARSE),
    "contact_points": (dict(BASE, contact_points=3), BASE),
    "element_Q8_3x3": (dict(BASE, gauss=3), BASE),
    "element_Q9_3x3": (dict(BASE, element="Q9", gauss=3), BASE),
}
FRACTIONS = np.array([0.02, 0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0])


def resampled(curve, origin):
    """200 points of F(delta - origin) by monotone interpolation of F^(2/3)."""
    x, force = np.array(curve).T
    inner = PchipInterpolator(x - origin, force ** (2 / 3))
    grid = (x[-1] - origin) * np.arange(1, 201) / 200
    return grid, inner(grid) ** 1.5


def quantities(result):
    """Numbers of one run: approaches, fitted coefficients, approach at fractions of F_max."""
    values = {key: result[key] for key in ("delta_max", "delta_res")}
    for names, key, origin in ((("a", "b"), "loading", 0.0),
                               (("m", "n"), "unloading", result["delta_res"])):
        x, force = resampled(result[key], origin)
        best, _ = curve_fit(lambda t, c, e: c * t**e, x, force, p0=(1.0, 1.4), maxfev=10000)
        values.update(zip(names, best))
        delta, F = np.array(result[key]).T
        at = PchipInterpolator((F / F[-1]) ** (2 / 3), delta)(FRACTIONS ** (2 / 3))
        for f, d in zip(FRACTIONS, at):
            values["%s_at_%.2f" % (key, f)] = float(d)
    return values


def estimate(runs):
    """Value and error of each quantity, both limits extrapolated at first order.

    Halving steps or elements halves the change (by_steps, by_level show it): a step sweeps the
    contact edge over a finite ring, an element resolves that edge to its own size.  The error is
    the plain sum of what each setting changes; the mesh part is all that its extrapolation adds.
    """
    def get(options):
        hit = [r for r in runs if r["options"] == options]
        return quantities(hit[0]) if hit else None

    by_steps = [v for v in (get(dict(BASE, steps=n)) for n in STEPS) if v]
    by_level = [v for v in (get(dict(BASE, level=n)) for n in LEVELS) if v]
    base, coarse, coarse_fine = get(BASE), get(COARSE), get(COARSE_FINE)
    if len(by_steps) < 3 or len(by_level) < 2 or not coarse_fine:
        return {}
    out = {}
    for key in base:
        steps, levels = [v[key] for v in by_steps], [v[key] for v in by_level]
        last, previous = 2 * steps[-1] - steps[-2], 2 * steps[-2] - steps[-3]
        gain = levels[-1] - levels[-2]
        parts = dict(steps=max(abs(last - previous), 0.25 * abs(last - steps[-1])),
                     mesh=abs(gain),
                     steps_on_mesh=2 * abs(coarse_fine[key] - coarse[key] - steps[2] + base[key]))
        for name, (changed, reference) in VARIATIONS.items():
            one, two = get(changed), get(reference)
            if one and two:
                parts[name] = abs(one[key] - two[key])
        out[key] = dict(value=last + (levels[-1] - base[key]) + gain, error=sum(parts.values()),
                        parts=parts, by_steps=steps, by_level=levels)
    return out


def hertz():
    """Elastic limit: worst |F/F_Hertz - 1| over five steps, and the residual approach."""
    material = dict(MATERIALS["A"], sigma_c=5e12)
    rows = []
    for level in LEVELS[:2]:
        r = half_space.run(material, 1.0, 1.0, 0.2, level=level, steps=5, release=5)
        x, F = np.array(r["loading"])[1:].T
        rows.append(dict(level=level, force_error=(F / x**1.5 - 1).tolist(),
                         residual_over_peak=r["delta_res"] / r["delta_max"]))
    return rows


def provenance():
    package = subprocess.run(["dpkg-query", "-W", "-f=${Version}", "python3-getfem"],
                             capture_output=True, text=True, check=False).stdout
    tree = ast.parse((HERE / "getfem_half_space.py").read_text())
    documented = (ast.Module, ast.ClassDef, ast.FunctionDef)
    for node in ast.walk(tree):  # comments and docstrings change no number
        if isinstance(node, documented) and ast.get_docstring(node):
            node.body = node.body[1:]
    return dict(command="/usr/bin/python3 tests/verification/getfem_drucker_prager.py",
                getfem=package, numpy=np.__version__, scipy=scipy.__version__,
                python=platform.python_version(), defaults=half_space.DEFAULTS,
                half_space_sha256=hashlib.sha256(ast.dump(tree).encode()).hexdigest())


def load(fresh):
    """Stored results if they come from the same half-space source, else an empty store."""
    here = provenance()
    if RESULTS.exists() and not fresh:
        store = json.loads(RESULTS.read_text())
        if store["provenance"]["half_space_sha256"] == here["half_space_sha256"]:
            return store
    return dict(provenance=here, units="delta in delta_y (mutual), F in F_y", hertz=[], cases={})


def rounded(value):
    if isinstance(value, float):
        return float("%.8g" % value)
    if isinstance(value, dict):
        return {k: rounded(v) for k, v in value.items()}
    return [rounded(v) for v in value] if isinstance(value, list) else value


def save(store):
    """One line per run or quantity, so that a changed number is a changed line."""
    def lines(value, depth):
        if depth and isinstance(value, (dict, list)) and value:
            inner = value.items() if isinstance(value, dict) else ((None, v) for v in value)
            body = ",\n".join((json.dumps(k) + ": " if k is not None else "")
                              + lines(v, depth - 1) for k, v in inner)
            return ("{\n%s\n}" if isinstance(value, dict) else "[\n%s\n]") % body
        return json.dumps(value)

    part = RESULTS.with_suffix(".part")
    part.write_text(lines(rounded(store), 4) + "\n")
    part.replace(RESULTS)


def study(store, name, budget):
    """All runs of one material, cheapest first; `budget` leaves out the dearest."""
    material, (unit, d_peak, d_rest, box) = MATERIALS[name], PLACING[name]
    F_y, delta_y = half_space.first_yield(**material)
    case = store["cases"].setdefault(name, dict(runs=[]))
    case.update(material=material, force_yield=F_y, approach_yield=delta_y,
                load_level=material["F_max"] / F_y,
                placing=dict(unit=unit, d_peak=d_peak, d_rest=d_rest, box=box))
    varied = [changed for changed, _ in VARIATIONS.values()]
    wanted = [COARSE, COARSE_FINE] + [dict(BASE, steps=n) for n in STEPS[:3]]
    wanted += [v for v in varied if v["level"] == 0] + [dict(BASE, steps=STEPS[3])]
    wanted += [dict(BASE, level=2)] + [v for v in varied if v["level"] > 0]
    for options in wanted[:budget]:
        if any(r["options"] == options for r in case["runs"]):
            continue
        result = half_space.run(material, unit, d_peak, d_rest, **dict(dict(box=box), **options))
        result["options"] = options
        case["runs"].append(result)
        case["estimate"] = estimate(case["runs"])
        save(store)
        print(name, options, "delta_max %.4f delta_res %.4f, %.0f s CPU"
              % (result["delta_max"], result["delta_res"], result["seconds"]), flush=True)
    case["estimate"] = estimate(case["runs"])
    save(store)


def table(store):
    for row in store["hertz"]:
        print("elastic limit, level %d: force off Hertz by at most %.2f %%, residual/peak %.1e"
              % (row["level"], 100 * max(map(abs, row["force_error"])), row["residual_over_peak"]))
    for name, case in store["cases"].items():
        m = case["material"]
        print("\n%s: E %g GPa, nu %g, phi %g deg, sigma_c %g MPa, F_max/F_y %.1f; CPU %.0f s"
              % (name, m["E"] / 1e9, m["nu"], m["phi"], m["sigma_c"] / 1e6, case["load_level"],
                 sum(r["seconds"] for r in case["runs"])))
        print("  apex returns: %d" % sum(r["apex_returns"] for r in case["runs"]))
        for r in case["runs"]:
            q = quantities(r)
            print("  %-52s" % ", ".join("%s %s" % kv for kv in r["options"].items()),
                  " ".join("%s %.4f" % (k, q[k]) for k in
                           ("delta_max", "delta_res", "a", "b", "m", "n")))
        for key, e in case["estimate"].items():
            if "_at_" not in key:
                print("  %-10s %10.4f +- %.4f (%.2f %%):" % (key, e["value"], e["error"],
                      100 * e["error"] / e["value"]),
                      ", ".join("%s %.4f" % kv for kv in e["parts"].items()))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--case", choices=sorted(MATERIALS), action="append")
    parser.add_argument("--runs", type=int, help="only the first so many runs of each material")
    parser.add_argument("--fresh", action="store_true", help="do not keep stored runs")
    parser.add_argument("--print", action="store_true", help="compute nothing")
    options = parser.parse_args()
    if options.print:
        table(json.loads(RESULTS.read_text()))
        return
    store = load(options.fresh)
    if not store["hertz"]:
        store["hertz"] = hertz()
        save(store)
    for name in options.case or sorted(MATERIALS):
        study(store, name, options.runs)
    table(store)


if __name__ == "__main__":
    main()
