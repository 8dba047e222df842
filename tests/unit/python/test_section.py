"""Sections as arrays, as histories and diagrams, and in the report."""

import tempfile
import unittest
from pathlib import Path

import numpy as np

import synthetic_run
import synthetic_section as cut
from synthetic_report import text_of_report
from test_pictures import run_command
from tremolo import Run
from with_run import WithRun


class Section(WithRun):
    @classmethod
    def write(cls):
        synthetic_run.write(cls.path, frames=4, size=4.0, structures=True)
        with Run(cls.path) as run:
            cls.structure = run.bodies[0]
        cut.add(cls.path, cls.structure)

    def test_a_cut_has_its_forces(self):
        self.assertEqual(["foot", "ring"], self.run.sections)
        self.assertIn("sections: foot, ring", repr(self.run))
        foot = self.run.section("foot")
        self.assertEqual(self.structure, foot.structure)
        np.testing.assert_allclose(foot["m"], cut.MOMENT * np.sin(foot.time))
        np.testing.assert_allclose(foot.moment[:, 0], foot["m"])
        np.testing.assert_allclose(foot.axial_force[:, 0], cut.THRUST)
        np.testing.assert_allclose(foot.shear_force[:, 0], 1e3 * foot.time)
        np.testing.assert_allclose(foot.thickness, [2.0])
        self.assertIsNone(foot.centre)
        self.assertIn(f"a cut through '{self.structure}'", repr(foot))
        with self.assertRaisesRegex(ValueError, "a single cut has no angle"):
            foot.angles

    def test_a_ring_has_those_of_all_cuts(self):
        ring = self.run.section("ring")
        self.assertEqual((400, cut.COUNT), ring.moment.shape)
        np.testing.assert_allclose(ring.angles, np.degrees(cut.ANGLES), atol=1e-9)
        np.testing.assert_allclose(ring.moment[ring.nearest(1.0)], cut.MOMENT * np.cos(2.0 * cut.ANGLES) * np.sin(1.0))
        np.testing.assert_allclose(np.linalg.norm(ring.places[0] - cut.CENTRE, axis=1), 2.5)
        least, greatest = ring.envelope("moment")
        np.testing.assert_allclose(greatest - least, cut.MOMENT * np.abs(np.cos(2.0 * cut.ANGLES)), rtol=1e-3)

    def test_refuses_what_is_not_there(self):
        with self.assertRaisesRegex(KeyError, "no section 'head'; it has foot, ring"):
            self.run.section("head")
        with self.assertRaisesRegex(KeyError, "no section force 'bending'; there are axial_force, shear_force, moment"):
            self.run.section("ring").envelope("bending")

    def test_is_in_plot_and_report(self):
        with tempfile.TemporaryDirectory() as folder:
            status, paths, error = run_command("plot", self.path, "--out", folder)
            self.assertEqual((0, ""), (status, error))
            for name in ("sections.png", "section_ring.png"):
                self.assertIn(str(Path(folder) / name), [str(path) for path in paths])
            text = text_of_report(self, self.path, folder)
        self.assertIn('<section id="sections">', text)
        self.assertIn("foot: section forces", text)
        self.assertIn("ring: extremes around it", text)
        self.assertIn("section foot", text)


if __name__ == "__main__":
    unittest.main()
