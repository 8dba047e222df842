"""Props as arrays, in maps, as a picture of their forces, and in the report."""

import tempfile
import unittest
from pathlib import Path

import h5py
import numpy as np

import synthetic_run
from synthetic_report import text_of_report
from tremolo import Run, style
from tremolo.pictures import props
from with_run import WithRun

TIMES = np.arange(0.0, 2.0, 0.005)
FORCE = -1e5 * (1.0 + np.sin(TIMES))  # N/m


def add(path, structure):
    """Adds a strut from a structure to the ground to a run file; its far end goes 1 m/s to the right."""
    rows = np.column_stack([TIMES, FORCE, 10.0 + TIMES, *np.broadcast_to([[33.0], [-2.0]], (2, len(TIMES))), 43.0 + TIMES,
                            np.full_like(TIMES, -2.0)])
    with h5py.File(path, "a") as file:
        file.attrs["prop_names"] = np.array([b"strut"])
        series = file.create_dataset("props/strut", data=rows)
        series.attrs["columns"] = np.array([b"time", b"n", b"length", b"from_x", b"from_y", b"to_x", b"to_y"])
        series.attrs["units"] = np.array([b"s", b"N/m", b"m", b"m", b"m", b"m", b"m"])
        series.attrs["from"] = np.bytes_(structure)
        series.attrs["to"] = np.bytes_("ground")


class Prop(WithRun):
    @classmethod
    def write(cls):
        synthetic_run.write(cls.path, frames=4, size=4.0, structures=True)
        with Run(cls.path) as run:
            cls.structure = run.bodies[0]
        add(cls.path, cls.structure)

    def test_has_its_force_and_its_ends(self):
        self.assertEqual(["strut"], self.run.props)
        self.assertIn("props: strut", repr(self.run))
        strut = self.run.prop("strut")
        np.testing.assert_allclose(strut.force, FORCE)
        np.testing.assert_allclose(strut.length, 10.0 + TIMES)
        self.assertEqual((self.structure, "ground"), strut.ends)
        self.assertEqual((len(TIMES), 2, 2), strut.places.shape)
        np.testing.assert_allclose(strut.ends_at(1.0), [[33.0, -2.0], [44.0, -2.0]])
        self.assertIn(f"from {self.structure} to ground", repr(strut))
        with self.assertRaisesRegex(KeyError, "no prop 'anchor'; it has strut"):
            self.run.prop("anchor")

    def test_is_drawn_where_it_is(self):
        figure, ax = style.plt.subplots()
        self.addCleanup(style.plt.close, figure)
        props.draw(ax, self.run, 1.0)
        np.testing.assert_allclose(ax.lines[0].get_xydata(), [[33.0, -2.0], [44.0, -2.0]])

    def test_has_a_picture_and_stands_in_the_report(self):
        with tempfile.TemporaryDirectory() as folder:
            self.assertEqual("props.png", Path(props.picture(self.run, Path(folder))).name)
            page = text_of_report(self, self.path, folder)
        self.assertIn('<a href="#props">Props</a>', page)
        self.assertIn("prop strut", page)
        self.assertIn("Forces in props", page)


if __name__ == "__main__":
    unittest.main()
