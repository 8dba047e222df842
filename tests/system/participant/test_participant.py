"""Free fields of one's own: the examples of docs/own-free-field.md in C++ and Python, the client of docs/wire-protocol.md that uses
nothing but pyzmq and the standard library, and what a model's mistake looks like.

    usage: test_participant.py TREMOLO SOURCE_DIR MY_FIELD
"""

import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

TREMOLO, SOURCE, MY_FIELD = sys.argv.pop(1), Path(sys.argv.pop(1)), sys.argv.pop(1)
sys.path[:0] = [str(SOURCE / "python"), str(SOURCE / "tests/system/runs")]

import numpy as np
import small_case
from tremolo import Run
from tremolo.participant import Field

EXAMPLE = SOURCE / "docs/examples/own_free_field_python/travelling_pulse.py"
CASE = small_case.CASE.format(angle=0.0, size=1.0, element=0.5, side="wave", base="total", order="musl", duration=1.2, tolerance=0.05,
                              every=0.1)


def tremolo(*arguments):
    environment = {key: value for key, value in os.environ.items() if key != "PYTHONPATH"}
    return subprocess.run([TREMOLO, *map(str, arguments)], capture_output=True, text=True, env=environment, timeout=60)


class Folder(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.path = Path(temporary.name)

    def program(self, text, name="model.py"):
        file = self.path / name
        file.write_text(text)
        file.chmod(0o755)
        return file

    def run_with(self, model, name, text=CASE):
        """The case with a model on all boundaries; the process and the run's folder."""
        case = self.path / f"{name}.toml"
        case.write_text(text.replace('model = "wave"', model))
        return tremolo("run", case, "--out", self.path / name), self.path / name


class Example(Folder):
    def test_conforms(self):
        done = tremolo("conform", EXAMPLE)
        self.assertEqual(0, done.returncode, done.stdout + done.stderr)
        self.assertIn("14 passed, 0 warned, 0 failed", done.stdout)

    def test_both_give_the_run_that_the_exact_wavefield_gives(self):
        """Measured: 5e-6 of the largest velocity, from the interpolation of 5 ms steps and 0.5 m points."""
        # The example in C++ has its own pulse, which reaches the surface at 0.8 s.
        pulse = CASE.replace("time = 0.5", "time = 0.8").replace("reference = [0.0, -10.0]", "reference = [0.0, 0.0]")
        exact, exact_folder = self.run_with('model = "wave"', "exact", pulse)
        self.assertEqual(0, exact.returncode, exact.stdout + exact.stderr)
        shutil.copy(EXAMPLE, self.path / "model.py")
        for program in ("model.py", MY_FIELD):
            with self.subTest(program):
                name = Path(program).stem
                mine, mine_folder = self.run_with(f'model = "external", program = "{program}"', name, pulse)
                self.assertEqual(0, mine.returncode, mine.stdout + mine.stderr)
                self.assert_same_velocities(Run(exact_folder), Run(mine_folder))

    def assert_same_velocities(self, exact, mine):
        largest = difference = 0.0
        for index in range(len(exact.times)):
            expected = exact.field(index, "velocity")
            largest = max(largest, abs(expected).max())
            difference = max(difference, abs(mine.field(index, "velocity") - expected).max())
        self.assertGreater(largest, 0.1)
        self.assertLess(difference, 3e-5 * largest)

    def test_the_cpp_example_is_short_and_knows_the_public_header_alone(self):
        text = (SOURCE / "docs/examples/own_free_field/main.cpp").read_text()
        code = [line for line in text.splitlines() if line.strip() and not line.strip().startswith("//")]
        self.assertLess(len(code), 50)
        self.assertEqual(["coupler/participant.hpp"], re.findall(r'#include "(coupler/.*)"', text))


class ManyPoints(Folder):
    def test_a_frame_is_as_large_as_the_hub_says(self):
        """A frame of 64 steps has more than 1 MiB from 205 points on, more than 4 MiB from 820 on. The hub grants credit in
        frames: a source that waits for more than a frame waits for ever."""
        for points in (625, 700, 5000):
            with self.subTest(points):
                text = EXAMPLE.read_text()
                levels = 'np.arange(case["mesh"]["box"][1] - 1.0, surface + 0.1, 0.5)'
                self.assertIn(levels, text)
                self.program(text.replace(levels, f'np.linspace(case["mesh"]["box"][1] - 1.0, surface, {points})'))
                done, _ = self.run_with('model = "external", program = "model.py"', f"run{points}",
                                        CASE + "\n[coupling]\nstep_deadline_s = 10\n")
                self.assertEqual(0, done.returncode, done.stdout + done.stderr)


class Page(Folder):
    def test_client_of_the_wire_protocol_page_conforms(self):
        page = (SOURCE / "docs/wire-protocol.md").read_text()
        client = re.search(r"```python\n(.*?)```", page, re.DOTALL).group(1)
        self.assertNotIn("tremolo", client)
        done = tremolo("conform", self.program("#!/usr/bin/python3\n" + client))
        self.assertEqual(0, done.returncode, done.stdout + done.stderr)
        self.assertIn(" 0 failed", done.stdout)


class Mistakes(Folder):
    def end_of_run(self, old, new):
        text = EXAMPLE.read_text()
        self.assertIn(old, text)
        self.program(text.replace(old, new))
        done, _ = self.run_with('model = "external", program = "model.py"', "wrong")
        self.assertNotEqual(0, done.returncode)
        return done.stdout + done.stderr

    def test_a_value_that_is_not_finite_names_step_and_point(self):
        said = self.end_of_run("reflection * ricker", "np.nan * ricker")
        self.assertIn("the model's value at step 0, point 0 is not finite", said)

    def test_an_array_of_the_wrong_shape_is_described(self):
        said = self.end_of_run("np.stack([up + down, o, o, o,", "np.stack([up + down, o, o,")
        self.assertRegex(said, r"returned an array of shape \(\d+, 23, 4\).*wanted is \(\d+, 23, 5\), or 10 with the rates")

    def test_rates_need_no_formula(self):
        field = Field("total", lambda y, t: np.sin(5.0 * t)[:, None, None] * np.ones((1, len(y), 5)), [-1.0, 0.0], 0.0,
                      0.01, 10)
        expected = 5.0 * np.cos(5.0 * field.times(3, 4))
        self.assertLess(abs(field.values(3, 4)[:, 0, 5] - expected).max(), 1e-7)

    def test_fields_that_cannot_be_served_are_refused(self):
        for wrong in ({"y": [0.0, -1.0]}, {"y": [0.0]}, {"y": [0.0, np.nan]}, {"time_step": 0.0}, {"step_count": 1}, {"step_count": 2000.5}):
            keys = {"y": [-1.0, 0.0], "start_time": 0.0, "time_step": 0.01, "step_count": 9} | wrong
            with self.assertRaises(ValueError, msg=wrong):
                Field("total", None, **keys)


if __name__ == "__main__":
    unittest.main(verbosity=2)
