"""The notebook-like script of docs/examples, as its reader runs it, and what it shows: series, lines, help."""

import pydoc
import subprocess
import sys
import tempfile
import types
import unittest
from pathlib import Path
from unittest import mock

import h5py
import numpy as np

import synthetic_run
import synthetic_site
import tremolo
from tremolo import Line, Run, Series, Site

SCRIPT = Path(__file__).parents[3] / "docs/examples/results_in_python/results.py"


class Script(unittest.TestCase):
    def test_it_runs_from_its_first_cell_to_its_last(self):
        with tempfile.TemporaryDirectory() as folder:
            site, run = Path(folder) / "site", Path(folder) / "run"
            site.mkdir(), run.mkdir()
            synthetic_site.write(site)
            synthetic_run.write(run / "run.h5", size=2.0, frames=4)
            with h5py.File(run / "run.h5", "a") as file:
                _write_line(file)
            done = subprocess.run([sys.executable, SCRIPT, site, run], capture_output=True, text=True)
            self.assertEqual(0, done.returncode, done.stderr)
            self.assertTrue((site / "strain.png").exists() and (run / "velocity.png").exists())
        for text in ("synthetic site under eql, fe, wave", "Vs30 = 394 m/s", "eql: PGA = 3.00 1", "line shaft: largest shear strain 0.02 at y = -3.00 m"):
            self.assertIn(text, done.stdout)


def _write_line(file):
    """Two points 1 and 3 m deep, of which the lower one strains by 0.02 t."""
    time = np.linspace(0.0, 1.0, 11)
    columns, rows = ["time"], [time]
    for number, depth in enumerate((1.0, 3.0)):
        for name, values in {"x": 0 * time, "y": 0 * time - depth, "ux": 0 * time, "uy": 0 * time, "gxy": 0.01 * (number + 1) * time}.items():
            columns.append(f"{name}{number}")
            rows.append(values)
    dataset = file.create_dataset("lines/shaft", data=np.column_stack(rows))
    dataset.attrs["columns"] = np.array([name.encode() for name in columns])
    dataset.attrs["units"] = np.array([b"s"] + [b"m"] * (len(columns) - 1))


class Histories(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.path = Path(folder.name) / "run.h5"
        synthetic_run.write(cls.path, size=2.0, frames=2)
        with h5py.File(cls.path, "a") as file:
            _write_line(file)
        cls.run_file = Run(cls.path)
        cls.addClassCleanup(cls.run_file.close)

    def test_a_line_has_values_and_coordinates(self):
        line = self.run_file.line("shaft")
        np.testing.assert_allclose(line.values("gxy"), np.outer(np.linspace(0.0, 1.0, 11), [0.01, 0.02]))
        found = line.coordinates
        np.testing.assert_allclose(found["y"], [-1.0, -3.0])
        np.testing.assert_allclose(found["distance"], [0.0, 2.0])
        np.testing.assert_allclose(found["time"], np.linspace(0.0, 1.0, 11))

    def test_a_part_of_a_history_holds_its_ends(self):
        point = self.run_file.line("shaft")[1]
        part = point.between(0.2, 0.5)
        np.testing.assert_allclose(part.time, [0.2, 0.3, 0.4, 0.5])
        np.testing.assert_allclose(part["gxy"], 0.02 * part.time)
        self.assertEqual(point.units, part.units)

    def test_a_frame_of_pandas_has_the_time_for_its_index_and_the_units(self):
        """Where pandas is not installed, by what it is called with."""
        made = types.SimpleNamespace(attrs={})
        pandas = types.SimpleNamespace(DataFrame=mock.Mock(return_value=made), Index=mock.Mock(return_value="index"))
        with mock.patch.dict(sys.modules, pandas=pandas):
            frame = self.run_file.line("shaft")[1].to_frame()
        (rows,), options = pandas.DataFrame.call_args
        self.assertEqual(["x", "y", "ux", "uy", "gxy"], options["columns"])
        self.assertEqual("index", options["index"])
        np.testing.assert_allclose(rows[:, 4], 0.02 * np.linspace(0.0, 1.0, 11))
        self.assertEqual("time", pandas.Index.call_args[1]["name"])
        self.assertEqual("s", frame.attrs["units"]["time"])

    def test_without_pandas_it_says_what_to_install(self):
        with mock.patch.dict(sys.modules, pandas=None), self.assertRaisesRegex(ImportError, "python3-pandas.*dict\\(series\\)"):
            self.run_file.monitor("crest").to_frame()

    def test_what_is_printed_says_what_there_is(self):
        self.assertIn("2 frames, 0 to 0.02 s; monitors: crest; lines: shaft", repr(self.run_file))
        self.assertRegex(repr(self.run_file.monitor("crest")), r"<Series: \d+ rows, 0 to .* s; time \(s\), x \(m\)")


class Help(unittest.TestCase):
    def test_every_public_name_teaches(self):
        """Its own words with an example, and a sentence for each of its methods."""
        for item in (Run, Series, Line, Site):
            self.assertIn("\n        ", item.__doc__, item)
            for name, member in vars(item).items():
                if not name.startswith("_") and (callable(member) or isinstance(member, (property, classmethod))):
                    self.assertTrue(getattr(item, name).__doc__, f"{item.__name__}.{name}")
        for name in tremolo.__all__:
            self.assertIn(f"help({name})", tremolo.__doc__)
        self.assertIn('run.monitor("crest")["ax"]', pydoc.render_doc(tremolo))


if __name__ == "__main__":
    unittest.main()
