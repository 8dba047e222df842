"""`tremolo cost`: small ladders, what they measure, and what is refused.

    usage: test_cost.py TREMOLO PYTHON_PACKAGE_DIR
"""

import csv
import json
import shutil
import sys
import unittest
from pathlib import Path

TREMOLO, PACKAGE = sys.argv.pop(1), sys.argv.pop(1)
sys.path[:0] = [PACKAGE, str(Path(__file__).parents[1] / "runs")]

import small_case
from tremolo import Run


def study(work, *arguments, out="ladder"):
    """What `tremolo cost` says, and what it has written."""
    result = work.command("cost", work.case, "--out", work.path / out, *arguments)
    assert result.returncode == 0, result.stdout + result.stderr
    return result.stdout, json.loads((work.path / out / "cost.json").read_text())


def written_times(folder):
    return {path: path.stat().st_mtime_ns for path in folder.glob("*/run.h5")}


class Cost(unittest.TestCase):
    def test_a_box_converges_at_second_order_and_the_target_is_answered(self):
        ladder = ["--knob", "mesh.size=2,1,0.5", "--knob", "time.transfer=flip,apic", "--target", "2%"]
        with small_case.Workspace(TREMOLO) as work:
            said, found = study(work, *ladder)
            rungs = found["rungs"]
            self.assertEqual(6, len(rungs))
            self.assertIn("against the exact field", found["error_of"])
            for fit in found["fits"]:
                self.assertEqual(3, fit["points"])
                self.assertTrue(1.7 < fit["order"] < 2.3, fit)
                # Cells and steps: 1/h2 and 1/h, but for the last step of a run.
                self.assertTrue(2.9 < fit["work_order"] < 3.1, fit)
            self.assert_front(rungs)
            self.assert_answer(said, found)
            self.assert_table(work.path / "ladder" / "cost.csv", rungs)
            self.assertGreater((work.path / "ladder" / "cost.png").stat().st_size, 10000)
            self.assert_costs(work.path / "ladder", rungs)
            self.assert_resumed(work, ladder, found)

    def assert_front(self, rungs):
        """No rung beats one of the front, and one of the front beats every other."""
        def beats(a, b):
            return a["cpu_s"] <= b["cpu_s"] and a["error"] <= b["error"] and a != b

        for rung in rungs:
            self.assertEqual(rung["front"], not any(beats(other, rung) for other in rungs), rung)

    def assert_answer(self, said, found):
        good = [rung for rung in found["rungs"] if rung["error"] <= 0.02]
        best = min(good, key=lambda rung: rung["cpu_s"])
        self.assertIn(f"measured: 2 % with {best['family']}, mesh.size = {best['size']:g}", said)
        predicted = found["prediction"]
        self.assertLessEqual(predicted["error"], 0.02 * (1 + 1e-9))
        self.assertRegex(said, r"predicted: 2 % with .* not run, by the fit")
        # A size that divides the box of 20 m.
        self.assertAlmostEqual(20.0 / predicted["size"], round(20.0 / predicted["size"]), places=6)

    def assert_table(self, path, rungs):
        with open(path, newline="") as table:
            rows = list(csv.DictReader(table))
        self.assertEqual([rung["error"] for rung in rungs], [float(row["relative_error"]) for row in rows])
        self.assertEqual([rung["knobs"]["time.transfer"] for rung in rungs], [row["time.transfer"] for row in rows])

    def assert_costs(self, folder, rungs):
        for rung in rungs:
            with Run(folder / rung["folder"]) as run:
                self.assertAlmostEqual(sum(run.table("processes")["cpu_time"]), rung["cpu_s"])

    def assert_resumed(self, work, ladder, found):
        """A finished rung stands; one that is missing is run."""
        folder = work.path / "ladder"
        (folder / found["rungs"][0]["folder"] / "rung.json").unlink()
        before = written_times(folder)
        _, again = study(work, *ladder)
        after = written_times(folder)
        changed = [path.parent.name for path in before if after[path] != before[path]]
        self.assertEqual([found["rungs"][0]["folder"]], changed)
        self.assertEqual([rung["error"] for rung in found["rungs"]], [rung["error"] for rung in again["rungs"]])
        work.case.write_text(work.case.read_text().replace("velocity = 0.1", "velocity = 0.2"))
        result = work.command("cost", work.case, "--out", folder, *ladder)
        self.assertNotEqual(0, result.returncode)
        self.assertIn("holds a run of another text of the case", result.stderr)

    def test_a_slope_is_held_against_its_finest_run(self):
        with small_case.SlopeWorkspace(TREMOLO, velocity=0.05, duration=1.0) as work:
            said, found = study(work, "--knob", "mesh.size=2,1")
            self.assertTrue(found["rungs"][1]["reference"])
            self.assertNotIn("error", found["rungs"][1])
            self.assertIn("which has an error of its own", found["error_of"])
            self.assertTrue(0.001 < found["rungs"][0]["error"] < 0.5, found["rungs"][0])
            self.assertIn("reference", said)
            # Against a copy of itself there is no difference: monitors are read as they were written.
            shutil.copytree(work.path / "ladder" / found["rungs"][1]["folder"], work.path / "finest")
            _, same = study(work, "--knob", "mesh.size=2,1", "--reference", work.path / "finest")
            self.assertEqual(0.0, same["rungs"][1]["error"])
            self.assertEqual(found["rungs"][0]["error"], same["rungs"][0]["error"])

    def refusal(self, *arguments):
        with small_case.Workspace(TREMOLO) as work:
            result = work.command("cost", work.case, "--out", work.path / "ladder", *arguments)
            self.assertFalse((work.path / "ladder").exists())
        self.assertNotEqual(0, result.returncode)
        self.assertNotIn("Traceback", result.stdout + result.stderr)
        return result.stderr

    def test_a_key_that_no_case_has_is_refused_with_the_nearest_one(self):
        self.assertIn("did you mean 'fraction'?", self.refusal("--knob", "time.fractoin=0.5,0.8"))

    def test_a_target_that_is_none_is_refused(self):
        self.assertIn("--target 200%: write a relative error between 0 and 1", self.refusal("--target", "200%"))

    def test_a_knob_without_values_is_refused(self):
        self.assertIn("write it as KEY=VALUE,VALUE", self.refusal("--knob", "mesh.size"))


if __name__ == "__main__":
    unittest.main()
