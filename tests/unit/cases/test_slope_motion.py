"""The motion of the slope case: its measures, computed here by other means than where it is made, are those of the
Northridge record at LA Baldwin Hills, component 90.

    usage: test_slope_motion.py SOURCE_DIR
"""

import sys
import unittest
from pathlib import Path

import numpy as np

CASE = Path(sys.argv.pop(1)) / "cases" / "slope_oblique"
GRAVITY = 9.80665  # m/s2


def read_at2(path):
    """Step in s and acceleration in m/s2 of a PEER AT2 file."""
    lines = path.read_text(encoding="ascii").splitlines()
    count = int(lines[3].split("NPTS=")[1].split(",")[0])
    step = float(lines[3].split("DT=")[1].split("SEC")[0])
    values = np.array(" ".join(lines[4:]).split(), dtype=float)
    assert len(values) == count
    return step, GRAVITY * values


class SlopeMotion(unittest.TestCase):
    def setUp(self):
        self.step, self.acceleration = read_at2(CASE / "motion.AT2")
        average = 0.5 * (self.acceleration[1:] + self.acceleration[:-1])
        self.velocity = np.append(0.0, self.step * np.cumsum(average))

    def near(self, value, target, relative=0.02):
        self.assertLess(abs(value / target - 1.0), relative, f"{value} against {target}")

    def test_strength(self):
        self.near(np.max(np.abs(self.acceleration)), 0.2389 * GRAVITY)
        self.near(np.max(np.abs(self.velocity)), 0.1487)
        self.near(np.pi / (2.0 * GRAVITY) * np.sum(self.acceleration**2) * self.step, 0.670)

    def test_duration_and_place_of_strong_shaking(self):
        energy = np.cumsum(self.acceleration**2)
        time = self.step * np.arange(len(energy))
        start, middle, end = np.interp([0.05, 0.5, 0.95], energy / energy[-1], time)
        self.near(end - start, 16.56)
        self.near(start, 5.54, 0.05)
        self.near(middle, 10.38, 0.05)

    def test_mean_period_by_a_sum_over_the_fourier_series(self):
        count = len(self.acceleration)
        frequencies = np.arange(1, count // 2) / (count * self.step)
        frequencies = frequencies[(frequencies >= 0.25) & (frequencies <= 20.0)]
        time = self.step * np.arange(count)
        squares = np.array([abs(np.exp(-2j * np.pi * f * time) @ self.acceleration) ** 2 for f in frequencies])
        self.near(np.sum(squares / frequencies) / np.sum(squares), 0.5176)

    def test_has_no_energy_that_the_mesh_cannot_carry(self):
        power = np.abs(np.fft.rfft(self.acceleration)) ** 2
        frequency = np.fft.rfftfreq(len(self.acceleration), self.step)
        self.assertLess(np.sum(power[frequency > 8.0]) / np.sum(power), 1e-4)

    def test_ends_at_rest_where_it_began(self):
        displacement = self.step * np.cumsum(0.5 * (self.velocity[1:] + self.velocity[:-1]))
        self.assertLess(abs(self.velocity[-1]), 1e-6)
        self.assertLess(abs(displacement[-1]), 1e-5)
        self.assertLess(np.max(np.abs(displacement)), 0.1)


if __name__ == "__main__":
    unittest.main()
