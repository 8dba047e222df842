"""The picture of every kind of soil test, and what a file that is none is told."""

import tempfile
import unittest
from pathlib import Path

import h5py
import matplotlib.image
import numpy as np

import synthetic_soiltest
from test_pictures import run_command
from tremolo.soil_test import drawing, record, view

CURVES = {
    "strength_curve": {
        "stress_ratio": [0.1, 0.12], "cycles_1pc": [20.0, 8.0], "cycles_3pc": [25.0, 10.0],
        "cycles_5pc": [np.nan, np.nan], "cycles_ru98": [np.nan, 7.0],
    },
    "strength_target": {"cycles": [5.0, 15.0, 30.0], "stress_ratio": [0.15, 0.12, 0.09]},
}
MODULUS = {
    "modulus_curve": {
        "strain_amplitude": [1e-6, 1e-4, 1e-2], "shear_modulus": [60e6, 45e6, 5e6], "modulus_ratio": [1.0, 0.75, 0.08],
        "damping": [0.0, 0.05, 0.3],
    }
}
REFERENCE = """step,eps_xx,eps_yy,gamma_xy,sig_xx,sig_yy,sig_zz,sig_xy
0,0,0,0,-50,-100,-45,0
9,0,0,0.01,-60,-80,-42,12
9,0,0,0.01,-60,-80,-42,12
"""


class Pictures(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.addCleanup(self.temporary.cleanup)
        self.path = Path(self.temporary.name) / "test.h5"

    def expect_panels(self, expected):
        figure = drawing.draw(record.read(self.path))
        panels = [(ax.get_xlabel(), ax.get_ylabel()) for ax in figure.axes]
        drawing.style.plt.close(figure)
        self.assertEqual(panels, expected)

    def expect_picture(self, *options):
        status, paths, error = run_command("soiltest", self.path, *options)
        self.assertEqual((status, error), (0, ""))
        self.assertEqual(paths, [str(self.path.with_suffix(".png"))])
        pixels = matplotlib.image.imread(paths[0])
        self.assertGreater(pixels.shape[1], 500)
        self.assertGreater(pixels[..., :3].std(), 0.02)

    loops = ("shear strain (%)", "shear stress (kPa)")
    path_in_plane = ("mean effective stress in the plane p' (kPa)", "shear stress (kPa)")
    pressure = ("cycles", "excess pore pressure ratio $r_u$")
    strain = ("cycles", "shear strain (%)")

    def test_cyclic_shear(self):
        synthetic_soiltest.write(self.path, [synthetic_soiltest.history()])
        self.expect_panels([self.loops, self.path_in_plane, self.pressure, self.strain])

    def test_several_stress_ratios(self):
        histories = [synthetic_soiltest.history(), synthetic_soiltest.history(5.0)]
        synthetic_soiltest.write(self.path, histories, tables=CURVES)
        strength = ("uniform cycles", "cyclic stress ratio CSR")
        self.expect_panels([self.loops, self.path_in_plane, strength, self.pressure, self.strain])
        self.expect_picture()

    def test_panels_of_one_stress_ratio_of_several_say_which(self):
        histories = [synthetic_soiltest.history(), synthetic_soiltest.history(5.0)]
        synthetic_soiltest.write(self.path, histories, tables=CURVES)
        figure = drawing.draw(record.read(self.path))
        loops, path, _, pressure, strain = figure.axes
        for ax in (loops, path):
            self.assertIn("CSR 0.1", [text.get_text() for text in ax.get_legend().get_texts()])
        self.assertEqual([ax.get_title(loc="left") for ax in (pressure, strain)], ["CSR 0.1", "CSR 0.1"])
        drawing.style.plt.close(figure)

    def test_many_amplitudes_have_a_colour_bar(self):
        amplitudes = [1e-6, 1e-5, 1e-4, 1e-3, 1e-2]
        histories = [synthetic_soiltest.history(amplitude=amplitude) for amplitude in amplitudes]
        about = {"loading": "modulus_curve", "title": "amplitudes"}
        synthetic_soiltest.write(self.path, histories, about, MODULUS, amplitudes)
        figure = drawing.draw(record.read(self.path))
        bar = figure.axes[-1]
        figure.draw_without_rendering()
        labels = [text.get_text() for text in bar.get_yticklabels()]
        self.assertEqual(labels, [f"{100 * amplitude:.3g} % strain" for amplitude in amplitudes])
        drawing.style.plt.close(figure)

    def test_softening_soil_has_a_residual_line(self):
        parameters = {
            "name": ["cohesion_peak", "cohesion_residual", "friction_peak_deg", "friction_residual_deg"],
            "value": [4e3, 1e3, 45.0, 30.0],
        }
        pressure = {"p": [0.0, 200e3], "q": [5e3, 300e3]}
        tables = {"parameters": parameters, "lines/failure": pressure}
        synthetic_soiltest.write(self.path, [synthetic_soiltest.history()], {"law": "mohr_coulomb"}, tables)
        test = record.read(self.path)
        residual = {label: points for label, _, _, points in view.law_lines(test)}["residual"]
        np.testing.assert_allclose(residual["q"], [1e3 * np.sqrt(3.0), 1e3 * np.sqrt(3.0) + 200e3])
        test.parameters["value"] = [4e3, 4e3, 45.0, 45.0]
        self.assertNotIn("residual", [label for label, *_ in view.law_lines(test)])

    def test_strain_controlled_cycles(self):
        synthetic_soiltest.write(self.path, [synthetic_soiltest.history()], {"loading": "cyclic_strain"}, MODULUS)
        modulus = ("shear strain amplitude (%)", "G / Gmax")
        damping = ("shear strain amplitude (%)", "damping ratio (%)")
        self.expect_panels([self.loops, self.path_in_plane, self.pressure, modulus, damping])

    def test_drained_compression(self):
        about = {"kind": "plane_strain_compression", "drainage": "drained", "loading": "monotonic"}
        synthetic_soiltest.write(self.path, [synthetic_soiltest.compression()], about)
        loading = ("axial strain (%)", "deviator stress q (kPa)")
        volume = ("axial strain (%)", "volumetric strain, compression (%)")
        self.expect_panels([loading, ("mean effective stress in the plane p' (kPa)", loading[1]), volume])

    def test_compression(self):
        compression = ("mean effective stress p' (kPa)", "volumetric strain, compression (%)")
        about = {"kind": "isotropic_compression", "drainage": "drained", "loading": "monotonic"}
        synthetic_soiltest.write(self.path, [synthetic_soiltest.compression()], about)
        self.expect_panels([compression])
        about["kind"] = "oedometer"
        synthetic_soiltest.write(self.path, [synthetic_soiltest.compression()], about)
        path = ("mean effective stress in the plane p' (kPa)", "deviator stress q (kPa)")
        self.expect_panels([("vertical effective stress (kPa)", compression[1]), path])

    def test_reference_lies_below(self):
        reference = self.path.with_suffix(".csv")
        reference.write_text(REFERENCE)
        synthetic_soiltest.write(self.path, [synthetic_soiltest.history()], {"loading": "monotonic"})
        pressure = ("shear strain (%)", "excess pore pressure ratio $r_u$")
        self.expect_panels([self.loops, self.path_in_plane, pressure])
        self.expect_picture("--over", reference)
        below = record.read_reference(reference)
        figure = drawing.draw(record.read(self.path), [below])
        drawn = {line.get_label(): line.get_xydata() for line in figure.axes[0].get_lines()}
        drawing.style.plt.close(figure)
        np.testing.assert_allclose(drawn["reference"], [[0.0, 0.0], [1.0, 12.0]])
        np.testing.assert_allclose(drawn["tremolo"][:, 1].max(), 10.0)
        own = record.read_reference(reference, "Pa")
        np.testing.assert_allclose(own["sig_xy"], [0.0, 12.0])

    def test_bounding_line_in_shear_is_half_the_deviator(self):
        synthetic_soiltest.write(self.path, [synthetic_soiltest.history()])
        figure = drawing.draw(record.read(self.path))
        lines = {line.get_label(): line.get_xydata() for line in figure.axes[1].get_lines()}
        drawing.style.plt.close(figure)
        p, shear = lines["bounding"][-1]
        self.assertAlmostEqual(shear / p, 1.2 / 2.0)


class Refusals(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.addCleanup(self.temporary.cleanup)
        self.folder = Path(self.temporary.name)

    def expect_refusal(self, message, path, *options):
        status, paths, error = run_command("soiltest", path, *options)
        self.assertEqual((status, paths), (1, []))
        self.assertEqual(error.count("\n"), 1, error)
        self.assertIn(message, error)

    def test_absent_file(self):
        self.expect_refusal("nowhere.h5: no such soil test", self.folder / "nowhere.h5")

    def test_no_hdf5(self):
        path = self.folder / "text.h5"
        path.write_text("not a file of HDF5")
        self.expect_refusal("text.h5: cannot be read as HDF5", path)

    def test_other_hdf5(self):
        path = self.folder / "other.h5"
        with h5py.File(path, "w") as file:
            file["x"] = 1.0
        self.expect_refusal("has no table /about: not a file that `tremolo soiltest` wrote", path)

    def test_history_without_stress(self):
        path = self.folder / "thin.h5"
        history = synthetic_soiltest.history()
        del history["sig_xy"]
        synthetic_soiltest.write(path, [history])
        self.expect_refusal("the history of test 000 has no column sig_xy", path)

    def expect_curve_refused(self, message, curve, *options, about=None):
        """The message follows the name of the curve's file."""
        path, over = self.folder / "test.h5", self.folder / "r.csv"
        synthetic_soiltest.write(path, [synthetic_soiltest.history()], {"loading": "monotonic"} | (about or {}))
        over.write_bytes(curve if isinstance(curve, bytes) else curve.encode())
        self.expect_refusal(f"r.csv: {message}", path, "--over", over, *options)

    def test_curve_that_is_none(self):
        none = "is no reference curve, "
        self.expect_curve_refused(none + "its first line has no column eps_xx", "time,acceleration\n0,1\n")
        self.expect_curve_refused(none + "its first line has no column eps_xx", "Dear colleague,\nthe curve follows.\n")
        self.expect_curve_refused(none + "its first line has no column eps_xx", "")
        self.expect_curve_refused(none + "but a binary file", b"\x89PNG\r\n\xff\xfe")

    def test_curve_with_broken_rows(self):
        head = REFERENCE.splitlines()[0]
        self.expect_curve_refused("has no row below its first line", head + "\n")
        self.expect_curve_refused("row 4 is not 8 numbers: 'and so on'", REFERENCE + "and so on\n")
        self.expect_curve_refused("row 4 is not 8 numbers: '9,0,0'", REFERENCE + "9,0,0\n")
        self.expect_curve_refused("column sig_xy has a value that is not finite", REFERENCE.replace(",12\n", ",nan\n"))

    def test_curve_without_cycles_below_cycles(self):
        message, about = "has no column cycle, but the picture of this test counts cycles", {"loading": "cyclic_stress"}
        self.expect_curve_refused(message, REFERENCE, about=about)

    def test_curve_in_the_other_unit(self):
        pascal = "step,eps_xx,eps_yy,gamma_xy,sig_xx,sig_yy,sig_zz,sig_xy\n0,0,0,0,-5e4,-1e5,-4.5e4,0\n"
        stress = "in {} its first vertical stress is {} kPa, that of test.h5 is 100 kPa: "
        looks, neither = "looks like {0}: give --stress-unit {0}", "neither Pa nor kPa makes them alike"
        unit = ("--stress-unit", "Pa")
        self.expect_curve_refused(stress.format("kPa", "1e+05") + looks.format("Pa"), pascal)
        self.expect_curve_refused(stress.format("Pa", "0.1") + looks.format("kPa"), REFERENCE, *unit)
        self.expect_curve_refused(stress.format("kPa", "0.1") + neither, REFERENCE.replace("-100,", "-0.1,"))
        self.expect_curve_refused(stress.format("Pa", "1e+05") + neither, pascal.replace("-1e5", "-1e8"), *unit)

    def test_curve_of_another_stress_is_drawn(self):
        """Ten times the stress is another test, not another unit."""
        path, over = self.folder / "test.h5", self.folder / "r.csv"
        synthetic_soiltest.write(path, [synthetic_soiltest.history()], {"loading": "monotonic"})
        over.write_text(REFERENCE.replace("-100,", "-1000,"))
        self.assertEqual(run_command("soiltest", path, "--over", over)[0], 0)


if __name__ == "__main__":
    unittest.main()
