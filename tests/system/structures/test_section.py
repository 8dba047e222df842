"""Cuts through an elastic frame from its case to its pictures: at rest they bear what is above them, shaken they are in balance with the
frame's mass times its acceleration, and a run that is killed goes on with the same bits.

    usage: test_section.py TREMOLO SOURCE_DIR
"""

import sys
import unittest
from pathlib import Path

TREMOLO, SOURCE = sys.argv.pop(1), Path(sys.argv.pop(1))
sys.path[:0] = [str(SOURCE / "python"), str(Path(__file__).parent)]

import numpy as np
from structure_cases import FrameWorkspace, checkpoints, resumes_with_the_same_bits, whole_run, with_checkpoints
from tremolo import Run


class Section(unittest.TestCase):
    def test_from_the_case_to_its_pictures(self):
        with FrameWorkspace(TREMOLO) as work, Run(work.run("run")) as run:
            self.assertEqual("complete", run.status)
            self.assertEqual(["left", "right", "sill", "around"], run.sections)
            left, right, sill, around = (run.section(name) for name in run.sections)
            self.assertEqual(len(run.body("block")), len(left))
            # The mass above the walls' middles is a half of the frame's; above the sill's cut, all but 4 m by 0.75 m.
            self.assertAlmostEqual(-0.5, (left["n"][0] + right["n"][0]) / work.weight, delta=1e-3)
            self.assertAlmostEqual(-0.75, sill["n"][0] / work.weight, delta=1e-3)
            self.assertAlmostEqual(left["n"][0], right["n"][0], delta=1e-3 * work.weight)
            self.assertAlmostEqual(left["m"][0], -right["m"][0], delta=1e-3 * work.weight)
            # Shaken, what lies above the sill pushes it with its mass times its acceleration, up to its bending and turning.
            body = run.body("block")
            acceleration = np.gradient(body["vx"], body.time)
            inertia = 0.75 * body.mass * acceleration
            self.assertGreater(np.abs(inertia).max(), 0.02 * work.weight)
            self.assertLess(np.abs(sill["q"] - inertia).max(), 0.25 * np.abs(inertia).max())
            self.assertGreater(np.corrcoef(sill["q"], inertia)[0, 1], 0.98)
            # The ring's cuts to both sides are those of the walls, the other way around.
            np.testing.assert_allclose(around.angles, 45.0 * np.arange(8), atol=1e-9)
            np.testing.assert_allclose(around.axial_force[:, 0], right["n"], atol=1e-3 * work.weight)
            np.testing.assert_allclose(around.axial_force[:, 4], left["n"], atol=1e-3 * work.weight)
            # They go with the frame.
            moved = around.places[:, 0, 0] - around.places[0, 0, 0]
            self.assertLess(np.abs(moved - (body["x"] - body["x"][0])).max(), 0.2 * np.abs(moved).max())
            done = work.command("plot", work.path / "run")
            self.assertEqual(0, done.returncode, done.stdout + done.stderr)
            for picture in ("sections.png", "section_around.png"):
                self.assertIn(picture, done.stdout)

    def test_resumed_after_a_kill_it_gives_the_same_bits(self):
        with with_checkpoints(FrameWorkspace(TREMOLO, duration=0.5), every_steps=100) as work:
            whole = whole_run(work)
            resumes_with_the_same_bits(self, work, whole, checkpoints(whole)[-1] // 3)


if __name__ == "__main__":
    unittest.main()
