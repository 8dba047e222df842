"""A slope of soft clay slides out through the side of its model, until soil is too far outside: a warning says how far it has
moved through the dashpots, and so it does when the run goes on from a checkpoint.

    usage: test_lost_hold.py TREMOLO PYTHON_PACKAGE_DIR
"""

import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

TREMOLO = sys.argv.pop(1)
sys.argv.pop(1)

CASE = """
title = "A slope of clay whose toe stands close to the side"

[motion]
pulse = { shape = "ricker", frequency = 1.0, velocity = 0.5, time = 1.5 }
wave = "SV"
angle_deg = 0.0
reference = [0.0, -20.0]

[surface]
level = 0.0

[halfspace]
density = 1800.0
young = 40e6
poisson = 0.3

[soil.clay]
model = "mohr_coulomb"
density = 1800.0
young = 40e6
poisson = 0.3
cohesion_peak = 34e3
cohesion_residual = 8e3
friction_peak_deg = 0.0
friction_residual_deg = 0.0
softening = 30.0
reference_size = 2.0

[[region]]
soil = "clay"
polygon = [[0.0, -20.0], [60.0, -20.0], [60.0, 10.0], [16.0, 10.0], [6.0, 0.0], [0.0, 0.0]]

[mesh]
size = 2.0
box = [0.0, -20.0, 60.0, 10.0]

[boundary]
left = { model = "wave", surface = 0.0, spring = false }
right = { model = "wave", surface = 10.0, spring = false }
base = { model = "wave", form = "incident", spring = false }

[[stage]]
kind = "gravity"

[[stage]]
kind = "shaking"
duration_s = 12.0

[checkpoint]
every_steps = 500

[output]
every_s = 2.0
"""


def tremolo(*arguments):
    return subprocess.run([TREMOLO, *map(str, arguments)], capture_output=True, text=True, timeout=300.0)


def moved(done):
    """How far the soil has moved out of the model as the run tells it, m."""
    said = re.search(r"warning: soil has moved out of the model by ([\d.]+) m at the left side", done.stdout + done.stderr)
    return float(said.group(1)) if said else None


class LostHold(unittest.TestCase):
    def test_is_told_by_a_run_and_by_one_that_goes_on_from_a_checkpoint(self):
        with tempfile.TemporaryDirectory(prefix="tremolo_test_") as folder:
            case, out = Path(folder) / "case.toml", Path(folder) / "run"
            case.write_text(CASE)
            done = tremolo("run", case, "--out", out)
            self.assertIn("has left the model", done.stderr)
            self.assertGreater(moved(done), 2.0, done.stdout)
            again = tremolo("resume", out)
            self.assertIn("has left the model", again.stderr)
            self.assertEqual(moved(again), moved(done), again.stdout)


if __name__ == "__main__":
    unittest.main()
