"""Every command of the package on a small synthetic run; the fronts' apparent velocity against the known one."""

import contextlib
import io
import itertools
import json
import tempfile
import unittest
from pathlib import Path

import h5py
import matplotlib.image
import numpy as np
from matplotlib.text import Text

import synthetic_run
from tremolo import Run, bodies, comparison, drift, histories, motion, pore_pressure, style
from tremolo.pictures import fronts, maps, preview, profile, stages
from tremolo.__main__ import main


def run_command(*arguments):
    """Exit status, lines on stdout, stderr."""
    out, error = io.StringIO(), io.StringIO()
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(error):
        status = main([str(a) for a in arguments])
    return status, out.getvalue().splitlines(), error.getvalue()


class Pictures(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = Path(cls.temporary.name)
        for angle in (0, 15):
            (cls.folder / str(angle)).mkdir()
            synthetic_run.write(cls.folder / str(angle) / "run.h5", angle_deg=float(angle), size=2.0)

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def expect_pictures(self, paths, names):
        self.assertEqual([Path(p).name for p in paths], names)
        for path in paths:
            pixels = matplotlib.image.imread(path)
            self.assertGreater(pixels.shape[1], 500)
            self.assertGreater(pixels[..., :3].std(), 0.02, f"{path} is empty")

    def test_plot(self):
        status, paths, error = run_command("plot", self.folder / "15", "--time", 0.8)
        self.assertEqual((status, error), (0, ""))
        names = ["model.png", "acceleration.png", "shear_bands.png", "monitor_crest.png", "energy.png", "fronts.png"]
        self.expect_pictures(paths, names)

    def model(self, name, table=False, **attributes):
        """The texts of the picture of a model, and its axes."""
        path = self.folder / f"{name}.h5"
        synthetic_run.write(path, frames=1, size=2.0, structures=True)
        with h5py.File(path, "a") as file:
            file.attrs.update(attributes)
            if table:
                file.copy("monitors/crest", "shaking_table")
            for number, x in enumerate((45.5, 46.0, 46.5)):  # closer to each other than their names are long
                file.copy("monitors/crest", f"monitors/beside {number}")
                rows = file[f"monitors/beside {number}"]
                values = rows[()]
                values[:, 1] = x
                rows[...] = values
        with Run(path) as run:
            figure = preview.drawn(run)
        self.addCleanup(style.plt.close, figure)
        return {text.get_text(): text for text in figure.axes[0].texts if text.get_text()}, figure.axes[0]

    def test_model_has_the_dimensions_of_its_box(self):
        # Particles of 1 m: their centres are 69 m apart, and 19 and 29 m above each other.
        texts, _ = self.model("levels", surface_levels=[0.0, 10.0])
        self.assertLessEqual({"70 m", "20 m", "30 m"}, set(texts))
        # A container has no free field, so that its levels say nothing of the ground in it.
        texts, _ = self.model("contained", surface_levels=[0.0, 0.0])
        self.assertLessEqual({"70 m", "20 m", "30 m"}, set(texts))
        texts, _ = self.model("half", box=[0.0, -20.25, 70.5, 10.0], surface_levels=[0.0, 10.0])
        self.assertLessEqual({"70.5 m", "20.25 m", "30.25 m"}, set(texts))

    def test_labels_of_the_model_do_not_overlap(self):
        texts, axes = self.model("labels", water_table=-2.0)
        names = ["crest", "beside 0", "beside 1", "beside 2", "tunnel", "block", "water table, y = -2 m", "free field",
                 "transmitting base", "70 m"]
        boxes = {name: Text.get_window_extent(texts[name]) for name in names} | {"legend": axes.get_legend().get_window_extent()}
        for (one, box), (other, beside) in itertools.combinations(boxes.items(), 2):
            self.assertFalse(box.overlaps(beside), f"{one} and {other}")

    def test_a_shaking_table_is_called_so(self):
        texts, _ = self.model("on ground")
        self.assertLessEqual({"free field", "transmitting base", "incident SV wave,\n$\\beta$ = 15° from the vertical"}, set(texts))
        texts, _ = self.model("on a table", table=True)
        self.assertLessEqual({"wall", "shaking table"}, set(texts))
        self.assertFalse({"free field", "transmitting base"} & set(texts) or [text for text in texts if "incident" in text])

    def test_the_water_table_is_drawn(self):
        texts, axes = self.model("table", water_table=-2.5)
        self.assertIn("water table, y = -2.5 m", texts)
        self.assertIn(([0.0, 70.0], [-2.5, -2.5]), [(list(line.get_xdata()), list(line.get_ydata())) for line in axes.lines])
        texts, axes = self.model("line", phreatic_line=[0.0, -1.0, 30.0, -2.0, 70.0, -4.0])
        self.assertIn("phreatic surface", texts)
        self.assertIn(([0.0, 30.0, 70.0], [-1.0, -2.0, -4.0]), [(list(line.get_xdata()), list(line.get_ydata())) for line in axes.lines])
        texts, _ = self.model("dry")
        self.assertFalse([text for text in texts if "water" in text])

    def test_stages_show_where_their_water_stands(self):
        folder = self.folder / "staged"
        waters = {"1 gravity": {"water_table": -2.0}, "2 flood": {"phreatic_line": [0.0, 1.0, 70.0, -2.0]}, "3 dry": {}}
        for name, attributes in waters.items():
            path = folder / "stages" / name / "run.h5"
            path.parent.mkdir(parents=True)
            synthetic_run.write(path, frames=1, size=2.0)
            with h5py.File(path, "a") as file:
                file.attrs.update(attributes)
                count = len(file["frames/0000/position"])
                file["frames/0000/displacement"] = np.ones((count, 2))
                file["frames/0000/stress"] = -np.ones((count, 4))
        synthetic_run.write(folder / "run.h5", frames=1, size=2.0)
        with Run(folder / "run.h5") as run:
            figure = stages.figure_of(run)
        self.addCleanup(style.plt.close, figure)
        drawn = {axes.get_title(loc="left"): [list(line.get_ydata()) for line in axes.lines] for axes in figure.axes}
        self.assertEqual(([[-2.0, -2.0]], [[1.0, -2.0]], []), tuple(drawn[name] for name in ("gravity", "flood", "dry")))

    def test_motion_beside_the_spectrum_that_it_was_matched_to(self):
        target = {"period": np.array([0.1, 1.0]), "acceleration": np.array([4.903325, 1.96133])}
        spectrum = {"period": np.array([0.1, 1.0]), "acceleration": np.array([4.8, 2.0])}
        figure, ax = style.plt.subplots()
        motion._draw_response(ax, spectrum, 0.05, target)
        drawn = {line.get_label(): line.get_ydata() for line in ax.get_lines()}
        style.plt.close(figure)
        np.testing.assert_allclose(drawn["target"], [4.903325, 1.96133])
        np.testing.assert_allclose(drawn["motion"], [4.8, 2.0])

    def test_plot_of_structures_in_ground_with_pore_water(self):
        run = self.folder / "built"
        run.mkdir()
        synthetic_run.write(run / "run.h5", size=2.0, frames=60, water=True, structures=True)
        status, paths, error = run_command("plot", run, "--time", 0.8)
        self.assertEqual((status, error), (0, ""))
        names = ["model.png", "acceleration.png", "shear_bands.png", "pore_pressure_ratio.png", "pore_water.png", "bodies.png",
                 "contact_block.png", "drift.png", "monitor_crest.png", "energy.png", "fronts.png"]
        self.expect_pictures(paths, names)
        status, lines, error = run_command("compare", run, run, "--time", 0.8, "--out", self.folder / "w")
        self.assertEqual((status, error), (0, ""))
        self.assertIn(str(self.folder / "w" / "compare_pore_pressure_ratio.png"), lines)

    def test_drift_of_sides_and_base(self):
        path = self.folder / "drift.h5"
        synthetic_run.write(path, frames=1, size=2.0, structures=True)
        with Run(path) as run:
            figure = drift.figure_of(run)
        self.addCleanup(style.plt.close, figure)
        base, right = figure.axes
        _, vertical = base.get_lines()[:2]
        self.assertAlmostEqual(min(vertical.get_ydata()), -1e3 * synthetic_run.DRIFT, delta=0.01)
        horizontal, _ = right.get_lines()[:2]
        self.assertAlmostEqual(max(horizontal.get_xdata()), 29.75)
        self.assertEqual(horizontal.get_ydata()[-1], 9.75)

    def test_layers_of_the_free_fields_stand_beside_the_sides_in_the_colours_of_their_soils(self):
        synthetic_run.write(self.folder / "layers.h5", size=2.0)
        layers = [{"top_m": 10.0, "bottom_m": 4.0, "soil": "base layer"}, {"top_m": 4.0, "bottom_m": -30.0, "soil": None}]
        with h5py.File(self.folder / "layers.h5", "r+") as file:
            file["plan"] = np.bytes_(json.dumps({"free_field": {"left": layers[1:], "right": layers}}))
        with Run(self.folder / "layers.h5") as run:
            figure, ax = style.plt.subplots()
            left, upper, lower = profile.draw(ax, run, np.array([0.0, -20.0]), np.array([70.0, 10.0]))
            style.plt.close(figure)
        self.assertLess(left.get_x() + left.get_width(), 0.0)
        self.assertGreater(upper.get_x(), 70.0)
        self.assertEqual((4.0, 6.0), (upper.get_y(), upper.get_height()))
        self.assertEqual((-20.0, 24.0), (lower.get_y(), lower.get_height()))  # no deeper than the domain
        self.assertEqual(style.matplotlib.colors.to_rgba(style.SOIL_COLOURS[1]), upper.get_facecolor())
        self.assertEqual("elastic layer", lower.get_label())

    def test_structures_are_filled_where_they_are_and_their_holes_open(self):
        synthetic_run.write(self.folder / "tunnel.h5", size=2.0, structures=True)
        with Run(self.folder / "tunnel.h5") as run:
            figure, ax = style.plt.subplots()
            bodies.draw(ax, run, len(run.times) - 1)
            tunnel, block = ax.patches
            risen = synthetic_run.TUNNEL + [0.0, synthetic_run.RISE * run.times[-1]]
            inner, outer = tunnel.get_path().to_polygons(closed_only=True)[::-1]
            np.testing.assert_allclose(outer.mean(axis=0), risen, atol=0.06)

            def area(ring):
                x, y = ring.T
                return 0.5 * np.sum(x[:-1] * y[1:] - x[1:] * y[:-1])

            self.assertAlmostEqual(np.pi * 2.5**2, area(outer), delta=0.1)
            self.assertAlmostEqual(-np.pi * 2.2**2, area(inner), delta=0.1)  # against its outline: not filled
            self.assertAlmostEqual(8.0, area(block.get_path().to_polygons()[0]))
            style.plt.close(figure)

    def test_a_monitor_follows_the_effective_stress(self):
        synthetic_run.write(self.folder / "traced.h5", size=2.0, water=True)
        with Run(self.folder / "traced.h5") as run:
            (trace,) = pore_pressure.traces(pore_pressure.wet_monitors(run))
        self.assertEqual("crest", trace.label)
        np.testing.assert_allclose(trace.ratio, synthetic_run.pore_pressure_ratio(trace.time))
        np.testing.assert_allclose(trace.effective, 5e4 * (1.0 - trace.ratio))  # total stress does not change

    def test_dry_ground_has_no_picture_of_water(self):
        with Run(self.folder / "15") as run:
            self.assertIsNone(pore_pressure.monitors(run, self.folder))

    def test_times_of_a_high_model_lie_side_by_side(self):
        sizes = {}
        for width in (16.0, 70.0):
            synthetic_run.write(self.folder / "wide.h5", size=2.0, width=width)
            with Run(self.folder / "wide.h5") as run:
                picture = maps.acceleration([run], [0.4, 0.8, 1.2], self.folder, f"wide_{width}.png")
            sizes[width] = matplotlib.image.imread(picture).shape
        self.assertGreater(sizes[16.0][1], 1.5 * sizes[16.0][0])
        self.assertLess(sizes[70.0][1], 1.5 * sizes[70.0][0])

    def test_compare(self):
        runs = self.folder / "0", self.folder / "15"
        status, lines, error = run_command("compare", *runs, "--out", self.folder / "c", "--time", 0.8)
        self.assertEqual((status, error), (0, ""))
        paths = [line for line in lines if line.endswith(".png")]
        self.expect_pictures(paths, ["compare_histories.png", "compare_acceleration.png", "compare_shear_bands.png"])
        with Run(runs[0]) as first, Run(runs[1]) as second:
            peaks = [np.max(np.hypot(series["vx"], series["vy"])) for series in (run.monitor("crest") for run in (first, second))]
            velocity = next(line for line in lines if line.startswith("crest") and "v, m/s" in line).split()
            np.testing.assert_allclose([float(number) for number in velocity[3:5]], peaks, rtol=1e-3)
            self.assertAlmostEqual(float(velocity[5]), peaks[1] / peaks[0], delta=1e-3)

    def test_a_run_compared_with_itself_does_not_differ(self):
        with Run(self.folder / "15") as run:
            rows = [line.split() for line in comparison.lines(run, run)][1:]
        self.assertEqual({row[-2] for row in rows}, {"0.00"})
        self.assertEqual({row[-3] for row in rows} - {"-"}, {"1.000"})

    def test_of_runs_of_different_length_the_common_time_counts(self):
        (self.folder / "short").mkdir(exist_ok=True)
        synthetic_run.write(self.folder / "short" / "run.h5", angle_deg=15.0, size=2.0, frames=40)  # before the wave's peak
        with Run(self.folder / "15") as run, Run(self.folder / "short") as short:
            for pair in ((run, short), (short, run)):
                told, _, *lines = comparison.lines(*pair)
                self.assertRegex(told, r"^until 0\.795 s, where the shorter run ends")
                rows = [line.split() for line in lines if " a, " not in line]  # a is a one-sided slope at the end
                self.assertEqual({row[-2] for row in rows}, {"0.00"})
                self.assertEqual({row[-3] for row in rows} - {"-"}, {"1.000"})

    def test_time_outside_the_run_is_refused(self):
        status, _, error = run_command("plot", self.folder / "15", "--time", 99)
        self.assertEqual(status, 1)
        self.assertIn("time 99 s lies outside the run's frames, 0 to 1.98 s", error)

    def test_a_file_where_a_folder_is_wanted_is_one_line(self):
        file = self.folder / "file.txt"
        file.write_text("kept")
        runs = self.folder / "15", self.folder / "15"
        for command in (["plot", runs[0]], ["compare", *runs], ["extract", runs[0]]):
            for out in (file, file / "below"):
                status, lines, error = run_command(*command, "--out", out)
                self.assertEqual((1, [], f"tremolo: cannot make the folder {out}: {file} is no folder\n"), (status, lines, error))
        for out, reason in ((file / "page.html", f"cannot make the folder {file}: {file} is no folder"),
                            (self.folder, f"{self.folder}: is a folder; give the name of a file")):
            status, lines, error = run_command("report", runs[0], "--out", out)
            self.assertEqual((1, [], f"tremolo: {reason}\n"), (status, lines, error))
        self.assertEqual("kept", file.read_text())

    def test_absent_run_is_one_line(self):
        status, _, error = run_command("plot", self.folder / "nowhere")
        self.assertEqual(status, 1)
        self.assertEqual(error.count("\n"), 1)
        self.assertIn("no such run", error)

    def test_apparent_velocity_of_the_fronts(self):
        with Run(self.folder / "15") as run:
            p = fronts.slowness(*fronts.base_traces(run))
        self.assertAlmostEqual(p * synthetic_run.C_S / np.sin(np.radians(15.0)), 1.0, delta=0.01)
        with Run(self.folder / "0") as run:
            self.assertLess(abs(fronts.slowness(*fronts.base_traces(run))), fronts.PARALLEL)

    def test_verification(self):
        folder = self.folder / "verified"
        folder.mkdir()
        x, y = np.meshgrid(np.arange(0.5, 40.0), np.arange(-19.5, 0.0))
        summary = {"mesh_size": 2.0, "regions": [{"name": "interior", "relative_l2": 0.02}]}
        (folder / "verify.json").write_text(json.dumps(summary))
        with h5py.File(folder / "verify.h5", "w") as file:

            def table(path, **columns):
                group = file.create_group(path)
                group.attrs["columns"] = np.array([c.encode() for c in columns])
                for column, values in columns.items():
                    group[column] = values

            table("particles", x=x.ravel(), y=y.ravel(), relative_error=0.02 * np.abs(np.sin(x)).ravel())
            table("points", name=np.array([b"middle", b"surface"]), x=[20.0, 20.0], y=[-10.0, 0.0])
            t = np.linspace(0.0, 2.0, 100)
            for name in ("middle", "surface"):
                exact = synthetic_run.ricker(t)
                table(f"histories/{name}", time=t, exact_vx=exact, exact_vy=0 * t, vx=1.02 * exact, vy=0 * t)
        status, paths, error = run_command("verify-picture", folder)
        self.assertEqual((status, error), (0, ""))
        self.expect_pictures(paths, ["verify.png"])


class EvenSteps(unittest.TestCase):
    def test_uneven_times_are_resampled(self):
        time = np.array([0.0, 0.1, 0.2, 0.25, 0.35, 0.45])
        values, dt = histories.even_steps(time, 3.0 * time)
        self.assertAlmostEqual(dt, 0.1)
        np.testing.assert_allclose(values, 3.0 * np.arange(0.0, 0.5, 0.1))


if __name__ == "__main__":
    unittest.main()
