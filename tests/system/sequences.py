"""Random lives of a database: sweeps, merges, fits and exports, most of them disturbed.

After every command the database must be what it was or more, its numbers those of undisturbed sweeps.
"""

import contextlib
import dataclasses
import errno
import hashlib
import io
import json
import os
import random
import resource
import signal
import subprocess
import threading
import zipfile

import h5py

import grids
from program import FILE, INCOMPLETE, MISMATCH, SUCCESS

MODES = ("direct", "families")
COARSE = "set E = 10GPa\nset nu = 0.2\nset phi = 30\nset sigma-c = {}\nset resolution = 4\nset step-tolerance = 1e-1\n"

# One plastic row each, the others elastic; one row in both.
GRIDS = {"first": COARSE.format("20MPa, 500MPa, 1GPa"), "second": COARSE.format("15MPa, 1GPa, 2GPa")}

DATABASE = "table.h5"
SHARDS = 2


class Violation(Exception):
    """What must not happen has happened."""


def require(holds, what):
    if not holds:
        raise Violation(what)


def digest_holds(path):
    """Whether the digest beside a file is the file's, as sha256sum has it."""
    digests = path.with_name(path.name + ".sha256").read_text(encoding="utf-8").splitlines()
    return f"{hashlib.sha256(path.read_bytes()).hexdigest()}  {path.name}" in digests


def repeatable(content):
    return {name: value for name, value in content.items() if name not in grids.UNREPEATABLE}


def stored_rows(directory):
    """The rows of a row directory by the name of their file."""
    return {path.name: repeatable(json.loads(path.read_text(encoding="utf-8"))["content"])
            for path in directory.glob("*.json") if path.name != "settings.json"}


def rows_in(content):
    """The rows of a database in its order, each as all its entries, curves included, bit for bit."""
    def entries(group, prefix=""):
        for name, item in group.items():
            if isinstance(item, h5py.Group):
                yield from entries(item, f"{prefix}{name}/")
            else:
                yield prefix + name, item[()]

    def bits(value):
        return value if isinstance(value, bytes) else value.tobytes()

    with h5py.File(io.BytesIO(content)) as file:
        columns = dict(entries(file["rows"]))
        curves = [tuple((name, bits(values)) for name, values in entries(file["curves"][str(i)]))
                  for i in range(len(columns["E_Pa"]))]
    return [tuple((name, bits(values[i])) for name, values in columns.items() if name not in grids.UNREPEATABLE)
            + curves[i] for i in range(len(curves))]


class Program:
    """The program, and what `check` says of databases and tables, asked once for the same rows."""

    def __init__(self, path):
        self.path = path
        self.checked = set()

    def run(self, directory, *words):
        return subprocess.run([self.path, *map(str, words)], cwd=directory, stdin=subprocess.DEVNULL,
                              capture_output=True, text=True, check=False)

    def check(self, path, rows):
        key = (path.suffix, tuple(rows))
        if key not in self.checked:
            result = self.run(path.parent, "check", path.name)
            require(result.returncode == SUCCESS, f"check refuses {path.name}: {result.stdout}{result.stderr}")
            self.checked.add(key)


class Calm:
    """What undisturbed sweeps give: rows by grid, the rows as they are exported, row files by name."""

    def __init__(self, program, directory):
        self.rows, self.exported, self.files, self.files_of = {}, {}, {}, {}
        for mode in MODES:
            for grid, content in GRIDS.items():
                database, table = directory / f"{mode}-{grid}.h5", directory / f"{mode}-{grid}.csv"
                (directory / f"{grid}.prm").write_text(content, encoding="utf-8")
                for words in (["sweep", f"{grid}.prm", "--mode", mode, "--jobs", 1, "--database", database],
                              ["export", database, "--csv", table]):
                    result = program.run(directory, *words)
                    require(result.returncode == SUCCESS, result.stderr)
                rows = rows_in(database.read_bytes())
                program.check(database, rows)
                self.rows[mode, grid] = rows
                self.exported.update(zip(rows, map(repeatable, grids.read_table(table))))
                self.files_of[mode, grid] = stored_rows(directory / f"{database.name}.rows")
                self.files.update(self.files_of[mode, grid])


@dataclasses.dataclass
class Fault:
    """How a command is disturbed: in its environment, its limits, or by signals from outside."""

    name: str = "none"
    environment: dict = dataclasses.field(default_factory=dict)
    largest_file: int = None
    kill_after: float = None
    kill_worker: bool = False  # instead of the program
    free_bytes: int = None


def draw_fault(draw, library, small_disk):
    kinds = ["none", "kill", "kill worker", "call", "call", "call", "end", "end", "small files", "TMPDIR"]
    kind = draw.choice(kinds + ["full disk", "full disk"] * small_disk)
    if kind.startswith("kill"):
        return Fault(kind, kill_after=draw.uniform(0, 1.5), kill_worker=kind == "kill worker")
    if kind in ("call", "end"):
        call = draw.choice(["open", "write", "write", "fsync", "close", "flock", "rename", "rename"])
        error = 0 if kind == "end" else draw.choice([errno.ENOSPC, errno.EIO, errno.EACCES, errno.EDQUOT])
        text = f"{call} {draw.randrange(1, draw.choice([4, 12, 40]))} {error}"
        return Fault(f"{kind} {text}", {"LD_PRELOAD": str(library), "DPCONTACT_TEST_FAULT": text})
    if kind == "small files":
        size = int(10 ** draw.uniform(0, 5.5))
        return Fault(f"files of at most {size} bytes", largest_file=size)
    if kind == "TMPDIR":
        return Fault(kind, {"TMPDIR": draw.choice(["/absent", "/dev/null", "/proc"])})
    if kind == "full disk":
        size = int(10 ** draw.uniform(2, 6))
        return Fault(f"{size} bytes free", free_bytes=size)
    return Fault()


def kill(process, worker):
    """Ends the program or one of its children."""
    with contextlib.suppress(OSError, IndexError):
        if worker:
            os.kill(grids.children_of(process.pid)[0], signal.SIGKILL)
        else:
            process.kill()


class Sequence:
    """One life of a database."""

    def __init__(self, program, calm, directory, seed):
        self.program, self.calm, self.directory, self.seed = program, calm, directory, seed
        draw = random.Random(seed)
        self.steps = draw.randrange(2, 6)
        self.mode = draw.choice(MODES)
        self.grid = draw.choice(list(GRIDS))
        self.database = directory / DATABASE
        self.log = []
        for grid, content in GRIDS.items():
            (directory / f"{grid}.prm").write_text(content, encoding="utf-8")
        (directory / "tmp").mkdir()

    def other_grid(self):
        return next(grid for grid in GRIDS if grid != self.grid)

    def draw_command(self, draw):
        """A command that has something to work on, as far as faults have left it."""
        grid = self.grid if draw.random() < 0.6 else self.other_grid()
        settings = [f"{grid}.prm", "--mode", self.mode, "--database", self.database]
        replace = ["--replace"] * (draw.random() < 0.3)
        kinds = ["sweep", "merge"] + ["merge", "fit", "export"] * self.database.exists()
        kind = draw.choice(kinds)
        if kind == "fit":
            return ["fit", DATABASE, "--write"]
        if kind == "export":
            further = ["--json-table", "out.json", "--xlsx", "out.xlsx"] * draw.choice([0, 1])
            return ["export", DATABASE, "--csv", "out.csv", *further]
        if kind == "sweep":
            return ["sweep", *settings, "--jobs", draw.choice([1, 2]), *replace]
        settings[0] = f"{self.grid}.prm"
        shards = [f"table.shard-{number}-of-{SHARDS}.h5.rows" for number in range(1, SHARDS + 1)]
        for number, shard in enumerate(shards, 1):
            if not any((self.directory / shard).glob("*.json")):
                return ["sweep", *settings, "--jobs", 1, "--shard", f"{number}/{SHARDS}"]
        return ["merge", *settings[:1], *shards, *settings[1:], *replace]

    def row_directories(self):
        return {path.name: stored_rows(path) for path in self.directory.glob("*.rows")}

    def rows_of_database(self):
        if not self.database.exists():
            return None
        require(digest_holds(self.database), "the digest of the database does not hold")
        return rows_in(self.database.read_bytes())

    def run(self, words, fault):
        """The exit code of a command that is disturbed."""
        def limit():
            if fault.largest_file is not None:
                resource.setrlimit(resource.RLIMIT_FSIZE, (fault.largest_file, fault.largest_file))
            resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
        environment = {**os.environ, "TMPDIR": str(self.directory / "tmp"), **fault.environment}
        filler = self.directory / "filler"
        if fault.free_bytes is not None:
            free = os.statvfs(self.directory)
            filler.write_bytes(bytes(max(0, free.f_bavail * free.f_frsize - fault.free_bytes)))
        with subprocess.Popen([self.program.path, *map(str, words)], cwd=self.directory, env=environment,
                              stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
                              text=True, errors="replace", preexec_fn=limit) as process:
            timer = threading.Timer(fault.kill_after or 0, kill, [process, fault.kill_worker])
            if fault.kill_after is not None:
                timer.start()
            message = process.communicate()[1]
            timer.cancel()
        filler.unlink(missing_ok=True)
        grids.wait_for_end(str(self.database))  # the workers end with it
        self.log.append(f"{' '.join(map(str, words))} [{fault.name}]: exit code {process.returncode}; "
                        f"{message.strip().splitlines()[-1:]}")
        require(process.returncode >= 0 or process.returncode == -9, f"a signal ended it: {message}")
        return process.returncode

    def step(self, words, fault):
        """One command, and what must hold after it."""
        rows, directories = self.rows_of_database(), self.row_directories()
        tables = {path: path.read_bytes() for path in [self.directory / "out.csv"] if path.exists()}
        code = self.run(words, fault)
        kept = words[1].removesuffix(".prm") if "--replace" in words else None
        self.check_database(rows, kept)
        self.check_row_directories(directories, kept)
        for path in tables:
            require(digest_holds(path), f"{path.name} was whole before")
        if code == SUCCESS:
            if self.database.exists():
                self.program.check(self.database, self.rows_of_database())
            if words[0] == "export":
                self.check_exports(words)
        elif fault.name == "none":
            require(code in (FILE, MISMATCH, INCOMPLETE), f"refused without reason: {code}")
        return code

    def check_database(self, rows, kept):
        """Not fewer rows than before, nor other numbers; the grid `kept` alone may be asked to stay."""
        calm = self.calm.rows
        now = self.rows_of_database()
        require(rows is None or now is not None, "the database is gone")
        for row in now or []:
            require(any(row in calm[self.mode, grid] for grid in GRIDS), "a row of the database has other numbers")
        for row in rows or []:
            require(row in now or (kept and row not in calm[self.mode, kept]), "a row of the database is lost")

    def check_row_directories(self, before, kept):
        """The same of the files of rows."""
        found = self.row_directories()
        for name, rows in before.items():
            for row in rows:
                dropped = kept and name == f"{DATABASE}.rows" and row not in self.calm.files_of[self.mode, kept]
                require(dropped or row in found[name], f"{name} has lost its row {row}")
        for name, rows in found.items():
            for row, content in rows.items():
                require(content == self.calm.files[row], f"{name}/{row} holds other numbers")
        require(not list(self.directory.rglob("*.damaged*")), "a row counts as damaged")

    def check_exports(self, words):
        rows = self.rows_of_database()
        table = self.directory / "out.csv"
        require(digest_holds(table), "the digest of out.csv does not hold")
        require([repeatable(row) for row in grids.read_table(table)] == [self.calm.exported[row] for row in rows],
                "out.csv is not the database")
        self.program.check(table, rows)
        if "out.json" in words:
            content = json.loads((self.directory / "out.json").read_text(encoding="utf-8"))
            require(len(content["rows"]) == len(rows), "out.json has not the database's rows")
            with zipfile.ZipFile(self.directory / "out.xlsx") as archive:
                require(archive.testzip() is None, "out.xlsx is damaged")

    def finish(self):
        """One plain run gives the undisturbed rows, and leaves no temporary files."""
        others = self.rows_of_database() or []
        for grid in (self.grid, self.other_grid()):
            words = ["sweep", f"{grid}.prm", "--mode", self.mode, "--jobs", 1, "--database", self.database]
            code = self.step(words, Fault())
            if code != MISMATCH:
                break
            require(self.mode == "families", "rows of the same settings were refused")
        require(code == SUCCESS, f"the plain run ends with {code}")
        rows, calm = self.rows_of_database(), self.calm.rows[self.mode, grid]
        require(rows[:len(calm)] == calm, "the rows are not the undisturbed ones")
        require(all(row in rows for row in others), "a row is lost")
        left = [path.name for directory in (self.directory, self.directory / f"{DATABASE}.rows")
                for path in directory.glob(f".{'' if directory.suffix else DATABASE}*.tmp")]
        require(not left, f"temporary files are left: {left}")

    def live(self, library, small_disk):
        for step in range(self.steps):
            draw = random.Random(f"{self.seed} {step}")
            fault = draw_fault(draw, library, small_disk)
            self.step(self.draw_command(draw), fault)
        self.finish()
