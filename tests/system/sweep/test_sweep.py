"""`tremolo sweep` with runs of a tenth of a second: table, pictures, shared free fields, motions, refusals.

    usage: test_sweep.py TREMOLO SOURCE_DIR
"""

import shutil
import sys
import unittest
from pathlib import Path

TREMOLO, SOURCE = sys.argv.pop(1), Path(sys.argv.pop(1))
sys.path[:0] = [str(SOURCE / "python"), str(Path(__file__).parent)]

import h5py
import numpy as np
from small_sweep import STUDY, SweepWorkspace
from tremolo import Run

RECIPE = SOURCE / "cases/slope_oblique/motion.toml"
WITH_RECORD = ('pulse = { shape = "ricker", frequency = 3.0, time = 0.5, velocity = 0.1 }', 'file = "none.AT2"\nkind = "incident"')


def programs(folder):
    """Of the free fields of a run."""
    with Run(folder) as run:
        return [source["program"] for source in run.plan["sources"]]


class Table(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.work = SweepWorkspace(TREMOLO)
        cls.addClassCleanup(cls.work.__exit__)
        cls.said = cls.work.swept("--jobs", 2)
        cls.rows = cls.work.rows()

    def test_it_is_the_product_in_order(self):
        self.assertEqual([(a, e) for a in ("0", "15") for e in ("40000000.0", "60000000.0", "80000000.0")],
                         [(row["motion.angle_deg"], row["soil.box.young"]) for row in self.rows])
        self.assertEqual({"complete"}, {row["status"] for row in self.rows})

    def test_measures_are_those_of_the_monitor(self):
        for row in self.rows:
            with Run(self.work.out / "runs" / row["run"]) as run:
                series = run.monitor("surface")
                self.assertEqual(float(row["surface.peak_displacement_m"]), np.hypot(series["ux"], series["uy"]).max())
                self.assertEqual(float(row["surface.final_ux_m"]), series["ux"][-1])
                self.assertAlmostEqual(float(row["cpu_s"]), sum(run.table("processes")["cpu_time"]))

    def test_intensities_are_those_of_the_pulse(self):
        # A Ricker velocity pulse has its peak V at its middle, and its steepest slope there is V pi f times a number:
        # v = V (1 - 2 s^2) exp(-s^2), s = pi f (t - t0), is steepest where dv/ds = s (4 s^2 - 6) exp(-s^2) is largest.
        s = np.linspace(0.0, 2.0, 200001)
        steepest = np.abs(s * (4.0 * s**2 - 6.0) * np.exp(-(s**2))).max()
        for row in self.rows:
            self.assertAlmostEqual(0.1, float(row["pgv_m_s"]), delta=1e-3)
            self.assertAlmostEqual(0.1 * np.pi * 3.0 * steepest, float(row["pga_m_s2"]), delta=0.02)

    def test_hdf5_holds_the_same_with_units(self):
        with h5py.File(self.work.out / "sweep.h5") as file:
            group = file["runs"]
            self.assertEqual(list(self.rows[0]), list(group.attrs["columns"]))
            for name in ("surface.peak_displacement_m", "motion.angle_deg", "pga_m_s2"):
                self.assertEqual([float(row[name]) for row in self.rows], list(group[name][()]))
            self.assertEqual("m", group["surface.peak_displacement_m"].attrs["unit"])
            self.assertEqual("degrees", group["motion.angle_deg"].attrs["unit"])
            self.assertEqual([row["run"] for row in self.rows], [name.decode() for name in group["run"][()]])

    def test_pictures_are_drawn(self):
        for name in ("sweep.png", "histories.png"):
            self.assertGreater((self.work.out / name).stat().st_size, 20000)

    def test_free_fields_are_computed_once_an_angle(self):
        computed = [row["run"] for row in self.rows if "tremolo-recording" not in programs(self.work.out / "runs" / row["run"])]
        self.assertEqual(["0001", "0004"], computed)
        self.assertEqual(["", "0001", "0001", "", "0004", "0004"], [row["replayed"] for row in self.rows])

    def test_a_replayed_run_has_the_bits_of_one_that_computes(self):
        for name in ("0005",):
            folder = self.work.path / f"direct_{name}"
            done = self.work.command("run", self.work.out / "cases" / f"{name}.toml", "--out", folder)
            self.assertEqual(0, done.returncode, done.stderr)
            with Run(folder) as direct, Run(self.work.out / "runs" / name) as swept:
                for column in ("ux", "uy", "vx", "ax"):
                    np.testing.assert_array_equal(direct.monitor("surface")[column], swept.monitor("surface")[column])

    def test_recordings_are_dropped_in_the_end(self):
        self.assertEqual([], list((self.work.out / "runs").glob("*/exchange.h5")))

    def test_every_run_is_told(self):
        for number in range(1, 7):
            self.assertIn(f"{number:04}", self.said)
        self.assertIn("6/6", self.said)


class Resumed(unittest.TestCase):
    def test_acceptance_another_value_makes_its_runs_alone(self):
        with SweepWorkspace(TREMOLO) as work:
            work.study.write_text(STUDY.replace(", 80e6", ""))
            work.swept()
            before, old = work.made(), work.rows()
            work.study.write_text(STUDY)
            self.assertIn("6 runs, 4 of them done", work.swept())
            after = work.made()
            self.assertEqual(before, {name: after[name] for name in before})
            self.assertEqual(6, len(after))
            kept = {row["run"]: row for row in work.rows()}
            self.assertEqual(old, [kept[row["run"]] for row in old])
            # Two more runs of two angles: each computes its own free field, for there is nobody to share it with.
            self.assertEqual("", kept["0005"]["replayed"] + kept["0006"]["replayed"])

    def test_a_failed_run_is_a_row_and_is_tried_again(self):
        study = 'case = "case.toml"\n[axes]\ncoupling.connect_deadline_s = [30, 0.0001]\nmotion.angle_deg = [0, 15]\n'
        with SweepWorkspace(TREMOLO, study) as work:
            done = work.sweep()
            self.assertEqual(1, done.returncode, done.stdout + done.stderr)
            rows = work.rows()
            self.assertEqual(["complete", "complete", "failed", "failed"], [row["status"] for row in rows])
            for row in rows[2:]:
                self.assertIn("within 0.0001 s", row["message"])
                self.assertEqual("", row["surface.peak_displacement_m"])
                self.assertIn(row["message"], done.stdout)
            self.assertIn("2 of 4 runs failed", done.stderr)
            before = work.made()
            log = work.out / "log" / "0003.txt"
            tried = log.stat().st_mtime_ns
            again = work.sweep()
            self.assertIn("4 runs, 2 of them done", again.stdout)
            self.assertGreater(log.stat().st_mtime_ns, tried)
            after = work.made()
            self.assertEqual([before["0001"], before["0002"]], [after["0001"], after["0002"]])

    def test_acceptance_who_waited_for_a_run_that_fails_computes_itself(self):
        # The first run of the angle, which records for the others, fails for its domain: no free field depends on its step.
        study = 'case = "case.toml"\n[axes]\ncoupling.connect_deadline_s = [0.0001, 30, 31]\n'
        with SweepWorkspace(TREMOLO, study) as work:
            self.assertEqual(1, work.sweep().returncode)
            self.assertEqual(["failed", "complete", "complete"], [row["status"] for row in work.rows()])

    def test_acceptance_another_record_under_the_same_name_is_another_run(self):
        study = 'case = "case.toml"\n[axes]\nmotion.file = ["a.AT2", "b.AT2"]\n'
        with SweepWorkspace(TREMOLO, study) as work:
            work.case.write_text(work.case.read_text().replace(*WITH_RECORD).replace("none.AT2", "a.AT2"))
            for name in ("a.AT2", "b.AT2"):
                shutil.copy(SOURCE / "cases/slope_oblique/motion.AT2", work.path / name)
            work.swept()
            before = work.made()
            text = (work.path / "b.AT2").read_text()
            (work.path / "b.AT2").write_text(text.replace("E-04", "E-03"))
            work.swept()
            after = work.made()
            self.assertEqual(before["0001"], after["0001"])
            self.assertNotEqual(before["0002"], after["0002"])


class Motions(unittest.TestCase):
    def test_seeds_become_motions_whose_measures_stand_in_the_table(self):
        study = f'case = "case.toml"\n[motions]\nrecipe = "{RECIPE}"\ncount = 2\n[axes]\nmotion.scale = [1, 2]\n'
        with SweepWorkspace(TREMOLO, study, duration=2.0) as work:
            work.case.write_text(work.case.read_text().replace(*WITH_RECORD).replace("none.AT2", str(RECIPE.parent / "motion.AT2")))
            work.swept()
            rows = work.rows()
            self.assertEqual(4, len(rows))
            seeds = list(dict.fromkeys(row["motion.file"] for row in rows))
            self.assertEqual("seed_249", seeds[0])
            self.assertEqual(2, len(seeds))
            self.assertEqual(sorted(f"{seed}.AT2" for seed in seeds), sorted(path.name for path in (work.out / "motions").iterdir()))
            # The first seed of the recipe is that of the case's own motion, and scale is a factor.
            self.assertEqual((work.out / "motions/seed_249.AT2").read_text().split("\n", 4)[4],
                             (RECIPE.parent / "motion.AT2").read_text().split("\n", 4)[4])
            pga = [float(row["pga_m_s2"]) for row in rows]
            self.assertAlmostEqual(2.0, pga[1] / pga[0], places=6)


class Samples(unittest.TestCase):
    STUDY = """case = "case.toml"
[axes]
motion.angle_deg = [0, 15]
soil.box.young = { low = 20e6, high = 80e6 }
motion.pulse.velocity = { low = 0.01, high = 1.0, scale = "log" }
[design]
kind = "latin_hypercube"
samples = 4
"""

    def test_a_latin_hypercube_covers_ranges_and_arrays_evenly(self):
        with SweepWorkspace(TREMOLO, self.STUDY) as work:
            work.swept()
            rows = work.rows()
            young = sorted(float(row["soil.box.young"]) for row in rows)
            self.assertEqual([0, 1, 2, 3], [int((value - 20e6) / 15e6) for value in young])
            speed = sorted(float(row["motion.pulse.velocity"]) for row in rows)
            self.assertEqual([0, 1, 2, 3], [int(2.0 * np.log10(value / 0.01)) for value in speed])
            self.assertEqual(["0", "0", "15", "15"], sorted(row["motion.angle_deg"] for row in rows))

    def test_acceptance_the_same_seed_has_the_same_runs(self):
        with SweepWorkspace(TREMOLO, self.STUDY) as work:
            work.swept()
            before = work.made()
            self.assertIn("4 of them done", work.swept())
            self.assertEqual(before, work.made())


class Refused(unittest.TestCase):
    def refusal(self, study, line):
        """Fails unless the study is refused with this line, and before anything is written."""
        with SweepWorkspace(TREMOLO, study) as work:
            done = work.sweep()
            self.assertFalse(work.out.exists())
            self.assertEqual(2, done.returncode, done.stderr)
            self.assertIn(f"{work.study}:{line}", done.stderr)

    def axes(self, text, line):
        self.refusal(f'case = "case.toml"\n[axes]\n{text}\n', line)

    def test_keys_that_no_case_has(self):
        self.axes("motion.angel_deg = [0]", "3:8: [axes] 'motion.angel_deg': unknown key 'angel_deg', did you mean 'angle_deg'?")
        self.axes("sol.box.young = [1e6]", "3:9: [axes] 'sol.box.young': unknown key 'sol', did you mean 'soil'?")
        self.axes("soil.bix.young = [1e6]", "3:10: [axes] 'soil.bix.young': the case has no [soil.bix], did you mean 'box'?")
        self.axes('"region[2].soil" = ["box"]', "3:1: [axes] 'region[2].soil': the case has no region[2]: it has 1 of [[region]]")

    def test_values_that_no_case_takes(self):
        self.axes("motion.angle_deg = [0, 95]", "3:24: [axes] 'motion.angle_deg' = 95: 'angle_deg' = 95 is out of range")
        self.axes('boundary.left.model = ["wav"]', "3:24: [axes] 'boundary.left.model' = \"wav\": 'model' = \"wav\" is not known, did you")
        self.axes("mesh.size = [2.0, 0.7]", "3:19: [axes] no case with mesh.size = 0.7: ")

    def test_axes_that_are_none(self):
        self.axes("mesh.size = []", "3:6: [axes] 'mesh.size' has no value")
        self.axes("mesh.size = 2.0", "3:6: [axes] 'mesh.size' must be an array of its values, found a number: write mesh.size = [2.0]")
        self.axes("mesh.size = [1, 2, 1]", "3:20: [axes] 'mesh.size' has the value 1 twice")
        self.axes("mesh.size = { low = 1, high = 2 }", "3:6: [axes] 'mesh.size' has a range, which only [design] kind = \"latin_hypercube\"")
        self.refusal('case = "case.toml"\n', "1:1: missing table [axes]")
        self.refusal('case = "case.toml"\n[axes]\n', "2:1: [axes] is empty")

    def test_a_list_whose_arrays_do_not_go_together(self):
        self.refusal('case = "case.toml"\n[axes]\nmesh.size = [1, 2]\nmotion.angle_deg = [0, 5, 15]\n[design]\nkind = "list"\n',
                     "4:8: [axes] 'motion.angle_deg' has 3 values, 'mesh.size' has 2")

    def test_keys_of_the_study_itself(self):
        good = 'case = "case.toml"\n[axes]\nmesh.size = [1, 2]\n'
        self.refusal("cas = 1\n" + good, "1:1: unknown key 'cas', did you mean 'case'?")
        self.refusal(good + '[measures]\ncolour = "mesh.siz"\n', "5:10: [measures] no axis 'mesh.siz', did you mean 'mesh.size'?")
        self.refusal(good + '[design]\nkind = "lst"\n', "5:8: [design] 'kind' = \"lst\" is not known, did you mean 'list'?")
        self.refusal(good + '[measures.spectral_ratio]\nof = "surfce"\nover = "surface"\nperiods = [0.5]\n',
                     "5:6: [measures.spectral_ratio] the case has no monitor 'surfce', did you mean 'surface'?")
        self.refusal(good.replace("case.toml", "cse.toml"), "1:8: ")

    def test_motions_twice(self):
        self.refusal(f'case = "case.toml"\n[motions]\nrecipe = "{RECIPE}"\ncount = 2\n[axes]\nmotion.file = ["a.AT2"]\n',
                     "6:8: [axes] [motions] gives the values of 'motion.file'")


if __name__ == "__main__":
    unittest.main()
