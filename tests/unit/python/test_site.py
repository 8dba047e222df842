"""A site under several models: tables, amplification, pictures and the report, of a site whose answers are known."""

import contextlib
import csv
import io
import tempfile
import unittest
from pathlib import Path

import numpy as np

import synthetic_run
import synthetic_site
from tremolo.__main__ import main
from tremolo.report import kinds, spectra
from tremolo.site import amplification, pictures, tables
from tremolo.site.read import Site


class Smoothing(unittest.TestCase):
    def test_the_window_is_that_of_konno_and_ohmachi(self):
        """At b log10(f/f_c) = k pi/2 it is (2/(k pi))^4 for odd k, 0 for even ones, and 1 at f_c."""
        centre, places = 2.0, np.arange(-3, 4)
        lines = centre * 10.0 ** (places * np.pi / (2.0 * spectra.BANDWIDTH))
        window = np.array([(2.0 / (3.0 * np.pi)) ** 4, 0.0, (2.0 / np.pi) ** 4, 1.0, (2.0 / np.pi) ** 4, 0.0, (2.0 / (3.0 * np.pi)) ** 4])
        for number in range(len(lines)):
            single = np.zeros(len(lines))
            single[number] = 1.0
            found = spectra.smoothed(lines, single, np.array([centre]))[0]
            self.assertAlmostEqual(window[number] / window.sum(), found, delta=1e-13)


class OfASite(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = Path(folder.name)
        synthetic_site.write(cls.folder)
        cls.site = Site(cls.folder)

    def test_models_in_the_order_of_the_command_and_those_refused(self):
        self.assertEqual(list(synthetic_site.FACTORS), list(self.site.models))
        self.assertEqual({"ode": "knows vertical incidence only"}, self.site.refused)
        self.assertEqual([("eql", "shear strain reaches 0.2 %")], self.site.warnings())

    def test_amplification_is_the_factor_raw_and_smoothed(self):
        for name, model in self.site.models.items():
            for ratio in (amplification.raw, amplification.smoothed):
                frequency, values = ratio(model, "outcrop")
                known = values[np.isfinite(values)]
                self.assertGreater(len(known), 0.2 * len(frequency))
                np.testing.assert_allclose(known, synthetic_site.FACTORS[name], rtol=1e-12)

    def test_spectra_are_in_g_and_scale_with_the_factor(self):
        found = tables.spectra(self.site)
        for name, factor in synthetic_site.FACTORS.items():
            np.testing.assert_allclose(found[f"{name}_g"], factor * found["outcrop_g"], rtol=1e-12)
        # A stiff oscillator moves with the ground.
        self.assertAlmostEqual(np.abs(synthetic_site.pulse()[1]).max() / 9.80665, found["outcrop_g"][0], delta=0.01 * found["outcrop_g"][0])

    def test_profiles_begin_at_the_surface(self):
        found = tables.profile(self.site.models["fe"])
        self.assertEqual((0.0, synthetic_site.DEPTH), (found["depth_m"][0], found["depth_m"][-1]))
        self.assertTrue(np.all(np.diff(found["depth_m"]) > 0.0))
        np.testing.assert_allclose(found["peak_sxy_Pa"][1:] / found["effective_stress_Pa"][1:], found["stress_ratio_1"][1:], rtol=1e-12)

    def test_tables_are_written_with_a_unit_in_each_heading(self):
        folder = self.folder / "tables"
        folder.mkdir()
        written = {path.stem: list(csv.reader(path.read_text().splitlines())) for path in tables.write(self.site, folder)}
        self.assertEqual({"models", "layers", "site", "measures", "spectra", "amplification", "amplification_raw", "profile_eql",
                          "profile_fe", "profile_wave", "strain_compatible_eql"}, set(written))
        for name, (heading, *rows) in written.items():
            self.assertTrue(all(len(row) == len(heading) for row in rows), name)
        self.assertEqual(["eql", "linear", f"{1.5 * np.abs(synthetic_site.pulse()[1]).max() / 9.80665:.9g}"], written["models"][1][:3])
        self.assertEqual("", written["layers"][2][2])  # the half-space has no bottom

    def test_every_panel_has_names_and_lines(self):
        for name, figure in pictures.of_site(self.site).items():
            for ax in figure.axes:
                self.assertTrue(ax.get_lines(), name)
                self.assertTrue(ax.get_xlabel() or ax.get_shared_x_axes().get_siblings(ax), name)
            self.assertTrue(any(ax.get_legend() for ax in figure.axes) or name.startswith("strain"), name)

    def test_the_command_writes_tables_pictures_and_one_page(self):
        with tempfile.TemporaryDirectory() as folder, contextlib.redirect_stdout(io.StringIO()) as said:
            synthetic_site.write(folder)
            self.assertEqual("site", kinds.kind_of(folder))
            self.assertEqual("column", kinds.kind_of(Path(folder) / "fe.h5"))
            self.assertEqual(0, main(["site", folder]))
            page = (Path(folder) / "report.html").read_text()
        self.assertIn("profiles.png", said.getvalue())
        for text in ("eql: shear strain reaches 0.2 %", "ode cannot compute this site: knows vertical incidence only",
                     "Strain-compatible soil, eql", "synthetic site"):
            self.assertIn(text, page)


class Commands(unittest.TestCase):
    """`plot`, `compare` and `extract` of free fields alone, as of runs."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        synthetic_site.write(self.folder)
        self.fe, self.wave = self.folder / "fe.h5", self.folder / "wave.h5"

    def said(self, *words, status=0):
        with contextlib.redirect_stdout(io.StringIO()) as out, contextlib.redirect_stderr(io.StringIO()) as error:
            self.assertEqual(status, main([str(word) for word in words]), error.getvalue())
        return out.getvalue() + error.getvalue()

    def test_plot_draws_a_free_field_and_a_site(self):
        self.said("plot", self.fe)
        self.assertTrue((self.folder / "pictures/fe.png").exists())
        self.said("plot", self.folder, "--out", self.folder / "drawn")
        self.assertTrue((self.folder / "drawn/amplification.png").exists())
        self.assertIn("no frames", self.said("plot", self.fe, "--time", "1", status=1))

    def test_compare_sets_peaks_beside_each_other(self):
        lines = self.said("compare", self.fe, self.wave).splitlines()
        row = next(line.split() for line in lines if line.startswith("surface") and "a, m/s" in line)
        self.assertAlmostEqual(synthetic_site.FACTORS["wave"] / synthetic_site.FACTORS["fe"], float(row[-3]), places=3)
        for name in ("histories", "surface", "spectra", "amplification", "profiles"):
            self.assertTrue((self.folder / f"pictures/compare_{name}.png").exists(), name)
        self.assertIn("is a study", self.said("compare", self.fe, self.folder, status=1))

    def test_compare_sets_a_run_beside_a_free_field(self):
        synthetic_run.write(self.folder / "run.h5", size=2.0, frames=2)
        self.assertIn("no monitor is common", self.said("compare", self.folder / "run.h5", self.fe))

    def test_extract_writes_histories_ratios_and_profiles(self):
        self.said("extract", self.fe, "--base", "10 m", "--out", self.folder / "out")
        ratio = np.genfromtxt(self.folder / "out/fourier_ratio_surface_over_10_m.csv", delimiter=",", names=True)
        known = ratio["fourier_ratio_x"][np.isfinite(ratio["fourier_ratio_x"])]
        np.testing.assert_allclose(known, synthetic_site.FACTORS["fe"], rtol=1e-6)
        for name in ("history_surface", "profile_fe", "layers"):
            self.assertTrue((self.folder / f"out/{name}.csv").exists(), name)
        self.assertIn("surface, 10 m", self.said("extract", self.fe, "--point", "0 m", status=1).replace("10 m, surface", "surface, 10 m"))


if __name__ == "__main__":
    unittest.main()
