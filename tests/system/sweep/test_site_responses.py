"""`tremolo sweep` of site responses: random profiles of a linear layer, whose amplification is known, end to end.

    usage: test_site_responses.py TREMOLO SOURCE_DIR
"""

import subprocess
import sys
import unittest
from pathlib import Path

TREMOLO, SOURCE = sys.argv.pop(1), Path(sys.argv.pop(1))
sys.path[:0] = [str(SOURCE / "python")]

import numpy as np
from layer_study import COUNT, DAMPING, DEPTH, RHO, ROCK, SIGMA, VS, Workspace
from tremolo import Run
from tremolo.site import suite


def amplified(frequency, vs):
    """|surface over outcrop| of the layer on its half-space, closed form."""
    speed = vs * np.sqrt(1.0 + 2j * DAMPING)
    phase = 2.0 * np.pi * frequency * DEPTH / speed
    return np.abs(1.0 / (np.cos(phase) + 1j * RHO * speed / ROCK * np.sin(phase)))


class LinearLayer(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.work = Workspace(TREMOLO)
        cls.addClassCleanup(cls.work.__exit__)
        cls.done = cls.work.sweep()
        assert cls.done.returncode == 0, cls.done.stdout + cls.done.stderr
        cls.rows = cls.work.rows()
        cls.responses = [suite.Response.read(cls.work.out / "runs" / row["run"] / "wave.h5") for row in cls.rows]
        cls.speeds = np.array([response.layers["vs"][0] for response in cls.responses])

    def test_a_row_a_realisation_with_the_measures_of_the_surface(self):
        self.assertEqual([str(number) for number in range(1, COUNT + 1)], [row["random_profile.realisation"] for row in self.rows])
        self.assertEqual({("wave", "complete")}, {(row["model"], row["status"]) for row in self.rows})
        for row, response, vs in zip(self.rows, self.responses, self.speeds):
            self.assertAlmostEqual(float(row["surface.pga_m_s2"]), response.profile["peak_ax"][-1], delta=1e-3 * float(row["surface.pga_m_s2"]))
            self.assertAlmostEqual(4.0 * DEPTH / vs, float(row["site.period_s"]), places=9)
            self.assertAlmostEqual(30.0 / (DEPTH / vs + 10.0 / 400.0), float(row["site.vs30_m_s"]), places=6)

    def test_speeds_have_the_distribution_that_is_asked_for(self):
        z = np.log(self.speeds / VS) / SIGMA
        self.assertEqual(COUNT, len(set(z)))
        self.assertLessEqual(np.abs(z).max(), 2.0 + 1e-9)
        # Moments of the standard normal distribution cut at two deviations, by quadrature.
        places = np.linspace(-2.0, 2.0, 4001)
        density = np.exp(-0.5 * places**2)
        second, fourth = (np.sum(density * places**power) / np.sum(density) for power in (2, 4))
        self.assertLess(abs(z.mean()), 4.0 * np.sqrt(second / COUNT))
        self.assertLess(abs((z**2).mean() - second), 4.0 * np.sqrt((fourth - second**2) / COUNT))

    def test_median_amplification_is_that_of_the_closed_form(self):
        ratios = np.array([response.transfer["surface_to_outcrop"] for response in self.responses])
        frequency = self.responses[0].transfer["frequency"]
        self.assertTrue(all(np.array_equal(frequency, response.transfer["frequency"]) for response in self.responses))
        median, sigma = suite.Curves(frequency, ratios).statistics()
        band = (frequency > 0.8) & (frequency < 7.5)  # where the pulse has more than a fiftieth of its peak
        logarithm = np.log([amplified(frequency[band], vs) for vs in self.speeds])
        np.testing.assert_allclose(median[band], np.exp(logarithm.mean(axis=0)), rtol=2e-3)
        np.testing.assert_allclose(sigma[band], logarithm.std(axis=0, ddof=1), rtol=2e-2, atol=2e-3)

    def test_pictures_and_tables_are_there(self):
        for name in ("sweep", "spectra", "amplification", "profiles"):
            self.assertGreater((self.work.out / f"{name}.png").stat().st_size, 10_000)
            self.assertIn(f"{name}.png", self.done.stdout)
        heading = (self.work.out / "tables/profile_vs.csv").read_text().splitlines()[0]
        self.assertEqual("depth_m,vs_median_m_s,vs_sigma_ln_1", heading)
        row = np.genfromtxt(self.work.out / "tables/profile_vs.csv", delimiter=",", skip_header=1)[0]
        self.assertAlmostEqual(np.exp(np.log(self.speeds).mean()), row[1], places=4)
        self.assertFalse((self.work.out / "histories.png").exists())

    def test_a_run_is_that_of_tremolo_column(self):
        row = self.rows[2]
        alone = self.work.path / "alone.h5"
        done = subprocess.run([TREMOLO, "column", self.work.out / f"cases/{row['run']}.toml", "--model", "wave", "--out", alone],
                              capture_output=True, text=True)
        self.assertEqual(0, done.returncode, done.stderr)
        self.assertRegex(done.stdout, r"realisation 3 of seed 1: sigma_ln 0.2, .*\n.*\n +0 to 20 +[\d.]+ +" + f"{self.speeds[2]:.1f}")
        with Run(alone) as one, Run(self.work.out / f"runs/{row['run']}/wave.h5") as other:
            np.testing.assert_array_equal(one.monitor("surface")["ax"], other.monitor("surface")["ax"])

    def test_acceptance_the_same_command_makes_no_run_again(self):
        before = self.work.made()
        done = self.work.sweep()
        self.assertIn(f"{COUNT} runs, {COUNT} of them done", done.stdout)
        self.assertEqual(before, self.work.made())


if __name__ == "__main__":
    unittest.main()
