"""The shipped tunnel in cells of 1 m, with water ten times softer and a motion half as long: liquefied sand lifts it.

    usage: test_tunnel_uplift.py TREMOLO PYTHON_PACKAGE_DIR
"""

import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

TREMOLO, PACKAGE = sys.argv.pop(1), sys.argv.pop(1)
CASE = Path(__file__).resolve().parents[3] / "cases" / "tunnel_uplift"
sys.path[:0] = [PACKAGE, str(CASE)]

import numpy as np
from study import PERIOD, liquefied, net_lift, rate, uplift
from tremolo.variants import run_variant, variant

SHAKEN = 9.5 * PERIOD  # s
COMPARED = 8.0  # s


def coarse(duration):
    """What makes a coarse case of the shipped one."""
    return {
        "level = 0.0\n\n[soil.sand]": "level = 0.0\nbulk_modulus = 2.2e8\n\n[soil.sand]",
        "[[refine]]\nbox = [17.0, -11.0, 28.0, 0.0]\nlevel = 1\n": "",
        "duration_s = 35.0 ": f"duration_s = {duration:.3f} ",
    }


class TunnelUplift(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory(prefix="tremolo_test_")
        place = Path(cls.folder.name)
        changes = {"cycles = 18.5 ": "cycles = 9.5 ", "samples = 2481": "samples = 1281"}
        (place / "motion.toml").write_text(variant(CASE / "motion.toml", changes))
        subprocess.run([TREMOLO, "motion", "--synthesise", "motion.toml", "--out", "motion.csv"], cwd=place, check=True, capture_output=True)
        cls.place = place
        cls.light = run_variant(TREMOLO, CASE / "case.toml", coarse(SHAKEN + 4.0), place, "light")

    @classmethod
    def tearDownClass(cls):
        cls.light.close()
        cls.folder.cleanup()

    def test_the_free_field_liquefies_within_eight_seconds(self):
        self.assertLess(liquefied(self.light, "free field"), 8.0)

    def test_the_tunnel_rises_with_every_cycle_while_the_ground_shakes(self):
        time, rise = uplift(self.light)
        after_cycles = np.interp(np.arange(3.0, SHAKEN - PERIOD, PERIOD), time, rise)
        self.assertGreater(np.diff(after_cycles).min(), 0.0, after_cycles)

    def test_the_tunnel_stops_with_the_shaking(self):
        time, rise = uplift(self.light)
        during = rate(time, rise, 3.0, SHAKEN)
        after = rate(time, rise, SHAKEN + PERIOD, time[-1])
        self.assertGreater(during, 0.01)  # m/s
        self.assertLess(abs(after), 0.05 * during)

    def test_energy_is_accounted_for(self):
        energy = self.light.energy
        dissipated = energy["plastic"][-1] + energy["viscous"][-1]
        self.assertLess(np.abs(energy["residual"]).max(), 0.02 * dissipated)

    def test_a_tunnel_as_heavy_as_the_sand_stays(self):
        changes = {**coarse(COMPARED), "density = 300.0 ": "density = 1900.0 "}
        with run_variant(TREMOLO, CASE / "case.toml", changes, self.place, "heavy") as heavy:
            time, rise = uplift(heavy)
        self.assertLess(abs(rise[-1]), 0.05 * np.interp(time[-1], *uplift(self.light)))


if __name__ == "__main__":
    unittest.main()
