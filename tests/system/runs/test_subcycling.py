"""Levels of a graded mesh with steps of their own, through the `tremolo` command.

    usage: test_subcycling.py TREMOLO PYTHON_PACKAGE_DIR
"""

import re
import sys
import unittest
from pathlib import Path

TREMOLO, PACKAGE = sys.argv.pop(1), sys.argv.pop(1)
sys.path[:0] = [PACKAGE, str(Path(__file__).parent)]

import numpy as np
from small_case import SLOPE_BOXES, SlopeWorkspace, Workspace, refine, subcycled
from tremolo import Run

BOXES = (([0.0, -5.0, 20.0, 0.0], 1), ([8.0, -2.0, 14.0, 0.0], 2))


class Subcycling(unittest.TestCase):
    def test_a_wave_is_the_same_in_a_quarter_of_the_steps(self):
        histories, counts = [], []
        for change in (lambda work: work, subcycled):
            with change(refine(Workspace(TREMOLO, duration=1.2), *BOXES)) as work:
                counts.append(int(re.search(r"(\d+) steps for", work.command("explain", work.case).stdout)[1]))
                histories.append(Run(work.run("run", "--threads", "1")).monitor("surface"))
        self.assertAlmostEqual(4.0, counts[0] / counts[1], delta=0.05)
        times = np.linspace(0.0, 1.15, 400)
        one, own = (np.interp(times, h["time"], h["vx"]) for h in histories)
        self.assertGreater(np.max(np.abs(one)), 0.1)
        self.assertLess(np.sqrt(np.sum((own - one) ** 2) / np.sum(one ** 2)), 0.05)

    def test_explain_says_which_step_a_level_takes(self):
        with subcycled(refine(Workspace(TREMOLO), *BOXES)) as work:
            result = work.command("explain", work.case)
            self.assertEqual(0, result.returncode, result.stderr)
            self.assertIn("on  sub-cycling", result.stdout)
            self.assertIn("4 steps of", result.stdout)

    def test_a_slope_yields(self):
        with subcycled(refine(SlopeWorkspace(TREMOLO, velocity=2.0), *SLOPE_BOXES)) as work:
            run = Run(work.run("run", "--threads", "1"))
            self.assertGreater(np.max(run.field(len(run.times) - 1, "equivalent_plastic_strain")), 0.01)
            self.assertLess(np.max(np.abs(run.energy["residual"])), 0.02 * np.max(run.energy["input"]))

    def test_acceptance_a_slope_stays_at_rest_without_motion(self):
        with subcycled(refine(SlopeWorkspace(TREMOLO, velocity=1e-12, duration=0.5), *SLOPE_BOXES)) as work:
            run = Run(work.run("run"))
            for index in range(len(run.times)):
                self.assertLess(np.max(np.abs(run.field(index, "velocity"))), 1e-8)

    def test_a_mesh_without_levels_is_refused(self):
        with subcycled(Workspace(TREMOLO)) as work:
            result = work.command("run", work.case, "--out", work.path / "run")
            self.assertNotEqual(0, result.returncode)
            self.assertIn("does not go with cells of one size", result.stderr)


if __name__ == "__main__":
    unittest.main()
