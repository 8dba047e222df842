"""Response spectra against closed forms and against published values for a real record."""

import csv
import os
import unittest
from pathlib import Path

import numpy as np

from tremolo.histories import even_steps
from tremolo.response_spectrum import oscillators, response_spectrum

G = 9.81  # m/s2, of the reference values
SOURCE = Path(os.environ.get("TREMOLO_SOURCE_DIR", Path(__file__).resolve().parents[3]))
REFERENCE = Path(os.environ.get("TREMOLO_REFERENCE", SOURCE / "../shared/reference"))


def read_at2(path):
    """A PEER AT2 record: accelerations (m/s2) and step (s)."""
    lines = path.read_text().splitlines()
    dt = float(lines[3].upper().split("DT=")[1].split()[0].rstrip(","))
    return G * np.array([float(word) for line in lines[4:] for word in line.split()]), dt


class EvenSteps(unittest.TestCase):
    def test_keep_the_step_of_the_shaking_where_a_rest_has_longer_ones(self):
        time = np.concatenate([np.arange(0.0, 17.0, 0.01), np.arange(17.0, 600.0, 0.1)])
        even, dt = even_steps(time, np.sin(time))
        self.assertAlmostEqual(0.01, dt, places=9)
        np.testing.assert_allclose(even[:1700], np.sin(0.01 * np.arange(1700)), atol=1e-9)


class ClosedForms(unittest.TestCase):
    def test_step(self):
        """a = A: u = -A/w^2 [1 - e^(-zwt) (cos wd t + z/sqrt(1-z^2) sin wd t)], exact at every sample."""
        period, damping, amplitude = 0.7, 0.05, 2.0
        t = np.arange(0.0, 5.0, 0.01)
        u, _ = oscillators(np.full(t.size, amplitude), 0.01, [period], damping)
        omega = 2.0 * np.pi / period
        root = np.sqrt(1.0 - damping**2)
        free = np.exp(-damping * omega * t) * (np.cos(omega * root * t) + damping / root * np.sin(omega * root * t))
        np.testing.assert_allclose(u[:, 0], -amplitude / omega**2 * (1.0 - free), atol=1e-12)

    def test_ramp(self):
        """a = r t: the particular solution u = -r t/w^2 + 2 z r/w^3 and its free part, with velocity by hand."""
        period, damping, rate = 1.3, 0.2, 3.0
        t = np.arange(0.0, 4.0, 0.05)
        u, v = oscillators(rate * t, 0.05, [period], damping)
        omega = 2.0 * np.pi / period
        damped = omega * np.sqrt(1.0 - damping**2)
        c = -2.0 * damping * rate / omega**3
        s = (rate / omega**2 + damping * omega * c) / damped
        decay = np.exp(-damping * omega * t)
        exact_u = -rate * t / omega**2 + 2.0 * damping * rate / omega**3
        exact_u = exact_u + decay * (c * np.cos(damped * t) + s * np.sin(damped * t))
        np.testing.assert_allclose(u[:, 0], exact_u, atol=1e-12)
        np.testing.assert_allclose(np.gradient(exact_u, t, edge_order=2)[1:-1], v[1:-1, 0], atol=2e-2 * np.abs(v).max())

    def test_harmonic_steady_state(self):
        """Amplification 1 / sqrt((1 - r^2)^2 + (2 z r)^2), r = forcing over natural frequency."""
        dt, forcing, damping = 0.002, 2.0, 0.05
        t = np.arange(0.0, 30.0, dt)
        periods = np.array([0.2, 0.5, 0.9])
        u, _ = oscillators(np.sin(2.0 * np.pi * forcing * t), dt, periods, damping)
        amplification = (2.0 * np.pi / periods) ** 2 * np.abs(u)[t > 25.0].max(axis=0)
        ratio = forcing * periods
        exact = 1.0 / np.sqrt((1.0 - ratio**2) ** 2 + (2.0 * damping * ratio) ** 2)
        np.testing.assert_allclose(amplification, exact, rtol=1e-3)

    def test_stiff_oscillator_feels_the_ground(self):
        ground = np.sin(np.arange(0.0, 10.0, 0.01))
        np.testing.assert_allclose(response_spectrum(ground, 0.01, [0.02]), np.abs(ground).max(), rtol=1e-3)


class RealRecord(unittest.TestCase):
    def test_northridge_baldwin_hills(self):
        record = REFERENCE / "records" / "RSN985_NORTHR_BLD090.AT2"
        table = REFERENCE / "waves" / "record_BLD090_layered3.csv"
        if not (record.exists() and table.exists()):
            self.skipTest(f"reference data absent: {record}")
        acceleration, dt = read_at2(record)
        rows = csv.DictReader(line for line in table.read_text().splitlines() if not line.startswith("#"))
        published = next(row for row in rows if row["motion"] == "input_outcrop")
        values = {float(key[4:-2]): float(value) for key, value in published.items() if key.startswith("Sa_T")}
        self.assertEqual(len(values), 13)
        spectrum = response_spectrum(acceleration, dt, list(values)) / G
        np.testing.assert_allclose(spectrum, list(values.values()), rtol=1e-6)


if __name__ == "__main__":
    unittest.main()
