"""Reads a database as a user of Python would, and compares it with its JSON and CSV."""

import csv
import json
import pathlib
import subprocess
import sys
import tempfile

import h5py
import numpy as np


def same(stored, expected):
    """The same text, or the same number; NaN and infinities are text in JSON."""
    if isinstance(expected, str) and not isinstance(stored, str):
        expected = float(expected)
    return stored == expected or (stored != stored and expected != expected)


def check_group(group, expected):
    assert list(group) and set(group) == set(expected), list(group)
    for name, dataset in group.items():
        values = expected[name]
        assert dataset.shape == (len(values),), name
        assert all(same(x, y) for x, y in zip(dataset[()].tolist(), values)), name
        assert "units" in dataset.attrs and dataset.attrs["description"], name


def main(writer):
    with tempfile.TemporaryDirectory() as name:
        directory = pathlib.Path(name)
        subprocess.run([writer, name], check=True)
        expected = json.loads((directory / "sample.json").read_text(encoding="utf-8"))
        lines = (directory / "sample.csv").read_text(encoding="utf-8").split("\n")
        first = next(i for i, line in enumerate(lines) if not line.startswith("#"))
        table = list(csv.DictReader("\n".join(lines[first:]).splitlines(keepends=True)))
        assert len(table) == len(expected)

        with h5py.File(directory / "sample.h5", "r") as file:
            assert file.attrs["schema_version"] == 3
            assert dict(file["provenance"].attrs) == {
                "git_revision": "0123abc",
                "input": "φ = 20°",
            }
            rows = file["rows"]
            assert list(rows)[:3] == ["E_Pa", "nu", "phi_deg"], "columns in their order"
            assert list(rows) == list(table[0])
            assert rows["force_yield_N"].attrs["units"] == "N"
            assert rows["force_yield_N"].fletcher32
            for column, dataset in rows.items():
                text = h5py.check_string_dtype(dataset.dtype)
                values = dataset.asstr()[()] if text else dataset[()].tolist()
                assert len(values) == len(expected)
                for i, value in enumerate(values):
                    assert same(value, expected[i][column]), (column, i, value)
                    cell = table[i][column]
                    assert same(value, cell if text else type(value)(cell)), (column, i, cell)
            assert set(file["curves"]) == {str(i) for i in range(len(expected))}
            for i, row in enumerate(expected):
                curve = file["curves"][str(i)]
                for branch in ("loading", "unloading"):
                    check_group(curve[branch], row["curve"][branch])
                check_group(curve["profile"], row["peak_profile"])
            assert np.issubdtype(rows["dofs"].dtype, np.unsignedinteger)


if __name__ == "__main__":
    main(sys.argv[1])
