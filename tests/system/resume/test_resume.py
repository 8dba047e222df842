"""A run that is killed anywhere and resumed gives the bits of an unbroken one.

    usage: test_resume.py TREMOLO SOURCE_DIR

TREMOLO_RESUME_KILLS says how many random kills there are of each case; TREMOLO_RESUME_SEED repeats those of another time.
"""

import os
import random
import shutil
import sys
import unittest
from pathlib import Path

TREMOLO, SOURCE = sys.argv.pop(1), Path(sys.argv.pop(1))
sys.path[:0] = [str(SOURCE / "python"), str(Path(__file__).parent)]

import h5py
from broken_run import (BoxWorkspace, SlopeWorkspace, checkpoints, differences, exchange_differences, killed, model, record,
                        resumed, whole_run, with_checkpoints)
from angle_cases import UNDRAINED, WATER, FlatWorkspace
from small_case import SLOPE_BOXES, PeriodicWorkspace, refine, subcycled

KILLS = int(os.environ.get("TREMOLO_RESUME_KILLS", "1"))
SEED = int(os.environ.get("TREMOLO_RESUME_SEED", random.randrange(10**6)))
MIXED = {"left": model("fe"), "right": model("ode"), "base": model("wave")}

LINE_AND_MASS = """
[[line]]
name = "shaft"
from = [18.0, 5.0]
to = [18.0, -5.0]

[[sliding_mass]]
name = "wedge"
polygon = [[12.0, 0.0], [24.0, 8.0], [12.0, 9.0]]
"""


class ResumeCase(unittest.TestCase):
    def setUp(self):
        print(f"TREMOLO_RESUME_SEED={SEED}", file=sys.stderr)
        self.chance = random.Random(SEED)

    def finish(self, work, folder, victim, text):
        """Says how to go on, and does."""
        self.assertIn(f"tremolo resume {folder}", text) if victim != "tremolo" else None
        result = resumed(work, folder)
        self.assertEqual(0, result.returncode, f"after the death of {victim}:\n{result.stdout}{result.stderr}")
        self.assertIn("going on from step", result.stdout)

    def broken_and_resumed(self, work, *options):
        """Kills anybody anywhere, several times, and compares."""
        whole = whole_run(work, *options)
        last = checkpoints(whole)[-1]
        broken = 0
        for attempt in range(20 * KILLS):
            folder = work.path / f"broken{attempt}"
            step = self.chance.randint(1, last - 1)
            victim, text = killed(work, folder, ["run", work.case, "--out", folder, *options], step, chance=self.chance)
            if victim is None:
                continue  # it was over before
            with self.subTest(victim=victim, step=step):
                self.finish(work, folder, victim, text)
                self.assertEqual([], differences(folder, whole))
                if (whole / "exchange.h5").exists():
                    self.assertEqual([], exchange_differences(folder, whole))
                self.assertFalse(list(folder.glob("*.before")))
            broken += 1
            if broken == KILLS:
                return whole
        self.fail(f"{KILLS} runs could not be broken")


class Resume(ResumeCase):
    def test_three_models_with_their_exchange_recorded(self):
        with with_checkpoints(record(BoxWorkspace(TREMOLO, **MIXED, duration=1.0)), every_steps=50) as work:
            whole = self.broken_and_resumed(work)
            self.assertEqual(2, len(checkpoints(whole)))

    def test_wet_ground_that_yields_under_a_wave_at_an_angle(self):
        with with_checkpoints(FlatWorkspace(TREMOLO, ground=UNDRAINED, water=WATER, velocity=0.3, duration=0.7), every_steps=500) as work:
            self.broken_and_resumed(work)

    def test_a_set_that_is_not_complete_does_not_count(self):
        with with_checkpoints(BoxWorkspace(TREMOLO, **MIXED, duration=1.0), every_steps=40) as work:
            whole = whole_run(work)
            folder = work.path / "broken"
            victim, text = killed(work, folder, ["run", work.case, "--out", folder], 80, victim="domain")
            self.assertEqual("domain", victim, text)
            newest = folder / "checkpoints" / f"{checkpoints(folder)[-1]:010}"
            half = newest.with_name(f"{checkpoints(folder)[-1] + 40:010}.part")
            shutil.rmtree(half, ignore_errors=True)
            shutil.copytree(newest, half)
            (half / "manifest.json").unlink()
            self.finish(work, folder, victim, text)
            self.assertEqual([], differences(folder, whole))

    def test_a_resumed_run_that_dies_is_resumed_again(self):
        with with_checkpoints(record(BoxWorkspace(TREMOLO, **MIXED, duration=1.0)), every_steps=30) as work:
            whole = whole_run(work)
            folder = work.path / "broken"
            last = checkpoints(whole)[-1]
            first, _ = killed(work, folder, ["run", work.case, "--out", folder], last // 3, victim="domain")
            again, text = killed(work, folder, ["resume", folder], max(checkpoints(folder)) + 30, victim="domain")
            self.assertEqual(("domain", "domain"), (first, again), text)
            # One that died while it took over what its files held before has left them aside.
            for name in ("run.h5", "exchange.h5"):
                (folder / name).rename(folder / f"{name}.before")
                (folder / name).write_bytes(b"half taken over")
            self.finish(work, folder, again, text)
            self.assertEqual([], differences(folder, whole))
            self.assertEqual([], exchange_differences(folder, whole))

    def test_by_wall_time(self):
        with with_checkpoints(BoxWorkspace(TREMOLO, **MIXED, duration=2.0), every_wall_s=0.1, keep=3) as work:
            folder = work.path / "broken"
            victim, text = killed(work, folder, ["run", work.case, "--out", folder], 50, victim="left")
            self.assertEqual("left", victim, text)
            self.finish(work, folder, victim, text)
            self.assertEqual([], differences(folder, whole_run(work)))


class AcceptanceOtherModels(ResumeCase):
    def test_a_slope_whose_particles_are_cut_on_three_levels(self):
        slope = refine(SlopeWorkspace(TREMOLO, velocity=2.0, duration=1.0), *SLOPE_BOXES)
        slope.case.write_text(slope.case.read_text() + LINE_AND_MASS)
        with with_checkpoints(slope, every_steps=150) as work:
            whole = self.broken_and_resumed(work)
            with h5py.File(whole / "run.h5") as file:
                counts = [len(frame["position"]) for frame in file["frames"].values()]
            self.assertGreater(counts[-1], counts[0], "nothing was cut")

    def test_in_lockstep(self):
        with with_checkpoints(record(BoxWorkspace(TREMOLO, **MIXED, duration=1.0)), every_steps=50, keep=1) as work:
            whole = self.broken_and_resumed(work, "--mode", "lockstep")
            self.assertEqual(1, len(checkpoints(whole)))

    def test_levels_with_steps_of_their_own(self):
        slope = subcycled(refine(SlopeWorkspace(TREMOLO, velocity=2.0, duration=1.0), *SLOPE_BOXES))
        with with_checkpoints(slope, every_steps=40) as work:
            self.broken_and_resumed(work)

    def test_death_while_a_checkpoint_is_written_costs_nothing(self):
        # With one after every step there is hardly a moment in which none is being written.
        with with_checkpoints(BoxWorkspace(TREMOLO, **MIXED, duration=1.0), every_steps=1) as work:
            self.broken_and_resumed(work)

    def test_a_slope_with_gravity_and_softening(self):
        with with_checkpoints(SlopeWorkspace(TREMOLO, duration=1.5), every_steps=50) as work:
            self.broken_and_resumed(work)

    def test_periodic_sides_that_soil_crosses(self):
        for sides in ("periodic", "periodic_springs"):
            with PeriodicWorkspace(TREMOLO, sides=sides, duration=1.5) as work:
                work.case.write_text(work.case.read_text().replace("velocity = 0.1", "velocity = 10.0"))
                self.broken_and_resumed(with_checkpoints(work, every_steps=60))

    def test_particles_that_are_cut_on_their_way_round_a_period(self):
        with refine(PeriodicWorkspace(TREMOLO, duration=1.5), ([6.0, -10.0, 14.0, 0.0], 1)) as work:
            work.case.write_text(work.case.read_text().replace("velocity = 0.1", "velocity = 10.0"))
            whole = self.broken_and_resumed(with_checkpoints(work, every_steps=60))
            with h5py.File(whole / "run.h5") as file:
                counts = [len(frame["position"]) for frame in file["frames"].values()]
            self.assertGreater(counts[-1], counts[0], "nothing was cut")


if __name__ == "__main__":
    unittest.main()
