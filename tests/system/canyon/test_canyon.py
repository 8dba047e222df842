"""A canyon in a small box, run as a user runs it, against its exact motion (half_space_uneven.py), which knows neither cells nor box:
what the canyon scatters leaves through matched layers and their corners.

    usage: test_canyon.py TREMOLO PYTHON_PACKAGE_DIR
"""

import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

TREMOLO, PACKAGE = sys.argv.pop(1), sys.argv.pop(1)
sys.path[:0] = [PACKAGE, str(Path(__file__).parent)]

import numpy as np
from canyon_case import DEPTH, SIGMA, pulse, write
from elastic_ground import GROUND
from half_space_uneven import Forces, Gaussian, UnevenGround, bessel_k
from tremolo import Run

ANGLES = (0, 15, 30)


class Method(unittest.TestCase):
    """That of the exact motion."""

    def test_bessel_functions(self):
        for z, k0, k1 in ((1.0, 0.42102443824070834, 0.6019072301972346), (0.1, 2.427069024702017, 9.853844780870606),
                          (20.0, 5.741237815336524e-10, 5.883057969557038e-10)):  # Abramowitz and Stegun, tables 9.8 and 9.11
            found = bessel_k(np.array([z + 0j]))
            self.assertAlmostEqual(1.0, found[0][0] / k0, 9)
            self.assertAlmostEqual(1.0, found[1][0] / k1, 9)
        # Where the expansions meet, each holds on its side.
        z = np.exp(1.5j) * np.array([11.999999, 12.000001])
        for k in bessel_k(z):
            self.assertLess(abs(k[1] / k[0] - 1.0), 1e-5)

    def test_forces_satisfy_the_equations_of_motion(self):
        s, h = 2.0 + 12.0j, 0.1
        place = np.array([7.0, -20.0])
        cross = place + h * np.array([[0, 0], [1, 0], [-1, 0], [0, 1], [0, -1]])
        field = Forces(GROUND, s, cross, np.zeros((1, 2)))
        u, gradient = field.displacement()[:, 0], field.gradient()[:, 0]
        for axis, (plus, minus) in enumerate(((1, 2), (3, 4))):
            difference = (u[plus] - u[minus]) / (2.0 * h)
            self.assertLess(np.abs(difference - gradient[0][:, :, axis]).max(), 1e-4 * np.abs(gradient[0]).max())
        stress = GROUND.stress(gradient)
        force = (stress[1, :, :, 0] - stress[2, :, :, 0] + stress[3, :, :, 1] - stress[4, :, :, 1]) / (2.0 * h)
        inertia = GROUND.density * s**2 * u[0]
        self.assertLess(np.abs(force - inertia).max(), 1e-4 * np.abs(inertia).max())

    def test_forces_twice_as_dense_change_nothing(self):
        s, angles = 1.8 + 2j * np.pi * 2.5, np.radians(ANGLES)
        places = np.array([[0.0, -20.0], [0.0, -16.25], [30.0, -1.0], [70.0, -0.25], [-60.0, -50.0]])
        coarse, left = UnevenGround(GROUND, Gaussian(DEPTH, SIGMA), 1.25).transfer(s, angles, places)
        fine, _ = UnevenGround(GROUND, Gaussian(DEPTH, SIGMA), 0.625).transfer(s, angles, places)
        self.assertLess(left, 5e-3)
        self.assertLess(np.abs(coarse - fine).max(), 1e-4 * np.abs(fine).max())


class AcceptanceSmallBox(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = Path(cls.enterClassContext(tempfile.TemporaryDirectory(prefix="tremolo_test_")))
        keys = [(angle, size, "matched_layer") for size in (1.0, 2.0) for angle in ANGLES]
        keys += [(15, 2.0, "dashpots"), (15, 2.0, "springs")]
        cls.runs = {key: cls.run_of(folder, *key) for key in keys}
        # Some hundred particles of each mesh stand for all; a frame has the particles in one order.
        cls.chosen, places = {}, []
        for size in (1.0, 2.0):
            place = cls.runs[0, size, "matched_layer"].frame(0)["position"]
            cls.chosen[size] = np.random.default_rng(1).choice(len(place), 200, replace=False)
            places.append(place[cls.chosen[size]])
        cls.times = {size: cls.runs[0, size, "matched_layer"].times for size in cls.chosen}
        exact = UnevenGround(GROUND, Gaussian(DEPTH, SIGMA), 1.25)
        times = np.concatenate(list(cls.times.values()))
        velocities, left = exact.velocities(pulse, np.radians(ANGLES), np.concatenate(places), times)
        assert left < 5e-3, left
        first, n = len(cls.times[1.0]), len(places[0])
        cls.exact = {(angle, size): velocities[i][slice(*rows), slice(*columns)] for i, angle in enumerate(ANGLES)
                     for size, rows, columns in ((1.0, (None, first), (None, n)), (2.0, (first, None), (n, None)))}

    @staticmethod
    def run_of(folder, angle, size, absorber):
        name = f"{angle}_{size}_{absorber}"
        case = write(folder / f"{name}.toml", angle, size, absorber)
        done = subprocess.run([TREMOLO, "run", case, "--out", folder / name], capture_output=True, text=True, timeout=200)
        assert done.returncode == 0, done.stdout + done.stderr
        return Run(folder / name)

    def errors(self, angle, size, absorber="matched_layer"):
        """Relative L2 error of all the velocities, and of those of the particle that has the largest."""
        run, exact = self.runs[angle, size, absorber], self.exact[angle, size]
        np.testing.assert_allclose(run.times, self.times[size])
        found = np.array([run.field(i, "velocity")[self.chosen[size]] for i in range(len(run.times))])
        wrong, norm = ((found - exact) ** 2).sum((0, 2)), (exact**2).sum((0, 2))
        whole, worst = np.sqrt(wrong.sum() / norm.sum()), np.sqrt((wrong / norm).max())
        print(f"{angle} degrees, cells of {size} m, {absorber}: {100 * whole:.2f} %, worst particle {100 * worst:.2f} %")
        return whole, worst

    def test_has_the_exact_motion(self):
        for angle in ANGLES:
            with self.subTest(angle):
                whole, worst = self.errors(angle, 1.0)
                self.assertLess(whole, 0.008)
                self.assertLess(worst, 0.02)

    def test_errs_by_its_cells_alone(self):
        for angle in ANGLES:
            with self.subTest(angle):
                self.assertGreater(np.log2(self.errors(angle, 2.0)[0] / self.errors(angle, 1.0)[0]), 1.6)

    def test_dashpots_return_what_is_scattered(self):
        self.assertGreater(self.errors(15, 2.0, "dashpots")[0], 0.05)

    def test_springs_beside_them_let_less_come_back(self):
        self.assertLess(self.errors(15, 2.0, "springs")[0], self.errors(15, 2.0, "dashpots")[0])


if __name__ == "__main__":
    unittest.main(verbosity=2)
