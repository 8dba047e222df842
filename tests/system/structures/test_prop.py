"""A block that is tied to the ground, from its case to its pictures: at rest it presses onto the ground by its weight and the prestress,
shaken the tie's force follows the way of its ends, and a run that is killed goes on with the same bits.

    usage: test_prop.py TREMOLO SOURCE_DIR
"""

import sys
import unittest
from pathlib import Path

TREMOLO, SOURCE = sys.argv.pop(1), Path(sys.argv.pop(1))
sys.path[:0] = [str(SOURCE / "python"), str(Path(__file__).parent)]

import numpy as np
from structure_cases import AnchoredWorkspace, checkpoints, resumes_with_the_same_bits, whole_run, with_checkpoints
from tremolo import Run

STIFFNESS = 2e7  # N/m2


class Prop(unittest.TestCase):
    def test_from_the_case_to_its_pictures(self):
        with AnchoredWorkspace(TREMOLO) as work:
            done = work.command("explain", work.case)
            self.assertIn("from 'block' at (0, 0.5) to the ground at (0, -2.5) m", done.stdout)
            out = work.run("run")
            with Run(out) as run, Run(out / "stages" / "2 tie") as tied:
                self.assertEqual("complete", run.status)
                self.assertEqual(["anchor"], run.props)
                np.testing.assert_allclose(tied.prop("anchor").force, [work.prestress])
                anchor, body = run.prop("anchor"), run.body("block")
                self.assertEqual(("block", "ground"), anchor.ends)
                self.assertEqual(len(body), len(anchor))
                self.assertAlmostEqual(work.prestress, anchor.force[0], delta=1e-3 * work.prestress)
                self.assertAlmostEqual(work.weight + work.prestress, body["normal_y"][1], delta=0.01 * work.weight)
                # Its force follows the way of its ends, tension alone.
                wanted = np.maximum(0.0, work.prestress + STIFFNESS * (anchor.length - 3.0))
                np.testing.assert_allclose(anchor.force, wanted, atol=1e-6 * work.prestress)
                self.assertGreater(np.ptp(anchor.force), 0.02 * work.prestress)
                places = anchor.places
                np.testing.assert_allclose(np.linalg.norm(places[:, 1] - places[:, 0], axis=1), anchor.length, rtol=1e-9)
                energy = run.energy
                self.assertLess(np.abs(energy["residual"]).max(), 0.01 * energy["kinetic"].max())
            done = work.command("plot", out)
            self.assertEqual(0, done.returncode, done.stdout + done.stderr)
            self.assertIn("props.png", done.stdout)
            self.assertIn("props have the forces 'anchor' 60 kN/m", (out / "log" / "domain.log").read_text())

    def test_resumed_after_a_kill_it_gives_the_same_bits(self):
        with with_checkpoints(AnchoredWorkspace(TREMOLO, duration=0.5), every_steps=100) as work:
            whole = whole_run(work)
            resumes_with_the_same_bits(self, work, whole, checkpoints(whole)[-1] // 3)


if __name__ == "__main__":
    unittest.main()
