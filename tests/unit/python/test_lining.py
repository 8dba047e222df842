"""Linings as arrays, in maps, as diagrams and in the report."""

import tempfile
import unittest
from pathlib import Path

import numpy as np

import synthetic_lining as ring
import synthetic_run
from synthetic_report import text_of_report
from test_pictures import run_command
from tremolo import Run, bodies, style
from tremolo.pictures import linings
from with_run import WithRun


class Lining(WithRun):
    @classmethod
    def write(cls):
        synthetic_run.write(cls.path, frames=4, size=4.0)
        ring.add(cls.path, 2.0)

    def setUp(self):
        super().setUp()
        self.lining = self.run.lining("ring")

    def test_has_its_section_forces(self):
        self.assertEqual(["ring"], self.run.linings)
        self.assertIn("linings: ring", repr(self.run))
        self.assertEqual((400, ring.COUNT), self.lining.moment.shape)
        row = self.lining.nearest(1.0)
        np.testing.assert_allclose(self.lining.moment[row], ring.MOMENT * np.sin(1.0) * np.sin(2.0 * ring.middle_angles()))
        np.testing.assert_allclose(self.lining.axial_force, ring.THRUST)
        np.testing.assert_allclose(self.lining.shear_force, 0.1 * self.lining.moment)
        self.assertEqual((400, ring.SEGMENTS), self.lining.pressure.shape)
        np.testing.assert_allclose(self.lining.shear, 0.1 * ring.PRESSURE)
        least, greatest = self.lining.envelope("moment")
        np.testing.assert_allclose(greatest - least, ring.MOMENT * np.abs(np.sin(2.0 * ring.middle_angles())), rtol=1e-3)
        self.assertEqual((0.3, 7e7, ring.HINGES), (self.lining.thickness, self.lining.bending_stiffness, self.lining.hinges))

    def test_refuses_what_is_not_there(self):
        with self.assertRaisesRegex(KeyError, "no lining 'tube'; it has ring"):
            self.run.lining("tube")
        with self.assertRaisesRegex(KeyError, "no section force 'bending'; there are axial_force, shear_force, moment"):
            self.lining.envelope("bending")

    def test_has_faces_where_it_is(self):
        outer, inner = self.lining.faces(0.5)
        centre = ring.CENTRE + [ring.DRIFT * 0.5, 0.0]
        flat = ring.RADIUS * np.cos(np.pi / ring.COUNT)  # of the polygon's edges
        corner = 1.0 / np.cos(np.pi / ring.COUNT)
        np.testing.assert_allclose(np.linalg.norm(outer - centre, axis=1), corner * (flat + 0.15))
        np.testing.assert_allclose(np.linalg.norm(inner - centre, axis=1), corner * (flat - 0.15))

    def test_is_drawn_as_a_ring_that_is_open_within(self):
        figure, ax = style.plt.subplots()
        bodies.draw(ax, self.run, 0)
        outer, inner = ax.patches[0].get_path().to_polygons(closed_only=True)

        def area(polygon):
            x, y = polygon.T
            return 0.5 * np.sum(x[:-1] * y[1:] - x[1:] * y[:-1])

        style.plt.close(figure)
        self.assertAlmostEqual(np.pi * 3.15**2, area(outer), delta=0.3)
        self.assertAlmostEqual(-np.pi * 2.85**2, area(inner), delta=0.3)

    def test_diagrams_stand_on_the_side_that_moments_stretch(self):
        figure = linings.diagrams(self.lining, "ring", [1.5])
        self.addCleanup(style.plt.close, figure)
        moment, thrust, _ = figure.axes[:3]
        drawn = next(line for line in moment.get_lines() if line.get_label().startswith("t = 1.5")).get_xydata()[:-1]
        away = np.linalg.norm(drawn - ring.CENTRE, axis=1) - ring.RADIUS * np.cos(np.pi / ring.COUNT)
        row = self.lining.moment[self.lining.nearest(1.5)]
        self.assertTrue(np.all(np.sign(away) == np.sign(row)))
        np.testing.assert_allclose(away / row, away[0] / row[0])
        thrust_line = next(line for line in thrust.get_lines() if line.get_label().startswith("t = 1.5")).get_xydata()
        self.assertTrue(np.all(np.linalg.norm(thrust_line - ring.CENTRE, axis=1) > ring.RADIUS))  # compression
        self.assertIn("-19.62 to 19.62 kNm/m", moment.get_title(loc="left").replace("−", "-"))

    def test_contact_stands_on_the_outer_face(self):
        """The synthetic ring bears one pressure all around it."""
        figure = linings.diagrams(self.lining, "ring", [1.5], contact=True)
        self.addCleanup(style.plt.close, figure)
        pressure, shear = figure.axes[:2]
        drawn = next(line for line in pressure.get_lines() if line.get_label().startswith("t = 1.5")).get_xydata()[:-1]
        self.assertEqual(ring.SEGMENTS, len(drawn))
        away = np.linalg.norm(drawn - ring.CENTRE, axis=1) - np.linalg.norm(self.lining.segments - ring.CENTRE, axis=1)
        np.testing.assert_allclose(away, away[0], rtol=0.02)
        self.assertGreater(away[0], 0.0)
        self.assertTrue(pressure.get_title(loc="left").startswith("pressure of the soil"))
        self.assertTrue(shear.get_title(loc="left").startswith("shear of the soil"))

    def test_is_in_plot_and_report(self):
        with tempfile.TemporaryDirectory() as folder:
            status, paths, error = run_command("plot", self.path, "--out", folder)
            self.assertEqual((0, ""), (status, error))
            for name in ("lining_ring.png", "lining_ring_contact.png"):
                self.assertIn(str(Path(folder) / name), [str(path) for path in paths])
            text = text_of_report(self, self.path, folder)
        self.assertIn('<section id="linings">', text)
        self.assertIn("ring: extremes around it", text)
        self.assertIn("lining ring", text)


if __name__ == "__main__":
    unittest.main()
