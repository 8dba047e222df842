"""What `tremolo check` passes, real processes take: columns alone (`check --column`) and runs. `tests/fuzz/processes` draws many more
cases within one process.
"""

import sys
import unittest

TREMOLO, PACKAGE, _ = sys.argv.pop(1), sys.argv.pop(1), sys.argv.pop(1)
sys.path.insert(0, PACKAGE)

from free_field_cases import BoxWorkspace, ColumnWorkspace, model

PULSE = 'pulse = {{ shape = "ricker", frequency = 2.0, time = 0.6, velocity = 0.1 }}\nkind = "{}"'

# The ratio stands at the soil, at the layer, or in [damping].
CLAY = """
[soil.clay]
model = "mkz"
density = 1800.0
vs = 170.0
vp = 340.0
reference_strain = 1e-3
beta = 1.0
exponent = 0.9
"""
RAYLEIGH = '[damping]\nmodel = "rayleigh"\nfrequencies = [1.4, 7.0]\n'
LAYER = "[[profile]]\nthickness = 20.0\n"
GROUNDS = {
    "soil": LAYER + 'soil = "clay"\n' + CLAY + "damping = 0.02\n" + RAYLEIGH,
    "layer": LAYER + "density = 1800.0\nvs = 170.0\nvp = 340.0\ndamping = 0.02\n" + RAYLEIGH,
    "all": LAYER + 'soil = "clay"\n' + CLAY + RAYLEIGH + "ratio = 0.02\n",
}


class Columns(unittest.TestCase):
    def test_rayleigh_damping_under_each_kind_of_motion(self):
        for kind in ("incident", "outcrop", "within"):
            for where, ground in GROUNDS.items():
                with ColumnWorkspace(TREMOLO, ground=ground, motion=PULSE.format(kind), size=1.0) as work:
                    for name in ("fe", "ode"):
                        checked = work.command("check", work.case, "--column", name)
                        self.assertEqual(0, checked.returncode, (kind, where, name, checked.stderr))
                        self.assertIn(f"ok for `tremolo column --model {name}`", checked.stdout)
                        ran = work.command("column", work.case, "--model", name, "--out", "out.h5", "--duration", "1")
                        self.assertEqual(0, ran.returncode, (kind, where, name, ran.stderr))

    def test_what_check_refuses_column_refuses_alike(self):
        with ColumnWorkspace(TREMOLO, ground=GROUNDS["soil"], motion=PULSE.format("outcrop"), size=1.0) as work:
            known = work.command("check", work.case, "--column", "wave")
            self.assertEqual(0, known.returncode, known.stderr)
        with ColumnWorkspace(TREMOLO, ground=GROUNDS["soil"], motion=PULSE.format("within"), size=1.0) as work:
            for name in ("wave", "eql", "mpm"):
                checked = work.command("check", work.case, "--column", name)
                ran = work.command("column", work.case, "--model", name, "--out", "out.h5")
                self.assertEqual((2, 2), (checked.returncode, ran.returncode), (name, checked.stderr, ran.stderr))
                self.assertEqual(checked.stderr, ran.stderr)
            self.assertEqual(2, work.command("check", work.case).returncode)  # it is no complete case

    def test_water_needs_gravity_where_its_model_has_pressure(self):
        ground = (LAYER + 'soil = "clay"\n' + CLAY.replace("density = 1800.0\n", "porosity = 0.4\npermeability = 1e-6\n") +
                  "[water]\nlevel = -1.0\n")
        with ColumnWorkspace(TREMOLO, ground=ground, motion=PULSE.format("incident"), size=1.0) as work:
            for name in ("wave", "eql", "ode"):
                explained = work.command("explain", work.case, "--column", name)
                self.assertEqual(0, explained.returncode, (name, explained.stderr))
                self.assertRegex(explained.stdout, r"clay, \w+, wet")
                ran = work.command("column", work.case, "--model", name, "--out", "out.h5", "--duration", "0.5")
                self.assertEqual(0, ran.returncode, (name, ran.stderr))
            refused = work.command("check", work.case, "--column", "fe")
            self.assertIn('add a [[stage]] of kind = "gravity"', refused.stderr)

    def test_a_step_beyond_the_limit_is_refused_with_its_key(self):
        with ColumnWorkspace(TREMOLO, ground=GROUNDS["soil"], motion=PULSE.format("incident"), size=1.0) as work:
            work.case.write_text(work.case.read_text().replace("[fe]\n", "[fe]\ndt = 0.1\n"))
            refused = work.command("check", work.case, "--column", "fe")
            self.assertRegex(refused.stderr, r"\[fe\] 'dt' = 0\.1 s, must be below")


class Runs(unittest.TestCase):
    def test_rayleigh_damping_beside_and_below_the_domain(self):
        ground = GROUNDS["soil"].replace("thickness = 20.0", "thickness = 10.0") + """
[[region]]
soil = "clay"
polygon = [[0.0, -10.0], [20.0, -10.0], [20.0, 0.0], [0.0, 0.0]]
"""
        for left, base in (("fe", "incident"), ("ode", "blended")):
            with BoxWorkspace(TREMOLO, ground=ground, duration=0.1, left=model(left), right=model(left),
                              base=model(left, form=base)) as work:
                text = work.case.read_text()
                work.case.write_text(text.replace("wave = ", 'kind = "outcrop"\nwave = ').replace("size = 0.5", "size = 1.0"))
                checked = work.command("check", work.case)
                self.assertEqual(0, checked.returncode, checked.stderr)
                ran = work.command("run", work.case, "--out", "run")
                self.assertEqual(0, ran.returncode, ran.stderr + ran.stdout)


if __name__ == "__main__":
    unittest.main()
