"""What a run stores of a layer on a half-space under a vertical shear wave, against closed forms.

The motion of the free surface, u_s(t), says all of the layer below it, at the depth z:

    v(z, t) = [v_s(t - z/c) + v_s(t + z/c)] / 2,        gamma(z, t) = du_x/dy = [v_s(t - z/c) - v_s(t + z/c)] / (2 c),

the mean acceleration of the ground above the depth D, c [v_s(t + D/c) - v_s(t - D/c)] / (2 D), and the Fourier ratio of the
depths z_1 and z_2, |cos(k z_1) / cos(k z_2)|, k = 2 pi f / c (Kramer 1996, Geotechnical Earthquake Engineering, 7.2.1).

    usage: test_extract.py TREMOLO SOURCE_DIR
"""

import csv
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np

TREMOLO, SOURCE = sys.argv.pop(1), Path(sys.argv.pop(1))
sys.path.insert(0, str(SOURCE / "python"))

from tremolo import Run
from tremolo.extract import followed, points
from tremolo.histories import even_steps
from tremolo.report import spectra

SPEED, DENSITY, GRAVITY = 150.0, 1800.0, 9.81
DEPTH = 5.0  # of the sliding mass
CASE = """
title = "layer on a half-space"
motion = { pulse = { shape = "ricker", frequency = 3.0, time = 0.5, velocity = 0.1 }, wave = "SV", angle_deg = 0.0, reference = [0.0, -20.0] }
surface = { level = 0.0 }
halfspace = { density = 1900.0, vs = 400.0, vp = 800.0 }
mesh = { size = 0.5, box = [0.0, -20.0, 4.0, 0.0] }
boundary = { sides = "periodic", base = { model = "wave" } }
output = { history_every_s = 0.002, every_s = 0.05 }
profile = [{ soil = "layer", thickness = 10.0 }]
stage = [{ kind = "gravity" }, { kind = "shaking", duration_s = 3.0 }]
[soil.layer]
model = "linear_elastic"
density = 1800.0
vs = 150.0
vp = 300.0
[soil.rock]
model = "linear_elastic"
density = 1900.0
vs = 400.0
vp = 800.0
[[region]]
soil = "layer"
polygon = [[0.0, -10.0], [4.0, -10.0], [4.0, 0.0], [0.0, 0.0]]
[[region]]
soil = "rock"
polygon = [[0.0, -20.0], [4.0, -20.0], [4.0, -10.0], [0.0, -10.0]]
[[monitor]]
name = "surface"
point = [2.125, -0.125]
[[monitor]]
name = "deep"
point = [2.125, -9.875]
[[line]]
name = "shaft"
from = [2.125, -0.125]
to = [2.125, -9.875]
spacing = 0.5
[[sliding_mass]]
name = "upper half"
polygon = [[-1.0, -5.0], [5.0, -5.0], [5.0, 1.0], [-1.0, 1.0]]
"""


def setUpModule():
    """One run for all tests."""
    global folder, run, time, surface, tables
    temporary = tempfile.TemporaryDirectory(prefix="tremolo_test_")
    unittest.addModuleCleanup(temporary.cleanup)
    folder = Path(temporary.name)
    (folder / "case.toml").write_text(CASE)
    tremolo("run", "case.toml", "--out", "run")
    run = Run(folder / "run")
    time, surface = run.monitor("surface")["time"], run.monitor("surface")["vx"]
    tremolo("extract", "run", "--base", "deep", "--ky", "0.1", "--downslope", "left")
    tables = folder / "run" / "tables"


def tremolo(*arguments):
    told = subprocess.run([TREMOLO, *arguments], cwd=folder, capture_output=True, text=True, timeout=300)
    assert told.returncode == 0, told.stdout + told.stderr
    return told.stdout


def table(name):
    with open(tables / name, newline="", encoding="utf-8") as stream:
        rows = list(csv.DictReader(stream))
    return {column: np.array([float(row[column] or "nan") for row in rows]) for column in rows[0]}


def waves(z):
    """Velocity at the surface later and earlier by z/c, and the times at which both are known."""
    known = time + z / SPEED <= time[-1]
    return np.interp(time - z / SPEED, time, surface)[known], np.interp(time + z / SPEED, time, surface)[known], known


def error(found, exact):
    return np.linalg.norm(found - exact) / np.linalg.norm(exact)


class Layer(unittest.TestCase):
    def test_points_of_the_line_move_and_strain_as_the_surface_says(self):
        points = run.line("shaft")
        self.assertEqual(21, len(points))
        for point in points[2:-1]:  # at surface and interface all neighbours lie on one side: the strain is that 0.125 m away
            z = point["uy"][0] - point["y"][0]
            later, earlier, known = waves(z)
            self.assertLess(error(point["vx"][known], (later + earlier) / 2.0), 0.005, f"z = {z}")
            self.assertLess(error(point["gxy"][known], (later - earlier) / (2.0 * SPEED)), 0.005, f"z = {z}")

    def test_soil_followed_through_frames_moves_and_strains_as_a_monitor(self):
        for name in ("surface", "shaft#10"):
            stored = points.find(run, name)[0]
            found = followed.series(run, stored.start)
            self.assertEqual(61, len(found))
            self.assertEqual(stored.series.columns, [column for column in stored.series.columns if column in found.columns])
            for column in stored.series.columns[1:]:
                history = stored.series[column]
                # Between the rows of a history, 0.002 s apart, lines: within (w dt)^2 / 8 of a motion at 10 Hz.
                np.testing.assert_allclose(found[column], np.interp(found["time"], time, history), atol=2e-3 * np.abs(history).max() + 1e-12,
                                           err_msg=f"{name}, {column}")

    def test_any_place_has_a_history(self):
        told = tremolo("extract", "run", "--point", "0.9,-3.1")
        self.assertIn("0.9,-3.1: no history is stored there; the soil that began at 0.875,-3.125 is followed through the frames, every 0.05 s", told)
        found = table("history_0.9,-3.1.csv")
        later, earlier = waves(3.125)[:2]
        exact = np.interp(found["time_s"], time[: len(later)], (later + earlier) / 2.0)
        self.assertLess(error(found["vx_m_s"][:-2], exact[:-2]), 0.005)

    def test_rest_stress_is_the_weight_above(self):
        for point in run.line("shaft"):
            z = point["uy"][0] - point["y"][0]
            self.assertAlmostEqual(-point["syy"][0] / (DENSITY * GRAVITY * z), 1.0, delta=1e-3)

    def test_profile_holds_the_peaks(self):
        found = table("profile_shaft.csv")
        np.testing.assert_allclose(found["y_m"], -0.125 - 0.4875 * np.arange(21), atol=0.15)  # nearest particles
        for z, velocity, strain, ratio in zip(-found["y_m"], found["peak_vx_m_s"], found["peak_gxy"], found["stress_ratio"]):
            later, earlier, _ = waves(z)
            self.assertAlmostEqual(velocity / np.abs((later + earlier) / 2.0).max(), 1.0, delta=0.005)
            if 1.0 < z < 9.8:
                peak = np.abs(later - earlier).max() / (2.0 * SPEED)
                self.assertAlmostEqual(strain / peak, 1.0, delta=0.005)
                # A particle has the stress of about the middle of its cell, a quarter of a cell away.
                near = [np.abs(np.subtract(*waves(z + step)[:2])).max() * DENSITY * SPEED / 2.0 for step in (-0.15, 0.15)]
                self.assertLess(0.995 * near[0], ratio * DENSITY * GRAVITY * z)
                self.assertLess(ratio * DENSITY * GRAVITY * z, 1.005 * near[1])

    def test_sliding_mass_moves_as_the_ground_above_its_base(self):
        mass = run.sliding_mass("upper half")
        np.testing.assert_allclose(mass["mass"], DENSITY * DEPTH * 4.0, rtol=1e-9)
        later, earlier, known = waves(DEPTH)
        exact = SPEED * (earlier - later) / (2.0 * DEPTH)
        self.assertLess(error(mass["ax"][known], exact), 0.005)
        # Ground that moves to the right drives a mass to the left.
        np.testing.assert_allclose(table("newmark_upper_half.csv")["decoupled_k_max"], exact.max() / GRAVITY, rtol=0.005)

    def test_fourier_ratio_is_that_of_the_layer(self):
        found = table("fourier_ratio_surface_over_deep.csv")
        f, ratio = found["frequency_Hz"], found["fourier_ratio_x"]
        z_1, z_2 = (run.monitor(name)["uy"][0] - run.monitor(name)["y"][0] for name in ("surface", "deep"))
        # The window over the closed form, with the surface's own spectrum.
        record, dt = even_steps(time, run.monitor("surface")["ax"])
        amplitude = np.abs(np.fft.rfft(record, 8 * len(record)))[1:]
        lines = np.fft.rfftfreq(8 * len(record), dt)[1:]
        k = 2.0 * np.pi * lines / SPEED
        below = amplitude * np.abs(np.cos(k * z_2) / np.cos(k * z_1)).clip(max=10.0)
        expected = spectra.smoothed(lines, amplitude, f) / spectra.smoothed(lines, below, f)
        known = np.isfinite(ratio) & (f > 0.5) & (f < 8.0)
        self.assertGreater(np.count_nonzero(known), 40)
        self.assertLess(np.abs(ratio[known] / expected[known] - 1.0).max(), 0.03)
        # Unsmoothed at 2 Hz, away from the resonance at c/4H = 3.75 Hz.
        at = 2.0 * np.pi * 2.0 / SPEED
        self.assertAlmostEqual(np.interp(2.0, f, ratio) * np.cos(at * z_2) / np.cos(at * z_1), 1.0, delta=0.03)

    def test_relative_displacement_is_the_integral_of_the_strain(self):
        found = table("history_surface.csv")
        points = run.line("shaft")
        depths = np.array([point["uy"][0] - point["y"][0] for point in points])
        drift = np.trapz([point["gxy"] for point in points], depths, axis=0)
        self.assertLess(error(found["ux_relative_m"], drift), 0.01)


if __name__ == "__main__":
    unittest.main()
