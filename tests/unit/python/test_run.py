"""Run: what was written is what is read."""

import os
import random
import tempfile
import traceback
import unittest
from pathlib import Path

import h5py
import numpy as np

import synthetic_run
from tremolo import Run
from tremolo.run import DamagedRun


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


class ReadsStructures(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        synthetic_run.write(Path(cls.folder.name) / "run.h5", frames=4, size=4.0, structures=True)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def test_bodies_stand_where_they_are_at_a_time(self):
        with Run(self.folder.name) as run:
            self.assertEqual(["tunnel", "block"], run.bodies)
            tunnel, block = run.body("tunnel"), run.body("block")
            self.assertEqual((8e3, 1e4), (tunnel.mass, tunnel.inertia))
            outline, hole = tunnel.corners(0.05)
            turned = synthetic_run.TURN * 0.05
            first = synthetic_run.TUNNEL + [0.0, synthetic_run.RISE * 0.05]
            np.testing.assert_allclose(outline[0], first + 2.5 * np.array([np.cos(turned), np.sin(turned)]))
            np.testing.assert_allclose(hole[0], first + 2.2 * np.array([np.cos(turned), np.sin(turned)]))
            self.assertIsNone(block.hole)
            np.testing.assert_allclose(block.corners(0.05)[0], synthetic_run.BLOCK)
            with self.assertRaisesRegex(KeyError, "no body 'house'; it has tunnel, block"):
                run.body("house")

    def test_an_elastic_body_is_as_bent_as_its_frames_say(self):
        names = ["time", "x0", "y0", "x1", "y1", "x2", "y2", "hole_x0", "hole_y0"]
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "run.h5"
            synthetic_run.write(path, frames=2, size=4.0, structures=True)
            with h5py.File(path, "a") as file:
                series = file.create_dataset("outlines/block", data=np.array([[0.0] * 9, [0.5, *range(8)]]))
                series.attrs["columns"] = np.array([name.encode() for name in names])
                series.attrs["units"] = np.array([b"1"] * 9)
            with Run(folder) as run:
                outline, hole = run.body("block").corners(0.25)
                np.testing.assert_allclose(outline, [[0.0, 0.5], [1.0, 1.5], [2.0, 2.5]])
                np.testing.assert_allclose(hole, [[3.0, 3.5]])
                self.assertEqual((48, 2), run.body("tunnel").corners(0.25)[0].shape)

    def test_contact_nodes_of_a_frame(self):
        with Run(self.folder.name) as run:
            nodes = run.contact(3)
            self.assertEqual("block", run.bodies[nodes["body"][0]])
            self.assertEqual(8e4, nodes["normal_force"].sum())

    def test_a_run_without_structures_has_neither(self):
        with tempfile.TemporaryDirectory() as folder:
            synthetic_run.write(Path(folder) / "run.h5", frames=2, size=4.0)
            with Run(folder) as run:
                self.assertEqual([], run.bodies)
                self.assertIsNone(run.contact(0))


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


def read_everything(path):
    with Run(path) as run:
        for index in range(len(run.times)):
            run.frame(index)
        for name in run.monitors:
            run.monitor(name)
        return run.title, run.status, run.case, run.energy, run.boundary, run.table("timings"), run.attribute("box")


class ReadsADamagedRun(unittest.TestCase):
    """Bytes are changed anywhere, or the end is missing: what is said names the file."""

    def told(self, path):
        """The status of reading a file, 0 where it is read or refused in words. In a process of its own: the library does not forget damage."""
        child = os.fork()
        if child == 0:
            try:
                read_everything(path)
            except (DamagedRun, OSError, ValueError) as error:
                os._exit(0 if str(path) in str(error) else 1)
            except BaseException:
                traceback.print_exc()
                os._exit(1)
            os._exit(0)
        return os.waitpid(child, 0)[1]

    def test_is_refused_in_words(self):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "run.h5"
            synthetic_run.write(path, frames=3, size=5.0, damaged=True)
            good = path.read_bytes()
            for seed in range(60):
                chance = random.Random(seed)
                bytes_now = bytearray(good)
                for _ in range(chance.choice([1, 5, 50])):
                    bytes_now[chance.randrange(len(bytes_now))] = chance.randrange(256)
                if seed % 5 == 0:
                    del bytes_now[chance.randrange(len(bytes_now)):]
                path.write_bytes(bytes_now)
                self.assertEqual(0, self.told(path), f"seed {seed}")

    def test_a_link_that_cannot_be_decoded_is_refused_in_words(self):
        """tremolo writes the links of a group as messages of its header: version, flags, order, length of the name, name."""
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "run.h5"
            with h5py.File(path, "w") as file:
                file.attrs["schema_version"] = np.bytes_("1.0")
                links = h5py.h5p.create(h5py.h5p.GROUP_CREATE)
                links.set_link_creation_order(h5py.h5p.CRT_ORDER_TRACKED)
                frames = h5py.Group(h5py.h5g.create(file.id, b"frames", gcpl=links))
                for index in range(5):
                    frames.create_group(f"{index:04}").attrs["time"] = 0.1 * index
            content = bytearray(path.read_bytes())
            name = content.index(b"\x040001")
            self.assertEqual(1, content[name - 10])
            content[name - 10] = 99
            path.write_bytes(content)
            self.assertEqual(0, self.told(path))
            with self.assertRaisesRegex(DamagedRun, "run.h5: cannot read the frames, the file is damaged"):
                Run(path)

    def test_a_frame_that_is_not_there_is_named_with_those_that_are(self):
        with tempfile.TemporaryDirectory() as folder:
            synthetic_run.write(Path(folder) / "run.h5", frames=3, size=5.0)
            with Run(folder) as run:
                self.assertEqual(list(run.frame(2)), list(run.frame(np.int64(-1))))
                for read in (run.frame, lambda index: run.field(index, "velocity"), run.contact):
                    for index in (3, 10**9, -4):
                        with self.assertRaisesRegex(IndexError, f"run.h5: no frame {index}; the run has 3 frames, 0 to 2"):
                            read(index)
                    for index in (9.9, 1.0, "1", None):
                        with self.assertRaisesRegex(TypeError, f"frame {index!r} is no whole number; the run has 3 frames, 0 to 2"):
                            read(index)
            with h5py.File(Path(folder) / "run.h5", "a") as file:
                del file["frames"]
                file.create_group("frames")
            with Run(folder) as run, self.assertRaisesRegex(IndexError, "no frame 0; the run has no frame yet"):
                run.frame(0)

    def test_an_unknown_field_or_column_is_named_with_those_that_exist(self):
        with tempfile.TemporaryDirectory() as folder:
            synthetic_run.write(Path(folder) / "run.h5", frames=1, size=5.0)
            with Run(folder) as run:
                with self.assertRaisesRegex(KeyError, "run.h5: no field 'speed' in frame 0; it has acceleration, .*velocity"):
                    run.field(0, "speed")
                with self.assertRaisesRegex(KeyError, "no field 'speed'; the frame has acceleration, .*velocity"):
                    run.frame(0)["speed"]
                with self.assertRaisesRegex(KeyError, "no column 'speed'; the series has time, x, y, ux, uy, vx, vy, ax, ay"):
                    run.monitor("crest")["speed"]

    def test_a_series_becomes_a_dictionary_of_its_columns(self):
        with tempfile.TemporaryDirectory() as folder:
            synthetic_run.write(Path(folder) / "run.h5", frames=1, size=5.0)
            with Run(folder) as run:
                series = run.monitor("crest")
                columns = dict(series)
                self.assertEqual(["time", "x", "y", "ux", "uy", "vx", "vy", "ax", "ay"], list(columns))
                np.testing.assert_array_equal(series["ax"], columns["ax"])
                self.assertEqual(list(columns), list(series))

    def test_an_unknown_monitor_is_named_with_those_that_exist(self):
        with tempfile.TemporaryDirectory() as folder:
            synthetic_run.write(Path(folder) / "run.h5", frames=1, size=5.0)
            with Run(folder) as run, self.assertRaisesRegex(KeyError, "no monitor 'summit'; it has crest"):
                run.monitor("summit")


if __name__ == "__main__":
    unittest.main()
