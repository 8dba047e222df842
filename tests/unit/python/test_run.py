"""Run: what was written is what is read."""

import tempfile
import unittest
from pathlib import Path

import h5py
import numpy as np

import synthetic_run
from tremolo import Run


class ReadsARun(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.path = Path(cls.folder.name) / "run.h5"
        synthetic_run.write(cls.path, frames=4, size=4.0, damaged=True)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def test_attributes_are_plain_values(self):
        with Run(self.folder.name) as run:
            self.assertEqual(run.title, "synthetic slope")
            self.assertEqual(run.status, "complete")
            self.assertEqual(run.case, "title = 'synthetic slope'\n")
            self.assertEqual(run.attribute("soil_names"), ["sand", "base layer"])
            self.assertEqual(run.attribute("angle_deg"), 15.0)
            self.assertIsNone(run.attribute("absent"))

    def test_frames_hold_all_particles(self):
        with Run(self.path) as run:
            np.testing.assert_allclose(run.times, [0.0, 0.02, 0.04, 0.06])
            self.assertEqual(run.nearest_frame(0.045), 2)
            expected = synthetic_run.slope_particles(4.0)
            np.testing.assert_array_equal(run.frame(3)["position"], expected)
            self.assertEqual(run.field(3, "velocity").shape, expected.shape)

    def test_rows_that_never_arrived_are_left_out(self):
        with Run(self.path) as run:
            crest = run.monitor("crest")
            self.assertEqual(len(crest), 16)
            self.assertFalse(np.isnan(crest["ax"]).any())
            self.assertEqual(crest.units["ax"], "m/s2")

    def test_tables_and_energy(self):
        with Run(self.path) as run:
            self.assertEqual(run.table("timings")["pass"], ["scatter", "gather"])
            self.assertIsNone(run.table("processes"))
            np.testing.assert_allclose(run.energy["elastic"], 1e3 * run.energy["time"])
            self.assertEqual(run.boundary["traction"].shape, (len(run.boundary["time"]), len(run.boundary["length"]), 2))


class RefusesWhatIsNoRun(unittest.TestCase):
    def test_absent_foreign_and_newer_files(self):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "run.h5"
            with self.assertRaisesRegex(FileNotFoundError, "run.h5: no such run"):
                Run(folder)
            path.write_text("text")
            with self.assertRaisesRegex(OSError, "cannot be read as HDF5"):
                Run(folder)
            path.unlink()
            with h5py.File(path, "w") as file:
                file.attrs["schema_version"] = np.bytes_("2.0")
            with self.assertRaisesRegex(ValueError, "schema version 2.0, this package reads 1.x"):
                Run(folder)


if __name__ == "__main__":
    unittest.main()
