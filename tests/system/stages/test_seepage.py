"""A levee that water seeps through, as a user runs it: what `explain` and `check` say, each side's table, the ground at
rest with the flow, and the surface in run.h5.

    usage: test_seepage.py TREMOLO SOURCE_DIR
"""

import sys
import unittest
from pathlib import Path

TREMOLO, SOURCE = sys.argv.pop(1), Path(sys.argv.pop(1))
sys.path[:0] = [str(SOURCE / "python"), str(SOURCE / "tests" / "system" / "runs")]

import numpy as np
import small_case
from tremolo.run import Run

CASE = """
title = "Levee on sand, water seeping through"
[motion]
pulse = {{ shape = "ricker", frequency = 3.0, time = 0.5, velocity = 0.05 }}
wave = "SV"
angle_deg = 0.0
reference = [0.0, -4.0]
[surface]
level = 0.0
[halfspace]
density = 2200.0
vs = 760.0
vp = 1900.0
[[profile]]
thickness = 4.0
soil = "sand"
[water]
{water}
[soil.sand]
model = "linear_elastic"
young = 60e6
poisson = 0.3
porosity = 0.4
permeability = 1e-4
[soil.levee]
model = "linear_elastic"
young = 40e6
poisson = 0.3
porosity = 0.4
permeability = 2e-5
[[region]]
soil = "sand"
polygon = [[0.0, -4.0], [32.0, -4.0], [32.0, 0.0], [0.0, 0.0]]
[[region]]
soil = "levee"
polygon = [[6.0, 0.0], [26.0, 0.0], [18.0, 4.0], [14.0, 4.0]]
[mesh]
size = 1.0
box = [0.0, -4.0, 32.0, 4.0]
[boundary]
left = {{ model = "fe" }}
right = {{ model = "fe" }}
base = {{ model = "fe", form = "incident" }}
[fe]
element_size = 1.0
[[stage]]
kind = "gravity"
[[stage]]
kind = "shaking"
duration_s = 0.1
[[monitor]]
name = "toe"
point = [24.25, 0.25]
[output]
every_s = 0.1
fields = ["stress", "pore_pressure", "excess_pore_pressure", "darcy_velocity"]
"""
SEEPAGE = "seepage = true\nleft = 3.0\nright = -0.5"


class LeveeWorkspace(small_case.Workspace):
    template = CASE
    defaults = {"water": SEEPAGE}


class Seepage(unittest.TestCase):
    def said(self, command, water=SEEPAGE, code=0):
        with LeveeWorkspace(TREMOLO, water=water) as work:
            result = work.command(command, work.case)
            self.assertEqual(code, result.returncode, result.stdout + result.stderr)
            return result.stdout + result.stderr

    def test_explain_says_what_it_found(self):
        text = self.said("explain")
        for words in (
            "m3/s flow through a metre of width, found in",
            "the phreatic surface leaves the ground at x = ",
            "water table at y = 3 m",
            "water table at y = -0.5 m",
            "on  seepage force",
        ):
            self.assertIn(words, text)

    def test_check_refuses_what_cannot_be(self):
        for water, words in (
            ("line = [[0.0, 3.0], [20.0, 1.0]]", "'line' goes from x = 0 to 20 m, and the model from x = 0 to 32 m"),
            ("seepage = true\nleft = 5.0\nright = 1.0", "would meet over the ground, which rises to y = 4 m"),
            ("seepage = true\nleft = 3.0\nright = -5.0", "'right' = -5 m does not lie above the base"),
        ):
            self.assertIn(words, self.said("check", water, code=2))

    def test_the_ground_rests_with_the_flow(self):
        with LeveeWorkspace(TREMOLO) as work:
            run = Run(work.run("seeping") / "run.h5")
        x, y = np.reshape(run.attribute("phreatic_line"), (-1, 2)).T
        self.assertAlmostEqual(3.0, y[0], places=6)
        self.assertAlmostEqual(-0.5, y[-1], delta=0.1)
        self.assertTrue((np.diff(y) < 1e-9).all(), y)
        # The free water of 3 m stands on the ground at the left: p = gamma (3 - y), with no excess.
        places, pressure = run.field(0, "position"), run.field(0, "pore_pressure")
        beside = (places[:, 0] < 1.0) & (places[:, 1] < 0.0)
        np.testing.assert_allclose(pressure[beside], 9810.0 * (3.0 - places[beside, 1]), rtol=0.01)
        self.assertLess(np.abs(run.field(0, "excess_pore_pressure")).max(), 1.0)
        # Water runs to the right under the levee.
        below = (abs(places[:, 0] - 16.0) < 2.0) & (places[:, 1] < -1.0)
        self.assertGreater(run.field(0, "darcy_velocity")[below, 0].min(), 1e-6)

    def test_a_line_says_that_it_is_no_flow(self):
        text = self.said("explain", "line = [[0.0, 3.0], [8.0, 3.0], [24.0, -0.5], [32.0, -0.5]]")
        self.assertIn("phreatic line from y = 3 m at the left to y = -0.5 m at the right", text)
        self.assertIn("pressures are 4.79 % higher", text)


if __name__ == "__main__":
    unittest.main()
