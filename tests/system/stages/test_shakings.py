"""Main shock, rest, aftershock, rest, as a user runs them: the domain as its columns, sand that remembers, and a run that
goes on in any stage.

    usage: test_shakings.py TREMOLO SOURCE_DIR
"""

import sys
import unittest
from pathlib import Path

TREMOLO, SOURCE = sys.argv.pop(1), Path(sys.argv.pop(1))
sys.path[:0] = [str(SOURCE / "python"), str(SOURCE / "tests" / "system" / "resume"), str(Path(__file__).parent)]

import numpy as np
from broken_run import goes_on_with_the_same_bits, resumed, whole_run, with_checkpoints
from rest_case import RestWorkspace, replayed, rest
from tremolo import column
from tremolo.run import Run


def shaking(duration, velocity=0.35, name="aftershock", time=1.0):
    """A later stage of shaking, by a pulse as the first one has."""
    return (f'\n[[stage]]\nkind = "shaking"\nname = "{name}"\nduration_s = {duration}\n'
            f'motion = {{ pulse = {{ shape = "ricker", frequency = 1.5, time = {time}, velocity = {velocity} }} }}\n')


def at(series, name, time):
    return np.interp(time, series["time"], series[name])


class Shakings(unittest.TestCase):
    def test_acceptance_the_domain_is_shaken_again_as_its_columns(self):
        # 3 s, rest until 23 s, 3 s, rest until 36 s; the rests pass up to 5 times as fast.
        stages = rest(20.0, time_factor=5.0) + shaking(3.0) + rest(10.0, name='"last rest"', time_factor=5.0)
        with RestWorkspace(TREMOLO, rest=stages) as work:
            result = work.command("run", work.case, "--out", work.path / "run", "--threads", 1)
            said = result.stdout + result.stderr
            self.assertEqual(0, result.returncode, said)
            for note in ("note: the rest begins at 3.0", "note: the aftershock begins at 23.0", "note: the last rest begins at 26"):
                self.assertIn(note, said)
            run = Run(work.path / "run" / "run.h5")
            fields = {}
            for model in ("mpm", "fe"):
                out = work.path / f"{model}.h5"
                result = work.command("column", work.case, "--model", model, "--out", out, "--depths", "0,2.5", "--every", 0.02)
                self.assertEqual(0, result.returncode, result.stdout + result.stderr)
                fields[model] = column.read(out)[1][0]
        surface = run.monitor("surface")
        self.assertAlmostEqual(36.0, surface["time"][-1], delta=0.01)
        for model, times, within in (("mpm", (3.0, 22.9, 26.0, 35.9), 0.015), ("fe", (22.9, 35.9), 0.06)):
            for time in times:
                self.assertAlmostEqual(1.0, at(surface, "uy", time) / at(fields[model], "uy", time), delta=within, msg=f"{model} {time}")
        # Both shocks shake the surface at the same time of their stages.
        peak = lambda start: surface["time"][np.argmax(np.where(abs(surface["time"] - start - 1.5) < 1.5, surface["vx"], -1.0))] - start
        self.assertAlmostEqual(peak(0.0), peak(23.0), delta=0.15)
        self.assertIn(23.0, np.round(run.times, 2))  # the stage begins with a frame
        self.assertLess(at(surface, "uy", 35.9), at(surface, "uy", 22.9) - 1e-3)  # and settles once more

    def test_two_shocks_are_the_sum_of_both_in_elastic_ground(self):
        elastic = {"soil": 'model = "linear_elastic"\nyoung = 100e6\npoisson = 0.3\nporosity = 0.4\n'}
        with RestWorkspace(TREMOLO, shaking=1.5, **elastic) as work:
            text = work.case.read_text().replace('library = "pm4sand_dr55"\n', "").replace("time = 1.0, velocity", "time = 0.8, velocity")

            def surface(name, stages, first=0.35):
                work.case.write_text(text.replace("velocity = 0.35", f"velocity = {first}") + stages)
                run = Run(work.run(name, "--threads", 1) / "run.h5")
                return run.monitor("surface")["vx"]

            rests = rest(0.5, name='"pause"')
            both = surface("both", rests + shaking(1.5, 0.2, time=0.8))
            one = surface("one", rests + shaking(1.5, 0.0, time=0.8))
            other = surface("other", rests + shaking(1.5, 0.2, time=0.8), first=0.0)
            self.assertLess(np.abs(both - one - other).max(), 1e-8 * np.abs(both).max())
            self.assertGreater(np.abs(other).max(), 0.3 * np.abs(one).max())

    def test_a_run_that_is_broken_in_any_stage_goes_on(self):
        stages = rest(1.0, time_factor=5.0) + shaking(0.2, time=0.1) + rest(0.2, name='"last rest"')
        changes = {"rest": stages, "boundary": 'sides = "periodic"', "shaking": 0.2}
        with with_checkpoints(RestWorkspace(TREMOLO, **changes), every_steps=200) as work:
            whole = whole_run(work)
            goes_on_with_the_same_bits(self, work, whole, before_last=200)
            out = work.path / "part"
            ended = work.command("run", work.case, "--out", out, "--threads", 1, "--until", "rest")
            for stage, end in ("rest", 1.2), ("aftershock", 1.4):
                self.assertEqual(0, ended.returncode, ended.stdout + ended.stderr)
                self.assertIn(f"ended after the stage '{stage}'", Run(out / "run.h5").status)
                self.assertAlmostEqual(end, Run(out / "run.h5").monitor("surface")["time"][-1], delta=0.06)
                for other, said in ((stage, "this stage was over at the checkpoint"), ("last rets", "did you mean 'last rest'?")):
                    refused = resumed(work, out, "--until", other)
                    self.assertNotEqual(0, refused.returncode)
                    self.assertIn(f"--until {other}: ", refused.stderr)
                    self.assertIn(said, refused.stderr)
                ended = resumed(work, out, *(("--until", "aftershock") if stage == "rest" else ()))
            self.assertEqual(0, ended.returncode, ended.stdout + ended.stderr)
            self.assertEqual("complete", Run(out / "run.h5").status)
            for name in ("uy", "pore_pressure_ratio"):
                self.assertTrue(np.array_equal(Run(whole / "run.h5").monitor("2.5 m")[name], Run(out / "run.h5").monitor("2.5 m")[name]))

    def test_a_recording_with_another_aftershock_is_refused(self):
        stages = rest(0.2) + shaking(0.2, time=0.1)
        with RestWorkspace(TREMOLO, shaking=0.2, rest=stages + "\n[record]\nexchange = true\n") as work:
            work.run("run", "--threads", 1)
            replay = replayed(work.case.read_text())
            work.case.write_text(replay)
            same = work.command("run", work.case, "--out", work.path / "same", "--threads", 1)
            self.assertEqual(0, same.returncode, same.stdout + same.stderr)
            work.case.write_text(replay.replace("time = 0.1, velocity = 0.35", "time = 0.1, velocity = 0.3"))
            other = work.command("run", work.case, "--out", work.path / "other", "--threads", 1)
            self.assertNotEqual(0, other.returncode)
            self.assertIn("motion.2.pulse.velocity is 0.35 in the recording, 0.3 in the case", other.stdout + other.stderr)


if __name__ == "__main__":
    unittest.main()
