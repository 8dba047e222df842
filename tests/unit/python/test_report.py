"""The parts of a report: spectra against closed forms, images of particles, points kept of a line, what is refused."""

import contextlib
import io
import json
import tempfile
import unittest
from pathlib import Path
from unittest import mock

import h5py
import numpy as np

import synthetic_run
import synthetic_site
from tremolo import Run
from tremolo.__main__ import main
from tremolo.report import facts, frames, kinds, spectra


class FourierAmplitude(unittest.TestCase):
    def test_of_a_gaussian_pulse_is_its_transform(self):
        dt, width = 0.002, 0.02
        time = np.arange(0.0, 8.0, dt)
        acceleration = np.exp(-(((time - 4.0) / width) ** 2))
        centres = spectra.frequencies(8.0, dt)
        # |A(f)| = sqrt(pi) w exp(-(pi f w)^2); the window widens it by less than 1 %.
        exact = np.sqrt(np.pi) * width * np.exp(-((np.pi * centres * width) ** 2))
        found = spectra.fourier_amplitude(acceleration, dt, centres)
        np.testing.assert_allclose(found, exact, rtol=0.02)

    def test_smoothing_keeps_a_level_and_finds_the_place_of_a_line(self):
        lines = np.arange(1, 2001) * 0.0125
        centres = spectra.frequencies(20.0, 0.01)
        np.testing.assert_allclose(spectra.smoothed(lines, np.full(len(lines), 3.0), centres), 3.0, rtol=1e-12)
        single = np.where(np.abs(lines - 5.0) < 1e-9, 1.0, 0.0)
        self.assertAlmostEqual(5.0, centres[np.argmax(spectra.smoothed(lines, single, centres))], delta=0.1)

    def test_frequencies_are_those_that_the_record_holds(self):
        centres = spectra.frequencies(2.0, 0.02)
        self.assertAlmostEqual(0.5, centres[0])
        self.assertLessEqual(centres[-1], 0.5 / 0.02)


class Images(unittest.TestCase):
    def test_a_particle_fills_its_square_and_nothing_else(self):
        # 10 pixels a metre; a particle of 0.8 m is drawn 1 m wide.
        pixels = frames.raster(np.array([[2.0, 1.0]]), 0.8, np.array([7], dtype=np.uint8), (0.0, 0.0, 4.0, 3.0), (30, 40))
        # The uppermost row comes first: 1 m above the ground of 3 m is row 20 of 30.
        expected = np.full((30, 40), frames.NOTHING)
        expected[15:25, 15:25] = 7
        np.testing.assert_array_equal(expected, pixels)

    def test_large_squares_are_drawn_as_small_ones_are(self):
        # Two squares of many pixels, one of them cut by the edge; then each of them as many small ones side by side.
        box, shape = (0.0, 0.0, 4.0, 3.0), (300, 400)
        large = frames.raster(np.array([[2.0, 1.0], [4.0, 2.5]]), 0.8, np.array([7, 9], dtype=np.uint8), box, shape)
        small = np.full(shape, frames.NOTHING, dtype=np.uint8)
        for (x, y), colour in (((2.0, 1.0), 7), ((4.0, 2.5), 9)):
            offsets = np.arange(-0.5, 0.5, 0.01) + 0.005
            points = np.array([[x + dx, y + dy] for dx in offsets for dy in offsets])
            pixels = frames.raster(points, 0.01 / 1.25, np.full(len(points), colour, dtype=np.uint8), box, shape)
            small[pixels == colour] = colour
        self.assertLess(np.mean(large != small), 0.005)  # a row of pixels at the edges
        self.assertEqual(9, large[50, 399])

    def test_particles_beyond_the_bounds_are_left_out(self):
        pixels = frames.raster(np.array([[-9.0, 1.0], [1.0, 99.0]]), 0.5, np.zeros(2, dtype=np.uint8), (0.0, 0.0, 4.0, 3.0), (30, 40))
        self.assertTrue(np.all(pixels == frames.NOTHING))

    def test_levels_end_with_the_scale(self):
        self.assertEqual([0, 0, frames.COLOURS - 1, frames.COLOURS - 1], list(frames.levels(np.array([-9.0, -1.0, 1.0, 9.0]), -1.0, 1.0)))

    def test_a_player_that_is_too_large_shows_fewer_frames(self):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "run.h5"
            synthetic_run.write(path, size=2.0, frames=20)
            with Run(path) as run:
                whole = frames.Player([run], ["a"])
                self.assertEqual(20, len(whole.times))
                # The pulse peaks at 0.6 s; the frames up to 0.38 s hold its rise, most of which comes late.
                self.assertGreater(whole.times[whole.start()], 0.2)
                with mock.patch.object(frames, "MOST_BYTES", whole._bytes() // 2):
                    thin = frames.Player([run], ["a"])
                self.assertIn(len(thin.times), (5, 10))
                for field in thin.content()["fields"]:
                    for panel in field["panels"]:
                        self.assertEqual(len(thin.times), len(panel["images"]))


def refusal(*arguments):
    error = io.StringIO()
    with contextlib.redirect_stderr(error):
        status = main([str(a) for a in arguments])
    return status, error.getvalue()


class Refused(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = Path(temporary.name)

    def test_damaged_studies_are_named(self):
        with h5py.File(self.folder / "test.h5", "w") as file:
            file.attrs["content"] = np.bytes_("soil test")
        with h5py.File(self.folder / "column.h5", "w") as file:
            file.attrs["content"] = np.bytes_("column")
        for name in ("swap", "cost"):
            (self.folder / name).mkdir()
            (self.folder / name / f"{name}.json").write_text(json.dumps([]))
        for name, kind in (("test.h5", "soiltest"), ("column.h5", "column"), ("swap", "swap"), ("cost", "cost")):
            with self.subTest(name):
                self.assertEqual(kind, kinds.kind_of(self.folder / name))
                status, error = refusal("report", self.folder / name)
                self.assertEqual(1, status)
                self.assertIn(f"tremolo: {self.folder / name}: ", error)

    def test_runs_and_studies_stand_in_one_page(self):
        synthetic_run.write(self.folder / "run.h5", size=2.0, frames=2)
        synthetic_site.write_column(self.folder / "column.h5", "fe")
        with mock.patch("tremolo.report.checklist.checklist", return_value=facts.Table([], [], "")):
            self.assertEqual(0, main(["report", str(self.folder / "run.h5"), str(self.folder / "column.h5")]))
        page = (self.folder / "report.html").read_text()
        for text in ("synthetic slope", "synthetic site", "free field alone, model fe", "study-0-0-0", "history-crest"):
            self.assertIn(text, page)

    def test_a_run_without_frames(self):
        path = self.folder / "run.h5"
        synthetic_run.write(path, size=2.0, frames=2)
        with h5py.File(path, "a") as file:
            for name in list(file["frames"]):
                del file["frames"][name]
        status, error = refusal("report", path)
        self.assertEqual(1, status)
        self.assertIn("holds no particle frame yet", error)

    def test_without_its_libraries_it_says_which_packages_bring_them(self):
        path = self.folder / "run.h5"
        synthetic_run.write(path, size=2.0, frames=2)
        with mock.patch.dict("sys.modules", {"jinja2": None}):
            status, error = refusal("report", path)
        self.assertEqual(1, status)
        self.assertIn("needs the Debian packages python3-jinja2 and python3-plotly", error)


class Measures(unittest.TestCase):
    def test_arias_intensity_and_duration_of_a_steady_motion(self):
        # a = 2 m/s2 for 10 s: pi/(2 g) a^2 T, and 90 % of it in 9 s.
        arias, duration = facts._duration(np.full(1000, 2.0), 0.01)
        self.assertAlmostEqual(np.pi / (2.0 * 9.80665) * 4.0 * 10.0, arias, places=9)
        self.assertAlmostEqual(9.0, duration, delta=0.02)


try:
    import plotly  # noqa: F401  (charts need it)
    from tremolo.report import charts
except ImportError:
    charts = None


@unittest.skipIf(charts is None, "python3-plotly is missing (scripts/setup.sh installs it)")
class Lines(unittest.TestCase):
    def test_points_are_few_and_no_peak_is_lost(self):
        values = np.sin(np.linspace(0.0, 300.0, 20001))
        values[12345] = 9.0
        values[777] = -8.0
        chosen = charts.kept(values)
        self.assertLessEqual(len(chosen), charts.MOST_POINTS + 2)
        self.assertTrue({0, 777, 12345, 20000} <= set(chosen.tolist()))
        self.assertTrue(np.all(np.diff(chosen) > 0))
        np.testing.assert_array_equal(np.arange(900), charts.kept(values[:900]))


@unittest.skipIf(charts is None, "python3-plotly is missing (scripts/setup.sh installs it)")
class OfARunThatIsNotComplete(unittest.TestCase):
    def test_has_what_there_is(self):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "run.h5"
            synthetic_run.write(path, size=2.0, frames=5, water=True, structures=True)
            with h5py.File(path, "a") as file:
                file.attrs["status"] = np.bytes_("aborted: <b>killed</b> & gone")
                for name in ("energy", "timings", "processes", "timeline", "plan"):
                    file.pop(name, None)
            self.assertEqual((0, ""), refusal("report", path))
            text = (Path(folder) / "report.html").read_text(encoding="utf-8")
        # What a run says of itself is text, never markup.
        self.assertIn("run aborted: &lt;b&gt;killed&lt;/b&gt; &amp; gone", text)
        self.assertIn("Shown when a run has ended well.", text)
        for section in ("frames", "monitors", "structures", "water", "drift"):
            self.assertIn(f'<section id="{section}">', text)
        self.assertNotIn('<section id="energy">', text)


if __name__ == "__main__":
    unittest.main()
