"""Soil and structures that are placed and removed, as a user runs it: explain lists the stages, the model that is
shaken is that of the last one with what it has gone through, a broken run goes on with the same bits, and a pit that
does not stand leaves a frame of the model that failed.

    usage: test_construction.py TREMOLO SOURCE_DIR
"""

import sys
import unittest
from pathlib import Path

TREMOLO, SOURCE = sys.argv.pop(1), Path(sys.argv.pop(1))
sys.path[:0] = [str(SOURCE / "python"), str(SOURCE / "tests" / "system" / "runs"), str(SOURCE / "tests" / "system" / "resume")]

import numpy as np
import small_case
from broken_run import differences, goes_on_with_the_same_bits, resumed, whole_run, with_checkpoints
from tremolo.pictures import stages
from tremolo.run import Run

CASE = """
title = "ground that is dug and filled"

[motion]
pulse = {{ shape = "ricker", frequency = 3.0, time = 0.3, velocity = 0.05 }}
wave = "SV"
angle_deg = 0.0
reference = [0.0, -6.0]

[surface]
level = 0.0

[halfspace]
density = 1800.0
vs = 120.0
vp = 225.0

[soil.ground]
model = "drucker_prager"
density = 1800.0
vs = 120.0
vp = 225.0
cohesion = {cohesion}
friction_deg = 10.0

[[region]]
soil = "ground"
polygon = [[0.0, -6.0], [16.0, -6.0], [16.0, 0.0], [7.0, 0.0], [7.0, -3.0], [3.0, -3.0], [3.0, 0.0], [0.0, 0.0]]

[[region]]
name = "pit"
soil = "ground"
polygon = [[3.0, -3.0], [7.0, -3.0], [7.0, 0.0], [3.0, 0.0]]

[[region]]
name = "bank"
soil = "ground"
polygon = [[9.0, 0.0], [14.0, 0.0], [13.0, 1.0], [10.0, 1.0]]

[[structure]]
name = "block"
polygon = [[4.0, -3.0], [6.0, -3.0], [6.0, -1.0], [4.0, -1.0]]
rigid = true
density = 2400.0
friction = 0.5

[mesh]
size = 0.5
box = [0.0, -6.0, 16.0, 2.0]

[boundary]
sides = "periodic"
base = {{ model = "wave", form = "total" }}

[[stage]]
kind = "gravity"
residual = 1e-6

[[stage]]
kind = "construction"
name = "dig"
remove = ["pit"]
residual = 1e-6
max_time_s = {patience}

[[stage]]
kind = "construction"
name = "build"
place = ["block", "bank"]
residual = 1e-6
{loads}
[[stage]]
kind = "shaking"
duration_s = 0.4

[[monitor]]
name = "block"
point = [5.0, -2.0]
structure = "block"

[output]
every_s = 0.1
history_every_s = 0.05
fields = ["displacement", "stress", "state"]
"""


class DugWorkspace(small_case.Workspace):
    template, defaults = CASE, {"cohesion": "20e3", "patience": 60.0, "loads": ""}


ON_BLOCK = """
[[stage]]
kind = "load"
name = "machine"
structure = "block"
force_n_per_m = [2e3, -30e3]
residual = 1e-6
"""


class Construction(unittest.TestCase):
    def test_the_ground_is_shaken_as_it_was_built(self):
        with with_checkpoints(DugWorkspace(TREMOLO), every_steps=60) as work:
            listed = work.command("explain", work.case).stdout
            self.assertIn("removes 'pit'", listed)
            self.assertIn("places 'block', 'bank'", listed)
            whole = whole_run(work)
            frame = Run(whole / "run.h5").frame(0)
            x, y = frame["position"].T
            self.assertFalse(np.any((x > 3.0) & (x < 7.0) & (y > -3.0)))  # the pit is there
            bank = (x > 10.0) & (x < 13.0) & (y > 0.0) & (y < 1.0)
            self.assertTrue(np.any(bank))
            below = (np.abs(x - 5.0) < 1.0) & (y < -3.0) & (y > -4.0)
            self.assertGreater(frame["displacement"][below, 1].mean(), 0.0)  # it has risen
            under_bank = (np.abs(x - 11.5) < 1.0) & (y < 0.0) & (y > -1.0)
            self.assertLess(frame["displacement"][under_bank, 1].mean(), 0.0)
            names = [name for name, _ in stages.frames(Run(whole / "run.h5"))]
            self.assertEqual(["gravity", "dig", "build"], names)
            moved = [np.hypot(*stage.field(0, "displacement").T).max() for _, stage in stages.frames(Run(whole / "run.h5"))]
            self.assertEqual(0.0, moved[0])
            self.assertGreater(moved[1], 0.0)
            goes_on_with_the_same_bits(self, work, whole)

    def test_acceptance_the_stages_are_drawn(self):
        with DugWorkspace(TREMOLO) as work:
            drawn = work.command("plot", work.run("run"))
            self.assertEqual(0, drawn.returncode, drawn.stderr)
            for picture in "stages.png", "shear_bands.png":  # there are no accelerations to choose times by
                self.assertIn(picture, drawn.stdout)

    def test_a_run_that_ends_after_a_static_stage_goes_on_from_it(self):
        with DugWorkspace(TREMOLO, loads=ON_BLOCK) as work:
            listed = work.command("explain", work.case).stdout
            self.assertIn("force of [2000, -30000] N/m on the structure 'block', which stays", listed)
            whole = whole_run(work)
            block = Run(whole / "run.h5").body("block")
            weight = 9.81 * block.mass + 30e3
            self.assertAlmostEqual(-weight, block["weight_y"][0], delta=1e-6 * weight)
            self.assertAlmostEqual(weight, block["normal_y"][1] + block["friction_y"][1], delta=0.01 * weight)
            for count, stage in ((2, "dig"), (4, "machine")):
                folder = work.run(stage, "--threads", 1, "--until", stage)
                part = Run(folder / "run.h5")
                self.assertIn(f"ended after the stage '{stage}'", part.status)
                self.assertEqual(["block"] if count > 2 else [], list(part.bodies))
                self.assertEqual(count, len(stages.frames(part)))
                result = resumed(work, folder)
                self.assertEqual(0, result.returncode, result.stdout + result.stderr)
                self.assertEqual([], differences(folder, whole))
                for (name, frame), (_, of_whole) in zip(stages.frames(Run(folder / "run.h5")), stages.frames(Run(whole / "run.h5")), strict=True):
                    self.assertTrue(np.array_equal(frame.field(0, "stress"), of_whole.field(0, "stress")), name)
            settled = [frame.body("block").outline[:, 1].min() for _, frame in stages.frames(Run(whole / "run.h5"))[2:]]
            self.assertLess(settled[1], settled[0] - 1e-5)  # frames show the block where it has gone
            self.assertIn("nothing to go on with", resumed(work, folder).stderr)

    def test_acceptance_a_run_goes_on_from_stage_to_stage(self):
        with DugWorkspace(TREMOLO, loads=ON_BLOCK) as work:
            whole = whole_run(work)
            folder = work.run("part", "--threads", 1, "--until", "gravity")
            for count, stage in enumerate(("dig", "build", "machine"), 2):
                result = resumed(work, folder, "--until", stage)
                self.assertEqual(0, result.returncode, result.stdout + result.stderr)
                part = Run(folder / "run.h5")
                self.assertIn(f"ended after the stage '{stage}'", part.status)
                self.assertEqual(count, len(stages.frames(part)))
                if stage == "build":
                    over = resumed(work, folder, "--until", "dig")
                    self.assertNotEqual(0, over.returncode)
                    self.assertIn("--until dig: this stage was over at the checkpoint of step 0, 0 s, from which the run goes on; "
                                  "still to come: 'machine', 'shaking'", over.stderr)
            result = resumed(work, folder)
            self.assertEqual(0, result.returncode, result.stdout + result.stderr)
            self.assertEqual([], differences(folder, whole))

    def test_a_run_that_keeps_no_checkpoint_cannot_end_early(self):
        with with_checkpoints(DugWorkspace(TREMOLO), keep=0) as work:
            result = work.command("run", work.case, "--until", "dig")
            self.assertNotEqual(0, result.returncode)
            self.assertIn("--until dig: the case keeps no checkpoint to go on from", result.stdout + result.stderr)

    def test_a_pit_that_does_not_stand_leaves_a_frame(self):
        with DugWorkspace(TREMOLO, cohesion="1e3", patience=3.0) as work:
            result = work.command("run", work.case, "--out", work.path / "fails")
            self.assertNotEqual(0, result.returncode)
            self.assertIn("stage 'dig': the ground did not come to rest", result.stdout + result.stderr)
            run = Run(work.path / "fails" / "run.h5")
            x, y = run.frame(0)["position"].T
            self.assertFalse(np.any((x > 3.0) & (x < 7.0) & (y > -3.0)))
            self.assertFalse(np.any(y > 0.0))  # the bank has not come yet


if __name__ == "__main__":
    unittest.main()
