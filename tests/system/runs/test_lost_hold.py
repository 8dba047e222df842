"""A slope of soft clay slides out through the side of its model, until soil is too far outside: a warning says how far it has
moved through the dashpots, and so it does when the run goes on from a checkpoint. Springs hold the sides of a slope that fails.

    usage: test_lost_hold.py TREMOLO PYTHON_PACKAGE_DIR
"""

import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

TREMOLO, PACKAGE = sys.argv.pop(1), sys.argv.pop(1)
SLOPE = Path(__file__).resolve().parents[3] / "cases" / "slope_oblique"
sys.path[:0] = [PACKAGE, str(SLOPE)]

import numpy as np
from study import BASE, MESHES
from tremolo.variants import run_variant

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


class AcceptanceFailedSlope(unittest.TestCase):
    """The slope of the front page under the vertical wave, 25 s after it has failed."""

    CHANGES = {"angle_deg = 15.0": "angle_deg = 0.0", "duration_s = 16.0": "duration_s = 40.0", BASE: BASE.replace("incident", "blended"),
               **MESHES["coarse"][1]}

    def test_its_sides_and_base_are_where_their_free_fields_are(self):
        """Measured: 34 mm at the right side, 19 mm in the lower left corner; dashpots alone let 2.3 and 0.9 m go at 15 degrees."""
        with tempfile.TemporaryDirectory(prefix="tremolo_test_") as folder:
            (Path(folder) / "motion.AT2").write_bytes((SLOPE / "motion.AT2").read_bytes())
            with run_variant(TREMOLO, SLOPE / "case.toml", self.CHANGES, Path(folder), "held") as run:
                faces = run.table("drift")
        moved = np.hypot(faces["dx"], faces["dy"])
        self.assertLess(moved.max(), 0.05)
        corner = np.argmin(np.hypot(faces["x"], faces["y"] + 20.0))
        self.assertLess(moved[corner], 0.025)


if __name__ == "__main__":
    unittest.main()
