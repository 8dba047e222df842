"""Free fields that other programs computed: tables and OpenSees recorder files become recordings; wrong units and signs are found.

    usage: test_import.py TREMOLO SOURCE_DIR
"""

import contextlib
import functools
import shutil
import sys
import unittest
from pathlib import Path

TREMOLO, SOURCE = sys.argv.pop(1), Path(sys.argv.pop(1))
sys.path[:0] = [str(SOURCE / "python"), str(Path(__file__).parent)]

import numpy as np
from recorded_case import BoxWorkspace, model, record, write_csv, write_opensees
from tremolo import Run

RIGHT = {"--velocity-unit": "m/s", "--stress-unit": "Pa", "--stress-sign": "tension", "--depth-positive": "up",
         "--vertical-positive": "up"}


@functools.cache
def box():
    """A flat elastic box under a vertical SV pulse, by plane waves, and its run."""
    work = record(BoxWorkspace(TREMOLO, left=model("wave"), right=model("wave"), base=model("wave"), duration=1.3))
    unittest.addModuleCleanup(work.__exit__)
    return work, work.case.read_text(), work.run("live")


@contextlib.contextmanager
def flat():
    """The box as it is; what a test makes of it goes."""
    work, text, _ = box()
    work.case.write_text(text)
    try:
        yield work
    finally:
        for made in ("field.csv", "field.h5"):
            (work.path / made).unlink(missing_ok=True)
        shutil.rmtree(work.path / "from_import", ignore_errors=True)


def exported(work):
    """The free field of the direct run: times, levels, values [times, levels, 5]; and the run."""
    _, _, live = box()
    result = work.command("export", f"{live}:left", "field.csv")
    assert result.returncode == 0, result.stderr
    table = np.loadtxt(work.path / "field.csv", delimiter=",", skiprows=1)
    times, levels = np.unique(table[:, 0]), np.unique(table[:, 1])
    return times, levels, table.reshape(len(times), len(levels), 7)[:, :, 2:], Run(live)


def velocities(run):
    return np.concatenate([run.monitor(name)[component] for name in run.monitors for component in ("vx", "vy")])


class Import(unittest.TestCase):
    def imported(self, work, *files, status=0, **changes):
        """Runs `tremolo import` with the right answers but for changes, underscores for dashes; returns its output."""
        answers = {**RIGHT, **{"--" + key.replace("_", "-"): str(value) for key, value in changes.items()}}
        flags = [word for key, value in answers.items() for word in ([key] if value == "" else [key, value])]
        result = work.command("import", *files, "--out", "field.h5", *flags)
        self.assertEqual(status, result.returncode, result.stdout + result.stderr)
        return result.stdout + result.stderr

    def difference(self, work, direct):
        """Of the domain's velocities when the recording stands on all sides, relative L2."""
        work.case.write_text(work.case.read_text().replace('model = "wave"', model("recording", file="field.h5")))
        run = Run(work.run("from_import"))
        return np.linalg.norm(velocities(run) - velocities(direct)) / np.linalg.norm(velocities(direct))

    def test_the_table_of_an_export_gives_what_the_direct_run_gave(self):
        """What is left is of the rates, found by differences: 4.5e-10 is measured."""
        with flat() as work:
            direct = exported(work)[3]
            output = self.imported(work, "field.csv")
            self.assertRegex(output, r"the horizontal motion obeys rho a = div sigma with rho = 1[67]\d\d")
            self.assertLess(self.difference(work, direct), 1e-8)

    def test_other_units_signs_and_an_axis_that_points_down_give_the_same(self):
        with flat() as work:
            times, levels, values, direct = exported(work)
            turned = values[:, ::-1] * [100.0, -100.0, -1e-3, -1e-3, 1e-3]  # cm/s, kPa, compression, z down
            write_csv(work.path / "down.csv", times, -levels[::-1] + 3.0, turned)
            self.imported(work, "down.csv", velocity_unit="cm/s", stress_unit="kPa", stress_sign="compression",
                          depth_positive="down", vertical_positive="down", surface=3.0)
            self.assertLess(self.difference(work, direct), 5e-5)

    def test_a_file_a_level_without_what_is_zero_anyway(self):
        with flat() as work:
            times, levels, values, direct = exported(work)
            files = []
            for k, level in enumerate(levels):
                files.append(f"level{k}.csv")
                write_csv(work.path / files[-1], times, [level], values[:, k:k + 1, [0, 4]], ["vx", "sxy"])
            self.assertIn("not given, taken as zero: vy, sxx, syy", self.imported(work, *files))
            self.assertLess(self.difference(work, direct), 5e-5)

    def test_opensees_recorders_give_what_the_direct_run_gave(self):
        """Stresses between and beyond the centres of elements of 0.5 m are linear: 1.8e-3 is measured."""
        with flat() as work:
            times, levels, values, direct = exported(work)
            write_opensees(work.path, times, levels, values)
            options = {"opensees": "points.csv", "depth_positive": "down"}
            static = self.imported(work, "vel.out", "stress.out", status=1, **options)
            self.assertIn("--remove-initial-stress takes the first stress away", static)
            self.imported(work, "vel.out", "stress.out", remove_initial_stress="", **options)
            self.assertLess(self.difference(work, direct), 3e-3)

    def test_wrong_answers_are_found_and_the_right_one_is_named(self):
        with flat() as work:
            exported(work)
            self.assertRegex(self.imported(work, "field.csv", status=1, stress_unit="kPa"),
                             r"rho = 1\.[67]\d*e\+06 kg/m3, which is outside 1000 to 3000: a unit is wrong; possible: --stress-unit Pa")
            self.assertRegex(self.imported(work, "field.csv", status=1, velocity_unit="cm/s"), "possible:.*--velocity-unit m/s")
            self.assertRegex(self.imported(work, "field.csv", status=1, depth_unit="ft"), "possible:.*--depth-unit m")
            for wrong in ({"stress_sign": "compression"}, {"depth_positive": "down"}, {"vertical_positive": "down"}):
                self.assertRegex(self.imported(work, "field.csv", status=1, **wrong),
                                 r"rho = -1[67]\d\d(\.\d+)? kg/m3: a sign is wrong, --stress-sign, --depth-positive or --vertical-positive")
            self.assertRegex(self.imported(work, "field.csv", status=1, density=2200), "outside 1760 to 2640")
            self.assertFalse((work.path / "field.h5").exists())

    def test_velocity_and_stress_that_do_not_belong_together_are_refused(self):
        with flat() as work:
            times, levels, values, _ = exported(work)
            relative = values.copy()
            relative[:, :, :2] -= relative[:, :1, :2]
            write_csv(work.path / "relative.csv", times, levels, relative)
            self.assertRegex(self.imported(work, "relative.csv", status=1), "no density explains the horizontal motion.*relative velocities")

    def test_uneven_times_are_resampled_where_this_is_asked_for(self):
        """Cubics of third order, every fourth time missing: 1.2e-5 is measured."""
        with flat() as work:
            times, levels, values, _ = exported(work)
            work.case.write_text(work.case.read_text().replace("duration_s = 1.3", "duration_s = 1.25"))
            direct = Run(work.run("shorter"))
            kept = np.arange(len(times)) % 4 != 3
            write_csv(work.path / "uneven.csv", times[kept], levels, values[kept])
            self.assertRegex(self.imported(work, "uneven.csv", status=1), "not evenly spaced.*--resample DT")
            self.imported(work, "uneven.csv", resample=0.005)
            self.assertLess(self.difference(work, direct), 1e-4)

    def test_what_is_wrong_in_a_file_is_said_with_its_line(self):
        good = "time,depth,vx,sxy\n" + "".join(f"{t},{d},0,0\n" for t in range(6) for d in range(3))
        cases = [
            (good.replace("2,1,0,0", "2,1,nan,0"), r"field\.csv:9: 'nan' is not a finite number"),
            (good.replace("2,1,0,0", "2,1,0"), r"field\.csv:9: 3 values, the header has 4"),
            (good.replace("4,1,0,0", "2.5,1,0,0"), r"field\.csv:15: time 2\.5 s at depth 1 comes after 3 s"),
            (good.replace("2,1,0,0\n", ""), r"time 2 s has 2 depths, the first time 0 s has 3"),
            (good.replace("vx,sxy", "vx,tau"), r"field\.csv:1: the header must name time, depth"),
            (good, r"all velocities are zero"),
            ("", r"field\.csv: is empty"),
        ]
        with flat() as work:
            for text, message in cases:
                (work.path / "field.csv").write_text(text)
                self.assertRegex(self.imported(work, "field.csv", status=1), message)

    def test_units_and_signs_have_to_be_said(self):
        with flat() as work:
            (work.path / "field.csv").write_text("")
            for key in RIGHT:
                flags = [word for other in RIGHT if other != key for word in (other, RIGHT[other])]
                result = work.command("import", "field.csv", "--out", "field.h5", *flags)
                self.assertEqual(2, result.returncode)
                self.assertIn(f"{key} is required", result.stderr)


if __name__ == "__main__":
    unittest.main()
