"""The references that errors are measured against, and how far they can be trusted."""

import json
import pathlib

import measure
from laws import COEFFICIENTS, coefficient_difference, law_difference

FILE = pathlib.Path(__file__).resolve().parent / "benchmark_reference.json"

# The reference first, then its witnesses: fine meshes on which the edge of the contact meets other nodes. What
# they disagree on is not known better. The tolerances make the load step end where no step is cut back any more:
# where the 16 steps it starts with are, they become 32, and the difference from 32 says nothing (39 and 48 steps on
# both branches for the plastic material on FINE: the defaults end there, 1.7 % of the peak force away).
FINE, COARSER = "--resolution 80 --surface-halvings 1", "--resolution 60 --surface-halvings 1"
MOVED = FINE + " --mesh-stretch 1.02"
RUNS = {
    "type 1": ("--step-tolerance 1e-4", FINE, COARSER, MOVED),
    "frictional": ("--step-tolerance 5e-5", FINE, COARSER),
    "plastic": ("--step-tolerance 3e-4", MOVED, COARSER),
    "most plastic": ("--step-tolerance 8e-4", FINE, COARSER),
    "elastic": ("", ""),  # the closed form
}


def load(materials):
    stored = json.loads(FILE.read_text(encoding="utf-8"))["references"]
    missing = [name for name in materials if name not in stored]
    if missing:
        raise SystemExit(f"benchmark: {FILE} lacks {', '.join(missing)}: run runs/benchmark --reference")
    return stored


def compute(materials):
    references = {}
    for name, constants in materials.items():
        tolerance, *meshes = RUNS[name]
        commands = [" ".join(f"{constants} {mesh} {tolerance}".split()) for mesh in meshes]
        results = []
        for command in commands:
            measure.say(f"reference: {command}")
            run = measure.solve(command)
            if run.document is None:
                raise SystemExit(f"benchmark: {run.message}")
            results.append(run.document)
        references[name] = entry(commands, results)
        text = json.dumps({"made_again_by": "runs/benchmark --reference", "references": references},
                          indent=2, ensure_ascii=False)
        FILE.write_text(text + "\n", encoding="utf-8")


def entry(commands, results):
    finest, others = results[0], results[1:]
    return {
        "command": "dpcontact solve " + commands[0] + " --json",
        "git_revision": finest["versions"]["git_revision"],
        "scene": finest["scene"],
        "yield": {key: finest["yield"][key] for key in ("force", "approach")},
        "peak": {"approach": finest["peak"]["approach"]},
        "residual_approach": finest["residual_approach"],
        "fit": {c: finest["fit"][c] for c in COEFFICIENTS},
        "step_error": finest["step_error"],
        "cost": {key: finest["cost"][key] for key in ("dofs", "steps", "cut_backs", "wall_seconds")},
        "witnesses": [{"command": "dpcontact solve " + command + " --json",
                       "law_difference": law_difference(result, finest),
                       "coefficient_difference": coefficient_difference(result, finest)}
                      for command, result in zip(commands[1:], others)],
    }


def doubt(stored):
    """How far the witnesses are from a reference: (law, coefficient), 0 for a closed form."""
    return tuple(max((witness[key] for witness in stored["witnesses"]), default=0.0)
                 for key in ("law_difference", "coefficient_difference"))
