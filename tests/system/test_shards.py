"""A grid over shards and their merge: the rows of one process, or a refusal."""

import hashlib
import json
import re
import shutil

import grids
import program
from grids import FAMILIES, GRID
from program import BAD_INPUT, CORRUPT, FILE, INCOMPLETE, MISMATCH


def compact(lines):
    """What nlohmann::json::dump() gives of the lines that dump(1) gives."""
    return "".join(re.sub(r'^("[^"]*"): ', r"\1:", line.strip()) for line in lines)


def alter(path, entry, value):
    """Replaces an entry of a sealed row file and seals it again."""
    lines = path.read_text(encoding="utf-8").splitlines()

    def digest():
        return hashlib.sha256(compact(["{", *lines[2:-3], "}"]).encode()).hexdigest()
    assert lines[-2] == f' "sha256": "{digest()}"', path
    number = next(i for i, line in enumerate(lines) if line.startswith(f'  "{entry}": '))
    lines[number] = f'  "{entry}": {value},'
    lines[-2] = f' "sha256": "{digest()}"'
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")


class TestCase(grids.TestCase):
    def setUp(self):
        super().setUp()
        self.grid = self.write("grid.prm", GRID)

    def merge(self, *shards, grid=None):
        return ["merge", grid or self.grid, *shards, "--database", "merged.h5"]

    def make_shard(self, number, count):
        self.succeed("sweep", self.grid, "--jobs", "1", "--shard", f"{number}/{count}",
                     "--database", "grid.h5")

    def make_shards(self, count):
        """All shards of the grid, by name."""
        for number in range(1, count + 1):
            self.make_shard(number, count)
        self.assertFalse((self.directory / "grid.h5").exists())
        return [f"grid.shard-{number}-of-{count}.h5.rows" for number in range(1, count + 1)]


class Shards(TestCase):
    def check_like_one_process(self, content):
        grid = self.write("grid.prm", content)
        self.succeed("sweep", grid, "--jobs", "1", "--database", "one.h5")
        shards = self.make_shards(4)
        self.succeed(*self.merge(*shards))
        self.assertEqual(self.table("merged.h5"), self.table("one.h5"))
        self.assertEqual(self.rows("merged.h5"), self.rows("one.h5"))
        with self.subTest("what is merged is a sweep that is done"), self.unchanged_files():
            self.assertEqual(self.document("sweep", grid, "--database", "merged.h5")["computed"], 0)
            self.succeed(*self.merge(*shards))
            self.succeed(*self.merge("merged.h5.rows"))

    def test_direct_rows_are_those_of_one_process(self):
        self.check_like_one_process(GRID)

    def test_families_are_those_of_one_process(self):
        self.check_like_one_process(FAMILIES)

    def test_every_row_is_in_one_shard(self):
        grid = self.write("wide.prm", GRID.replace("phi = 20, 30", "phi = 20, 25, 30, 35, 40"))
        listing = ["sweep", grid, "--mode", "families", "--dry-run"]
        whole = self.document(*listing)["rows"]
        parts = [self.document(*listing, "--shard", f"{number}/3")["rows"] for number in (1, 2, 3)]
        self.assertEqual(sorted(map(str, sum(parts, []))), sorted(map(str, whole)))
        self.assertEqual(sorted(map(len, parts)), [2, 4, 4])  # families of two rows stay whole

    def test_shard_resumes(self):
        arguments = ["sweep", self.grid, "--jobs", "1", "--shard", "1/2", "--database", "grid.h5"]
        first = self.document(*arguments)
        self.assertEqual((first["shard"], first["row_directory"], first["rows"], first["computed"]),
                         ("1/2", "grid.shard-1-of-2.h5.rows", 2, 2))
        rows = self.rows("grid.shard-1-of-2.h5")
        row = next(path for path in (self.directory / first["row_directory"]).glob("*.json")
                   if path.name != "settings.json")
        row.unlink()
        self.assertEqual(self.document(*arguments)["computed"], 1)
        self.assertEqual(self.rows("grid.shard-1-of-2.h5"), rows)

    def test_bad_shards(self):
        with self.unchanged_files():
            for text in ("0/4", "5/4", "-1/4", "4", "1/4/2", ""):
                with self.subTest(text):
                    self.assertIn("shard", self.fail_with(
                        BAD_INPUT, "sweep", self.grid, "--shard", text))


class Merge(TestCase):
    def copy_of(self, shard):
        """Its row directory under another name, and the first row there."""
        shutil.copytree(self.directory / shard, self.directory / f"copy-{shard}")
        return f"copy-{shard}", min(path for path in
                                    (self.directory / f"copy-{shard}").glob("*.json")
                                    if path.name != "settings.json")

    def test_missing_rows(self):
        shards = self.make_shards(4)
        with self.unchanged_files():
            message = self.fail_with(INCOMPLETE, *self.merge(*shards[1:3]))
            self.assertIn("2 of 4 rows are missing", message)
            self.assertEqual(message.count("E = 10 GPa"), 2)
            self.fail_with(FILE, *self.merge(*shards, "absent.rows"))

        with self.subTest("a damaged row is missing until its shard is run again"):
            row = min((self.directory / shards[0]).glob("*.json"),
                      key=lambda path: path.name == "settings.json")
            row.write_bytes(row.read_bytes()[:100])
            result = self.run_program(*self.merge(*shards))
            self.assertEqual(result.returncode, INCOMPLETE)
            self.assertIn("damaged", result.stderr)
            self.assertFalse((self.directory / "merged.h5.rows").exists())
            self.make_shard(1, 4)
            self.succeed(*self.merge(*shards))

    def test_foreign_shards(self):
        shards = self.make_shards(2)
        (self.directory / "empty.rows").mkdir()
        other = self.write("other.prm", GRID.replace("phi = 20, 30", "phi = 30"))
        families = self.write("families.prm", FAMILIES)
        with self.unchanged_files():
            self.fail_with(CORRUPT, *self.merge(*shards, "empty.rows"))
            self.assertIn("not of this grid",
                          self.fail_with(MISMATCH, *self.merge(*shards, grid=other)))
            result = self.run_program(*self.merge(*shards), "--resolution", "13")
            self.assertEqual(result.returncode, MISMATCH, result.stderr)
            self.assertIn("stored 12, now 13", result.stderr)
            result = self.run_program(*self.merge(*shards, grid=families))
            self.assertEqual(result.returncode, MISMATCH, result.stderr)
        self.succeed("sweep", self.grid, "--resolution", "13", "--database", "merged.h5")
        with self.unchanged_files():
            self.assertEqual(self.run_program(*self.merge(*shards)).returncode, MISMATCH)

    def test_duplicates(self):
        shards = self.make_shards(2)
        copy, row = self.copy_of(shards[0])
        alter(row, "wall_seconds", "12.5")
        result = self.run_program(*self.merge(*shards, shards[0], copy), "--json")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(json.loads(result.stdout)["duplicates"], 2)
        self.assertIn("2 rows are in several shards", result.stderr)
        merged = self.table("merged.h5")

        with self.subTest("conflicting"):
            alter(row, "a", "1.25")
            with self.unchanged_files():
                message = self.fail_with(CORRUPT, *self.merge(*shards, copy))
                self.assertRegex(message, r"E = 10 GPa.* and 1\.25")
                self.fail_with(CORRUPT, *self.merge(copy))  # against what is merged already
            self.assertEqual(self.table("merged.h5"), merged)

    def test_converged_row_stands_above_a_failed_one(self):
        shards = self.make_shards(2)
        copy, row = self.copy_of(shards[0])
        alter(row, "status", '"failed"')
        self.assertEqual(self.run_program(*self.merge(copy, shards[1])).returncode, INCOMPLETE)
        self.assertEqual(sorted(row["status"] for row in self.table("merged.h5")),
                         ["converged"] * 3 + ["failed"])
        for arguments in (shards, [copy, *shards]):
            self.succeed(*self.merge(*arguments))
            self.assertEqual({row["status"] for row in self.table("merged.h5")}, {"converged"})


if __name__ == "__main__":
    program.main()
