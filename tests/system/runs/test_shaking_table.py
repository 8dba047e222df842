"""A container on a shaking table through the `tremolo` command.

    usage: test_shaking_table.py TREMOLO PYTHON_PACKAGE_DIR
"""

import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

TREMOLO, PACKAGE = sys.argv.pop(1), sys.argv.pop(1)
sys.path[:0] = [PACKAGE, str(Path(__file__).parent)]

import numpy as np
from run_files import arrays
from tremolo import Run

FREQUENCY, ARRIVAL, VELOCITY = 3.0, 0.5, 0.1  # of the pulse: Hz, s, m/s
CASE = f"""title = "A box on a table"
[motion]
kind = "within"
wave = "SV"
pulse = {{ shape = "ricker", frequency = {FREQUENCY}, time = {ARRIVAL}, velocity = {VELOCITY} }}
[mesh]
size = 0.5
box = [0.0, -4.0, 8.0, 0.0]
[soil.sand]
model = "linear_elastic"
density = 1700.0
young = 40e6
poisson = 0.28
[[region]]
soil = "sand"
polygon = [[0.0, -4.0], [8.0, -4.0], [8.0, -1.0], [0.0, 0.0]]
[boundary]
sides = "container"
base = {{ model = "shaking_table" }}
[[stage]]
kind = "gravity"
[[stage]]
kind = "shaking"
duration_s = 1.2
[[monitor]]
name = "bottom"
point = [4.1, -3.9]
[[monitor]]
name = "top"
point = [0.9, -0.2]
[[sliding_mass]]
name = "all"
polygon = [[0.0, -4.0], [8.0, -4.0], [8.0, 0.0], [0.0, 0.0]]
[output]
every_s = 0.2
history_every_s = 0.005
"""


def pulse(t):
    """Velocity of the table, m/s, and its displacement, m."""
    a = (np.pi * FREQUENCY * (t - ARRIVAL)) ** 2
    return VELOCITY * (1.0 - 2.0 * a) * np.exp(-a), VELOCITY * (t - ARRIVAL) * np.exp(-a)


class ShakingTable(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = Path(cls.enterClassContext(tempfile.TemporaryDirectory(prefix="tremolo_test_")))
        (cls.folder / "case.toml").write_text(CASE)
        cls.run_of("run")
        cls.result = Run(cls.folder / "run")

    @classmethod
    def run_of(cls, name, *options):
        done = cls.command("run", cls.folder / "case.toml", "--out", cls.folder / name, *options)
        assert done.returncode == 0, done.stdout + done.stderr

    @staticmethod
    def command(*words):
        return subprocess.run([TREMOLO, *map(str, words)], capture_output=True, text=True, timeout=120)

    def test_bottom_moves_with_the_table_in_space(self):
        table = self.result.monitor("bottom")
        velocity, displacement = pulse(table["time"])
        # A quarter of a cell above the base: the soil there lags by what 0.125 m of shear let it.
        self.assertLess(np.abs(table["vx"] - velocity).max(), 0.02 * VELOCITY)
        self.assertLess(np.abs(table["ux"] - displacement).max(), 0.02 * np.abs(displacement).max())

    def test_motion_of_the_table_is_written(self):
        table = self.result.shaking_table
        velocity, displacement = pulse(table["time"])
        self.assertLess(np.abs(table["vx"] - velocity).max(), 1e-3 * VELOCITY)
        self.assertLess(np.abs(table["ux"] - displacement).max(), 1e-3 * np.abs(displacement).max())
        self.assertLess(np.abs(np.gradient(velocity, table["time"]) - table["ax"]).max(), 0.02 * np.abs(table["ax"]).max())
        self.assertEqual(0.0, np.abs(table["vy"]).max())

    def test_a_vertical_motion_goes_with_it(self):
        """The table moves along y too; the bottom goes with it, and so does the ledger."""
        beside = "[motion.vertical]\npulse = { shape = \"ricker\", frequency = 4.0, time = 0.6, velocity = 0.05 }\n[mesh]"
        (self.folder / "both.toml").write_text(CASE.replace("[mesh]", beside))
        done = self.command("run", self.folder / "both.toml", "--out", self.folder / "both")
        self.assertEqual(0, done.returncode, done.stdout + done.stderr)
        both = Run(self.folder / "both")
        table, bottom = both.shaking_table, both.monitor("bottom")
        a = (np.pi * 4.0 * (table["time"] - 0.6)) ** 2
        expected = 0.05 * (1.0 - 2.0 * a) * np.exp(-a)
        np.testing.assert_allclose(table["vx"], self.result.shaking_table["vx"], atol=1e-6 * VELOCITY)
        self.assertLess(np.abs(table["vy"] - expected).max(), 1e-3 * 0.05)
        self.assertLess(np.abs(bottom["vy"] - table["vy"]).max(), 0.03 * 0.05)
        energy = both.energy
        self.assertLess(np.abs(energy["residual"]).max(), 0.02 * np.abs(energy["elastic"]).max())  # 1.8 %, of P alone 1.3 %

    def test_extract_takes_the_table_as_base(self):
        done = self.command("extract", self.folder / "run", "--point", "top", "--base", "shaking table", "--out", self.folder / "tables")
        self.assertEqual(0, done.returncode, done.stderr)
        written = np.genfromtxt(self.folder / "tables" / "history_top.csv", delimiter=",", names=True)
        relative = self.result.monitor("top")["ux"] - self.result.shaking_table["ux"]
        np.testing.assert_allclose(written["ux_relative_m"], relative, atol=1e-9)

    def test_frames_are_seen_from_the_table(self):
        i = int(np.argmin(np.abs(np.array(self.result.times) - 0.4)))
        moved = self.result.field(i, "displacement")
        _, table = pulse(self.result.times[i])
        self.assertGreater(abs(table), 4e-3)
        self.assertLess(np.abs(moved[:, 0]).max(), 0.1 * abs(table))

    def test_soil_stays_between_the_walls_at_rest(self):
        last = len(self.result.times) - 1
        position = self.result.field(last, "position")
        self.assertTrue((position[:, 0] > 0.0).all() and (position[:, 0] < 8.0).all() and (position[:, 1] > -4.0).all())

    def test_mean_acceleration_is_the_force_of_base_and_walls(self):
        # All soil: what it has gained of momentum in space when the pulse is over is nothing.
        mass = self.result.sliding_mass("all")
        late = mass["time"] > 0.9
        self.assertLess(np.abs(np.trapz(mass["ax"], mass["time"])), 0.02 * VELOCITY)
        self.assertLess(np.abs(mass["vx"][late].mean()), 0.02 * VELOCITY)

    def test_energy_is_accounted_for(self):
        energy = self.result.energy
        self.assertLess(np.abs(energy["residual"]).max(), 0.02 * np.abs(energy["input"]).max())

    def test_explain_says_how(self):
        text = self.command("explain", self.folder / "case.toml").stdout
        self.assertIn("Ricker pulse of 3 Hz, 0.1 m/s at 0.5 s, of a shaking table along x", text)
        self.assertIn("on  shaking table", text)
        self.assertNotIn("surface at y", text)

    def test_check_tells_the_table_s_acceleration(self):
        text = self.command("check", self.folder / "case.toml").stdout
        told = re.search(r"peak acceleration ([0-9.]+) m/s2 .* of the shaking table", text)
        # Largest (6 x - 4 x^3) exp(-x^2) is 1.952; samples that hold all frequencies miss the peak by up to a per cent.
        self.assertAlmostEqual(1.0, float(told[1]) / (1.952 * np.pi * FREQUENCY * VELOCITY), delta=0.01)

    def test_modes_and_threads_give_the_same_bits(self):
        (self.folder / "lockstep.toml").write_text(CASE + '[coupling]\nmode = "lockstep"\n')
        done = self.command("run", self.folder / "lockstep.toml", "--threads", 2, "--out", self.folder / "lockstep")
        self.assertEqual(0, done.returncode, done.stdout + done.stderr)
        here, there = (arrays(self.folder / name) for name in ("run", "lockstep"))
        self.assertEqual(here.keys(), there.keys())
        for name in here:
            if name.startswith(("frames", "monitors", "energy")):
                self.assertEqual(here[name], there[name], name)

    def test_verify_and_column_say_that_there_is_no_free_field(self):
        for words in (("verify", self.folder / "run"), ("column", self.folder / "case.toml", "--model", "fe", "--out", "x.csv")):
            done = self.command(*words)
            self.assertNotEqual(0, done.returncode, words)
            self.assertNotIn("Traceback", done.stderr)


if __name__ == "__main__":
    unittest.main(verbosity=2)
