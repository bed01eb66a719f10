"""Who may include whom: rooms only leftwards, and their sub-folders likewise."""

import re
import unittest

from tree import ROOMS, ROOT, SUBFOLDERS, InSmallTree, TestCase, name_of, production_sources, read

# A curve is all that leaves the solver; a mesh is made without a fit.
FORBIDDEN = {"fitting": ["deal.II/", "gmsh"], "database": ["deal.II/", "gmsh"], "meshing": ["gsl/"]}

# A discrete-element code takes these away: they know the standard library and each other, so that
# every folder of the room may know them.
TAKEN_AWAY = {"database/contact_law/contact_law.h", "database/contact_law/contact_law_c.h",
              "database/contact_law/contact_law_c.cc"}

# Written by the build.
GENERATED = {"git_revision.h"}

INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]', re.MULTILINE)


def place_of(name):
    """The sub-folder's place in its room's order, and the sub-folder; None where there is no order."""
    parts = name.split("/")
    for place, equals in enumerate(SUBFOLDERS.get(parts[0], [])):
        if len(parts) > 2 and parts[1] in equals:
            return place, parts[1]
    return None


def complaint_about_own_header(root, includer, name):
    if includer in TAKEN_AWAY and f"{includer.rpartition('/')[0]}/{name}" in TAKEN_AWAY:
        return None  # copied into one folder of another program, they stand there without a path
    if not (root / name).is_file():
        return "is no path from the repository's root"
    if includer in TAKEN_AWAY:
        return None if name in TAKEN_AWAY else "would have to be taken away with it"
    room, other = includer.split("/")[0], name.split("/")[0]
    if other not in ROOMS[:ROOMS.index(room) + 1]:
        return f"does not belong left of {room}"
    if other == room and room in SUBFOLDERS and name not in TAKEN_AWAY:
        own, theirs = place_of(includer), place_of(name)
        if own and theirs and own[1] != theirs[1] and theirs[0] >= own[0]:
            return f"does not belong left of {room}/{own[1]}"
    return None


def complaint(root, includer, bracket, name):
    if bracket == '"':
        return None if name in GENERATED else complaint_about_own_header(root, includer, name)
    room = includer.split("/")[0]
    if any(name.startswith(prefix) for prefix in FORBIDDEN.get(room, [])):
        return f"is not for {room} to know"
    return None


def include_violations(root):
    found = []
    for path in production_sources(root):
        includer = name_of(root, path)
        for bracket, name in INCLUDE.findall(read(path)):
            if wrong := complaint(root, includer, bracket, name):
                found.append(f"{includer}: {name} {wrong}")
    return found


def homeless_files(root):
    """Files of a room with sub-folders that are in none of the list's."""
    return [name for name in (name_of(root, path) for path in production_sources(root))
            if name.split("/")[0] in SUBFOLDERS and place_of(name) is None]


class Rules(TestCase):
    def test_includes_go_leftwards(self):
        self.assertGreater(len(production_sources(ROOT)), 100)
        self.assert_none(include_violations(ROOT))

    def test_every_file_is_in_a_folder_that_has_its_place_in_the_order(self):
        self.assert_none(homeless_files(ROOT))

    def test_the_lists_name_what_is_there(self):
        for room, order in SUBFOLDERS.items():
            for folder in sum(order, []):
                self.assertTrue((ROOT / room / folder).is_dir(), f"{room}/{folder}")
        for name in TAKEN_AWAY:
            self.assertTrue((ROOT / name).is_file(), name)


class Checker(InSmallTree):
    """The checks see what they are for."""

    def assert_refused(self, includer, line):
        self.write(includer, line + "\n")
        self.assertEqual(len(include_violations(self.root)), 1)

    def assert_allowed(self, includer, line):
        self.write(includer, line + "\n")
        self.assertEqual(include_violations(self.root), [])

    def test_leftwards_is_allowed(self):
        self.assert_allowed("runs/sweep/file.cc", '#include "meshing/good.h"')
        self.assert_allowed("solver/path/file.cc", '#include "solver/laws/good.h"')
        self.assert_allowed("solver/path/other.cc", '#include "solver/path/good.h"')

    def test_rightwards_is_seen(self):
        self.assert_refused("solver/laws/file.cc", '  # include "fitting/good.h"')

    def test_rightwards_inside_a_room_is_seen(self):
        self.assert_refused("solver/laws/file.cc", '#include "solver/system/good.h"')

    def test_equals_are_seen(self):
        self.assert_refused("solver/closed_form/file.cc", '#include "solver/discretisation/good.h"')

    def test_relative_path_is_seen(self):
        self.assert_refused("solver/laws/file.cc", '#include "good.h"')

    def test_library_of_another_room_is_seen(self):
        self.assert_refused("fitting/file.cc", "#include <deal.II/fe/fe_q.h>")

    def test_library_that_a_mesh_needs_not_is_seen(self):
        self.assert_refused("meshing/file.h", "#include <gsl/gsl_fit.h>")

    def test_contact_law_that_knows_a_row_is_seen(self):
        self.assert_refused("database/contact_law/contact_law.h", '#include "database/rows/good.h"')

    def test_contact_law_is_for_the_whole_room(self):
        self.write("database/contact_law/contact_law.h", "")
        self.assert_allowed("database/tables/file.cc", '#include "database/contact_law/contact_law.h"')
        self.assert_refused("solver/path/file.cc", '#include "database/contact_law/contact_law.h"')

    def test_file_without_a_place_is_seen(self):
        self.write("solver/elsewhere/file.h", "")
        self.write("solver/file.h", "")
        self.assertEqual(homeless_files(self.root), ["solver/elsewhere/file.h", "solver/file.h"])


if __name__ == "__main__":
    unittest.main(verbosity=2)
