"""The pair style of runs/dem in LAMMPS: what contacts remember, what is listed, what is refused."""

import os
import pathlib
import re
import shutil
import subprocess
import sys

import program

TABLE = pathlib.Path(sys.argv.pop(2)).resolve()

# Radii are 10 mm unless a test says otherwise; overlaps of micrometres are plastic.
BOX = """
units si
atom_style sphere
newton {newton}
boundary {boundary}
region box block {box}
create_box 1 box
"""
GRAINS = "set group all diameter 0.02\nset group all density 2600\n"
STYLE = """
pair_style dpcontact universal {table}
pair_coeff * * 10e9 0.15 25 15e6
neighbor 1e-3 bin
neigh_modify delay 0 every 1 check no
timestep 1e-7
"""
MEASURED = """
group second id {second}
compute measured second reduce sum fx
thermo_style custom step c_measured
thermo_modify lost error norm no
"""
VARIANTS = [(newton, ranks) for newton in ("off", "on") for ranks in (1, 2)]


def move(micrometres):
    """Moves the group `second` in x at 1 m/s, 100 nm a step, so that its contacts are at work all the way."""
    return (f"fix motion second move linear {1 if micrometres > 0 else -1} 0 0 units box\n"
            f"run {round(abs(micrometres) * 10)}\nunfix motion\n")


def say(name, expression="c_measured"):
    return f'run 0\nprint "value {name} $({expression}:%.17g)"\n'


class TestCase(program.TestCase):
    def run_host(self, script, ranks=1, newton="off", boundary="f f f",
                 box="-0.1 0.1 -0.1 0.1 -0.1 0.1", second=3, table=TABLE):
        self.write("in.txt", script.format(table=table, newton=newton, boundary=boundary, box=box, second=second))
        command = [program.PROGRAM, "-in", "in.txt", "-log", "log.txt"]
        if ranks > 1:
            command = ["mpirun", "--oversubscribe", "--bind-to", "none", "-np", str(ranks), *command]
        as_root = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
                   "OMP_NUM_THREADS": "1"}
        return subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True, text=True,
                              check=False, cwd=self.directory, env=os.environ | as_root)

    def output(self, script, ranks=1, **options):
        if ranks > 1 and not shutil.which("mpirun"):
            self.skipTest("there is no mpirun")
        result = self.run_host(script, ranks, **options)
        self.assertEqual(result.returncode, 0, result.stdout[-2000:] + result.stderr[-1000:])
        return result.stdout

    def values(self, script, ranks=1, **options):
        """What the input printed by say(), by name."""
        found = re.findall(r"^value (\S+) (\S+)$", self.output(script, ranks, **options), re.MULTILINE)
        return {name: float(value) for name, value in found}

    def refusal(self, script, **options):
        """The message of a run that ends with an error."""
        result = self.run_host(script, **options)
        self.assertNotEqual(result.returncode, 0)
        found = re.search(r"^ERROR.*", result.stdout, re.MULTILINE)
        self.assertTrue(found, result.stdout[-2000:] + result.stderr[-1000:])
        return found.group(0)

    def assert_near(self, one, other, tolerance):
        self.assertLessEqual(abs(one / other - 1), tolerance, f"{one} against {other}")


class Memory(TestCase):
    """A pair is pressed by 10 µm, released by 1.5 µm and held: its force is that of 8.5 µm below a peak of 10."""

    PAIR = BOX + """
create_atoms 1 single 0.05 0.05 0
create_atoms 1 single -0.01 0 0
create_atoms 1 single 0.01 0 0
group far id 1
""" + GRAINS + STYLE + MEASURED + move(-10) + move(1.5) + say("before")

    def check_unchanged(self, commands, tolerance=0.0):
        for newton, ranks in VARIANTS:
            with self.subTest(newton=newton, ranks=ranks):
                found = self.values(self.PAIR + commands + say("after"), ranks, newton=newton)
                self.assertGreater(found["before"], 1)
                self.assert_near(found["after"], found["before"], tolerance)

    def test_deleted_atoms_and_new_ids(self):
        self.check_unchanged("delete_atoms group far compress yes\n")

    def test_deleted_atoms_and_old_ids(self):
        self.check_unchanged("delete_atoms group far compress no\n")

    def test_other_ids(self):
        self.check_unchanged("delete_atoms group far compress no\nreset_atom_ids sort yes\n")

    def test_grains_that_come(self):
        self.check_unchanged("create_atoms 1 single 0.08 0.08 0\nset atom 4 diameter 0.03\n")

    def test_the_other_process(self):
        # Both grains go from the left half of the box to the right.
        self.check_unchanged("displace_atoms all move -0.015 0 0\nrun 1\ndisplace_atoms all move 0.03 0 0\n",
                             tolerance=1e-8)  # of the place's last digits, over the overlap

    def test_a_restart_file_read_by_other_processes(self):
        held = self.values(self.PAIR + "write_restart held.restart\n")["before"]
        for newton, ranks in VARIANTS:
            with self.subTest(newton=newton, ranks=ranks):
                found = self.values("newton {newton}\nread_restart held.restart\ndelete_atoms group far\n" + STYLE +
                                    MEASURED.replace("id {second}", "id 2") + say("after"), ranks, newton=newton)
                self.assert_near(found["after"], held, 1e-9)

    def test_what_has_parted_meets_anew(self):
        # The second time is a first loading up to 8 µm.
        met = self.values(self.PAIR + move(30) + move(-29.5) + say("again"))["again"]
        first = self.values(BOX + """
create_atoms 1 single 0.05 0.05 0
create_atoms 1 single -0.01 0 0
create_atoms 1 single 0.01 0 0
""" + GRAINS + STYLE + MEASURED + move(-8) + say("first"))["first"]
        self.assert_near(met, first, 1e-8)


class Images(TestCase):
    """A grain between another and that one's image, which lie 40 mm − 10 µm apart: each contact has its own peak."""

    # 4 µm to the right, then 6 µm back: loading by 7 µm on one side, 3 µm below a peak of 9 on the other.
    MOTION = STYLE + MEASURED + move(4) + move(-6) + say("held")
    PERIODIC = BOX + """
create_atoms 1 single 0.001 0 0
create_atoms 1 single 0.020995 0 0
""" + GRAINS + MOTION

    def setUp(self):
        super().setUp()
        self.expected = self.values(BOX + """
create_atoms 1 single 0.001 0 0
create_atoms 1 single 0.020995 0 0
create_atoms 1 single 0.04099 0 0
""" + GRAINS + self.MOTION, second=2)["held"]

    def check(self, script, **options):
        for newton, ranks in VARIANTS:
            with self.subTest(newton=newton, ranks=ranks):
                found = self.values(script, ranks, newton=newton, boundary="p f f", second=2,
                                    box="0 0.03999 -0.1 0.1 -0.1 0.1", **options)
                self.assert_near(found["held"], self.expected, 1e-8)

    def test_two_contacts_of_one_pair(self):
        self.check(self.PERIODIC)

    def test_grains_that_cross_the_boundary(self):
        self.check(self.PERIODIC + "displace_atoms all move 0.03 0 0\n" + say("held"))

    def test_a_restart_file(self):
        self.values(self.PERIODIC + "write_restart held.restart\n", boundary="p f f", second=2,
                    box="0 0.03999 -0.1 0.1 -0.1 0.1")
        self.check("newton {newton}\nread_restart held.restart\n" + STYLE + MEASURED + say("held"))


class Bed(TestCase):
    """A periodic bed is pressed while it flies through the box twice, and some of it is taken out."""

    BED = BOX + """
lattice sc 0.02
create_atoms 1 box
""" + GRAINS + STYLE + """
neigh_modify delay 0 every 1 check yes
timestep 2e-6
atom_modify sort 10 0.0
displace_atoms all random 2e-5 2e-5 2e-5 4711 units box
velocity all set 80 6 -4 units box
fix move all nve/sphere
fix press all deform 1 x final 0 0.0798 y final 0 0.0598 z final 0 0.0798 units box
compute force all reduce sumsq fx fy fz
thermo_style custom step ke press c_force[1] c_force[2] c_force[3]
thermo_modify lost error norm no
run 500
group out id 3 17 29
delete_atoms group out
unfix press
fix release all deform 1 x final 0 0.07985 y final 0 0.05985 z final 0 0.07985 units box
run 500
""" + "".join(say(name, name) for name in ("ke", "press", "c_force[1]", "c_force[3]"))

    def test_processes_and_newton(self):
        expected = None
        for newton, ranks in VARIANTS:
            with self.subTest(newton=newton, ranks=ranks):
                found = self.values(self.BED, ranks, newton=newton, boundary="p p p", box="0 0.08 0 0.06 0 0.08")
                expected = expected or found
                for name, value in expected.items():
                    self.assert_near(found[name], value, 1e-6)


class Neighbours(TestCase):
    """Grains that are larger than what was there at first."""

    TWO = BOX + "create_atoms 1 single 0 0 0\ncreate_atoms 1 single 0.029995 0 0\n" + GRAINS + STYLE + MEASURED

    def test_a_grain_that_grows_between_runs_is_found(self):
        expected = self.values(self.TWO + "set atom 2 diameter 0.04\n" + say("force"), second=2)["force"]
        self.assertGreater(expected, 1)
        found = self.values(self.TWO + say("before") + "set atom 2 diameter 0.04\n" + say("force"), second=2)
        self.assertEqual(found, {"before": 0, "force": expected})

    def test_a_grain_that_grows_unseen_is_refused(self):
        message = self.refusal(self.TWO + "run 0\nset atom 2 diameter 0.04\nrun 10 pre no\n", second=2)
        self.assertIn("larger than the list of neighbours is made for", message)

    def test_poured_grains_are_found(self):
        # Into an empty box, and onto a floor of grains that are smaller.
        for floor in ("", "lattice sc 0.001\nregion floor block -0.003 0.003 -0.003 0.003 0 0.0005 units box\n"
                          "create_atoms 1 region floor\nset group all diameter 0.001\nset group all density 2600\n"
                          "group floor union all\nfix stay floor freeze\n"):
            with self.subTest(floor=bool(floor)):
                output = self.output(POURED.replace("FLOOR", floor))
                self.assertIn("placed 20", re.sub(r"\s+", " ", output))
                self.assertLess(self.deepest_overlap("bed.dump"), 1e-2)

    def deepest_overlap(self, name):
        """Over the radius of the smaller of two grains."""
        grains = [[float(word) for word in line.split()]
                  for line in (self.directory / name).read_text(encoding="utf-8").splitlines()[9:]]
        self.assertGreaterEqual(len(grains), 20)
        return max((a[3] + b[3] - sum((p - q) ** 2 for p, q in zip(a[:3], b[:3])) ** 0.5) / min(a[3], b[3])
                   for k, a in enumerate(grains) for b in grains[:k])


POURED = """
units si
atom_style sphere
newton off
boundary f f fm
comm_modify vel yes
region box block -0.006 0.006 -0.006 0.006 -0.001 0.02 units box
create_box 1 box
FLOOR
pair_style dpcontact universal {table}
pair_coeff * * 1e9 0.15 25 10e6
neighbor 1e-4 bin
neigh_modify delay 0 every 1 check yes
region slab cylinder z 0 0 0.004 0.004 0.018 units box
group poured empty
fix down poured gravity 9.81 vector 0 0 -1
fix ins poured pour 20 1 4711 region slab diam one 0.002 dens 2600 2600 vel 0 0 0 0 -1
fix fall poured nve/sphere
fix bottom poured wall/gran hertz/history 1e9 NULL 1e3 NULL 0.0 0 zplane 0 NULL
fix sides poured wall/gran hertz/history 1e9 NULL 1e3 NULL 0.0 0 zcylinder 0.005
fix drag poured viscous 5e-4
timestep 1e-6
thermo 10000
run 20000
print "placed $(count(poured):%.0f)"
write_dump all custom bed.dump x y z radius
"""


class Limits(TestCase):
    PAIR = BOX + "create_atoms 1 single 0 0 0\ncreate_atoms 1 single {place} 0 0\n" + GRAINS + STYLE + MEASURED

    def pair(self, place):
        return self.PAIR.replace("{place}", str(place))

    def test_within_small_strain_nothing_is_said(self):
        self.assertNotIn("dpcontact: ", self.output(self.pair(0.01999) + "run 1\n", second=2))

    def test_large_strain_is_said_first_and_at_its_worst(self):
        output = self.output(self.pair(0.0195) + move(-300), second=2)
        found = re.findall(r"pair_style dpcontact: (.*?) is beyond small strain.*: atoms 1 and 2 overlap by (\S+) of "
                           r"the smaller radius at step (\d+)", output)
        self.assertEqual(found, [("a contact", "0.05", "0"), ("the deepest contact of this run", "0.08", "3000")])

    def test_a_centre_within_another_grain_is_refused(self):
        self.assertIn("the centre of one lies within the other", self.refusal(self.pair(0.009) + "run 0\n", second=2))


class Digest(TestCase):
    SCRIPT = BOX + STYLE

    def setUp(self):
        super().setUp()
        for file in (TABLE, pathlib.Path(f"{TABLE}.sha256")):
            shutil.copy(file, self.directory)
        self.table = self.directory / TABLE.name

    def test_a_table_with_its_digest_is_read(self):
        self.output(self.SCRIPT, table=self.table)

    def test_a_table_without_digest_is_refused(self):
        pathlib.Path(f"{self.table}.sha256").unlink()
        self.assertIn("is missing", self.refusal(self.SCRIPT, table=self.table))

    def test_an_altered_table_is_refused(self):
        self.table.write_text(self.table.read_text(encoding="utf-8").replace("1.4838531", "1.4838532"),
                              encoding="utf-8")
        self.assertIn("is truncated or altered", self.refusal(self.SCRIPT, table=self.table))

    def test_a_missing_table_is_refused(self):
        self.assertIn("cannot read", self.refusal(self.SCRIPT, table=self.directory / "none.csv"))


if __name__ == "__main__":
    program.main()
