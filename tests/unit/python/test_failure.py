"""The time at which a shear band connects toe and crest, on bands drawn by hand."""

import contextlib
import io
import tempfile
import unittest
from pathlib import Path

import h5py
import numpy as np
from tremolo import Run, failure
from tremolo.__main__ import main

SIZE = 1.0


def write(path, bands):
    """A 10 m slope from (20, 0) to (30, 10) with one frame a second; bands[i] are the strained cells of frame i."""
    x, y = np.meshgrid(np.arange(0.5, 50.0), np.arange(-9.5, 10.0))
    inside = (y < 0.0) | (x > 20.0 + y)
    material = np.column_stack([x[inside], y[inside]])
    cells = {tuple(c): k for k, c in enumerate(np.floor(material).astype(int))}
    with h5py.File(path, "w") as file:
        file.attrs.update({"schema_version": np.bytes_("1.0"), "mesh_size": SIZE, "surface_levels": [0.0, 10.0],
                           "angle_deg": 0.0})
        frames = file.create_group("frames")
        for number, band in enumerate(bands):
            frame = frames.create_group(f"{number:04}")
            frame.attrs["time"] = float(number)
            strain = np.zeros(len(material))
            strain[[cells[cell] for cell in band]] = 0.2
            # The soil has moved: the band is looked for where the soil lay.
            displacement = np.full(material.shape, 3.7 * number)
            frame["position"], frame["displacement"] = material + displacement, displacement
            frame["equivalent_plastic_strain"] = strain
        toe = file.create_dataset("monitors/toe", data=np.array([[0.0, 20.0, 0.0]]))
        toe.attrs["columns"] = np.array([b"time", b"x", b"y"])
        toe.attrs["units"] = np.array([b"s", b"m", b"m"])


def diagonal(first, last):
    """Cells along a band from the toe, one up and one to the right a step; they touch at corners only."""
    return [(21 + i, i) for i in range(first, last)]


def write_graded(path, strained):
    """A 4 m slope of 1 m cells beneath y = 0 and half-metre ones above; `strained` are points in strained cells."""
    cells = [((i + 0.5, j - 3.5), 1.0) for i in range(10) for j in range(4)]
    cells += [((0.5 * i + 0.25, 0.5 * j + 0.25), 0.5) for i in range(20) for j in range(8) if i > 4 + j]
    with h5py.File(path, "w") as file:
        file.attrs.update({"schema_version": np.bytes_("1.0"), "mesh_size": 1.0, "particle_size": 1.0,
                           "surface_levels": [0.0, 4.0], "angle_deg": 0.0})
        frame = file.create_group("frames/0000")
        frame.attrs["time"] = 0.0
        frame["position"] = [centre for centre, _ in cells]
        frame["displacement"] = np.zeros((len(cells), 2))
        frame["size"] = [size for _, size in cells]
        frame["equivalent_plastic_strain"] = [
            0.2 if any(np.max(np.abs(np.subtract(centre, point))) < 0.5 * size for point in strained) else 0.0
            for centre, size in cells
        ]
        toe = file.create_dataset("monitors/toe", data=np.array([[0.0, 2.5, 0.0]]))
        toe.attrs["columns"] = np.array([b"time", b"x", b"y"])
        toe.attrs["units"] = np.array([b"s", b"m", b"m"])


class FailureOnAGradedMesh(unittest.TestCase):
    def failure_time(self, strained):
        with tempfile.TemporaryDirectory() as folder:
            write_graded(Path(folder) / "run.h5", strained)
            with Run(folder) as run:
                return failure.failure_time(run)

    ABOVE = [(3.75 + 0.5 * i, 0.25 + 0.5 * i) for i in range(8)]

    def test_a_band_goes_on_in_cells_of_another_size(self):
        self.assertEqual(0.0, self.failure_time([(2.5, -0.5), (3.5, -0.5), *self.ABOVE]))

    def test_a_gap_between_the_levels_does_not_connect(self):
        self.assertIsNone(self.failure_time([(2.5, -0.5), *self.ABOVE[1:]]))


class FailureTime(unittest.TestCase):
    def failure_time(self, bands, strain=0.1):
        with tempfile.TemporaryDirectory() as folder:
            write(Path(folder) / "run.h5", bands)
            with Run(folder) as run:
                return failure.failure_time(run, strain)

    def test_the_first_frame_whose_band_connects(self):
        self.assertEqual(2.0, self.failure_time([[], diagonal(0, 6), diagonal(0, 10), diagonal(0, 10)]))

    def test_a_gap_in_the_band_does_not_connect(self):
        self.assertIsNone(self.failure_time([diagonal(0, 5) + diagonal(6, 10)]))

    def test_a_band_that_does_not_reach_the_toe_does_not_connect(self):
        self.assertIsNone(self.failure_time([diagonal(3, 10)]))

    def test_a_band_below_the_crest_does_not_connect(self):
        self.assertIsNone(self.failure_time([diagonal(0, 7)]))

    def test_weaker_strain_is_no_band(self):
        self.assertIsNone(self.failure_time([diagonal(0, 10)], strain=0.3))


class BetweenTwoPoints(unittest.TestCase):
    """The band of the cells (21, 0) to (28, 7), whose centres lie half a metre from their corners."""

    def printed(self, *options):
        with tempfile.TemporaryDirectory() as folder:
            write(Path(folder) / "run.h5", [[], diagonal(0, 8)])
            out, error = io.StringIO(), io.StringIO()
            with contextlib.redirect_stdout(out), contextlib.redirect_stderr(error), contextlib.suppress(SystemExit):
                main(["failure", folder, *options])
            return out.getvalue() + error.getvalue()

    def test_it_connects_what_it_comes_near_to(self):
        self.assertIn("fails at 1.00 s", self.printed("--from", "21.5,0.5", "--to", "28.5,7.5"))
        self.assertIn("fails at 1.00 s", self.printed("--from=20.5,-0.5", "--to=28.5,5.9"))

    def test_it_does_not_connect_what_is_farther_away_than_two_cells(self):
        self.assertIn("has not failed by 1.00 s", self.printed("--from", "21.5,0.5", "--to", "31.0,9.5"))
        self.assertIn("has not failed", self.printed("--from", "10.0,-5.0", "--to", "28.5,7.5"))

    def test_wrong_points_are_refused(self):
        self.assertIn("is no point, X,Y in m", self.printed("--from", "21.5", "--to", "28.5,7.5"))
        self.assertIn("give both, or neither", self.printed("--from", "21.5,0.5"))
        self.assertIn("m from the nearest soil", self.printed("--from", "21.5,0.5", "--to", "80.0,7.5"))


if __name__ == "__main__":
    unittest.main()
