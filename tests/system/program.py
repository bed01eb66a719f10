"""Runs the program under test, whose path is the first argument of the script."""

import contextlib
import importlib.machinery
import importlib.util
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

PROGRAM = None
STUDIES = pathlib.Path(__file__).resolve().parents[2] / "runs" / "studies"

# meshing/errors.h
SUCCESS, INTERNAL, USAGE, BAD_INPUT, FILE, SOLVER, MISMATCH, CORRUPT, INCOMPLETE = range(9)


def load_script(name):
    """A script of runs/studies/ as a module; their names have no ending."""
    loader = importlib.machinery.SourceFileLoader(name, str(STUDIES / name))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader(name, loader))
    loader.exec_module(module)
    return module


class TestCase(unittest.TestCase):
    """A test in a directory of its own."""

    maxDiff = None

    def setUp(self):
        directory = tempfile.TemporaryDirectory()
        self.addCleanup(directory.cleanup)
        self.directory = pathlib.Path(directory.name)

    def run_program(self, *arguments, **options):
        return subprocess.run([PROGRAM, *map(str, arguments)], stdin=subprocess.DEVNULL,
                              capture_output=True, text=True, cwd=self.directory, **options)

    def succeed(self, *arguments):
        result = self.run_program(*arguments)
        self.assertEqual(result.returncode, SUCCESS, result.stderr)
        return result

    def document(self, *arguments):
        """The one JSON document on standard output; NaN and Infinity are no JSON."""
        def refuse(word):
            raise ValueError(f"{word} is no JSON")
        return json.loads(self.succeed(*arguments, "--json").stdout, parse_constant=refuse)

    def fail_with(self, code, *arguments):
        """Fails with this code, one line on standard error, nothing on standard output."""
        result = self.run_program(*arguments)
        self.assertEqual(result.returncode, code, result.stderr)
        self.assertEqual(result.stdout, "")
        self.assertEqual(len(result.stderr.splitlines()), 1, result.stderr)
        self.assertTrue(result.stderr.startswith("dpcontact: error: "), result.stderr)
        return result.stderr

    def write(self, name, content):
        path = self.directory / name
        path.write_text(content, encoding="utf-8")
        return path

    @contextlib.contextmanager
    def unchanged_files(self):
        """Every file below the directory is afterwards what it was."""
        def snapshot():
            return {str(path): path.read_bytes() if path.is_file() else None
                    for path in self.directory.rglob("*") if path.name != "lock"}
        before = snapshot()
        yield
        self.assertEqual(before, snapshot())


def main():
    global PROGRAM
    PROGRAM = os.path.abspath(sys.argv.pop(1))
    unittest.main(module="__main__", verbosity=2)
