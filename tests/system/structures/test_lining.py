"""A lining with three hinges from its case to its pictures: contact bears its weight, its section forces are in balance with what
soil presses on it, hinges pass no moment, and a run that is killed goes on with the same bits.

    usage: test_lining.py TREMOLO SOURCE_DIR
"""

import sys
import unittest
from pathlib import Path

TREMOLO, SOURCE = sys.argv.pop(1), Path(sys.argv.pop(1))
sys.path[:0] = [str(SOURCE / "python"), str(Path(__file__).parent)]

import numpy as np
from structure_cases import LinedWorkspace, checkpoints, resumes_with_the_same_bits, whole_run, with_checkpoints
from tremolo import Run

GRAVITY = 9.81  # m/s2
CENTRE = np.array([0.3, -6.1])


def soil_force(ring, row):
    """Force of the soil on the ring, N/m: pressure inwards and shear along each segment."""
    arm = ring.segments - CENTRE
    inward = -arm / np.linalg.norm(arm, axis=1)[:, None]
    along = np.column_stack([inward[:, 1], -inward[:, 0]])  # counter-clockwise
    length = 2.0 * np.pi * 2.6 / len(arm)
    return length * np.sum(ring.pressure[row][:, None] * inward + ring.shear[row][:, None] * along, axis=0)


class Lining(unittest.TestCase):
    def test_from_the_case_to_its_pictures(self):
        with LinedWorkspace(TREMOLO) as work, Run(work.run("run")) as run:
            self.assertEqual("complete", run.status)
            self.assertEqual(["ring"], run.linings)
            ring = run.lining("ring")
            self.assertEqual(len(run.monitor("surface")), len(ring))
            weight = 0.25 * 2500.0 * 2.0 * np.pi * (2.6 - 0.125) * GRAVITY
            force = soil_force(ring, 0)
            self.assertAlmostEqual(1.0, force[1] / weight, delta=0.02)
            self.assertAlmostEqual(0.0, force[0] / weight, delta=0.02)
            # A cut through the springlines: both walls bear what soil presses on the upper half, less its weight.
            self.assertEqual(3, len(ring.hinges))
            walls = [hinge for hinge in ring.hinges if abs(ring.nodes[hinge, 1] - CENTRE[1]) < 0.1]
            above = ring.segments[:, 1] > CENTRE[1]
            arm = ring.segments[above] - CENTRE
            inward = -arm / np.linalg.norm(arm, axis=1)[:, None]
            pressed = ring.pressure[0][above] * inward[:, 1] - ring.shear[0][above] * inward[:, 0]
            borne = -2.0 * np.pi * 2.6 / len(ring.segments) * pressed.sum() + 0.5 * weight
            thrust = -sum(0.5 * (ring.axial_force[0, wall] + ring.axial_force[0, wall - 1]) for wall in walls)
            self.assertAlmostEqual(1.0, thrust / borne, delta=0.1)
            # A hinge passes no moment, but what shear on the outer face turns half of an element by.
            sizes = np.linalg.norm(np.roll(ring.nodes, -1, axis=0) - ring.nodes, axis=1)
            for hinge in ring.hinges:
                at = ring.moment[:, hinge] + 0.5 * sizes[hinge] * ring.shear_force[:, hinge]
                self.assertLess(np.abs(at).max(), 0.1 * np.abs(ring.moment).max())
            # It moves with the ground, and shaking ovals it.
            self.assertGreater(np.abs(ring.moment - ring.moment[0]).max(), 1e3)
            moved = ring.places - ring.places[0]
            self.assertGreater(np.abs(moved).max(), 1e-3)
            self.assertLess(np.ptp(moved[..., 0].mean(axis=1)), 2.0 * np.ptp(run.monitor("surface")["ux"]))
            # Soil that comes to new nodes, or leaves them, leaves no segment without pressure.
            self.assertLess(np.abs(np.diff(ring.pressure, axis=0)).max(), 0.1 * ring.pressure[0].mean())
            energy = run.energy
            self.assertLess(np.abs(energy["residual"]).max(), 0.01 * np.abs(energy["input"]).max())
            done = work.command("plot", work.path / "run")
            self.assertEqual(0, done.returncode, done.stdout + done.stderr)
            self.assertIn("lining_ring.png", done.stdout)

    def test_resumed_after_a_kill_it_gives_the_same_bits(self):
        with with_checkpoints(LinedWorkspace(TREMOLO, duration=0.3), every_steps=100) as work:
            whole = whole_run(work)
            resumes_with_the_same_bits(self, work, whole, checkpoints(whole)[-1] // 3)


if __name__ == "__main__":
    unittest.main()
