"""`tremolo column --models`: a site under several models in one report, against closed forms.

    usage: test_site.py TREMOLO PYTHON_PACKAGE_DIR MY_FIELD
"""

import csv
import shutil
import sys
import unittest

TREMOLO, PACKAGE, _ = sys.argv.pop(1), sys.argv.pop(1), sys.argv.pop(1)
sys.path.insert(0, PACKAGE)

import numpy as np
from free_field_cases import ColumnWorkspace, stages
from tremolo.site import amplification
from tremolo.site.read import Site

PULSE = 'pulse = {{ shape = "ricker", frequency = 3.0, time = 1.0, velocity = {} }}'
ROCK, G = 2000.0 * 400.0, 9.80665
LAYER = """
[[profile]]
thickness = 20.0
density = 1800.0
vs = 200.0
vp = 400.0

[damping]
model = "kelvin_voigt"
ratio = 0.05
reference_hz = 3.0
"""
CLAY = """
[water]
level = -4.0

[[profile]]
thickness = 20.0
soil = "clay"

[soil.clay]
model = "mkz"
density = 1825.0
porosity = 0.5
drainage = "undrained"
vs = 150.0
vp = 300.0
curve = "darendeli"
plasticity_index = 30.0
mean_stress = 60e3
damping = 0.01
shear_strength = 20e3

[damping]
model = "constant"
reference_hz = 3.0
"""


def amplified(frequency):
    """|surface over outcrop| of the layer on its half-space, closed form."""
    shear = 1800.0 * 200.0**2 * (1.0 + 2j * 0.05 * frequency / 3.0)
    speed = np.sqrt(shear / 1800.0)
    phase = 2.0 * np.pi * frequency * 20.0 / speed
    return np.abs(1.0 / (np.cos(phase) + 1j * 1800.0 * speed / ROCK * np.sin(phase)))


def rows_of(path):
    """Columns of a table by name."""
    heading, *rows = csv.reader(path.read_text().splitlines())
    return {name: [row[number] for row in rows] for number, name in enumerate(heading)}


class OneLayer(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        work = ColumnWorkspace(TREMOLO, ground=LAYER, motion=PULSE.format(1e-3), size=0.25)
        cls.addClassCleanup(work.__exit__)
        cls.result = work.command("column", work.case, "--models", "wave,fe,ode", "--out", work.path / "out", "--duration", "6")
        assert cls.result.returncode == 0, cls.result.stdout + cls.result.stderr
        cls.work, cls.folder = work, work.path / "out"
        cls.site = Site(cls.folder)

    def once_more(self, folder):
        return self.work.command("column", self.work.case, "--models", "wave", "--out", folder, "--duration", "4")

    def test_a_file_of_somebody_else_is_not_written_again(self):
        other = shutil.copytree(self.folder, self.work.path / "other")
        (other / "site.json").write_text("mine")
        self.assertNotEqual(0, self.once_more(other).returncode)
        self.assertEqual("mine", (other / "site.json").read_text())

    def test_acceptance_the_folder_of_an_earlier_command_is_written_again(self):
        again = shutil.copytree(self.folder, self.work.path / "again")
        result = self.once_more(again)
        self.assertEqual(0, result.returncode, result.stderr)
        self.assertEqual(["wave"], list(Site(again).models))

    def test_raw_amplification_is_the_closed_form(self):
        """Elements of 0.25 m err by (w h/c)^2/24 of a wavelength, and the ground rings for 6 s."""
        for name, tolerance in (("wave", 1e-3), ("fe", 1e-2), ("ode", 1e-2)):
            frequency, ratio = amplification.raw(self.site.models[name], "outcrop")
            band = (frequency > 0.8) & (frequency < 7.5)  # where the pulse has more than a fiftieth of its peak
            np.testing.assert_allclose(ratio[band], amplified(frequency[band]), rtol=tolerance, err_msg=name)

    def test_smoothed_amplification_keeps_the_first_peak_and_its_place(self):
        frequency, ratio = amplification.smoothed(self.site.models["wave"], "outcrop")
        fine = np.linspace(1.0, 5.0, 4001)
        peak = fine[np.argmax(amplified(fine))]
        near = (frequency > 1.0) & (frequency < 5.0)
        self.assertAlmostEqual(peak, frequency[near][np.nanargmax(ratio[near])], delta=0.05 * peak)
        self.assertAlmostEqual(amplified(peak), np.nanmax(ratio[near]), delta=0.03 * amplified(peak))

    def test_the_site(self):
        facts = self.site.facts
        self.assertAlmostEqual(30.0 / (20.0 / 200.0 + 10.0 / 400.0), facts["vs30"], places=9)
        self.assertAlmostEqual(0.4, facts["period"], places=12)
        self.assertAlmostEqual(ROCK / (1800.0 * 200.0), facts["impedance_contrast"], places=12)

    def test_stress_ratio_is_over_the_weight(self):
        profile = self.site.models["wave"].profile
        np.testing.assert_allclose(profile["effective_stress"], 1800.0 * G * -profile["y"], atol=1e-6)
        below = profile["y"] < 0.0
        np.testing.assert_allclose(profile["stress_ratio"][below], profile["peak_sxy"][below] / profile["effective_stress"][below])
        np.testing.assert_allclose(profile["cyclic_stress_ratio"], 0.65 * profile["stress_ratio"])

    def test_tables_stand_top_down_in_the_folder(self):
        depth = np.array(rows_of(self.folder / "tables/profile_fe.csv")["depth_m"], dtype=float)
        self.assertEqual((0.0, 20.0), (depth[0], depth[-1]))
        self.assertTrue(np.all(np.diff(depth) >= 0.0))
        self.assertEqual(["linear elastic", "half-space"], rows_of(self.folder / "tables/layers.csv")["soil"])
        self.assertEqual(["wave", "fe", "ode"], rows_of(self.folder / "tables/models.csv")["model"])

    def test_pictures_and_the_page_are_there(self):
        for name in ("histories", "spectra", "amplification", "profiles"):
            self.assertGreater((self.folder / f"pictures/{name}.png").stat().st_size, 10_000)
        self.assertIn("Models", (self.folder / "report.html").read_text())

    def test_nothing_speaks_against_weak_motion_in_fine_elements(self):
        self.assertEqual([], self.site.warnings())


class Yielding(unittest.TestCase):
    """Clay under a pulse that strains it by per cents, in coarse elements."""

    @classmethod
    def setUpClass(cls):
        work = ColumnWorkspace(TREMOLO, ground=CLAY + stages(2.0), motion=PULSE.format(0.2), size=4.0)
        cls.addClassCleanup(work.__exit__)
        cls.result = work.command("column", work.case, "--models", "eql,fe,wave,mpm", "--out", work.path / "out")
        assert cls.result.returncode == 0, cls.result.stdout + cls.result.stderr
        cls.site = Site(work.path / "out")
        cls.warnings = dict.fromkeys(("eql", "fe", "wave"), "")
        for model, text in cls.site.warnings():
            cls.warnings[model] += text + "\n"

    def test_a_model_that_cannot_is_refused_and_the_others_go_on(self):
        self.assertEqual(["eql", "fe", "wave"], list(self.site.models))
        self.assertIn("missing [mesh]", self.site.refused["mpm"])
        self.assertIn("refused:", self.result.stdout)

    def test_warnings_say_strain_frequency_and_strength(self):
        self.assertRegex(self.warnings["eql"], r"shear strain reaches [\d.]+ % at [\d.]+ m .* equivalent linear soil is for strains up to 0.1 %")
        self.assertRegex(self.warnings["wave"], r"linear soil is for strains up to 0.05 %")
        self.assertRegex(self.warnings["fe"], r"elements of 4 m carry shear waves up to [\d.]+ Hz .* halve the elements")
        self.assertNotIn("elements", self.warnings["eql"])
        for text in self.warnings.values():
            self.assertIn("times the strength given, 20 kPa", text)
        self.assertIn("warning: eql: shear strain", self.result.stdout)

    def test_effective_stress_is_less_by_the_water(self):
        """1825 kg/m3 with water in half of the volume, 1325 without."""
        profile = self.site.models["wave"].profile
        depth = -profile["y"]
        total = 1325.0 * np.minimum(depth, 4.0) + 1825.0 * np.maximum(depth - 4.0, 0.0)
        expected = G * (total - 1000.0 * np.maximum(depth - 4.0, 0.0))
        np.testing.assert_allclose(profile["effective_stress"], expected, rtol=1e-3)  # gravity of the case is 9.81

    def test_strain_compatible_soil_follows_its_strain(self):
        found = self.site.models["eql"].strain_compatible
        density = np.where(found["top"] < 4.0, 1325.0, 1825.0)  # above the table the same G makes faster waves
        np.testing.assert_allclose(density * found["vs"] ** 2, 1825.0 * 150.0**2 * found["modulus_ratio"], rtol=1e-9)
        np.testing.assert_allclose(found["effective_strain"], 0.65 * found["largest_strain"])
        order = np.argsort(found["effective_strain"])
        self.assertTrue(np.all(np.diff(found["modulus_ratio"][order]) <= 1e-3))
        self.assertTrue(np.all(np.diff(found["damping"][order]) >= -1e-3))


class Commands(unittest.TestCase):
    def test_options_that_do_not_go_together(self):
        with ColumnWorkspace(TREMOLO, ground=LAYER, motion=PULSE.format(1e-3), size=1.0) as work:
            for words, why in ((["--out", "a"], "--model or --models"), (["--models", "fe,fe", "--out", "a"], "'fe' is named twice"),
                               (["--models", "fe", "--model", "fe", "--out", "a"], "excludes"),
                               (["--models", "fe", "--record", "a.h5"], "excludes")):
                result = work.command("column", work.case, *words)
                self.assertNotEqual(0, result.returncode, words)
                self.assertIn(why, result.stderr + result.stdout)


if __name__ == "__main__":
    unittest.main()
