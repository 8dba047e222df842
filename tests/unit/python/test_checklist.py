"""The reviewer's list of a report against closed forms, and the files that its commands read."""

import tempfile
import tomllib
import unittest
from pathlib import Path

import numpy as np

from tremolo.report import checklist

CASE = """
[soil.sand]
model = "pm4sand"
relative_density = 0.55
shear_modulus_coefficient = 677.0
contraction_rate = 0.4
permeability = 1e-4
void_ratio = 0.7
rest_coefficient = 0.4

[soil.rock]
model = "linear_elastic"

[mesh]
size = 1.0
"""


class UniformRun:
    """A run whose soil stands under one stress at the start and under another one at the end."""

    case = CASE
    times = np.array([0.0, 1.0])
    plan = {"dt_s": 0.8e-3, "critical_dt_s": 1e-3}
    energy = {"residual": np.array([0.0, -2.0]), "input": np.array([0.0, 100.0])}

    def __init__(self, folder, fields=("stress", "soil")):
        self.path, self._fields = Path(folder) / "run.h5", fields

    def has_field(self, name):
        return name in self._fields

    def field(self, index, name):
        if name == "soil":
            return np.repeat([0, 1], 50)
        # Mobilised in the plane: asin(25/75) at the start; asin(60/100), turned by 45 degrees, at the end.
        stress = [-50e3, -100e3, -50e3, 0.0] if index == 0 else [-100e3, -100e3, -80e3, 60e3]
        return np.tile(stress, (100, 1))

    def attribute(self, name):
        return {"soil_names": ["sand", "rock"]}.get(name)

    def table(self, name):
        return {"dx": np.array([0.003, 0.0]), "dy": np.array([0.004, 0.001]), "x": np.array([0.0, 5.0]), "y": np.array([-2.0, -9.0]),
                "strength_share": np.array([0.7, 0.1])}


class Checklist(unittest.TestCase):
    def setUp(self):
        self.folder = self.enterContext(tempfile.TemporaryDirectory())
        self.rows = {row[0]: row[1:] for row in checklist.checklist(UniformRun(self.folder)).rows}

    def test_numbers_are_those_of_the_closed_forms(self):
        self.assertEqual("at most 5 mm beyond the free field, at x = 0 m, y = -2 m; springs ask for 0.7 of the soil's strength at most",
                         self.rows["base and side drift"][0])
        self.assertEqual("largest residual 2 J/m, 2 % of the largest work of the free field", self.rows["energy ledger"][0])
        angles = self.rows["K0 and mobilised friction angle of 'sand'"][0]
        self.assertIn("K0 0.50 to 0.50", angles)
        self.assertIn("at the start and the end 19.5°, 36.9°", angles)
        self.assertEqual("0.0008 s, 0.80 of the critical one", self.rows["time step"][0])

    def test_files_of_the_commands(self):
        written = {path.name: tomllib.loads(path.read_text()) for path in (Path(self.folder) / "checks").iterdir()}
        self.assertEqual({"sand_strength.toml", "permeability.toml", "cells.toml"}, set(written))
        test = written["sand_strength.toml"]
        self.assertEqual((100e3, 0.4), (test["test"]["vertical_stress"], test["test"]["k0"]))
        self.assertEqual({"model", "relative_density", "shear_modulus_coefficient", "contraction_rate", "density"}, set(test["soil"]))
        np.testing.assert_allclose(written["permeability.toml"]["axes"]["soil"]["sand"]["permeability"], [1e-5, 1e-4, 1e-3])
        self.assertEqual([1.0, 0.5], written["cells.toml"]["axes"]["mesh"]["size"])
        for words, command in ((words, row[1]) for words, row in self.rows.items() if "checks/" in row[1]):
            self.assertTrue((Path(self.folder) / command.split()[2]).exists(), words)

    def test_without_frames_of_stress_it_says_what_is_missing(self):
        rows = {row[0]: row[1:] for row in checklist.checklist(UniformRun(self.folder, fields=("soil",))).rows}
        self.assertEqual(["the frames hold no stress", '[output] fields = ["stress", ...]'], rows["element tests of 'sand' with its CSR-N line"])
        self.assertNotIn("K0 and mobilised friction angle of 'sand'", rows)

    def test_a_folder_that_cannot_be_written_is_reported(self):
        run = UniformRun(Path(self.folder) / "missing")
        self.assertIn("could not be written", checklist.checklist(run).caption)


if __name__ == "__main__":
    unittest.main()
