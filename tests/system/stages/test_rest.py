"""The rest after shaking, as a user runs it: sand reconsolidates in the domain as in its columns, a time factor changes
little, and the run ends and goes on where it should.

    usage: test_rest.py TREMOLO SOURCE_DIR
"""

import sys
import unittest
from pathlib import Path

TREMOLO, SOURCE = sys.argv.pop(1), Path(sys.argv.pop(1))
sys.path[:0] = [str(SOURCE / "python"), str(SOURCE / "tests" / "system" / "resume"), str(Path(__file__).parent)]

import numpy as np
from broken_run import goes_on_with_the_same_bits, whole_run, with_checkpoints
from rest_case import RestWorkspace, replayed, rest
from tremolo import column
from tremolo.run import Run


def at(series, name, time):
    return np.interp(time, series["time"], series[name])


def settlement(run, time):
    """mm"""
    return -1e3 * at(run.monitor("surface"), "uy", time)


class Rest(unittest.TestCase):
    def run_of(self, **changes):
        with RestWorkspace(TREMOLO, **changes) as work:
            return Run(work.run("run", "--threads", 1) / "run.h5")

    def columns_of(self, work, models):
        """The free field at the surface by model."""
        fields = {}
        for model in models:
            out = work.path / f"{model}.h5"
            result = work.command("column", work.case, "--model", model, "--out", out, "--depths", "0", "--duration", 33.0, "--every", 0.02)
            self.assertEqual(0, result.returncode, result.stdout + result.stderr)
            fields[model] = column.read(out)[1][0]
        return fields

    def test_the_domain_settles_as_its_columns_and_by_more_than_without(self):
        with RestWorkspace(TREMOLO, rest=rest(30.0, time_factor=5.0)) as work:
            result = work.command("run", work.case, "--out", work.path / "run", "--threads", 1)
            self.assertEqual(0, result.returncode, result.stdout + result.stderr)
            self.assertIn("note: the rest begins at 3.0", result.stdout + result.stderr)
            run = Run(work.path / "run" / "run.h5")
            fields = self.columns_of(work, ("mpm", "fe"))
        with RestWorkspace(TREMOLO, shaking=33.0) as work:
            shaken = self.columns_of(work, ("fe",))["fe"]
        self.assertAlmostEqual(33.0, run.monitor("surface")["time"][-1], delta=0.01)
        # Reversals of PM4Sand go with the slightest change of a path: seven runs whose motions differ by 1e-9 settle by 98.2 to
        # 103.5, 100.2 to 101.8, and 100.9 to 102.0 % of the column.
        for time, scatter in ((4.0, 0.04), (10.0, 0.025), (32.9, 0.025)):
            self.assertAlmostEqual(1.0, settlement(run, time) / (-1e3 * at(fields["mpm"], "uy", time)), delta=scatter)
        for time in (10.0, 32.9):  # by elements and another scheme
            self.assertAlmostEqual(1.0, settlement(run, time) / (-1e3 * at(fields["fe"], "uy", time)), delta=0.05)
        self.assertGreater(settlement(run, 32.9), 3.0 * -1e3 * at(shaken, "uy", 32.9))

    def test_acceptance_a_time_factor_changes_little(self):
        keys = {"permeability": 1e-4, "boundary": 'sides = "periodic"'}
        slow = self.run_of(rest=rest(7.0), **keys)
        fast = self.run_of(rest=rest(7.0, time_factor=10.0), **keys)
        self.assertAlmostEqual(10.0, fast.monitor("surface")["time"][-1], delta=0.01)
        self.assertAlmostEqual(10.0, fast.times[-1], delta=0.01)
        added = settlement(slow, 9.9) - settlement(slow, 3.0)
        for time in (4.0, 7.0, 9.9):
            self.assertAlmostEqual(settlement(slow, time), settlement(fast, time), delta=0.01 * added)
            self.assertAlmostEqual(at(slow.monitor("2.5 m"), "pore_pressure_ratio", time),
                                   at(fast.monitor("2.5 m"), "pore_pressure_ratio", time), delta=0.002)
        # Velocities are those of the soil's time too: their integral is the settlement.
        series = fast.monitor("surface")
        late = series["time"] > 6.0
        moved = np.trapz(series["vy"][late], series["time"][late])
        self.assertAlmostEqual(1.0, moved / np.ptp(series["uy"][late]) * -1.0, delta=0.02)

    def test_a_run_that_is_broken_in_the_rest_goes_on(self):
        changes = {"rest": rest(0.5, time_factor=5.0), "boundary": 'sides = "periodic"', "shaking": 0.5}
        with with_checkpoints(RestWorkspace(TREMOLO, **changes), every_steps=400) as work:
            whole = whole_run(work)
            goes_on_with_the_same_bits(self, work, whole)

    def test_a_long_rest_of_a_column_passes_check(self):
        # Histories at every 5 ms would be more than a column takes.
        with RestWorkspace(TREMOLO, permeability=1e-4, rest=rest(3000.0, time_factor=20.0)) as work:
            result = work.command("check", work.case, "--column", "fe")
            self.assertEqual(0, result.returncode, result.stdout + result.stderr)

    def test_a_recording_with_another_rest_is_refused(self):
        changes = {"boundary": 'left = { model = "mpm" }\nright = { model = "mpm" }', "shaking": 0.2}
        with RestWorkspace(TREMOLO, rest=rest(0.2) + "\n[record]\nexchange = true\n", **changes) as work:
            work.run("run", "--threads", 1)
            replay = replayed(work.case.read_text())
            work.case.write_text(replay)
            same = work.command("run", work.case, "--out", work.path / "same", "--threads", 1)
            self.assertEqual(0, same.returncode, same.stdout + same.stderr)
            work.case.write_text(replay.replace('kind = "rest"\n', 'kind = "rest"\ntime_factor = 2.0\n'))
            other = work.command("run", work.case, "--out", work.path / "other", "--threads", 1)
            self.assertNotEqual(0, other.returncode)
            self.assertIn("rest.time_factor is 1 in the recording, 2 in the case", other.stdout + other.stderr)

    def test_ends_when_the_pressure_is_gone(self):
        run = self.run_of(rest=rest(100.0, time_factor=5.0, until_ratio=0.3), boundary='sides = "periodic"')
        end = run.monitor("2.5 m")
        self.assertGreater(end["time"][-1], 3.5)
        self.assertLess(end["time"][-1], 50.0)
        self.assertLess(end["pore_pressure_ratio"][-1], 0.3)
        self.assertGreater(end["pore_pressure_ratio"].max(), 0.5)


if __name__ == "__main__":
    unittest.main()
