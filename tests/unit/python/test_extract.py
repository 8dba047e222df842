"""Tables of a run against closed forms: sliding blocks, spectral ratios of a layer, profiles of a standing wave."""

import contextlib
import csv
import io
import tempfile
import unittest
from pathlib import Path
from unittest import mock

import h5py
import numpy as np

import synthetic_run
from tremolo import Run
from tremolo.pictures import preview
from tremolo.__main__ import main
from tremolo.extract import newmark, points, ratios
from tremolo.report import spectra

G = 9.80665  # m/s2


def slides(time, driving, k_y):
    return newmark.sliding_displacement(time, driving, k_y * G)[-1]


class SlidingBlock(unittest.TestCase):
    def test_rectangular_pulse(self):
        # Newmark (1965): V^2 / (2 g N) (1 - N / A), V = A g t_0.
        a, t_0 = 0.5, 0.3
        edge = 1e-9
        time, driving = np.array([0.0, edge, t_0, t_0 + edge, 4.0]), a * G * np.array([0.0, 1.0, 1.0, 0.0, 0.0])
        for n in (0.05, 0.1, 0.3, 0.45):
            exact = (a * G * t_0) ** 2 / (2.0 * G * n) * (1.0 - n / a)
            self.assertAlmostEqual(slides(time, driving, n) / exact, 1.0, delta=1e-7)
        self.assertEqual(0.0, slides(time, driving, 0.5))

    def test_half_sine_pulse_converges_to_second_order(self):
        # Sliding begins at A sin(w t_1) = k; v = A/w (cos w t_1 - cos w t) - k (t - t_1) until the pulse ends, then falls at the
        # rate k: integrated by hand.
        peak, duration, k_y = 4.0, 0.4, 1.0 / G
        k, w = k_y * G, np.pi / duration
        t_1 = np.arcsin(k / peak) / w
        left = duration - t_1
        v_end = peak / w * (np.cos(w * t_1) + 1.0) - k * left
        exact = peak / w * (np.cos(w * t_1) * left + np.sin(w * t_1) / w) - k * left**2 / 2.0 + v_end**2 / (2.0 * k)
        errors = []
        for count in (21, 41, 81):
            time = np.concatenate([np.linspace(0.0, duration, count), [5.0]])
            driving = np.concatenate([peak * np.sin(w * time[:-1]), [0.0]])
            errors.append(abs(slides(time, driving, k_y) / exact - 1.0))
        self.assertLess(errors[-1], 1e-3)
        for coarse, fine in zip(errors, errors[1:]):
            self.assertGreater(np.log2(coarse / fine), 1.8)

    def test_stops_and_slides_again_within_a_step(self):
        # Half a second of excess 1 gives v_0 = 0.5. Then the excess -2 + 3 t makes v = 0.5 - 2 t + 1.5 t^2, which is zero at
        # t = 1/3; the block rests until the excess is zero, at 2/3, and slides again until the last sample, at 1.
        time = np.array([0.0, 0.5, 0.5 + 1e-12, 1.5])
        excess = np.array([1.0, 1.0, -2.0, 1.0])
        first = 0.5 * 1.0 * 0.5**2
        second = 0.5 / 3.0 - 2.0 / 2.0 / 9.0 + 3.0 / 6.0 / 27.0
        third = 3.0 / 6.0 / 27.0
        k = 5.0
        self.assertAlmostEqual(newmark.sliding_displacement(time, excess + k, k)[-1], first + second + third, delta=1e-9)

    def test_sine_against_steps_of_time(self):
        # Independently: Euler's steps so short that they do not show, until the tenth period.
        w, peak, k = 2.0 * np.pi, 3.0, 1.2
        time = np.arange(0.0, 10.0, 0.002)
        found = newmark.sliding_displacement(time, peak * np.sin(w * time), k)[-1]
        dt, v, d = 1e-5, 0.0, 0.0
        for excess in peak * np.sin(w * np.arange(0.0, 10.0, dt)) - k:
            v = max(0.0, v + excess * dt)
            d += v * dt
        self.assertAlmostEqual(found / d, 1.0, delta=1e-3)

    def test_never_slides_up(self):
        time = np.linspace(0.0, 3.0, 301)
        up = -3.0 * np.sin(np.pi * time / 3.0)
        self.assertEqual(0.0, slides(time, up, 0.01))
        self.assertTrue(np.all(np.diff(newmark.sliding_displacement(time, 3.0 * np.sin(20.0 * time), 1.0)) >= 0.0))

    def test_inertia_is_opposite_to_the_ground(self):
        # Ground that moves to the right lets a mass slide to the left.
        np.testing.assert_array_equal([-2.0], newmark.driving([2.0], 1.0))
        np.testing.assert_array_equal([2.0], newmark.driving([2.0], -1.0))


class Motion:
    """A series as extract sees it, of an acceleration along x."""

    def __init__(self, time, ax, ay=None):
        self._columns = {"time": time, "ax": ax, "ay": np.zeros_like(ax) if ay is None else ay}

    def __getitem__(self, column):
        return self._columns[column]

    def __len__(self):
        return len(self._columns["time"])


class LayerOnHalfSpace(unittest.TestCase):
    """The surface of an elastic layer over the outcrop of its half-space: 1 / sqrt(cos^2 kH + alpha^2 sin^2 kH), alpha the
    ratio of impedances (Roesset 1977; Kramer 1996, Eq. 7.29 without damping)."""

    HEIGHT, SPEED, ALPHA = 20.0, 250.0, 0.4

    def setUp(self):
        # The outcrop moves by a Ricker wavelet; the surface is the outcrop's motion once each way, then each echo.
        self.time = np.arange(0.0, 20.0, 0.005)
        outcrop = synthetic_run.ricker(self.time, 5.0, 0.6)
        echo = (1.0 - self.ALPHA) / (1.0 + self.ALPHA)
        surface = sum(
            2.0 / (1.0 + self.ALPHA) * (-echo) ** n * synthetic_run.ricker(self.time - (2 * n + 1) * self.HEIGHT / self.SPEED, 5.0, 0.6)
            for n in range(25))
        self.outcrop, self.surface = Motion(self.time, outcrop), Motion(self.time, surface)

    def exact(self, f):
        phase = 2.0 * np.pi * f * self.HEIGHT / self.SPEED
        return 1.0 / np.sqrt(np.cos(phase) ** 2 + (self.ALPHA * np.sin(phase)) ** 2)

    def test_fourier_ratio_is_the_smoothed_transfer_function(self):
        table = ratios.fourier(self.surface, self.outcrop)
        f, found = table["frequency_Hz"], table["fourier_ratio_x"]
        # What the window makes of the closed form, by an integration of its own on fine lines.
        lines = np.arange(0.005, 40.0, 0.005)
        pulse = (lines / 5.0) ** 2 * np.exp(-((lines / 5.0) ** 2))  # |A| of the wavelet, but for a factor
        known = np.isfinite(found)
        expected = spectra.smoothed(lines, self.exact(lines) * pulse, f) / spectra.smoothed(lines, pulse, f)
        self.assertGreater(np.count_nonzero(known), 50)
        self.assertLess(np.abs(found[known] / expected[known] - 1.0).max(), 0.005)
        # And the peak at c/4H, pointwise, where the window takes off some percent.
        peak = np.nanargmax(found)
        self.assertAlmostEqual(f[peak] / (self.SPEED / 4.0 / self.HEIGHT), 1.0, delta=0.03)
        self.assertAlmostEqual(found[peak] * self.ALPHA, 1.0, delta=0.03)

    def test_direction_without_motion_and_weak_frequencies_have_no_ratio(self):
        table = ratios.fourier(self.surface, self.outcrop)
        self.assertTrue(np.isnan(table["fourier_ratio_y"]).all())
        self.assertTrue(np.isnan(table["fourier_ratio_x"][table["frequency_Hz"] > 20.0]).all())

    def test_response_ratio_of_one_motion_is_its_factor(self):
        twice = Motion(self.time, 2.0 * self.outcrop["ax"], 3.0 * self.outcrop["ax"])
        table = ratios.response(twice, Motion(self.time, self.outcrop["ax"], self.outcrop["ax"]))
        for direction, factor in (("x", 2.0), ("y", 3.0)):
            found = table[f"response_ratio_{direction}"]
            self.assertTrue(np.isfinite(found).any())
            np.testing.assert_allclose(found[np.isfinite(found)], factor, rtol=1e-12)

    def test_base_at_rest_is_refused(self):
        with self.assertRaisesRegex(ValueError, "the base does not move"):
            ratios.fourier(self.surface, Motion(self.time, np.zeros_like(self.time)))


LINE_COLUMNS = {"x": "m", "y": "m", "ux": "m", "uy": "m", "vx": "m/s", "vy": "m/s", "ax": "m/s2", "ay": "m/s2", "sxx": "Pa", "syy": "Pa",
                "szz": "Pa", "sxy": "Pa", "exx": "1", "eyy": "1", "gxy": "1"}
DEPTHS = np.arange(0.0, 11.0)
SPEED, DENSITY, OMEGA, AMPLITUDE = 120.0, 1800.0, 2.0 * np.pi * 3.0, 0.02
MASS_ACCELERATION = 2.0  # m/s2, a half sine of 0.5 s


def write_series(file, path, columns, rows):
    series = file.create_dataset(path, data=rows)
    series.attrs["columns"] = np.array([name.encode() for name in columns])
    series.attrs["units"] = np.array([unit.encode() for unit in columns.values()])


def add_line_and_mass(path):
    """A standing shear wave u = A cos(k z) sin(w t) along a line from the surface at y = 10 down, and a mass."""
    time = np.arange(0.0, 2.0, 0.002)
    k = OMEGA / SPEED
    columns, rows = {"time": "s"}, [time]
    for number, z in enumerate(DEPTHS):
        columns |= {f"{name}{number}": unit for name, unit in LINE_COLUMNS.items()}
        ux, gxy = AMPLITUDE * np.cos(k * z) * np.sin(OMEGA * time), AMPLITUDE * k * np.sin(k * z) * np.sin(OMEGA * time)
        values = {"x": 50.0 + ux, "y": 10.0 - z, "ux": ux, "vx": AMPLITUDE * OMEGA * np.cos(k * z) * np.cos(OMEGA * time),
                  "ax": -(OMEGA**2) * ux, "syy": -DENSITY * G * z, "sxy": DENSITY * SPEED**2 * gxy, "gxy": gxy}
        rows += [values.get(name, 0.0) * np.ones_like(time) for name in LINE_COLUMNS]
    mass_columns = {"time": "s", "mass": "kg/m", "x": "m", "y": "m", "ux": "m", "uy": "m", "vx": "m/s", "vy": "m/s", "ax": "m/s2", "ay": "m/s2"}
    mass = np.zeros((len(time), len(mass_columns)))
    mass[:, 0], mass[:, 1] = time, 1e5
    mass[:, 8] = MASS_ACCELERATION * np.sin(np.pi * time / 0.5) * (time < 0.5)
    with h5py.File(path, "a") as file:
        file.attrs["surface_levels"] = [0.0, 10.0]
        write_series(file, "lines/shaft", columns, np.column_stack(rows))
        write_series(file, "sliding_masses/wedge", mass_columns, mass)
        file["sliding_masses/wedge"].attrs["outline"] = [30.0, 0.0, 45.0, 10.0, 30.0, 12.0]


def read_csv(path):
    with open(path, newline="", encoding="utf-8") as stream:
        rows = list(csv.DictReader(stream))
    return {name: np.array([float(row[name]) if row[name] else np.nan for row in rows]) for name in rows[0]}


class Command(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.path = Path(cls.folder.name)
        synthetic_run.write(cls.path / "run.h5", frames=20, size=2.0)
        add_line_and_mass(cls.path / "run.h5")

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def extract(self, *arguments, run=None):
        out, err = io.StringIO(), io.StringIO()
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
            status = main(["extract", str(run or self.path), *arguments])
        return status, out.getvalue(), err.getvalue()

    def table(self, name):
        return read_csv(self.path / "tables" / name)

    def test_profile_of_a_standing_wave(self):
        status, _, err = self.extract("--base", "shaft#10")
        self.assertEqual((0, ""), (status, err))
        found, k = self.table("profile_shaft.csv"), OMEGA / SPEED
        np.testing.assert_allclose(found["distance_m"], DEPTHS, atol=1e-9)
        np.testing.assert_allclose(found["y_m"], 10.0 - DEPTHS, atol=1e-9)
        # Peaks are sought at the rows, every 0.002 s: within 1 - cos(w dt/2) of the closed form.
        for name, exact in (("peak_ax_m_s2", OMEGA**2 * AMPLITUDE * np.cos(k * DEPTHS)), ("peak_vx_m_s", OMEGA * AMPLITUDE * np.cos(k * DEPTHS)),
                            ("peak_ux_m", AMPLITUDE * np.cos(k * DEPTHS)), ("peak_gxy", AMPLITUDE * k * np.sin(k * DEPTHS)),
                            ("peak_ux_relative_m", AMPLITUDE * (np.cos(k * DEPTHS) - np.cos(10.0 * k)))):
            np.testing.assert_allclose(found[name], np.abs(exact), rtol=2e-4, atol=1e-12, err_msg=name)
        stress = DENSITY * SPEED**2 * AMPLITUDE * k * np.sin(k * DEPTHS)
        np.testing.assert_allclose(found["stress_ratio"][1:], stress[1:] / (DENSITY * G * DEPTHS[1:]), rtol=2e-4)
        self.assertTrue(np.isnan(found["stress_ratio"][0]))  # at the surface nothing weighs

    def test_history_of_the_nearest_point(self):
        status, out, _ = self.extract("--point", "50.3,6", "--base", "shaft#10")
        self.assertEqual(0, status)
        self.assertIn("50.3,6: the nearest point stored is 'shaft#4', which began at 50,6, 0.3 m away", out)
        found, k = self.table("history_shaft#4.csv"), OMEGA / SPEED
        np.testing.assert_allclose(found["ux_relative_m"], AMPLITUDE * (np.cos(4.0 * k) - np.cos(10.0 * k)) * np.sin(OMEGA * found["time_s"]),
                                   atol=1e-9)
        np.testing.assert_allclose(found["gxy"], found["sxy_Pa"] / (DENSITY * SPEED**2), rtol=1e-6, atol=1e-12)

    def test_newmark_of_a_stored_mass(self):
        # The half sine drives a mass down a slope that falls to the left; what slides is independent of the rest of the run.
        status, out, err = self.extract("--ky", "0.05", "0.1", "0.3", "--base", "shaft#10")
        self.assertEqual((0, ""), (status, err))
        found = self.table("newmark_wedge.csv")
        np.testing.assert_allclose(found["k_y"], [0.05, 0.1, 0.3])
        np.testing.assert_allclose(found["decoupled_k_max"], MASS_ACCELERATION / G, rtol=1e-5)
        w = np.pi / 0.5
        for k_y, moved in zip(found["k_y"][:2], found["decoupled_displacement_m"]):
            k = k_y * G
            t_1 = np.arcsin(k / MASS_ACCELERATION) / w
            left = 0.5 - t_1
            v_end = MASS_ACCELERATION / w * (np.cos(w * t_1) + 1.0) - k * left
            self.assertGreater(v_end, 0.0)  # it slides on when the pulse is over
            exact = MASS_ACCELERATION / w * (np.cos(w * t_1) * left + np.sin(w * t_1) / w) - k * left**2 / 2.0 + v_end**2 / (2.0 * k)
            self.assertAlmostEqual(moved / exact, 1.0, delta=1e-3)
        self.assertEqual(0.0, found["decoupled_displacement_m"][2])
        self.assertIn("wedge: decoupled, k_y = 0.05, k_max = 0.204: slides", out)
        self.assertIn("note: soil yields in this run", out)  # as the synthetic run has it
        to_the_right = self.extract("--ky", "0.05", "--downslope", "right")
        self.assertEqual(0, to_the_right[0])
        self.assertEqual([0.0], list(self.table("newmark_wedge.csv")["decoupled_displacement_m"]))

    def test_pictures(self):
        status, _, err = self.extract("--base", "shaft#10", "--ky", "0.1", "--plot", "--out", str(self.path / "drawn"))
        self.assertEqual((0, ""), (status, err))
        for name in ("profile_shaft.png", "ratio_crest_over_shaft#10.png", "newmark_wedge.png", "relative_displacement.png"):
            self.assertTrue((self.path / "drawn" / name).stat().st_size > 5000, name)

    def test_preview_shows_lines_and_masses(self):
        with Run(self.path) as run, mock.patch.object(preview.style, "save", lambda figure, *_: figure):
            drawn = preview.preview(run, self.path)
        words = [text.get_text() for text in drawn.axes[0].texts]
        self.assertIn("shaft", words)
        self.assertIn("wedge", words)
        preview.style.plt.close(drawn)

    def test_mistakes_are_named(self):
        for arguments, words in ((("--point", "crst"), "stores no point 'crst'; it has crest, shaft#0 to #10. A place is written X,Y"),
                                 (("--point", "0,0"), "stores no history near 0,0, and has no frames with displacements by which"),
                                 (("--ky", "-0.1"), "--ky -0.1: a yield coefficient is a number above 0"),
                                 (("--ky", "nan"), "--ky nan: a yield coefficient is a number above 0")):
            status, _, err = self.extract(*arguments)
            self.assertEqual(1, status)
            self.assertIn(words, err)
            self.assertNotIn("Traceback", err)

    def test_run_without_masses_says_how_to_get_some(self):
        with tempfile.TemporaryDirectory() as folder:
            synthetic_run.write(Path(folder) / "run.h5", frames=2, size=4.0)
            status, _, err = self.extract("--ky", "0.1", run=folder)
            self.assertEqual(1, status)
            self.assertIn("stores no sliding mass: put [[sliding_mass]] into the case", err)

    def test_points_of_lines_read_as_monitors(self):
        with Run(self.path) as run:
            self.assertEqual(["shaft"], run.lines)
            third = run.line("shaft")[3]
            self.assertEqual(["time", *LINE_COLUMNS], third.columns)
            self.assertEqual("Pa", third.units["sxy"])
            self.assertEqual(12, len(points.stored(run)))
            self.assertEqual(1e5, run.sliding_mass("wedge")["mass"][0])
            np.testing.assert_array_equal([[30.0, 0.0], [45.0, 10.0], [30.0, 12.0]], run.sliding_mass("wedge").outline)
            with self.assertRaisesRegex(KeyError, "no line 'x'; it has shaft"):
                run.line("x")


def write_frames(path, table=None):
    """A standing shear wave u_x = A cos(k z) sin(w t), z below y = 10 m, which turns nothing, in particles of 0.5 m that a frame
    may name in any order and cut in halves. `table`: the displacement, velocity and acceleration of a shaking table over time."""
    x, y = (grid.ravel() for grid in np.meshgrid(np.arange(40.25, 45.0, 0.5), np.arange(0.25, 10.0, 0.5)))
    k, times = OMEGA / SPEED, np.arange(0.0, 1.0, 0.02)
    order = np.random.default_rng(1)
    with h5py.File(path, "w") as file:
        file.attrs.update({"schema_version": np.bytes_("1.2"), "title": np.bytes_("frames"), "status": np.bytes_("complete"),
                           "mesh_size": 1.0, "particle_size": 0.5, "soil_names": np.array([b"sand"])})
        file.create_group("monitors")
        for number, t in enumerate(times):
            start = np.column_stack([x, y])
            if number % 3 == 1:  # the particles on the left are cut, far from those that are followed
                start = np.vstack([start, start[x < 41.0] + 0.01])
            start = order.permutation(start)
            z = 10.0 - start[:, 1]
            shape = np.column_stack([np.cos(k * z), np.zeros_like(z)]) * AMPLITUDE
            fields = {"position": start + shape * np.sin(OMEGA * t), "displacement": shape * np.sin(OMEGA * t),
                      "velocity": shape * OMEGA * np.cos(OMEGA * t), "acceleration": -shape * OMEGA**2 * np.sin(OMEGA * t),
                      "stress": np.column_stack([-z, -2.0 * z, -3.0 * z, 0.0 * z]), "soil": np.zeros(len(z), dtype=np.int32)}
            frame = file.create_group(f"frames/{number:04}")
            frame.attrs["time"] = t
            for name, values in fields.items():
                frame[name] = values
        if table is not None:
            fine = np.arange(0.0, 1.0, 0.002)
            u, v, a = table(fine)
            zero = np.zeros_like(fine)
            columns = {"time": "s", "ux": "m", "uy": "m", "vx": "m/s", "vy": "m/s", "ax": "m/s2", "ay": "m/s2"}
            write_series(file, "shaking_table", columns, np.column_stack([fine, u, zero, v, zero, a, zero]))
    return times


class FollowedThroughFrames(unittest.TestCase):
    """A place without a monitor: its history is that of the wave, whatever the order of the particles."""

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.path = Path(self.folder.name)

    def test_history_is_that_of_the_wave(self):
        times = write_frames(self.path / "run.h5")
        with Run(self.path) as run:
            point, said = points.find(run, "43.3,4.8")
        self.assertTrue(point.of_frames)
        self.assertIn("the soil that began at 43.25,4.75 is followed through the frames, every 0.02 s", said)
        found, z, k = point.series, 10.0 - 4.75, OMEGA / SPEED
        np.testing.assert_allclose(found["time"], times, atol=1e-12)
        np.testing.assert_allclose(found["ux"], AMPLITUDE * np.cos(k * z) * np.sin(OMEGA * times), atol=1e-9)
        np.testing.assert_allclose(found["x"], 43.25 + found["ux"], atol=1e-9)
        np.testing.assert_allclose(found["ax"], -(OMEGA**2) * found["ux"], atol=1e-9)
        np.testing.assert_allclose(found["szz"], -3.0 * z, atol=1e-9)
        # The fit over the particles 0.5 m above and below: the wave's strain times sin(kd)/(kd).
        strain = AMPLITUDE * k * np.sin(k * z) * np.sin(OMEGA * times) * np.sin(0.5 * k) / (0.5 * k)
        np.testing.assert_allclose(found["gxy"], strain, atol=1e-9)
        self.assertEqual("Pa", found.units["sxy"])

    def test_history_on_a_shaking_table_is_in_space(self):
        times = write_frames(self.path / "run.h5", table=lambda t: (0.3 * t, 0.3 + 0.0 * t, 0.0 * t))
        with Run(self.path) as run:
            found = points.find(run, "43.25,9.75")[0].series
        moved = AMPLITUDE * np.cos(0.25 * OMEGA / SPEED) * np.sin(OMEGA * times)
        np.testing.assert_allclose(found["ux"], moved + 0.3 * times, atol=1e-9)
        np.testing.assert_allclose(found["x"], 43.25 + moved, atol=1e-9)  # places are those on the table, as of monitors

    def test_command_writes_it_and_leaves_out_what_frames_cannot_say(self):
        times = write_frames(self.path / "run.h5")
        out, err = io.StringIO(), io.StringIO()
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
            self.assertEqual(0, main(["extract", str(self.path), "--point", "43.25,4.75"]), err.getvalue())
            found = read_csv(self.path / "tables" / "history_43.25,4.75.csv")
            np.testing.assert_allclose(found["time_s"], times, atol=1e-8)
            self.assertEqual(1, main(["extract", str(self.path), "--point", "50,4.75"]))
            self.assertEqual(1, main(["extract", str(self.path), "--point", "43,4", "--base", "43,1"]))
        self.assertIn("there is no soil at 50,4.75: the nearest began at 44.75,4.75, 5.25 m away", err.getvalue())
        self.assertIn("that of a base cannot be taken from frames: put a [[monitor]] there", err.getvalue())


if __name__ == "__main__":
    unittest.main()
