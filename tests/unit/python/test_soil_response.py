"""Numbers taken from histories, against closed forms."""

import unittest

import numpy as np
from tremolo.soil_test import response

import synthetic_soiltest


def triangle(*ends, points=100):
    """Straight runs from 0 over these values."""
    runs = [np.linspace(a, b, points, endpoint=False) for a, b in zip((0.0, *ends), ends)]
    return np.append(np.concatenate(runs), ends[-1])


class Cycles(unittest.TestCase):
    cycle = np.array([0.0, 0.25, 0.5, 0.75])
    measure = np.array([0.0, 0.01, 0.03, 0.02])

    def test_first_crossing_is_interpolated(self):
        self.assertAlmostEqual(response.cycles_to(self.cycle, self.measure, 0.02), 0.375)

    def test_level_of_a_row_is_met_there(self):
        self.assertEqual(response.cycles_to(self.cycle, self.measure, 0.01), 0.25)
        self.assertEqual(response.cycles_to(self.cycle, self.measure, 0.0), 0.0)

    def test_level_that_is_not_reached(self):
        self.assertTrue(np.isnan(response.cycles_to(self.cycle, self.measure, 0.05)))


class Loops(unittest.TestCase):
    def test_viscous_ellipse(self):
        """tau = G gamma + eta dgamma/dt at the circular frequency 1: D = eta/(2 G)."""
        modulus, viscosity, amplitude = 40e6, 6e6, 1e-3
        t = np.linspace(0.0, 2.0 * np.pi, 20001)
        strain = amplitude * np.cos(t)
        stress = modulus * strain - viscosity * amplitude * np.sin(t)
        got = response.secant_and_damping(strain, stress)
        np.testing.assert_allclose(got, (amplitude, modulus, viscosity / (2.0 * modulus)), rtol=1e-6)

    def test_elastic_perfectly_plastic_loop(self):
        """Yield at gamma_y: G/Gmax = gamma_y/A, D = (2/pi)(1 - gamma_y/A)."""
        modulus, yielding, amplitude = 50e6, 2e-4, 1e-3
        first_yield = amplitude - 2.0 * yielding
        strain = np.array([amplitude, first_yield, -amplitude, -first_yield, amplitude])
        strength = modulus * yielding
        stress = strength * np.array([1.0, -1.0, -1.0, 1.0, 1.0])
        expected = amplitude, modulus * yielding / amplitude, 2.0 / np.pi * (1.0 - yielding / amplitude)
        np.testing.assert_allclose(response.secant_and_damping(strain, stress), expected, rtol=1e-12)

    def test_last_loop_of_every_amplitude(self):
        """Stiffness falls from loop to loop; only the last one of an amplitude counts."""
        small, large = 1e-4, 1e-3
        strain = triangle(small, -small, small, -small, small, 0.0, large, -large, large)
        turn = 100 * np.arange(10)
        stress = 80e6 * strain
        stress[turn[3] :] = 60e6 * strain[turn[3] :]
        stress[turn[6] :] = 20e6 * strain[turn[6] :]
        rows = response.last_loops(strain)
        self.assertEqual([(one.start, one.stop - 1) for one in rows], [(turn[3], turn[5]), (turn[7], turn[9])])
        loops = [response.secant_and_damping(strain[one], stress[one]) for one in rows]
        np.testing.assert_allclose([loop[0] for loop in loops], [small, large])
        np.testing.assert_allclose([loop[1] for loop in loops], [60e6, 20e6])
        np.testing.assert_allclose([loop[2] for loop in loops], [0.0, 0.0], atol=1e-12)

    def test_monotonic_strain_has_no_loop(self):
        self.assertEqual(response.last_loops(triangle(0.1)), [])


class Invariants(unittest.TestCase):
    def test_plane_and_space_are_told_apart(self):
        self.assertTrue(response.is_in_plane(synthetic_soiltest.history()))
        self.assertTrue(response.is_in_plane(synthetic_soiltest.compression(drop=20e3)))
        columns = synthetic_soiltest.compression(drop=20e3)
        columns["p"] = response.mean_stress(columns, in_plane=False)
        columns["q"] = response.deviator_of_space(columns)
        self.assertFalse(response.is_in_plane(columns))

    def test_pure_shear(self):
        """tau alone: q = 2 tau in the plane, sqrt(3) tau in space."""
        stress = {"sig_xx": np.zeros(1), "sig_yy": np.zeros(1), "sig_zz": np.zeros(1), "sig_xy": np.array([5e3])}
        self.assertAlmostEqual(response.deviator_of_plane(stress)[0], 10e3)
        self.assertAlmostEqual(response.deviator_of_space(stress)[0], np.sqrt(3.0) * 5e3)

    def test_compression_is_positive(self):
        stress = {"sig_xx": np.array([-50e3]), "sig_yy": np.array([-100e3]), "sig_zz": np.array([-60e3])}
        self.assertAlmostEqual(response.mean_stress(stress, in_plane=True)[0], 75e3)
        self.assertAlmostEqual(response.mean_stress(stress, in_plane=False)[0], 70e3)
        columns = {"eps_xx": np.array([0.01]), "eps_yy": np.array([-0.03])}
        self.assertAlmostEqual(response.volumetric_strain(columns)[0], 0.02)

    def test_pore_pressure_ratio(self):
        history = synthetic_soiltest.history(relief=0.8)
        np.testing.assert_allclose(response.pore_pressure_ratio(history), history["ru"], atol=1e-12)


class Differences(unittest.TestCase):
    def setUp(self):
        self.ours = synthetic_soiltest.history()
        self.reference = {name: column[::10].copy() for name, column in self.ours.items()}

    def test_equal_histories(self):
        difference, rows = response.stress_differences(self.ours, self.reference)
        self.assertEqual(len(rows), 201)
        self.assertEqual(difference.max(), 0.0)

    def test_the_largest_component_counts_at_its_row(self):
        self.reference["sig_xy"][50] += 300.0
        self.reference["sig_yy"][50] -= 700.0
        self.reference["sig_xx"][120] += 500.0
        difference, _ = response.stress_differences(self.ours, self.reference)
        self.assertAlmostEqual(difference[50], 700.0)
        self.assertAlmostEqual(difference[120], 500.0)
        self.assertAlmostEqual(difference.sum(), 1200.0)

    def test_rows_without_partner_are_refused(self):
        self.reference["step"] = self.reference["step"] + 1e6
        with self.assertRaisesRegex(ValueError, "only 0 of 201 rows"):
            response.stress_differences(self.ours, self.reference)


if __name__ == "__main__":
    unittest.main()
