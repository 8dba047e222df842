"""A light tunnel below a water table, from its case to its pictures: the lift of the water that it displaces, the pore pressure
that shaking raises around it, and the forces in balance with its motion.

    usage: test_tunnel.py TREMOLO SOURCE_DIR
"""

import sys
import unittest
from pathlib import Path

TREMOLO, SOURCE = sys.argv.pop(1), Path(sys.argv.pop(1))
sys.path[:0] = [str(SOURCE / "python"), str(Path(__file__).parent)]

import numpy as np
from structure_cases import TunnelWorkspace
from tremolo import Run

GRAVITY = 9.81  # m/s2
OUTLINE, HOLE = np.pi * 2.5**2, np.pi * 2.2**2  # m2
WEIGHT = 1800.0 * (OUTLINE - HOLE) * GRAVITY  # N/m
LIFT = 1000.0 * OUTLINE * GRAVITY


class Tunnel(unittest.TestCase):
    def checked(self, drainage, plot=False):
        with TunnelWorkspace(TREMOLO, drainage=drainage, duration=1.0) as work, Run(work.run("run")) as run:
            self.assertEqual("complete", run.status)
            tunnel = run.body("tunnel")
            # Weight less lift pull upwards: 192.6 kN/m of water, less 78.2 kN/m.
            np.testing.assert_allclose(tunnel["weight_y"], LIFT - WEIGHT, rtol=2e-3)
            self.assertGreater(LIFT, WEIGHT)
            self.assertGreater(np.abs(tunnel["water_x"]).max(), 1e-3 * WEIGHT)
            # Before the wave arrives, what soil exerts holds it down.
            start = tunnel["time"] < 0.05
            soil = tunnel["normal_y"] + tunnel["friction_y"] + tunnel["water_y"]
            np.testing.assert_allclose(soil[start], WEIGHT - LIFT, rtol=5e-3)
            crown = run.monitor("crown")
            self.assertNotIn("pore_pressure", crown.columns)
            self.assertGreater(np.abs(crown["vx"]).max(), 0.05)
            self.assertLess(np.abs(crown["uy"]).max(), 0.05)
            nodes = run.contact(len(run.times) - 1)
            self.assertTrue(np.abs(nodes["water_force"]).any())
            self.assertGreater(nodes["area"].sum(), 0.9 * 2.0 * np.pi * 2.5)
            if plot:
                done = work.command("plot", work.path / "run")
                self.assertEqual(0, done.returncode, done.stdout + done.stderr)
                self.assertIn("bodies.png", done.stdout)

    def test_acceptance_undrained(self):
        self.checked("undrained", plot=True)

    def test_with_water_that_flows(self):
        self.checked("coupled")


if __name__ == "__main__":
    unittest.main()
