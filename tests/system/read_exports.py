"""Reads an exported table with readers that are not dpcontact's: csv, openpyxl, json, h5py, pandas.

read_exports.py DATABASE.h5 TABLE.csv PACKAGE.json TABLE.xlsx TABLE.json: exits non-zero where they
do not hold the same numbers.
"""

import csv
import json
import math
import sys

import h5py
import openpyxl
import pandas

database, table, package, spreadsheet, document = sys.argv[1:]


def same(one, other, tolerance=0.):
    if one is None or other is None or one == "" or other == "":
        one, other = (math.nan if v in (None, "") else v for v in (one, other))
    try:
        one, other = float(one), float(other)
    except ValueError:
        return str(one) == str(other)
    return math.isclose(one, other, rel_tol=tolerance) or (math.isnan(one) and math.isnan(other))


with h5py.File(database) as file:
    reference = {name: file["rows"][name][()] for name in file["rows"]}
reference = {name: [v.decode() if isinstance(v, bytes) else v.item() for v in values]
             for name, values in reference.items()}
count = len(reference["E_Pa"])
assert count == 2 and len(reference) > 100

with open(table, encoding="utf-8") as stream:
    lines = [line for line in stream if not line.startswith("#")]
rows = list(csv.DictReader(lines))
frame = pandas.read_csv(table, comment="#", float_precision="round_trip")
sheet = list(openpyxl.load_workbook(spreadsheet)["rows"].iter_rows(values_only=True))
content = json.load(open(document, encoding="utf-8"))
described = json.load(open(package, encoding="utf-8"))["resources"][0]["schema"]

assert len(rows) == len(frame) == len(sheet) - 1 == len(content["rows"]) == count
names = list(rows[0])
assert [field["name"] for field in described["fields"]] == names == list(sheet[0])
assert set(described["primaryKey"]) <= set(names)
for k in range(count):
    for column, name in enumerate(names):
        expected = reference[name][k]
        for found in (rows[k][name], content["rows"][k][name], frame[name][k]):
            assert same(expected, found), (name, k, expected, found)
        # The spreadsheet holds 16 digits.
        assert same(expected, sheet[k + 1][column], 1e-15), (name, expected, sheet[k + 1][column])
print("the same", len(names), "columns")
