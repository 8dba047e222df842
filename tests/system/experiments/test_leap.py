"""Excess pore pressure of sand in a centrifuge (LEAP-UCD-2017, CU2), at the end of the shaking and until it is nearly gone:
the case of cases/leap_ucd_2017 in elements twice as high.

    usage: test_leap.py TREMOLO PYTHON_PACKAGE_DIR
"""

import sys
import tempfile
import unittest
from pathlib import Path

TREMOLO, PACKAGE = sys.argv.pop(1), sys.argv.pop(1)
CASES = Path(__file__).resolve().parents[3] / "cases" / "leap_ucd_2017"
sys.path[:0] = [PACKAGE, str(CASES)]

import numpy as np
from study import MEASURED, VARIANTS, column, container, largest_miss, means


class Leap(unittest.TestCase):
    def folder(self):
        return Path(self.enterContext(tempfile.TemporaryDirectory(prefix="tremolo_test_")))

    def column(self, *changes):
        folder = self.folder()
        return column(TREMOLO, folder, "column", {key: value for change in changes for key, value in change.items()})

    def test_pressure_is_that_of_the_centrifuge(self):
        time, pressure, _ = self.column(VARIANTS["coarse"][1])
        np.testing.assert_allclose(means(time, pressure, 16.0), MEASURED[16.0], atol=2.0)  # kPa, of the sensors
        self.assertLess(largest_miss(time, pressure), 0.2)

    def test_acceptance_without_a_rest_it_is_gone_too_soon(self):
        time, pressure, _ = self.column(VARIANTS["coarse"][1], VARIANTS["no_rest"][1])
        self.assertLess(means(time, pressure, 94.0).max(), 0.5)

    def test_acceptance_pressure_in_the_container_is_that_of_the_centrifuge(self):
        folder = self.folder()
        (folder / "motion.csv").write_bytes((CASES / "motion.csv").read_bytes())
        time, pressure, moved, _ = container(TREMOLO, folder)
        np.testing.assert_allclose(means(time, pressure, 16.0), MEASURED[16.0], atol=2.0)
        self.assertLess(largest_miss(time, pressure), 0.2)
        self.assertGreater(moved[-1], 0.1)  # m, downhill


if __name__ == "__main__":
    unittest.main()
