"""The shipped level ground, in cells of 2 m: it stays level and even along x between its free fields after it has liquefied.

    usage: test_level_ground.py TREMOLO PYTHON_PACKAGE_DIR
"""

import sys
import tempfile
import unittest
from pathlib import Path

TREMOLO, PACKAGE = sys.argv.pop(1), sys.argv.pop(1)
CASE = Path(__file__).resolve().parents[3] / "cases" / "level_ground"
sys.path[:0] = [PACKAGE, str(CASE)]

import numpy as np
from study import Level
from tremolo.variants import run_variant


class LevelGround(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory(prefix="tremolo_test_")
        place = Path(cls.folder.name)
        (place / "motion.csv").write_bytes((CASE / "motion.csv").read_bytes())
        changes = {"size = 0.5": "size = 2.0", "duration_s = 14.0": "duration_s = 9.0", "duration_s = 11.0": "duration_s = 3.0"}
        cls.run_ = run_variant(TREMOLO, CASE / "case.toml", changes, place, "level")
        cls.level = Level(cls.run_)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def test_liquefies(self):
        self.assertGreater(self.run_.monitor("5.25 m")["pore_pressure_ratio"][-1], 0.9)

    def test_the_surface_stays_level(self):
        # With the sides' normals of the start it tilts by 2.5 mm and goes on.
        rise = self.level.field(len(self.run_.times) - 1, "displacement")[-1, :, 1]
        self.assertLess(np.ptp(rise), 0.5e-3)

    def test_moves_alike_at_every_level(self):
        largest = max(np.abs(self.run_.field(i, "velocity")).max() for i in range(len(self.run_.times)))
        apart = max(np.ptp(self.level.field(i, "velocity"), axis=1).max() for i in range(len(self.run_.times)))
        self.assertLess(apart, 0.01 * largest)


if __name__ == "__main__":
    unittest.main()
