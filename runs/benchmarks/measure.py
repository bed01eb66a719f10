"""Runs the programs and takes the time."""

import csv
import json
import os
import pathlib
import shutil
import statistics
import subprocess
import sys
import tempfile
import time
from dataclasses import dataclass

from laws import coefficient_difference, law_difference

BUILD = pathlib.Path(__file__).resolve().parents[2] / "build"
OUTPUT = BUILD / "benchmark"
PROGRAM = BUILD / "dpcontact"


class Clock:
    def __init__(self):
        self.start = time.monotonic()

    def seconds(self):
        return time.monotonic() - self.start


CLOCK = Clock()


def say(text):
    print(f"benchmark {CLOCK.seconds():5.0f} s: {text}", file=sys.stderr, flush=True)


@dataclass
class Run:
    """A finished `dpcontact solve`: `document` is None where it failed, then `message` says why."""
    document: dict | None
    message: str
    processor_seconds: float


def run_timed(arguments):
    """(exit code, standard output, standard error, processor seconds) of a child process."""
    with tempfile.TemporaryFile() as output, tempfile.TemporaryFile() as errors:
        child = subprocess.Popen(arguments, stdin=subprocess.DEVNULL, stdout=output, stderr=errors)
        _, status, usage = os.wait4(child.pid, 0)
        child.returncode = os.waitstatus_to_exitcode(status)
        texts = []
        for file in (output, errors):
            file.seek(0)
            texts.append(file.read().decode("utf-8", "replace"))
    return child.returncode, *texts, usage.ru_utime + usage.ru_stime


def start_up_seconds():
    """Processor seconds of a program that does next to nothing; measured once."""
    if not hasattr(start_up_seconds, "value"):
        command = [str(PROGRAM), "yield", *"--E 10GPa --nu .2 --phi 30 --sigma-c 10MPa".split()]
        start_up_seconds.value = statistics.median(run_timed(command)[3] for _ in range(5))
    return start_up_seconds.value


def solve(options):
    start_up = start_up_seconds()
    code, output, errors, seconds = run_timed([str(PROGRAM), "solve", *options.split(), "--json"])
    message = ""
    if code != 0:
        message = [line for line in errors.splitlines() if "error: " in line][-1].split("error: ", 1)[1]
    return Run(json.loads(output) if code == 0 else None, message, max(0.0, seconds - start_up))


def curve(constants, options, reference, repeats, enough_seconds):
    """One line of the table of curves: error, cost and the time's median over the repeats."""
    runs = [solve(f"{constants} {options}")]
    while len(runs) < repeats and sum(run.processor_seconds for run in runs) < enough_seconds:
        runs.append(solve(f"{constants} {options}"))
    seconds = statistics.median(run.processor_seconds for run in runs)
    document = runs[0].document
    if document is None:
        return {"failure": runs[0].message, "processor_seconds": seconds}
    cost = document["cost"]
    return {
        "failure": "",
        "law_error": law_difference(document, reference),
        "coefficient_error": coefficient_difference(document, reference),
        "step_error": document["step_error"],
        "processor_seconds": seconds,
        "wall_seconds": statistics.median(run.document["cost"]["wall_seconds"] for run in runs),
        "runs": len(runs),
        **{key: cost[key] for key in ("dofs", "steps", "newton_iterations", "cut_backs", "peak_memory_bytes")},
    }


def kernels():
    """{(kernel, argument, …): (processor seconds, counters)} of Google Benchmark."""
    file = OUTPUT / "kernels.json"
    command = [str(BUILD / "dpcontact_benchmark"), "--benchmark_min_time=0.1", f"--benchmark_out={file}",
               "--benchmark_out_format=json"]
    subprocess.run(command, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                   stderr=subprocess.DEVNULL, check=True)
    unit = {"ns": 1e-9, "us": 1e-6, "ms": 1e-3, "s": 1.0}
    result = {}
    for line in json.loads(file.read_text(encoding="utf-8"))["benchmarks"]:
        name, *arguments = line["name"].split("/")
        values = [int(a.split(":")[1]) if ":" in a else a for a in arguments]
        result[(name, *values)] = (line["cpu_time"] * unit[line["time_unit"]], line)
    return result


def law():
    """{case: processor nanoseconds a call}, and of the construction of a universal law in all."""
    table = BUILD.parent / "database" / "universal.csv"
    file = OUTPUT / "law.json"
    subprocess.run([str(BUILD / "dpcontact_law_benchmark"), str(table), "--benchmark_repetitions=9",
                    f"--benchmark_out={file}", "--benchmark_out_format=json"],
                   stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, check=True)
    result = {}
    for line in json.loads(file.read_text(encoding="utf-8"))["benchmarks"]:
        if line.get("aggregate_name") == "median":
            calls = line["items_per_second"] if "items_per_second" in line else 1e9 / line["cpu_time"]
            result[line["run_name"]] = 1e9 / calls
    return result


def profile(constants, resolution):
    command = [str(BUILD / "dpcontact_profile"), *constants.split(), str(resolution)]
    return json.loads(subprocess.run(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, check=True).stdout)


def write_grid(directory, grid):
    lines = [f"set {key} = {value if isinstance(value, str) else ', '.join(value)}"
             for key, value in grid.items()]
    file = directory / "grid.prm"
    file.write_text("\n".join(lines) + "\n", encoding="utf-8")
    return file


def sweeps(grids, jobs):
    """Wall seconds of fresh sweeps that are started together, until the last has ended."""
    with tempfile.TemporaryDirectory(dir=OUTPUT) as folder:
        commands = []
        for k, grid in enumerate(grids):
            directory = pathlib.Path(folder) / str(k)
            directory.mkdir()
            commands.append([str(PROGRAM), "sweep", str(write_grid(directory, grid)), "--jobs", str(jobs),
                             "--database", str(directory / "rows.h5")])
        clock = Clock()
        children = [subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                                     stderr=subprocess.DEVNULL) for command in commands]
        codes = [child.wait() for child in children]
        seconds = clock.seconds()
    if any(codes):
        raise SystemExit(f"benchmark: a sweep failed, exit codes {codes}")
    return seconds


def others_load(seconds=1.0):
    """Processor seconds a second that the machine spends while this program waits."""
    def busy():
        with open("/proc/stat", encoding="ascii") as file:
            user, nice, system, _, _, irq, softirq, steal = map(int, file.readline().split()[1:9])
        return (user + nice + system + irq + softirq + steal) / os.sysconf("SC_CLK_TCK")
    before, clock = busy(), Clock()
    time.sleep(seconds)
    return (busy() - before) / clock.seconds()


def has_modes():
    """Whether `dpcontact sweep` can compute similarity families."""
    command = [str(PROGRAM), "sweep", "--help"]
    return "--mode" in subprocess.run(command, capture_output=True, text=True, check=True).stdout


def mode(grid, name):
    """(wall seconds, rows of the exported table) of a fresh sweep in a mode."""
    directory = OUTPUT / f"mode-{name}"
    shutil.rmtree(directory, ignore_errors=True)
    directory.mkdir()
    database, table = directory / "rows.h5", directory / "rows.csv"
    clock = Clock()
    subprocess.run([str(PROGRAM), "sweep", str(write_grid(directory, grid)), "--mode", name,
                    "--jobs", "2", "--database", str(database)], stdin=subprocess.DEVNULL,
                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=True)
    seconds = clock.seconds()
    subprocess.run([str(PROGRAM), "export", str(database), "--csv", str(table)], stdin=subprocess.DEVNULL,
                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=True)
    with open(table, newline="", encoding="utf-8") as file:
        return seconds, list(csv.DictReader(line for line in file if not line.startswith("#")))
