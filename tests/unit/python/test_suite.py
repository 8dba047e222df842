"""Many site responses of one site: medians and deviations of curves whose statistics are known, and what a sweep makes of its runs."""

import contextlib
import csv
import io
import json
import tempfile
import unittest
from pathlib import Path

import numpy as np

import synthetic_site
from tremolo import figures
from tremolo.__main__ import main
from tremolo.run import Run
from tremolo.site import suite, suite_pictures
from tremolo.site.read import Model
from tremolo.sweep import measures, site_responses, statistics, task
from tremolo.sweep.plan import Plan

MODELS, MOTIONS = ["eql", "wave"], ["a", "b", "c"]
SIGMA = 0.2
DEVIATIONS = np.array([-1.0, 0.0, 1.0])  # of a realisation, in sigmas: the mean is 0, the variance of three 1


class OfCurves(unittest.TestCase):
    def test_median_and_deviation_are_those_of_the_logarithm(self):
        curves = suite.Curves(np.array([1.0, 2.0]), np.exp(np.outer(DEVIATIONS, [0.1, 0.3])) * [2.0, 5.0])
        median, sigma = curves.statistics()
        np.testing.assert_allclose(median, [2.0, 5.0], rtol=1e-14)
        np.testing.assert_allclose(sigma, [0.1, 0.3], rtol=1e-12)

    def test_places_where_fewer_than_half_have_a_value_are_left_out(self):
        values = np.array([[1.0, np.nan, 0.0], [np.e, np.nan, 2.0], [np.e**2, 4.0, 2.0]])
        median, sigma = suite.Curves(np.arange(3.0), values).statistics()
        np.testing.assert_allclose(median, [np.e, np.nan, 2.0])
        np.testing.assert_allclose(sigma, [1.0, np.nan, 0.0], atol=1e-15)

    def test_one_response_has_no_deviation(self):
        median, sigma = suite.Curves(np.arange(2.0), np.array([[3.0, 4.0]])).statistics()
        np.testing.assert_array_equal(median.round(12), [3.0, 4.0])
        self.assertTrue(np.isnan(sigma).all())


def written(folder, failed=()):
    """A sweep of three motions and two models: the surface has exp(SIGMA z) times the factor of the model, and Vs exp(SIGMA z) times
    that of the site."""
    runs = [(motion, model) for motion in MOTIONS for model in MODELS]
    content = {
        "title": "by hand", "study": "none.toml", "case": "case.toml", "keeps_recordings": False,
        "axes": [{"key": "motion.file", "unit": ""}, {"key": "random_profile.realisation", "unit": ""}, {"key": "model", "unit": ""}],
        "measures": {"failure_strain": 0.1, "intensity": "pgv", "colour": "model", "draw": [], "spectral_ratio": None},
        "runs": [{"name": f"{number:04}", "values": [motion, MOTIONS.index(motion) + 1, model], "model": model, "inputs": "",
                  "free_fields": None, "motion": None} for number, (motion, model) in enumerate(runs, 1)],
    }
    (folder / "sweep.json").write_text(json.dumps(content))
    plan = Plan(folder)
    for run, (motion, model) in zip(plan.runs, runs):
        if run.name in failed:
            run.write_result(status="failed", message="it broke", replayed=None, settings=None, measures={})
            continue
        run.folder.mkdir(parents=True)
        spread = np.exp(SIGMA * DEVIATIONS[MOTIONS.index(motion)])
        synthetic_site.write_column(run.column, model, synthetic_site.FACTORS[model] * spread, synthetic_site.VS * spread)
        task.measure(run, plan.settings, None)
    return plan


class OfASweep(unittest.TestCase):
    def setUp(self):
        place = tempfile.TemporaryDirectory()
        self.addCleanup(place.cleanup)
        self.folder = Path(place.name)

    def test_a_family_a_model(self):
        found = site_responses.families(statistics.Sweep(written(self.folder)))
        self.assertEqual([(model, 3) for model in MODELS], [(family.name, len(family.responses)) for family in found])
        for family in found:
            factor = synthetic_site.FACTORS[family.name]
            for of in (suite.spectral_amplification, suite.fourier_amplification):
                median, sigma = of(family.responses).statistics()
                known = np.isfinite(median)
                self.assertGreater(known.sum(), 20)
                np.testing.assert_allclose(median[known], factor, rtol=1e-12)
                np.testing.assert_allclose(sigma[known], SIGMA, rtol=1e-9)
            for of, median in ((suite.speeds, synthetic_site.VS),
                               (lambda responses: suite.peaks(responses, "peak_ax"), factor * np.abs(synthetic_site.pulse()[1]).max())):
                curves = of(family.responses)
                np.testing.assert_allclose(curves.statistics()[0], median, rtol=1e-12)
                np.testing.assert_allclose(curves.statistics()[1], SIGMA, rtol=1e-9)

    def test_runs_of_one_model_are_one_family_without_a_name(self):
        plan = written(self.folder)
        plan.settings["colour"] = ""
        for run in plan.runs:
            run.values[2] = "eql"
        (family,) = site_responses.families(statistics.Sweep(plan))
        self.assertEqual(("", 6), (family.name, len(family.responses)))

    def test_a_run_that_failed_is_left_out(self):
        found = site_responses.families(statistics.Sweep(written(self.folder, failed=("0001",))))
        self.assertEqual({"eql": 2, "wave": 3}, {family.name: len(family.responses) for family in found})

    def test_measures_have_the_units_of_their_names(self):
        path = self.folder / "eql.h5"
        synthetic_site.write_column(path, "eql")
        with Run(path) as run:
            found = suite.measured(Model("eql", run))
        self.assertAlmostEqual(1.5 * np.abs(synthetic_site.pulse()[1]).max(), found["surface.pga_m_s2"])
        self.assertEqual(["m/s2", "m/s", "1", "m", "m/s", "s"], [measures.unit(name) for name in (
            "surface.pga_m_s2", "surface.arias_m_s", "largest_strain", "largest_strain_depth_m", "site.vs30_m_s", "cpu_s")])
        self.assertEqual((0.2, 394.0), (found["site.period_s"], found["site.vs30_m_s"]))

    def test_pictures_and_tables_are_written(self):
        sweep = statistics.Sweep(written(self.folder))
        names = [Path(path).relative_to(self.folder).as_posix() for path in site_responses.write(sweep)]
        self.assertEqual(["spectra.png", "amplification.png", "profiles.png"], names[:3])
        heading, *rows = csv.reader((self.folder / "tables/spectra.csv").read_text().splitlines())
        self.assertEqual(["period_s", "eql_surface_median_g", "eql_surface_sigma_ln_1", "wave_surface_median_g", "wave_surface_sigma_ln_1"],
                         heading[:5])
        column = np.array([row[2] for row in rows], dtype=float)
        np.testing.assert_allclose(column, SIGMA, rtol=1e-6)
        self.assertEqual(["depth_m", "eql_vs_median_m_s"], (self.folder / "tables/profile_vs.csv").read_text().split(",")[:2])

    def test_every_panel_has_its_curves_median_and_deviations(self):
        responses = site_responses.families(statistics.Sweep(written(self.folder)))
        for name, figure in suite_pictures.of_suite(responses).items():
            for ax in figure.axes:
                self.assertGreaterEqual(len(ax.get_lines()), 2, name)
                self.assertTrue(ax.get_xlabel() or ax.get_shared_x_axes().get_siblings(ax), name)
            self.assertTrue(any(ax.get_legend() for ax in figure.axes), name)
            suite_pictures.style.plt.close(figure)

    def test_plot_and_report_take_the_sweep(self):
        written(self.folder)
        found = figures.of_study(self.folder)
        self.assertEqual(["sweep", "spectra", "amplification", "profiles"], list(found))
        for figure in found.values():
            suite_pictures.style.plt.close(figure)
        with contextlib.redirect_stdout(io.StringIO()):
            self.assertEqual(0, main(["report", str(self.folder)]))
        page = (self.folder / "report.html").read_text()
        for text in ("Response spectra, 5 %: median and standard deviation of the logarithm", "Vs at small strain", "eql, median of 3"):
            self.assertIn(text, page)


if __name__ == "__main__":
    unittest.main()
