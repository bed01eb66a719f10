"""Runs the examples of runs/dem in LAMMPS and checks what they give; runs/dem/run says how it is called."""

import argparse
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]

ROCK = {"E": 10e9, "nu": 0.15, "phi": 25, "sigma": 15e6}
DENSITY = 2600.0

# Radii in m, velocity of approach in m/s.
COLLISIONS = [(0.05, 0.05, 0.001), (0.05, 0.05, 0.02), (0.05, 0.05, 0.2), (0.05, 0.05, 1.),
              (0.05, 0.02, 0.5), (0.01, 0.05, 1.)]
STEPS = 2000                  # time steps from touch to separation
REBOUND_TOLERANCE = 5e-3      # against the direct integration, of the rebound velocity
RESTART_TOLERANCE = 1e-9      # rounding: the restart file holds every bit, sums may change their order
BED_TOLERANCE = 1e-4          # rounding grown by the bed's chaos, over the largest force


def say(text):
    print(text, flush=True)


class Checks:
    def __init__(self):
        self.failed = 0

    def expect(self, holds, what):
        say(f"  {'holds ' if holds else 'FAILED'}  {what}")
        self.failed += not holds


class Host:
    """LAMMPS with the pair style, in a directory of its own."""

    def __init__(self, program, table, output):
        self.program, self.table, self.output = program, table, output

    def run(self, script, processes=1, **variables):
        command = [self.program, "-screen", "none", "-log", "log.lammps", "-in", HERE / script]
        for name, value in dict(ROCK, table=self.table, **variables).items():
            command += ["-var", name, repr(value) if isinstance(value, float) else str(value)]
        if processes > 1:
            command = ["mpirun", "--oversubscribe", "-np", str(processes)] + command
        environment = dict(os.environ, OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1",
                           OMP_NUM_THREADS="1")
        result = subprocess.run([str(word) for word in command], cwd=self.output, env=environment,
                                capture_output=True, text=True, check=False)
        log = (self.output / "log.lammps").read_text(encoding="utf-8")
        if result.returncode != 0 or "ERROR" in log:
            sys.exit(f"runs/dem: LAMMPS failed on {script}:\n{log[-2000:]}{result.stderr[-2000:]}")
        return log


def direct(program, table, r1, r2, speed):
    """The same collision integrated by dpcontact itself: the document of `dpcontact collide --json`."""
    words = [program, "collide", "--E", ROCK["E"], "--nu", ROCK["nu"], "--phi", ROCK["phi"], "--sigma-c",
             ROCK["sigma"], "--radius", r1, "--radius-2", r2, "--density", DENSITY, "--velocity", speed,
             "--table", table, "--json"]
    result = subprocess.run([str(word) for word in words], capture_output=True, text=True, check=False)
    if result.returncode != 0:
        sys.exit(f"runs/dem: {result.stderr}")
    return json.loads(result.stdout)


def rebound(log):
    return float(re.search(r"^rebound (\S+)", log, re.MULTILINE).group(1))


def collisions(host, program, checks):
    say(f"two spheres, {STEPS} time steps a collision, against dpcontact collide:")
    say("  R1, R2 mm    approach m/s   F/F_y     a/R > 0.1   rebound m/s: LAMMPS    direct      difference")
    worst = 0
    for r1, r2, speed in COLLISIONS:
        expected = direct(program, host.table, r1, r2, speed)
        step = expected["duration"] / STEPS
        variables = {"r1": r1, "r2": r2, "speed": speed, "density": DENSITY, "step": step,
                     "steps": round(1.05 * STEPS)}
        found = rebound(host.run("collision.in", interrupted=0, **variables))
        difference = found / expected["rebound_velocity"] - 1
        worst = max(worst, abs(difference))
        say(f"  {1e3 * r1:3.0f}, {1e3 * r2:3.0f} {speed:15g} {expected['load_level']:11.4g} "
            f"{'yes' if expected['strain_large'] else 'no':>10} {found:23.6g} "
            f"{expected['rebound_velocity']:11.6g} {difference:13.1e}")
    checks.expect(worst <= REBOUND_TOLERANCE, f"rebound within {100 * REBOUND_TOLERANCE} % of the direct integration")
    # The last one again, stopped in the middle of the contact and read from its restart file.
    host.run("collision.in", interrupted=1, **variables)
    again = rebound(host.run("collision.in", interrupted=2, **variables))
    checks.expect(abs(again / found - 1) <= RESTART_TOLERANCE,
                  f"the same after a restart during contact (difference {again / found - 1:.0e})")


def curve(path):
    rows = [[float(word) for word in line.split()] for line in path.read_text().splitlines() if line[:1] != "#"]
    return [row[0] for row in rows], [row[1] for row in rows]


def work(depth, force):
    """The work put in and the work given back, by the trapezoidal rule."""
    parts = [(b - a) * (f + g) / 2 for a, b, f, g in zip(depth, depth[1:], force, force[1:])]
    return sum(part for part in parts if part > 0), -sum(part for part in parts if part < 0)


def bed(host, checks):
    say("a bed of 125 spheres of three sizes between two plates, pressed by 16 mm, released, pressed again:")
    host.run("bed.in", interrupted=0, out="bed.txt")
    depth, force = curve(host.output / "bed.txt")
    bottom = depth.index(max(depth))
    top = bottom + depth[bottom:].index(min(depth[bottom:]))
    largest = max(force[:bottom + 1])

    def met(depths, forces):  # where the bed first resists by a hundredth of the largest force
        return next(d for d, f in zip(depths, forces) if f > 0.01 * largest)
    first, second = met(depth[:bottom], force[:bottom]), met(depth[top:], force[top:])
    put_in, back = work(depth[:top + 1], force[:top + 1])
    say(f"  largest force {largest:.4g} N, work {put_in:.4g} J put in and {back:.4g} J given back; "
        f"the bed is met at {1e3 * first:.2f} mm, the second time at {1e3 * second:.2f} mm")
    checks.expect(0 < back < put_in, "less work comes back than was put in")
    checks.expect(force[top] == 0, "the bed is free after release")
    checks.expect(second > first, "it stays compacted")

    host.run("bed.in", interrupted=1, out="bed_interrupted.txt")
    host.run("bed.in", interrupted=2, out="bed_restarted.txt")
    _, other_force = curve(host.output / "bed_restarted.txt")
    tail = force[-len(other_force):]
    difference = max(abs(f - g) for f, g in zip(tail, other_force)) / largest
    checks.expect(len(other_force) > 100 and difference <= BED_TOLERANCE,
                  f"the same after a restart during release (difference {difference:.0e} of the largest force)")
    if shutil.which("mpirun"):
        host.run("bed.in", processes=2, interrupted=0, out="bed_two.txt")
        _, two = curve(host.output / "bed_two.txt")
        half = bottom // 2  # later the last digits' chaos has grown
        difference = max(abs(f - g) for f, g in zip(force[:half], two[:half])) / largest
        checks.expect(difference <= BED_TOLERANCE,
                      f"the same on two processes (difference {difference:.0e} over the first half of pressing)")


def main():
    parser = argparse.ArgumentParser(prog="runs/dem/run", description=__doc__)
    parser.add_argument("--program", required=True, help="dpcontact")
    parser.add_argument("--host", required=True, help="dpcontact_lammps")
    parser.add_argument("--output", required=True, help="directory for the files of LAMMPS")
    parser.add_argument("--table", default=ROOT / "database" / "universal.csv", help="universal table")
    arguments = parser.parse_args()
    table = pathlib.Path(arguments.table).resolve()
    if not table.is_file():
        sys.exit(f"runs/dem: there is no universal table '{table}': give --table")
    output = pathlib.Path(arguments.output).resolve()
    output.mkdir(parents=True, exist_ok=True)
    program, checks = pathlib.Path(arguments.program).resolve(), Checks()
    host = Host(pathlib.Path(arguments.host).resolve(), table, output)
    collisions(host, program, checks)
    bed(host, checks)
    say(f"files in {output}")
    sys.exit(1 if checks.failed else 0)


if __name__ == "__main__":
    main()
