"""Runs `dpcontact solve`, several at a time, and keeps what is finished."""

import concurrent.futures
import csv
import hashlib
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import time
from dataclasses import dataclass, field

import numpy

PROGRAM = pathlib.Path(__file__).resolve().parents[2] / "build" / "dpcontact"
START = time.monotonic()
TIMEOUT_SECONDS = 120


def say(text):
    print(f"figures {time.monotonic() - START:4.0f} s: {text}", file=sys.stderr, flush=True)


def columns(path):
    """A CSV file with one line of headings: {heading: array}, of texts where a column is no number."""
    with open(path, newline="", encoding="utf-8") as file:
        head, *rows = csv.reader(file)
    result = {}
    for name, values in zip(head, zip(*rows)):
        try:
            result[name] = numpy.array(values, dtype=float)
        except ValueError:
            result[name] = numpy.array(values)
    return result


def shortened(message):
    """A message without the numbers of every iteration."""
    return re.sub(r"(?:[-+.0-9eE]+[, ]+){6,}", "… ", message).strip()


@dataclass
class Result:
    """A finished `dpcontact solve`: `document` is None where it failed, then `failure` says why."""
    options: str
    directory: pathlib.Path
    document: dict | None
    failure: str = ""
    read: dict = field(default_factory=dict)

    def table(self, name):
        """The columns of curve.csv, profile.csv, axis.csv or points.csv."""
        if name not in self.read:
            self.read[name] = columns(self.directory / f"{name}.csv")
        return self.read[name]

    def branch(self, name):
        """The columns of one branch of the curve, loading or unloading."""
        curve = self.table("curve")
        rows = curve["branch"] == name
        return {key: values[rows] for key, values in curve.items()}


class Solves:
    """Results by options, each computed once; kept below `directory` by options and program."""

    def __init__(self, directory):
        self.directory = directory
        self.program = hashlib.sha256(PROGRAM.read_bytes()).hexdigest()
        self.workers = os.cpu_count() or 1
        self.computed = 0

    def __call__(self, options):
        key = hashlib.sha256(f"{self.program} {options}".encode()).hexdigest()[:20]
        place = self.directory / key
        if not (place / "options.txt").is_file():
            shutil.rmtree(place, ignore_errors=True)
            self.compute(options, place)
        failure = place / "failure.txt"
        if failure.is_file():
            return Result(options, place, None, failure.read_text(encoding="utf-8").strip())
        return Result(options, place, json.loads((place / "result.json").read_text(encoding="utf-8")))

    def compute(self, options, place):
        start = time.monotonic()
        command = [str(PROGRAM), "solve", *options.split(), "--output", str(place)]
        failure = ""
        try:
            run = subprocess.run(command, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                                 stderr=subprocess.PIPE, text=True, timeout=TIMEOUT_SECONDS, check=False)
            if run.returncode != 0:
                errors = [line for line in run.stderr.splitlines() if "error: " in line]
                failure = shortened(errors[-1].split("error: ", 1)[1]) if errors else f"exit code {run.returncode}"
        except subprocess.TimeoutExpired:
            failure = f"not finished after {TIMEOUT_SECONDS} s"
        place.mkdir(parents=True, exist_ok=True)
        for fields in place.glob("*.vtu"):
            fields.unlink()
        if failure:
            (place / "failure.txt").write_text(failure + "\n", encoding="utf-8")
        # Last, so that a killed run leaves nothing that looks finished.
        (place / "options.txt").write_text(options + "\n", encoding="utf-8")
        self.computed += 1
        say(f"solved in {time.monotonic() - start:.1f} s{', failed' if failure else ''}: {options}")

    def all(self, list_of_options):
        """The results in order, as many at a time as there are processors."""
        return self.each(self, list_of_options)

    def each(self, function, arguments):
        with concurrent.futures.ThreadPoolExecutor(self.workers) as pool:
            return list(pool.map(function, arguments))


def need(result):
    """The document of a result that the figure cannot do without."""
    if result.document is None:
        raise SystemExit(f"figures: dpcontact solve {result.options} failed: {result.failure}")
    return result.document


def yield_surface(options):
    """The columns of `dpcontact yield-surface`."""
    run = subprocess.run([str(PROGRAM), "yield-surface", *options.split()], stdin=subprocess.DEVNULL,
                         stdout=subprocess.PIPE, text=True, check=True)
    head, *rows = csv.reader(run.stdout.splitlines())
    return dict(zip(head, numpy.array(rows, dtype=float).T))


def first_yield(options):
    """The document of `dpcontact yield`."""
    run = subprocess.run([str(PROGRAM), "yield", *options.split(), "--json"], stdin=subprocess.DEVNULL,
                         stdout=subprocess.PIPE, text=True, check=True)
    return json.loads(run.stdout)
