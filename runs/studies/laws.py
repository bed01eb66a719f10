"""How far apart two results of `dpcontact solve --json` are."""

COEFFICIENTS = "abmn"


def law_difference(one, other):
    """Largest difference of the two fitted laws over 0 … δ_max and δ_res … δ_max, over F_max."""
    scale = other["scene"]["force_max"] / other["yield"]["force"]
    unit = other["yield"]["approach"]
    top = other["peak"]["approach"] / unit
    largest = 0.0
    for i in range(1, 1001):
        x = top * i / 1000
        values = []
        for result in (one, other):
            fit, residual = result["fit"], result["residual_approach"] / unit
            loading = fit["a"] * x ** fit["b"]
            unloading = fit["m"] * max(0.0, x - residual) ** fit["n"]
            values.append((loading, unloading))
        largest = max(largest, *(abs(p - q) / scale for p, q in zip(*values)))
    return largest


def coefficient_difference(one, other):
    """Largest relative difference of a, b, m, n."""
    return max(abs(one["fit"][c] / other["fit"][c] - 1) for c in COEFFICIENTS)
