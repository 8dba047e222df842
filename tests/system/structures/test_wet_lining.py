"""A lining below a water table from its case to its pictures: at rest soil and water on its outer face bear its weight, the water
hydrostatically; shaking raises an excess pressure there; and a run that is killed goes on with the same bits.

    usage: test_wet_lining.py TREMOLO SOURCE_DIR
"""

import sys
import unittest
from pathlib import Path

TREMOLO, SOURCE = sys.argv.pop(1), Path(sys.argv.pop(1))
sys.path[:0] = [str(SOURCE / "python"), str(Path(__file__).parent)]

import numpy as np
from structure_cases import WetLinedWorkspace, checkpoints, resumes_with_the_same_bits, whole_run, with_checkpoints
from tremolo import Run

GRAVITY = 9.81  # m/s2
CENTRE = np.array([0.0, -6.0])
WEIGHT = 1800.0 * 0.3 * 2.0 * np.pi * (2.5 - 0.15) * GRAVITY  # N/m
LIFT = 1000.0 * np.pi * 2.5**2 * GRAVITY


def upward(ring, pressure, shear):
    """Sum over the segments, N/m."""
    arm = ring.segments - CENTRE
    inward = -arm / np.linalg.norm(arm, axis=1)[:, None]
    return 2.0 * np.pi * 2.5 / len(arm) * np.sum(pressure * inward[:, 1] - shear * inward[:, 0])


class WetLining(unittest.TestCase):
    def checked(self, drainage, plot=False):
        with WetLinedWorkspace(TREMOLO, drainage=drainage, duration=0.9) as work, Run(work.run("run")) as run:
            self.assertEqual("complete", run.status)
            ring = run.lining("ring")
            at_rest = -1000.0 * GRAVITY * ring.segments[:, 1]
            np.testing.assert_allclose(ring.water_pressure[0], at_rest, rtol=1e-3)
            self.assertAlmostEqual(1.0, upward(ring, ring.water_pressure[0], 0.0) / LIFT, delta=0.03)
            self.assertAlmostEqual(1.0, upward(ring, ring.pressure[0], ring.shear[0]) / WEIGHT, delta=0.1)
            # Less of it is effective on the lower side: the ring is lighter than its water.
            effective = ring.pressure[0] - ring.water_pressure[0]
            self.assertAlmostEqual(1.0, upward(ring, effective, ring.shear[0]) / (WEIGHT - LIFT), delta=0.1)
            excess = ring.water_pressure - at_rest
            self.assertGreater(np.abs(excess).max(), 1e3)
            self.assertGreater(np.abs(ring.moment - ring.moment[0]).max(), 1e3)
            energy = run.energy
            self.assertLess(np.abs(energy["residual"]).max(), 0.01 * np.abs(energy["input"]).max())
            if plot:
                done = work.command("plot", work.path / "run")
                self.assertEqual(0, done.returncode, done.stdout + done.stderr)
                self.assertIn("lining_ring_contact.png", done.stdout)

    def test_acceptance_undrained(self):
        self.checked("undrained", plot=True)

    def test_with_water_that_flows(self):
        self.checked("coupled")

    def test_resumed_after_a_kill_it_gives_the_same_bits(self):
        with with_checkpoints(WetLinedWorkspace(TREMOLO, drainage="coupled", duration=0.3), every_steps=50) as work:
            whole = whole_run(work)
            resumes_with_the_same_bits(self, work, whole, checkpoints(whole)[-1] // 3)


if __name__ == "__main__":
    unittest.main()
