"""Tests of a synthetic run that is written once for all tests of a class."""

import tempfile
import unittest
from pathlib import Path

from tremolo import Run


class WithRun(unittest.TestCase):
    """`path` of the run's file, which write() makes; in each test `run`, open."""

    @classmethod
    def write(cls):
        """Writes the run to `path`."""
        raise NotImplementedError

    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.path = Path(cls.folder.name) / "run.h5"
        cls.write()

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def setUp(self):
        self.run = Run(self.path)
        self.addCleanup(self.run.close)
