"""Random sequences of commands and faults on one database: nothing is lost, and nothing wrong is left.

test_sequences.py PROGRAM LIBRARY [--sequences N] [--first K] [--seed S] [--jobs J] [--directory D]

LIBRARY makes calls fail (tests/support/failing_calls.cc). The sequences run in temporary directories in
D; where D is a small file system, less than 100 MB, it is filled up now and then.
"""

import argparse
import concurrent.futures
import os
import pathlib
import sys
import tempfile
import unittest

import sequences

SMALL_DISK = 100_000_000

OPTIONS = None


def is_small(directory):
    disk = os.statvfs(directory)
    return disk.f_blocks * disk.f_frsize < SMALL_DISK


def run_sequence(number, program, calm):
    """The log of a sequence, and what was violated in it or None."""
    with tempfile.TemporaryDirectory(dir=OPTIONS.directory) as name:
        sequence = sequences.Sequence(program, calm, pathlib.Path(name), f"{OPTIONS.seed} {number}")
        try:
            sequence.live(OPTIONS.library, is_small(name))
        except sequences.Violation as violation:
            return sequence.log, str(violation)
        return sequence.log, None


class Sequences(unittest.TestCase):
    def test_nothing_is_lost(self):
        program = sequences.Program(OPTIONS.program)
        with tempfile.TemporaryDirectory() as directory:
            calm = sequences.Calm(program, pathlib.Path(directory))
        commands = disturbed = failed = 0
        numbers = range(OPTIONS.first, OPTIONS.first + OPTIONS.sequences)
        with concurrent.futures.ThreadPoolExecutor(OPTIONS.jobs) as pool:
            found = pool.map(lambda number: run_sequence(number, program, calm), numbers)
            for number, (log, violation) in zip(numbers, found):
                commands += len(log)
                disturbed += sum("[none]" not in line for line in log)
                failed += sum("exit code 0;" not in line for line in log)
                with self.subTest(f"sequence {number} of seed {OPTIONS.seed}"):
                    self.assertIsNone(violation, "\n".join(log))
        print(f"{len(numbers)} sequences, {commands} commands, {disturbed} disturbed, {failed} ended with an error",
              file=sys.stderr)
        self.assertGreater(disturbed, len(numbers))
        self.assertGreater(failed, len(numbers) // 2)


def main():
    global OPTIONS
    parser = argparse.ArgumentParser()
    parser.add_argument("program", type=os.path.abspath)
    parser.add_argument("library", type=os.path.abspath)
    parser.add_argument("--sequences", type=int, default=500)
    parser.add_argument("--first", type=int, default=0, help="number of the first sequence")
    parser.add_argument("--seed", type=int, default=2018)
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--directory")
    OPTIONS = parser.parse_args()
    if is_small(OPTIONS.directory or tempfile.gettempdir()):
        OPTIONS.jobs = 1  # what fills the disk for one sequence would fill it for the others
    unittest.main(argv=sys.argv[:1], verbosity=2)


if __name__ == "__main__":
    main()
