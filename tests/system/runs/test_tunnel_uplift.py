"""The shipped tunnel in cells of 2 m, with water ten times softer and a motion half as long: liquefied sand lifts it.

    usage: test_tunnel_uplift.py TREMOLO PYTHON_PACKAGE_DIR
"""

import sys
import tempfile
import unittest
from pathlib import Path

TREMOLO, PACKAGE = sys.argv.pop(1), sys.argv.pop(1)
CASE = Path(__file__).resolve().parents[3] / "cases" / "tunnel_uplift"
sys.path[:0] = [PACKAGE, str(CASE)]

import numpy as np
from study import COMPARED, PERIOD, SHORT, coarse, liquefied, rate, sides, synthesise, uplift
from tremolo.variants import run_variant


def coarser(duration):
    """Cells of 2 m, of which a box has whole numbers."""
    return coarse(duration, 2.0) | sides(22.0)


class Tunnel(unittest.TestCase):
    """The light tunnel of the case after some seconds."""

    duration = None  # s

    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory(prefix="tremolo_test_")
        place = Path(cls.folder.name)
        synthesise(TREMOLO, place)
        cls.place = place
        cls.light = run_variant(TREMOLO, CASE / "case.toml", coarser(cls.duration), place, "light")

    @classmethod
    def tearDownClass(cls):
        cls.light.close()
        cls.folder.cleanup()

    def expect_energy_accounted_for(self):
        energy = self.light.energy
        dissipated = energy["plastic"][-1] + energy["viscous"][-1]
        self.assertLess(np.abs(energy["residual"]).max(), 0.02 * dissipated)


class TunnelUplift(Tunnel):
    duration = 5.0

    def test_energy_is_accounted_for(self):
        self.expect_energy_accounted_for()

    def test_the_tunnel_rises_as_the_ground_begins_to_liquefy(self):
        time, rise = uplift(self.light)
        self.assertGreater(np.diff(np.interp(np.arange(3.0, self.duration, PERIOD), time, rise)).min(), 0.0, rise)


class AcceptanceTunnelUplift(Tunnel):
    duration = SHORT + 4.0

    def test_energy_is_accounted_for(self):
        self.expect_energy_accounted_for()

    def test_the_free_field_liquefies_within_eight_seconds(self):
        self.assertLess(liquefied(self.light, "free field"), 8.0)

    def test_the_tunnel_rises_with_every_cycle_while_the_ground_shakes(self):
        time, rise = uplift(self.light)
        after_cycles = np.interp(np.arange(3.0, SHORT - PERIOD, PERIOD), time, rise)
        self.assertGreater(np.diff(after_cycles).min(), 0.0, after_cycles)

    def test_the_tunnel_stops_with_the_shaking(self):
        time, rise = uplift(self.light)
        during = rate(time, rise, 3.0, SHORT)
        after = rate(time, rise, SHORT + PERIOD, time[-1])
        self.assertGreater(during, 0.01)  # m/s
        self.assertLess(abs(after), 0.05 * during)

    def test_a_tunnel_as_heavy_as_the_sand_stays(self):
        changes = {**coarser(COMPARED), "density = 300.0 ": "density = 1900.0 "}
        with run_variant(TREMOLO, CASE / "case.toml", changes, self.place, "heavy") as heavy:
            time, rise = uplift(heavy)
        self.assertLess(abs(rise[-1]), 0.05 * np.interp(time[-1], *uplift(self.light)))


if __name__ == "__main__":
    unittest.main()
