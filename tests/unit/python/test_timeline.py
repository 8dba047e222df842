"""The timeline in words and as a picture: who computed, who waited, for whom."""

import tempfile
import unittest
from pathlib import Path

import h5py
import numpy as np

import synthetic_run
from tremolo import Run, timeline

# 2 s in slices of 0.5 s: `right` computes to the end and the domain waits for it; `left` is done after 0.5 s.
SECONDS = {
    "left": {"computing": [0.5, 0.0, 0.0, 0.0], "waiting for domain": [0.0, 0.5, 0.5, 0.5]},
    "right": {"computing": [0.45, 0.45, 0.45, 0.45], "mapping": [0.05, 0.05, 0.05, 0.05]},
    "domain": {
        "computing": [0.1, 0.2, 0.2, 0.2],
        "mapping": [0.0, 0.1, 0.1, 0.1],
        "waiting for left": [0.1, 0.0, 0.0, 0.0],
        "waiting for right": [0.3, 0.2, 0.2, 0.2],
    },
}


def write_table(path):
    rows = [
        (process, activity, 0.5 * i, 0.5, seconds)
        for process, activities in SECONDS.items()
        for activity, slices in activities.items()
        for i, seconds in enumerate(slices)
    ]
    columns = ["process", "activity", "time", "slice", "duration"]
    with h5py.File(path, "a") as file:
        group = file.create_group("timeline")
        group.attrs["columns"] = np.array(columns, "S")
        for column, values in zip(columns, zip(*rows)):
            group[column] = np.array(values, "S") if isinstance(values[0], str) else np.array(values)


class Timelines(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = Path(cls.temporary.name)
        synthetic_run.write(cls.folder / "run.h5", frames=2, size=4.0)
        write_table(cls.folder / "run.h5")

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def test_come_back_as_they_were_written(self):
        with Run(self.folder) as run:
            lines = timeline.timelines(run)
        self.assertEqual(list(lines), list(SECONDS))
        np.testing.assert_array_equal(lines["domain"].activities["mapping"], SECONDS["domain"]["mapping"])
        for line in lines.values():
            self.assertAlmostEqual(line.end, 2.0)
        self.assertEqual(list(lines["domain"].waits()), ["right", "left"])
        self.assertEqual(lines["left"].done(), 0.5)
        self.assertEqual(lines["right"].done(), 2.0)

    def test_name_the_slow_source(self):
        with Run(self.folder) as run:
            said = list(timeline.sentences(timeline.timelines(run)))
        self.assertEqual(said[2], "domain: of 2.00 s it computed 35 %, mapped 15 % and waited 50 %, mostly for right")
        self.assertEqual(said[3], "the free fields were done after 2.00 s, right last")
        self.assertEqual(said[4], "domain waited 0.90 s for right: a faster right would shorten the run by at most that")

    def test_are_drawn(self):
        with Run(self.folder) as run:
            picture = timeline.picture(run, self.folder)
        self.assertGreater(picture.stat().st_size, 10_000)

    def test_are_missed_where_the_run_has_none(self):
        path = self.folder / "without.h5"
        synthetic_run.write(path, frames=2, size=4.0)
        with Run(path) as run, self.assertRaisesRegex(ValueError, "holds no timeline"):
            timeline.timelines(run)


if __name__ == "__main__":
    unittest.main()
