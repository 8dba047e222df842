"""A step of the ground's surface under vertical and oblique waves, run as a user runs it, against its exact motion
(half_space_uneven.py), which knows neither cells nor box, and against what Ashford et al. (1997, Bull. Seism. Soc. Am. 87(3), pp.
701-709) found: the crest moves most where the wave is five times as long as the step is high, H/lambda = 0.2.

    usage: test_step.py TREMOLO PYTHON_PACKAGE_DIR
"""

import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

TREMOLO, PACKAGE = sys.argv.pop(1), sys.argv.pop(1)
sys.path[:0] = [PACKAGE, str(Path(__file__).parent)]

import numpy as np
from elastic_ground import GROUND
from half_space_uneven import UnevenGround
from step_case import PLACES, TRENCH_ENDS, amplification, frequency, response, starts, trench, write
from tremolo import Run

SIZES = (2.0, 1.0)  # m, of cells
ANGLES = (0, 15)
SHARES = (0.1, 0.2, 0.3)  # H over the length of shear waves
CREST_SHARES = (0.05, 0.1, 0.15, 0.2, 0.25, 0.3, 0.4)
CREST = np.array([[-x, trench("right").level(-x) - 0.25] for x in (10.0, 7.5, 5.0, 2.5)])  # behind the steepest place
SCENES = ((0, "right"), (15, "right"), (15, "left"))  # angle, where the ground is lower: ahead of the wave or behind it


class Step(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = Path(cls.enterClassContext(tempfile.TemporaryDirectory(prefix="tremolo_test_")))
        cls.series = {(*scene, size): cls.series_of(folder, *scene, size) for size in SIZES for scene in SCENES}
        cls.places = {key: starts(series) for key, series in cls.series.items()}
        cls.exact = {}  # velocities [angles, points, 2] at the monitors of both sizes, then at the crest
        for falling, shares in (("right", CREST_SHARES), ("left", SHARES)):
            ground = UnevenGround(GROUND, trench(falling), 1.25, TRENCH_ENDS[falling])
            points = np.concatenate([*(cls.places[ANGLES[-1], falling, size] for size in SIZES), CREST])
            for share in shares:
                cls.exact[falling, share], left = ground.transfer(frequency(share), np.radians(ANGLES), points)
                assert left < 5e-3, left

    @staticmethod
    def series_of(folder, angle, falling, size):
        name = f"{angle}_{falling}_{size:g}"
        case = write(folder / f"{name}.toml", angle, falling, size)
        done = subprocess.run([TREMOLO, "run", case, "--out", folder / name], capture_output=True, text=True, timeout=300)
        assert done.returncode == 0, done.stdout + done.stderr
        run = Run(folder / name)
        return [run.monitor(f"place {i}") for i in range(len(PLACES))]

    def both(self, angle, falling, size, share):
        """Velocities [monitors, 2] for an incident wave of unit velocity: those of the run and the exact ones."""
        first = SIZES.index(size) * len(PLACES)
        exact = self.exact[falling, share][ANGLES.index(angle), first : first + len(PLACES)]
        return response(self.series[angle, falling, size], share), exact

    def test_moves_as_without_cells(self):
        for angle, falling in SCENES:
            for share in SHARES:
                errors = []
                for size in SIZES:
                    ours, exact = self.both(angle, falling, size, share)
                    errors.append(np.linalg.norm(ours - exact) / np.linalg.norm(exact))
                print(f"{angle} degrees, lower at the {falling}, H/lambda = {share}: {100 * errors[0]:.2f} and {100 * errors[1]:.2f} %")
                with self.subTest((angle, falling, share)):
                    self.assertLess(errors[1], 0.03)
                    self.assertLess(errors[1], max(0.01, 0.45 * errors[0]))

    def test_crest_is_amplified_most_at_a_fifth(self):
        for angle, least, most in ((0, 1.10, 1.16), (15, 1.33, 1.41)):
            at_crest = {share: self.exact["right", share][ANGLES.index(angle), -len(CREST) :] for share in CREST_SHARES}
            largest = np.array([amplification(angle, share, CREST, v).max() for share, v in at_crest.items()])
            print(f"{angle} degrees:", *(f"{share}: {value:.3f}" for share, value in zip(CREST_SHARES, largest)))
            ours, exact = (amplification(angle, 0.2, self.places[angle, "right", 1.0], v) for v in self.both(angle, "right", 1.0, 0.2))
            print("found at H/lambda = 0.2:", ours.round(3), "exact:", exact.round(3))
            with self.subTest(angle):
                self.assertAlmostEqual(0.2, CREST_SHARES[largest.argmax()], delta=0.06)
                self.assertTrue(least < largest.max() < most, largest.max())
                self.assertLess(np.abs(ours - exact).max(), 0.02)


if __name__ == "__main__":
    unittest.main(verbosity=2)
