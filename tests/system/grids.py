"""A small grid, and what a sweep made of one."""

import csv
import json
import pathlib
import time

import program

# Elastic and plastic rows, coarse enough for a fraction of a second each.
GRID = """
set E = 10GPa
set nu = 0.2
set phi = 20, 30
set sigma-c = 20MPa, 200MPa
set resolution = 12
set step-tolerance = 1e-2
"""

# All plastic, and fine enough for two processes to need a while after the first row is stored.
SLOW_GRID = (GRID.replace("20MPa, 200MPa", "10MPa, 20MPa, 30MPa")
             .replace("resolution = 12", "resolution = 20"))

# The first in families.
FAMILIES = GRID.replace("20MPa, 200MPa", "5MPa, 20MPa, 200MPa") + "set mode = families\n"

# What a run may not repeat: how long it took and what it used.
UNREPEATABLE = {"wall_seconds", "peak_memory_bytes"}


def read_table(path):
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def children_of(process):
    path = pathlib.Path(f"/proc/{process}/task/{process}/children")
    return [int(child) for child in path.read_text(encoding="utf-8").split()]


def processes_of(text):
    """Processes with this text in their command line."""
    found = []
    for path in pathlib.Path("/proc").glob("[0-9]*"):
        try:
            if text.encode() in (path / "cmdline").read_bytes():
                found.append(path.name)
        except OSError:
            pass
    return found


def wait_for_end(text):
    """Until no process has this text in its command line, or ctest's time runs out."""
    while processes_of(text):
        time.sleep(0.01)


class TestCase(program.TestCase):
    def table(self, database):
        self.succeed("export", database, "--csv", f"{database}.csv")
        rows = read_table(self.directory / f"{database}.csv")
        self.assertTrue(rows, f"{database} has no rows")
        return [{name: value for name, value in row.items() if name not in UNREPEATABLE}
                for row in rows]

    def stored_rows(self, database):
        """The files of the rows that are stored, with their bytes."""
        return {path: path.read_bytes()
                for path in (self.directory / f"{database}.rows").glob("*.json")
                if path.name != "settings.json"}

    def rows(self, database):
        """Every entry that a run can repeat, curves included, by the name of the row's file.

        settings.json is one of them; at least one row must be beside it.
        """
        found = {}
        for path in (self.directory / f"{database}.rows").glob("*.json"):
            content = json.loads(path.read_text(encoding="utf-8"))["content"]
            for name in UNREPEATABLE:
                content.pop(name, None)
            found[path.name] = content
        self.assertIn("settings.json", found)
        self.assertGreater(len(found), 1, f"{database} has no rows")
        return found
