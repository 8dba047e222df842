"""What is made of the runs of a sweep: table, groups, lines and pairs, from results written by hand; and slopes measured."""

import csv
import json
import tempfile
import unittest
from pathlib import Path
from unittest import mock

import numpy as np

from tremolo.sweep import measures, pictures, pool, slurm, statistics, table
from tremolo.sweep.plan import Order, Plan

MOTIONS, ANGLES = ["a", "b", "c", "d"], [0, 15]


def written(folder, result, runs=None, draw=None):
    """The plan of four motions at two angles; result(motion, angle): measures of a run, or None where it has none."""
    runs = runs or [(motion, angle) for motion in MOTIONS for angle in ANGLES]
    entries = [
        {"name": f"{number:04}", "values": [motion, angle], "inputs": "", "free_fields": angle,
         "motion": {"pga": 1.0, "pgv": 0.1 * (1 + MOTIONS.index(motion)), "arias": 0.5, "significant_duration": 9.0, "mean_period": 0.5}}
        for number, (motion, angle) in enumerate(runs, 1)
    ]
    content = {
        "title": "by hand", "study": "none.toml", "case": "case.toml", "keeps_recordings": False,
        "axes": [{"key": "motion.file", "unit": ""}, {"key": "motion.angle_deg", "unit": "degrees"}],
        "measures": {"failure_strain": 0.1, "intensity": "pgv", "colour": "motion.angle_deg", "draw": draw or [], "spectral_ratio": None}, "runs": entries,
    }
    (folder / "sweep.json").write_text(json.dumps(content))
    plan = Plan(folder)
    for run, (motion, angle) in zip(plan.runs, runs):
        found = result(motion, angle)
        if found is None:
            continue
        failed = isinstance(found, str)
        run.write_result(status="failed" if failed else "complete", message=found if failed else "", replayed=None, settings=None,
                         measures={} if failed else found)
    return plan


class WithoutSlurm(unittest.TestCase):
    def test_is_said_in_words(self):
        with tempfile.TemporaryDirectory() as folder:
            (Path(folder) / "cases").mkdir()
            plan = written(Path(folder), lambda motion, angle: None)
            with mock.patch.dict("os.environ", PATH=folder):
                with self.assertRaisesRegex(OSError, r"--slurm: sbatch cannot be started \(No such file or directory\): the commands of "
                                                     "Slurm must be on the PATH; without --slurm the runs are made on this machine"):
                    slurm.Arrays(plan, "", "tremolo").submit(plan.pending())
                (plan.folder / "slurm.json").write_text(json.dumps({"12": [0]}))
                with self.assertRaisesRegex(OSError, "--slurm: squeue cannot be started"):
                    slurm.Arrays(plan, "", "tremolo").going()
            with self.assertRaisesRegex(ValueError, "--slurm --partition='short: No closing quotation"):
                slurm.Arrays(plan, "--partition='short", "tremolo")


class OfAPlan(unittest.TestCase):
    def setUp(self):
        place = tempfile.TemporaryDirectory()
        self.addCleanup(place.cleanup)
        self.folder = Path(place.name)

    def sweep(self, result, runs=None, draw=None):
        return statistics.Sweep(written(self.folder, result, runs, draw))

    def test_measures_that_all_runs_share_are_left_out(self):
        def result(motion, angle):
            return {"crest.final_displacement_m": 0.1 + 0.01 * angle, "toe.final_displacement_m": 0.2, "failure_time_s": 3.0 if angle else None}

        self.assertEqual(["failure_time_s", "crest.final_displacement_m"], statistics.responses(self.sweep(result)))
        self.assertEqual(["toe.final_displacement_m"], statistics.responses(self.sweep(lambda motion, angle: {"toe.final_displacement_m": 0.2})))

    def test_a_study_chooses_what_is_drawn(self):
        def result(motion, angle):
            return {"crest.final_displacement_m": 0.1 + 0.01 * angle, "crest.final_ux_m": 0.05 * (1 + angle)}

        self.assertEqual(["crest.final_ux_m"], statistics.responses(self.sweep(result, draw=["crest.final_ux_m"])))
        with self.assertRaisesRegex(ValueError, r"none.toml: \[measures\] draw: the runs have no measure 'crest.ux'; they have .*crest.final_ux_m"):
            statistics.responses(self.sweep(result, draw=["crest.ux"]))

    def test_a_power_law_is_found_again(self):
        sweep = self.sweep(lambda motion, angle: {"crest.final_displacement_m": (2.0 + angle) * (0.1 * (1 + MOTIONS.index(motion))) ** 1.7})
        self.assertEqual("pgv_m_s", sweep.intensity)
        for colour, factor in ((0, 2.0), (15, 17.0)):
            runs = [number for number in sweep.complete if sweep.has_colour(number, colour)]
            line = statistics.fitted(sweep.numbers("pgv_m_s")[runs], sweep.numbers("crest.final_displacement_m")[runs])
            self.assertAlmostEqual(factor, line.factor, places=9)
            self.assertAlmostEqual(1.7, line.power, places=9)
            self.assertAlmostEqual(0.0, line.deviation, places=9)
            self.assertEqual(4, line.runs)

    def test_the_deviation_of_a_line_is_that_of_its_residuals(self):
        # ln y = +d, -d, -d, +d about zero at ln x = 0, 1, 2, 3: the line is level, and the residuals' squares sum to 4 d^2.
        d = 0.3
        line = statistics.fitted(np.exp([0.0, 1.0, 2.0, 3.0]), np.exp([d, -d, -d, d]))
        self.assertAlmostEqual(0.0, line.power)
        self.assertAlmostEqual(np.sqrt(4.0 * d**2 / 2.0), line.deviation)

    def test_no_line_through_motions_alike_or_too_few(self):
        self.assertIsNone(statistics.fitted([0.1, 0.1, 0.101], [1.0, 2.0, 3.0]))
        self.assertIsNone(statistics.fitted([0.1, 0.2, 0.3], [1.0, 2.0, 0.0]))
        self.assertIsNone(statistics.fitted([0.1, 0.2], [1.0, 2.0]))

    def test_a_slope_that_holds_fails_later_than_one_that_does_not(self):
        at = {("a", 0): 12.0, ("a", 15): 11.0, ("b", 0): None, ("b", 15): 14.0, ("c", 0): 9.0, ("c", 15): None, ("d", 0): 8.0, ("d", 15): 8.0}
        sweep = self.sweep(lambda motion, angle: {"failure_time_s": at[motion, angle]})
        (pair,) = statistics.compared(sweep, "failure_time_s")
        self.assertEqual((15, 4, 2, 1, 1), (pair.colour, pair.pairs, pair.smaller, pair.larger, pair.alike))
        self.assertEqual(-0.5, pair.median)  # of -1 and 0, where both fail

    def test_two_slopes_that_hold_are_alike(self):
        sweep = self.sweep(lambda motion, angle: {"failure_time_s": 5.0 if motion == "a" else None})
        (pair,) = statistics.compared(sweep, "failure_time_s")
        self.assertEqual((4, 0, 0, 4, 0.0), (pair.pairs, pair.smaller, pair.larger, pair.alike, pair.median))

    def test_pairs_leave_out_what_failed(self):
        sweep = self.sweep(lambda motion, angle: "it broke" if (motion, angle) == ("b", 15) else {"failure_time_s": 1.0 + angle})
        (pair,) = statistics.compared(sweep, "failure_time_s")
        self.assertEqual((3, 0, 3), (pair.pairs, pair.smaller, pair.larger))

    def test_groups_are_the_motions_of_an_angle(self):
        sweep = self.sweep(lambda motion, angle: {"x.final_displacement_m": float(MOTIONS.index(motion))})
        self.assertEqual([(0, [0, 2, 4, 6]), (15, [1, 3, 5, 7])], [(group.colour, group.runs) for group in sweep.groups()])
        count, median, low, high = sweep.spread("x.final_displacement_m", sweep.groups()[0])
        self.assertEqual((4, 1.5), (count, median))
        self.assertAlmostEqual(0.16 * 3.0, low)  # percentiles of 0, 1, 2, 3
        self.assertAlmostEqual(0.84 * 3.0, high)

    def test_the_table_has_rows_for_failed_and_missing_runs(self):
        results = {("a", 0): {"cpu_s": 2.0}, ("a", 15): "it broke"}
        plan = written(self.folder, lambda motion, angle: results.get((motion, angle)))
        table.write(plan)
        with open(self.folder / "sweep.csv", newline="") as stream:
            rows = list(csv.DictReader(stream))
        self.assertEqual(["complete", "failed"] + ["missing"] * 6, [row["status"] for row in rows])
        self.assertEqual(("it broke", "", "2.0"), (rows[1]["message"], rows[1]["cpu_s"], rows[0]["cpu_s"]))
        self.assertEqual((1, 1, 6), table.counts(plan))

    def test_one_run_of_each_free_field_goes_first(self):
        plan = written(self.folder, lambda motion, angle: None)
        order = Order(plan, plan.pending())
        self.assertEqual([0, 1], order.first)
        self.assertEqual({0: [2, 4, 6], 1: [3, 5, 7]}, order.then)
        self.assertEqual([0, 1], order.records)

    def test_a_run_that_is_left_alone_with_its_free_field_does_not_record(self):
        plan = written(self.folder, lambda motion, angle: {"cpu_s": 1.0} if motion != "d" else None)
        order = Order(plan, plan.pending())
        self.assertEqual(([6, 7], [], {}), (order.first, order.records, order.then))

    def test_pictures_of_failures_that_never_come(self):
        sweep = self.sweep(lambda motion, angle: {"failure_time_s": 5.0 if angle else None, "toe.peak_ax_m_s2": 1.0 + angle})
        self.assertEqual(["failure_time_s", "toe.peak_ax_m_s2"], statistics.responses(sweep))
        pictures.style.plt.close(pictures.draw(sweep))

    def test_a_sweep_without_a_complete_run_has_no_picture(self):
        with self.assertRaisesRegex(ValueError, "no run of the sweep has ended well"):
            pictures.draw(self.sweep(lambda motion, angle: "it broke"))

    def test_the_pool_keeps_to_its_jobs(self):
        plan = written(self.folder, lambda motion, angle: None)
        going, most = [], []

        def carry_out(task):
            going.append(task)
            most.append(len(going))
            task._run.write_result(status="complete", message="", replayed=None, settings=None, measures={})
            going.remove(task)

        with mock.patch.object(pool.Task, "carry_out", carry_out):
            self.assertEqual(list(range(8)), sorted(pool.carry_out(plan, plan.pending(), "tremolo", jobs=2)))
        self.assertLessEqual(max(most), 2)


class Slope:
    """A slope that rises to the right from 0 m to 10 m, its toe at x = 40 m: three particles above the toe, one below."""

    times = [0.0, 1.0]
    position = np.array([[33.0, 0.5], [45.0, 2.0], [60.0, 9.0], [10.0, -0.5]])
    displacement = np.array([[-9.0, -3.0], [0.0, 0.0], [0.0, 0.0], [0.0, 0.1]])

    def __init__(self, levels=(0.0, 10.0), mirrored=False):
        self._levels, self._sign = levels, -1.0 if mirrored else 1.0

    def attribute(self, name):
        return list(self._levels)

    def monitor(self, name):
        return {"x": [40.0 * self._sign]}

    def field(self, index, name):
        return getattr(self, name) * [self._sign, 1.0]


class RunOut(unittest.TestCase):
    def test_is_that_of_soil_from_above_the_toe(self):
        self.assertEqual(7.0, measures.run_out(Slope()))

    def test_of_a_slope_that_falls_to_the_right(self):
        self.assertEqual(7.0, measures.run_out(Slope((10.0, 0.0), mirrored=True)))

    def test_units_follow_from_names(self):
        self.assertEqual(["m", "m/s2", "rad", "s", "1", "1"], [measures.unit(name) for name in (
            "crest.final_ux_m", "a.peak_ax_m_s2", "b.final_tilt_rad", "cpu_s", "a.peak_r_u", "spectral_ratio_0.2s")])


if __name__ == "__main__":
    unittest.main()
