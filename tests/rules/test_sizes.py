"""How long a function and a file may be, and how much a folder may hold."""

import unittest

from functions import functions
from tree import ROOMS, ROOT, InSmallTree, TestCase, name_of, production_sources, read, sources

MAX_LINES_OF_A_FUNCTION = 80
MAX_LINES_OF_A_HEADER = 200
MAX_LINES_OF_A_FILE = 400
MAX_LINES_OF_A_TEST = 500
MAX_LINES_OF_A_README = 40
MAX_ENTRIES_OF_RUNS = 16

# name: (lines, why it may be longer)
LONGER_FILES = {
    "database/contact_law/contact_law.h":
        (1250, "one file on purpose: a discrete-element code takes it away alone"),
}


def limit_of(name):
    if name in LONGER_FILES:
        return LONGER_FILES[name][0]
    if name.startswith("tests/"):
        return MAX_LINES_OF_A_TEST
    return MAX_LINES_OF_A_HEADER if name.endswith(".h") else MAX_LINES_OF_A_FILE


def long_files(root):
    """Sources and scripts (their names have no ending) that have more lines than they may."""
    found = []
    for folder in ROOMS + ["tests"]:
        for path in sources(root, folder, {".h", ".cc", ".c", ".py", ""}):
            lines, name = len(read(path).splitlines()), name_of(root, path)
            if lines > limit_of(name):
                found.append(f"{name}: {lines} lines, at most {limit_of(name)}")
    return found


def long_functions(root):
    return [f"{name_of(root, path)}:{line}: {lines} lines, at most {MAX_LINES_OF_A_FUNCTION}: {head}"
            for path in production_sources(root)
            for line, lines, head in functions(read(path)) if lines > MAX_LINES_OF_A_FUNCTION]


def entries(folder):
    return [path for path in sorted(folder.iterdir()) if not path.name.startswith((".", "__pycache__"))]


def folders(root):
    """The rooms, the folders in them that hold a file, and tests/ itself."""
    found = {root / "tests"}
    for room in ROOMS:
        found.add(root / room)
        found.update(path.parent for path in (root / room).rglob("*") if path.is_file())
    return sorted(path for path in found if path.name != "__pycache__")


def readme_violations(root):
    found = []
    for folder in folders(root):
        readme = folder / "README.md"
        if not readme.is_file():
            found.append(f"{name_of(root, folder)}: no README.md")
        elif (lines := len(read(readme).splitlines())) > MAX_LINES_OF_A_README:
            found.append(f"{name_of(root, readme)}: {lines} lines, at most {MAX_LINES_OF_A_README}")
    return found


class Rules(TestCase):
    def test_files_can_be_read_at_one_sitting(self):
        self.assert_none(long_files(ROOT))

    def test_longer_files_exist(self):
        for name in LONGER_FILES:
            self.assertGreater(len(read(ROOT / name).splitlines()), MAX_LINES_OF_A_HEADER, name)

    def test_functions_fit_a_screen(self):
        self.assertGreater(sum(len(functions(read(path))) for path in production_sources(ROOT)), 1000)
        self.assert_none(long_functions(ROOT))

    def test_top_of_runs_is_seen_at_a_glance(self):
        self.assertLessEqual(len(entries(ROOT / "runs")), MAX_ENTRIES_OF_RUNS, entries(ROOT / "runs"))

    def test_every_folder_says_what_it_holds(self):
        self.assert_none(readme_violations(ROOT))


class Checker(InSmallTree):
    """The checks see what they are for."""

    def lines(self, name, count):
        self.write(name, "\n" * count)

    def test_long_file_is_seen(self):
        self.lines("runs/sweep/file.cc", 400)
        self.lines("runs/script", 400)
        self.lines("fitting/file.h", 200)
        self.lines("tests/fitting/file_test.cc", 500)
        self.assertEqual(long_files(self.root), [])
        self.lines("runs/sweep/file.cc", 401)
        self.lines("runs/script", 401)
        self.lines("fitting/file.h", 201)
        self.lines("tests/fitting/file_test.cc", 501)
        self.assertEqual(len(long_files(self.root)), 4)

    def test_long_function_is_seen(self):
        self.write("fitting/file.cc", "int f()\n{\n" + "  g();\n" * 77 + "}\n")
        self.assertEqual(long_functions(self.root), [])
        self.write("fitting/file.cc", "int f()\n{\n" + "  g();\n" * 78 + "}\n")
        self.assertEqual(len(long_functions(self.root)), 1)

    def test_folder_without_readme_is_seen(self):
        for folder in folders(self.root):
            self.lines(f"{name_of(self.root, folder)}/README.md", 40)
        self.assertEqual(readme_violations(self.root), [])
        self.lines("solver/README.md", 41)
        (self.root / "solver/path/README.md").unlink()
        self.assertEqual(len(readme_violations(self.root)), 2)

    def test_entries_leave_out_what_python_writes(self):
        self.lines("runs/__pycache__/module.pyc", 1)
        self.lines("runs/script", 1)
        self.assertIn("script", [path.name for path in entries(self.root / "runs")])
        self.assertNotIn("__pycache__", [path.name for path in entries(self.root / "runs")])


class Functions(unittest.TestCase):
    """What is a function, in code as clang-format leaves it."""

    def assert_functions(self, text, expected):
        self.assertEqual([(line, lines) for line, lines, _ in functions(text)], expected)

    def test_free_function_in_a_namespace(self):
        self.assert_functions("namespace n\n{\n  // says {\n  int f(const X &x,\n        int y)\n  {\n    if (x)\n"
                              "    {\n      g('{', \"}\", 1'000);\n    }\n  }\n} // namespace n\n", [(4, 8)])

    def test_classes_are_none_but_their_functions_are(self):
        self.assert_functions("template <typename T = int>\nclass X : public Y<T>\n{\npublic:\n  int f() const { return 1; }\n"
                              "  int a = 1;\n\nprivate:\n  double b{2};\n  bool operator==(const X &) const\n  {\n"
                              "    return true;\n  }\n};\n", [(5, 1), (10, 4)])

    def test_constructor_with_initialisers(self):
        self.assert_functions("X::X(const int n)\n  : a(n)\n  , b{n, 1}\n  , c{}\n{\n  f();\n}\n", [(1, 7)])

    def test_lambda_belongs_to_its_function(self):
        self.assert_functions("void f()\n{\n  const auto g = [&](int i) {\n    h(i);\n  };\n}\n", [(1, 6)])

    def test_lambda_in_no_function(self):
        self.assert_functions("const int value = [] {\n  return 1;\n}();\n", [(1, 3)])

    def test_tables_are_none(self):
        self.assert_functions("enum class E\n{\n  one,\n  two\n};\nconst std::vector<X> table = {\n"
                              "  {\"a\", f(1), X{2}},\n  {\"b\", f(2), X{3}},\n};\nconstexpr double x[] = {1, 2};\n"
                              "struct S\n{\n  int a = 1;\n};\n", [])


if __name__ == "__main__":
    unittest.main(verbosity=2)
