"""What is built after a shaking, as a user runs it: a berm on sand that has liquefied, dug away again, and a load. The
ground carries each of them in its own time, the ledger closes, and a broken run goes on with the same bits.

    usage: test_earthworks.py TREMOLO SOURCE_DIR
"""

import sys
import unittest
from pathlib import Path

TREMOLO, SOURCE = sys.argv.pop(1), Path(sys.argv.pop(1))
sys.path[:0] = [str(SOURCE / "python"), str(SOURCE / "tests" / "system" / "resume"), str(Path(__file__).parent)]

import numpy as np
from berm_case import BermWorkspace, stage
from broken_run import goes_on_with_the_same_bits, whole_run, with_checkpoints
from rest_case import rest
from tremolo.run import Run

def aftershock(duration):
    return (f'\n[[stage]]\nkind = "shaking"\nname = "aftershock"\nduration_s = {duration}\n'
            'motion = { pulse = { shape = "ricker", frequency = 3.0, time = 0.2, velocity = 0.1 } }\n')


class Earthworks(unittest.TestCase):
    def test_ground_bears_a_berm_until_it_is_dug_away(self):
        stages = rest(0.5) + stage("construction", "berm", 'place = ["berm"]', 1.0) + rest(0.5, name='"after it"') + \
            stage("construction", "dug", 'remove = ["berm"]', 1.0) + rest(0.3, name='"at last"') + \
            stage("construction", "again", 'place = ["berm"]', 0.2)
        with BermWorkspace(TREMOLO, stages, shaking=1.5) as work:
            listed = work.command("explain", work.case).stdout
            self.assertIn("places 'berm'; grows in 1 s of the soil's own time, from 2 s", listed)
            folder = work.run("run")
            run = Run(folder / "run.h5")
            count = lambda time: len(run.frame(int(np.argmin(np.abs(run.times - time))))["position"])
            self.assertEqual(count(1.6) + 16, count(2.6))  # 4 m by 1 m, four particles a cell
            self.assertEqual(count(1.6), count(4.6))
            self.assertEqual(count(1.6) + 16, count(5.0))
            with_berm = run.frame(int(np.argmin(np.abs(run.times - 3.1))))
            berm = with_berm["soil"] == list(run.attribute("soil_names")).index("fill")
            self.assertEqual(16, np.count_nonzero(berm))
            self.assertGreater(with_berm["position"][berm, 1].min(), -0.1)
            self.assertAlmostEqual(-1900.0 * 9.81 * 0.5, with_berm["stress"][berm, 1].mean(), delta=2e3)
            history = run.monitor("2.5 m")
            at = lambda name, time: np.interp(time, history["time"], history[name])
            total = lambda time: at("syy", time) - at("pore_pressure", time)
            self.assertLess(at("uy", 3.45), at("uy", 1.95) - 1e-3)  # the ground under it has settled
            weight = 1900.0 * 9.81
            self.assertTrue(0.4 * weight < total(1.95) - total(3.45) < weight, (total(1.95), total(3.45)))
            self.assertAlmostEqual(total(1.95), total(4.75), delta=0.1 * weight)
            energy = run.energy
            later = energy["time"] > 1.95  # the shaking is over
            grown = lambda name: np.ptp(energy[name][later])
            self.assertLess(grown("residual"), 1e-4 * energy["plastic"].max())
            self.assertLess(grown("transfer"), 0.5 * grown("plastic"))

    def test_acceptance_a_berm_that_comes_and_goes_is_drawn_and_reported(self):
        stages = rest(0.1) + stage("construction", "berm", 'place = ["berm"]', 0.2) + stage("construction", "dug", 'remove = ["berm"]', 0.2)
        with BermWorkspace(TREMOLO, stages, shaking=0.2) as work:
            folder = work.run("run")
            for command in ("plot", "report"):
                done = work.command(command, folder)
                self.assertEqual(0, done.returncode, done.stderr)

    def test_a_run_that_is_broken_in_any_of_them_goes_on(self):
        stages = rest(0.15) + stage("construction", "berm", 'place = ["berm"]', 0.15) + aftershock(0.15) + \
            stage("construction", "dug", 'remove = ["berm"]', 0.15) + \
            stage("load", "crane", "x_m = [6.5, 7.5]\npressure_pa = 5e3", 0.15)
        with with_checkpoints(BermWorkspace(TREMOLO, stages, shaking=0.2), every_steps=200) as work:
            whole = whole_run(work)
            goes_on_with_the_same_bits(self, work, whole)


if __name__ == "__main__":
    unittest.main()
