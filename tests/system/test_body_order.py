"""Everything that the program says of two bodies is the same in either order of them."""

import json

import program

FIRST = {"E": "10GPa", "nu": "0.15", "phi": "25", "sigma-c": "15MPa", "radius": "20mm"}
# What the second body may have of its own, in turn and all together.
OTHER = {"E": "30GPa", "nu": "0.3", "phi": "35", "sigma-c": "30MPa", "radius": "3mm", "dilation": "5",
         "hardening": "2GPa", "flow-stress-ratio": "0.9"}
COARSE = ["--resolution", "10", "--step-tolerance", "1e-2", "--force-max", "5N"]

# A Newton iteration ends below 1e-10 of the load; the orders differ in rounding and in when it ends.
SAME = 1e-6
UNREPEATABLE = {"wall_seconds", "peak_memory_bytes", "newton_iterations", "solves", "iterations"}
# Rounding themselves, or differences of what is nearly equal.
ROUNDING = {"residual", "yield_excess", "penetration", "energy_error", "axisymmetry_deviation"}


def leaves(document, path=()):
    items = document.items() if isinstance(document, dict) else enumerate(document)
    for key, value in items:
        if isinstance(value, (dict, list)):
            yield from leaves(value, (*path, key))
        else:
            yield (*path, key), value


def swapped(document):
    """The document of the other order, from this one."""
    result = json.loads(json.dumps(document))
    result["yield"]["body_forces"].reverse()
    for zone in ["plastic_zone", "flow_zone"]:
        result[zone], result[f"second_{zone}"] = result[f"second_{zone}"], result[zone]
    material, scene = result["material"], result["scene"]
    second = scene["second"]
    for key in material:
        if key != "criterion":
            material[key], second[key] = second[key], material[key]
    scene["radius"], second["radius"] = second["radius"], scene["radius"]
    return result


class BodyOrder(program.TestCase):
    def solve(self, first, second):
        words = [f"--{name}={value}" for name, value in first.items()]
        words += [f"--{name}-2={value}" for name, value in second.items()]
        result = self.run_program("solve", *words, *COARSE, "--json")
        self.assertEqual(result.returncode, 0, result.stderr)
        return json.loads(result.stdout), result.stderr

    def test_documents_are_symmetric(self):
        for names in [*([name] for name in OTHER), list(OTHER)]:
            with self.subTest(names):
                standard = {"dilation": FIRST["phi"], "hardening": "0", "flow-stress-ratio": "1"}
                first = {**standard, **FIRST}
                second = {**first, **{name: OTHER[name] for name in names}}
                if "phi" in names and "dilation" not in names:
                    second["dilation"] = second["phi"]
                (there, words), (back, words_back) = self.solve(first, second), self.solve(second, first)
                self.assertEqual(sorted(words.splitlines()), sorted(words_back.splitlines()))
                self.compare(swapped(there), back)

    def compare(self, one, other):
        one, other = dict(leaves(one)), dict(leaves(other))
        self.assertEqual(one.keys(), other.keys())
        compared = 0
        for path, value in one.items():
            name = path[-1]
            if name in UNREPEATABLE | ROUNDING or path[0] == "versions":
                continue
            if isinstance(value, float):
                # of differences of two curves: over what they are differences of
                scale = 1 if path[0] in ("fit", "error", "step_error") else abs(value)
                self.assertAlmostEqual(value, other[path], delta=SAME * max(scale, abs(value)) + 1e-300, msg=f"{path}")
            else:
                self.assertEqual(value, other[path], path)
            compared += 1
        self.assertGreater(compared, 100)


if __name__ == "__main__":
    program.main()
