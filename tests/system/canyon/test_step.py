"""A step of the ground's surface under vertical and oblique waves, run as a user runs it, against its exact motion
(half_space_uneven.py), which knows neither cells nor box, and against what Ashford et al. (1997, Bull. Seism. Soc. Am. 87(3), pp.
701-709) found: the crest moves most where the wave is five times as long as the step is high, H/lambda = 0.2.

All is compared at complex frequencies s = eta + i omega: what the trench's other edge sends arrives more than a second late, and
exp(-eta t) takes it away.

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
from half_space_uneven import UnevenGround, flat_ground
from step_case import GROUND, HEIGHT, OTHER, PLACES, pulse, trench, write
from tremolo import Run

ETA = 3.0  # 1/s
SIZES = (2.0, 1.0)  # m, of cells
ANGLES = (0, 15)
SHARES = (0.1, 0.2, 0.3)  # H over the length of shear waves
CREST_SHARES = (0.05, 0.1, 0.15, 0.2, 0.25, 0.3, 0.4)
CREST = np.array([[-x, trench("right").level(-x) - 0.25] for x in (10.0, 7.5, 5.0, 2.5)])  # behind the steepest place
SCENES = ((0, "right"), (15, "right"), (15, "left"))  # angle, where the ground is lower: ahead of the wave or behind it


def frequency(share):
    return ETA + 2j * np.pi * share * GROUND.vs / HEIGHT


def transformed(time, values, share):
    return np.trapz(values * np.exp(-frequency(share) * time), time)


def amplification(angle, share, places, velocities):
    """Horizontal velocity over that of the level ground on the upper side, as deep below its surface as the monitors there."""
    level = np.stack([places[:, 0], np.full(len(places), -0.25)], axis=-1)
    return np.abs(velocities[:, 0] / flat_ground(GROUND, np.radians(angle), frequency(share), level)[0][:, 0])


class Step(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = Path(cls.enterClassContext(tempfile.TemporaryDirectory(prefix="tremolo_test_")))
        cls.series = {(*scene, size): cls.series_of(folder, *scene, size) for size in SIZES for scene in SCENES}
        cls.places = {key: np.array([[s["x"][0] - s["ux"][0], s["y"][0] - s["uy"][0]] for s in series])
                      for key, series in cls.series.items()}
        cls.exact = {}  # velocities [angles, points, 2] at the monitors of both sizes, then at the crest
        for falling, shares in (("right", CREST_SHARES), ("left", SHARES)):
            side = 1.0 if falling == "right" else -1.0
            ground = UnevenGround(GROUND, trench(falling), 1.25, tuple(sorted((-300.0 * side, (OTHER + 300.0) * side))))
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
        time = np.linspace(0.0, 2.9, 20001)
        incident = transformed(time, pulse(time), share)
        velocities = [[transformed(s["time"], s[column], share) for column in ("vx", "vy")] for s in self.series[angle, falling, size]]
        first = SIZES.index(size) * len(PLACES)
        return np.array(velocities) / incident, self.exact[falling, share][ANGLES.index(angle), first : first + len(PLACES)]

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
