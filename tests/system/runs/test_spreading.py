"""The shipped gentle slope of saturated sand, in cells of 2 m: shaking liquefies it and it spreads downhill, cycle after cycle.

    usage: test_spreading.py TREMOLO PYTHON_PACKAGE_DIR
"""

import sys
import tempfile
import unittest
from pathlib import Path

TREMOLO, PACKAGE = sys.argv.pop(1), sys.argv.pop(1)
sys.path.insert(0, PACKAGE)

import numpy as np
from tremolo.variants import run_variant

CASE = Path(__file__).resolve().parents[3] / "cases" / "level_ground"
PERIOD = 1.0  # s, of the motion


class Spreading(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory(prefix="tremolo_test_")
        place = Path(cls.folder.name)
        (place / "motion.csv").write_bytes((CASE / "motion.csv").read_bytes())
        changes = {"size = 1.0": "size = 2.0", "duration_s = 14.0": "duration_s = 5.9", "duration_s = 11.0": "duration_s = 0.1"}
        cls.run_ = run_variant(TREMOLO, CASE / "slope.toml", changes, place, "slope")

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def moved(self, name, time):
        """Horizontal displacement of a monitor against the base, mean over the cycle that ends at a time, m."""
        table, base = self.run_.monitor(name), self.run_.monitor("base")
        cycle = (table["time"] > time - PERIOD - 1e-9) & (table["time"] <= time + 1e-9)
        return (table["ux"] - base["ux"])[cycle].mean()

    def test_liquefies(self):
        self.assertGreater(self.run_.monitor("middle 4.5 m")["pore_pressure_ratio"].max(), 0.7)

    def test_spreads_downhill_and_farther_with_every_second(self):
        for name in ("upper slope", "middle", "lower slope"):
            moved = [self.moved(name, time) - self.moved(name, 2.0) for time in (4.0, 5.0, 6.0)]
            self.assertGreater(np.diff(moved).min(), 0.0, (name, moved))
            self.assertGreater(moved[-1], 0.05, (name, moved))

    def test_the_slope_moves_more_than_the_flat_ground_beside_it(self):
        flat = max(abs(self.moved(name, 6.0)) for name in ("upper flat", "lower flat"))
        self.assertGreater(self.moved("middle", 6.0), flat)


if __name__ == "__main__":
    unittest.main()
