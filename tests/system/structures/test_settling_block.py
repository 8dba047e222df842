"""A heavy block on clay that yields under it: sides and base of a small box hold its weight once the shaking is over. The references
are a box of 192 m by 60 m in which 12 m of clay lie over elastic ground, 166.3 mm before matched layers and 171.3 mm before springs.

    usage: test_settling_block.py TREMOLO SOURCE_DIR
"""

import sys
import unittest
from pathlib import Path

TREMOLO, SOURCE = sys.argv.pop(1), Path(sys.argv.pop(1))
sys.path[:0] = [str(SOURCE / "python"), str(Path(__file__).parent), str(Path(__file__).parents[1] / "runs")]

import numpy as np
from small_case import Workspace
from tremolo import Run

AMPLITUDE, FREQUENCY = 0.15 * 9.81, 1.0  # m/s2, Hz
RAMP, LENGTH = 2.0, 20.0  # s

CLAY = """
title = "block on clay"

[motion]
file = "sine.csv"
quantity = "acceleration"
unit = "m/s2"
kind = "outcrop"
wave = "SV"
angle_deg = 0.0
reference = [0.0, -12.0]

[surface]
level = 0.0

[halfspace]
density = 1800.0
young = 25e6
poisson = 0.45

[soil.clay]
model = "mohr_coulomb"
density = 1800.0
young = 25e6
poisson = 0.45
cohesion_peak = 32e3
cohesion_residual = 32e3
friction_peak_deg = 0.0
friction_residual_deg = 0.0
softening = 0.0

[[region]]
soil = "clay"
polygon = [[-24.0, -12.0], [24.0, -12.0], [24.0, 0.0], [-24.0, 0.0]]

[[structure]]
name = "block"
polygon = [[-3.0, 0.0], [3.0, 0.0], [3.0, 8.0], [-3.0, 8.0]]
density = 1250.0
rigid = true
friction = 0.6

[mesh]
size = 1.0
box = [-24.0, -12.0, 24.0, 0.0]

[boundary]
left = {{ model = "wave"{spring} }}
right = {{ model = "wave"{spring} }}
base = {{ model = "wave"{spring} }}

[time]
fraction = 0.8

[[stage]]
kind = "gravity"

[[stage]]
kind = "shaking"
duration_s = 40.0

[output]
every_s = 10.0
history_every_s = 0.1
"""


def write_motion(path):
    """A sine that grows over two seconds and fades over the last two."""
    time = np.arange(0.0, LENGTH + 0.015, 0.01)
    envelope = np.clip(np.minimum(time, LENGTH - time) / RAMP, 0.0, 1.0)
    rows = np.column_stack([time, AMPLITUDE * envelope * np.sin(2.0 * np.pi * FREQUENCY * time)])
    np.savetxt(path, rows, delimiter=",", header="time,acceleration", comments="")


class BlockOnClay(Workspace):
    template, defaults = CLAY, {"spring": ""}

    def __init__(self, tremolo, **changes):
        super().__init__(tremolo, **changes)
        write_motion(self.path / "sine.csv")


class Settling(unittest.TestCase):
    def settled(self, **changes):
        """Settlement (m) at the end and 10 s before, and what the run says."""
        with BlockOnClay(TREMOLO, **changes) as work, Run(work.run("run")) as run:
            block = run.body("block")
            before = np.searchsorted(block["time"], block["time"][-1] - 10.0)
            return block["y"][0] - block["y"][-1], block["y"][0] - block["y"][before], run

    def held_at(self, expected, tolerance, **changes):
        last, before, _ = self.settled(**changes)
        print(f"row: settlement {changes or 'as by default'} {1e3 * last:.1f} mm, {1e3 * (last - before):.2f} mm in the last 10 s")
        self.assertAlmostEqual(last, expected, delta=tolerance)
        self.assertLess(abs(last - before), 0.2e-3)


class Springs(Settling):
    def test_hold_the_block(self):
        self.held_at(0.204, 0.010)


class AcceptanceOtherSupports(Settling):
    def test_stiffer_springs_hold_it_higher(self):
        self.held_at(0.167, 0.008, spring=", spring = [2.0, 1.0]")

    def test_softer_springs_hold_it_lower(self):
        self.held_at(0.265, 0.013, spring=", spring = [0.5, 0.25]")

    def test_dashpots_alone_let_it_sink(self):
        last, before, _ = self.settled(spring=", spring = false")
        self.assertGreater(last, 0.4)
        self.assertGreater(last - before, 1e-3)


if __name__ == "__main__":
    unittest.main()
