"""The shipped lined tunnel: its moment and thrust under a slow wave are those of the exact ring in ground that is sheared as the free
field is. In cells of 1 m, and as it is.

    usage: test_lined_tunnel.py TREMOLO SOURCE_DIR
"""

import sys
import tempfile
import unittest
from pathlib import Path

TREMOLO, SOURCE = sys.argv.pop(1), Path(sys.argv.pop(1))
CASE = SOURCE / "cases" / "lined_tunnel"
sys.path[:0] = [str(SOURCE / "python"), str(CASE)]

from study import ALONE, BONDED, OBLIQUE, TEXT, errors_of, shear_strain
from tremolo.variants import run_variant

COARSE = {TEXT[TEXT.index("[[refine]]"):TEXT.index("[time]")]: ""}


def errors(free, lined):
    with tempfile.TemporaryDirectory(prefix="tremolo_test_") as folder:
        with run_variant(TREMOLO, CASE / "case.toml", free, folder, "free") as run:
            _, strain = shear_strain(run)
        with run_variant(TREMOLO, CASE / "case.toml", lined, folder, "lined") as run:
            return errors_of(run, strain, sticks=True)


class LinedTunnel(unittest.TestCase):
    def test_in_cells_of_1_m(self):
        moment, thrust = errors(ALONE | COARSE, BONDED | COARSE)
        self.assertLess(abs(moment), 0.05)
        self.assertLess(abs(thrust), 0.05)


class AcceptanceLinedTunnel(unittest.TestCase):
    def test_as_it_is(self):
        for error in errors(ALONE, {}):
            self.assertLess(abs(error), 0.02)

    def test_under_a_wave_at_15_degrees(self):
        for error in errors(ALONE | OBLIQUE, OBLIQUE):
            self.assertLess(abs(error), 0.02)


if __name__ == "__main__":
    unittest.main()
