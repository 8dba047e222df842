"""The shipped lined tunnel in sand that liquefies: its thrust goes from that in sand at rest to that in a heavy fluid, moments are largest
before the sand has lost its strength, and the ring floats up. Smaller, in cells of 1.5 m without drainage; and as it is.

    usage: test_liquefied_tunnel.py TREMOLO SOURCE_DIR
"""

import sys
import tempfile
import unittest
from pathlib import Path

TREMOLO, SOURCE = sys.argv.pop(1), Path(sys.argv.pop(1))
CASE = SOURCE / "cases" / "lined_tunnel"
sys.path[:0] = [str(SOURCE / "python"), str(CASE)]

import numpy as np
from liquefied import LIQUEFIED, PERIOD, closed_forms, rise, thrust
from tremolo.variants import run_variant

# Layers and sides on cells of 1.5 m, water of 0.22 GPa that does not drain, and half of the shaking.
SKETCH = (("size = 1.0", "size = 1.5"), ("thickness = 20.0", "thickness = 21.0"), ("thickness = 10.0", "thickness = 9.0"), ("-20.0]", "-21.0]"),
          ("[-30.0, ", "[-21.0, "), ("[30.0, ", "[21.0, "), (", 30.0, 0.0]", ", 21.0, 0.0]"), ("-24.5", "-17.25"),
          ("level = -2.0\n", "level = -2.0\nbulk_modulus = 2.2e8\n"), ("permeability = 1e-4\n", 'permeability = 1e-4\ndrainage = "undrained"\n'),
          ('"hostun_dr45"\n', '"hostun_dr45"\ntolerance = 1e-3\n'), ("duration_s = 9.0 ", "duration_s = 4.9 "), ("duration_s = 3.0\n", "duration_s = 0.1\n"))


class LiquefiedTunnel(unittest.TestCase):
    def expect_sand_to_become_a_fluid(self, sketch):
        text = LIQUEFIED.read_text()
        for old, new in sketch:
            self.assertIn(old, text)
            text = text.replace(old, new)
        with tempfile.TemporaryDirectory(prefix="tremolo_test_") as folder:
            case = Path(folder) / "sketch.toml"
            case.write_text(text)
            (Path(folder) / "motion.csv").write_bytes((CASE / "motion.csv").read_bytes())
            with run_variant(TREMOLO, case, {}, folder, "run") as run:
                ring, free = run.lining("ring"), run.monitor("free field")
                at_rest, _, fluid = closed_forms(ring)
                compression, largest = thrust(ring), np.abs(ring.moment).max(axis=1)
                self.assertLess(abs(compression[0] / at_rest - 1.0), 0.05)
                last = ring.time >= ring.time[-1] - PERIOD
                self.assertLess(abs(compression[last].mean() / fluid - 1.0), 0.05)
                # Until it liquefies, sand that softens shears the ring; then it no longer does as hard.
                liquefied = free["time"][np.argmax(free["pore_pressure_ratio"] >= 0.9)]
                self.assertGreater(liquefied, 0.0)
                self.assertLess(ring.time[np.argmax(largest)], liquefied)
                self.assertGreater(largest.max(), 5.0 * largest[0])
                self.assertLess(largest[last].mean(), 0.6 * largest.max())
                cycles = np.interp(np.arange(2.0, ring.time[-1], PERIOD), ring.time, rise(ring))
                self.assertGreater(np.diff(cycles).min(), 0.0, cycles)
                self.assertGreater(rise(ring)[-1], 0.02)

    def test_smaller_in_cells_of_1_5_m(self):
        self.expect_sand_to_become_a_fluid(SKETCH)

    def test_acceptance_as_it_is(self):
        self.expect_sand_to_become_a_fluid(())


if __name__ == "__main__":
    unittest.main()
