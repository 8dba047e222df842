"""A load on saturated sand, as a user runs it: the ground has settled under it when the shaking begins, it goes on
acting, and a run that is broken goes on with the same bits.

    usage: test_load.py TREMOLO SOURCE_DIR
"""

import sys
import unittest
from pathlib import Path

TREMOLO, SOURCE = sys.argv.pop(1), Path(sys.argv.pop(1))
sys.path[:0] = [str(SOURCE / "python"), str(SOURCE / "tests" / "system" / "resume"), str(Path(__file__).parent)]

from broken_run import differences, goes_on_with_the_same_bits, resumed, whole_run, with_checkpoints
from rest_case import RestWorkspace, rest
from tremolo.run import Run

LOAD = """
[[stage]]
kind = "load"
name = "fill"
x_m = [0.0, 2.0]
pressure_pa = 30e3
"""
CHANGES = {"load": LOAD, "boundary": 'sides = "periodic"'}


class Load(unittest.TestCase):
    def test_a_broken_run_goes_on_with_the_ground_that_has_settled(self):
        changes = CHANGES | {"rest": rest(0.3), "shaking": 0.5}
        with with_checkpoints(RestWorkspace(TREMOLO, **changes), every_steps=400) as work:
            whole = whole_run(work)
            surface = Run(whole / "run.h5").monitor("surface")
            self.assertLess(surface["uy"][0], -5e-4)
            self.assertAlmostEqual(surface["uy"][0], surface["uy"][1], delta=1e-6)
            goes_on_with_the_same_bits(self, work, whole)

    def test_a_run_that_ends_after_a_stage_goes_on_from_it(self):
        with RestWorkspace(TREMOLO, **CHANGES | {"rest": rest(0.2), "shaking": 0.3}) as work:
            whole = work.run("whole", "--threads", 1)
            for stage, end in ("fill", 0.0), ("shaking", 0.3):
                folder = work.run(stage, "--threads", 1, "--until", stage)
                part = Run(folder / "run.h5")
                self.assertIn(f"ended after the stage '{stage}'", part.status)
                self.assertAlmostEqual(end, part.times[-1], delta=0.3)
                result = resumed(work, folder)
                self.assertEqual(0, result.returncode, result.stdout + result.stderr)
                self.assertEqual([], differences(folder, whole))
            result = work.command("run", work.case, "--until", "fil")
            self.assertNotEqual(0, result.returncode)
            self.assertIn("did you mean 'fill'?", result.stdout + result.stderr)

    def test_explain_and_report_know_it(self):
        with RestWorkspace(TREMOLO, **CHANGES) as work:
            result = work.command("explain", work.case)
            self.assertEqual(0, result.returncode, result.stdout + result.stderr)
            self.assertIn("2  fill                load          pressure of 30000 Pa on the surface", result.stdout)

    def test_a_second_name_is_refused(self):
        with RestWorkspace(TREMOLO, **CHANGES | {"load": LOAD + LOAD}) as work:
            result = work.command("check", work.case)
            self.assertNotEqual(0, result.returncode)
            self.assertIn("has the name 'fill' already", result.stdout + result.stderr)


if __name__ == "__main__":
    unittest.main()
