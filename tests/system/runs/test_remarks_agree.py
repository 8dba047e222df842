"""check, explain and run print equal warnings and notes, each with its place and its magnitude, and the positions of monitors that
they print are those of the run.

    usage: test_remarks_agree.py TREMOLO PYTHON_PACKAGE_DIR
"""

import json
import math
import re
import sys
import unittest
from pathlib import Path

TREMOLO, PACKAGE = sys.argv.pop(1), sys.argv.pop(1)
sys.path[:0] = [PACKAGE, str(Path(__file__).parent)]

from small_case import SlopeWorkspace, Workspace
from tremolo import Run


def remarks(result):
    """The warnings and notes that a command printed, without the folder of the case."""
    return [re.sub(r"^\s*\S*case\.toml", "case.toml", line) for line in (result.stdout + result.stderr).splitlines()
            if re.search(r"case\.toml:\d+:\d+: (warning|note): ", line)]


class RemarksAgree(unittest.TestCase):
    def common_remarks(self, work):
        """The remarks on a case by check, explain and run, which must be equal lines in equal order."""
        commands = {"check": ["check", work.case], "explain": ["explain", work.case],
                    "run": ["run", work.case, "--out", work.path / "run"]}
        results = {name: work.command(*words) for name, words in commands.items()}
        for name, result in results.items():
            self.assertEqual(0, result.returncode, name + result.stdout + result.stderr)
        printed = {name: remarks(result) for name, result in results.items()}
        self.assertEqual(printed["check"], printed["explain"])
        self.assertEqual(printed["check"], printed["run"])
        return printed["check"]

    def magnitude(self, printed, words):
        """The first number behind the words of the one remark that has them."""
        [line] = [line for line in printed if words in line]
        return float(re.search(re.escape(words) + r"\s*([-+0-9.e]+)", line)[1])

    def test_of_a_pulse_at_the_wrong_time_in_a_box_of_wrong_density(self):
        with Workspace(TREMOLO, size=2.0, duration=0.2) as work:
            work.case.write_text(work.case.read_text().replace("time = 0.5", "time = 0.1").replace("density = 1700.0", "density = 1.7"))
            printed = self.common_remarks(work)
            self.assertEqual(2, sum("'density' = 1.7 kg/m3 is that of no soil or rock" in line for line in printed))
            # The Ricker pulse of 3 Hz reaches the base when half of it has passed: its peak is missing, or its second half is late.
            missing = self.magnitude(printed, "what came earlier, up to")
            self.assertTrue(1.0 < missing <= 100.0, printed)
            self.assertTrue(any(" of the incident wave's energy reaches the model after the run's end at 0.2 s" in line for line in printed),
                            printed)

    def test_of_a_slope(self):
        with SlopeWorkspace(TREMOLO, duration=0.05) as work:
            printed = self.common_remarks(work)
            self.assertTrue(any("free field" in line and "yield" in line for line in printed), printed)
            self.assertTrue(any("after the run's end" in line for line in printed), printed)

    def test_monitors_are_where_the_note_says(self):
        with Workspace(TREMOLO, duration=0.05) as work:
            printed = self.common_remarks(work)
            [line] = [line for line in printed if 'monitor "surface"' in line]
            found = re.search(r"starts at \[(\S+), (\S+)\], (\S+) m from its point", line)
            x, y, distance = map(float, found.groups())
            history = Run(work.path / "run").monitor("surface")
            self.assertAlmostEqual(x, history["x"][0] - history["ux"][0], 9)
            self.assertAlmostEqual(y, history["y"][0] - history["uy"][0], 9)
            self.assertAlmostEqual(distance, ((x - 10.0) ** 2 + y**2) ** 0.5, 3)

    def test_explain_prints_the_levels_and_times_that_the_page_gives_as_formulas(self):
        """docs/own-free-field.md: N = ceil((y_s - y0) n / h); from -p (x1 - x0) to T."""
        with Workspace(TREMOLO, size=4.0, base="incident", duration=0.7) as work:
            work.case.write_text(work.case.read_text().replace("size = 4.0", "size = 4.0\nparticles_per_cell = 3").replace(
                "box = [0.0, -10.0, 20.0, 0.0]", "box = [0.0, -12.0, 20.0, 0.0]").replace("-10.0", "-12.0"))
            result = work.command("explain", "--json", work.case)
            self.assertEqual(0, result.returncode, result.stderr)
            served = json.loads(result.stdout)["served"]
            slowness = math.sin(math.radians(15.0)) / math.sqrt(40e6 / (2.0 * 1.28 * 1700.0))
            levels = {"total": [-12.0 + 12.0 * j / 9 for j in range(10)], "incident": [-12.0]}
            found = {}
            for source in served:
                self.assertAlmostEqual(slowness, source["slowness_x_s_per_m"], 12)
                self.assertAlmostEqual(-20.0 * slowness, source["from_s"], 9)
                self.assertEqual(0.7, source["to_s"])
                found |= {field["field"]: field["levels_m"] for field in source["fields"]}
            self.assertEqual(set(levels), set(found))
            for field, wanted in levels.items():
                self.assertEqual(len(wanted), len(found[field]), found)
                for one, other in zip(wanted, found[field]):
                    self.assertAlmostEqual(one, other, 9)


if __name__ == "__main__":
    unittest.main()
