"""Periodic sides through the `tremolo` command, wrapped and by springs.

    usage: test_periodic.py TREMOLO PYTHON_PACKAGE_DIR
"""

import sys
import unittest
from pathlib import Path

TREMOLO, PACKAGE = sys.argv.pop(1), sys.argv.pop(1)
sys.path[:0] = [PACKAGE, str(Path(__file__).parent)]

import numpy as np
from run_files import arrays
from small_case import PeriodicWorkspace, add_inclusion
from tremolo import Run


def motion(folder):
    """Of the monitor at the surface: [time][vx, vy]."""
    table = Run(folder).monitor("surface")
    return np.column_stack([table["vx"], table["vy"]])


def with_inclusion(x, sides):
    """The motion 5 m right of the left end of a soft inclusion there, which need not lie away from the seam."""
    with PeriodicWorkspace(TREMOLO, sides=sides) as work:
        return motion(add_inclusion(work, x).run("run"))


class Periodic(unittest.TestCase):
    def test_flat_ground_agrees_with_the_exact_wave_and_explain_says_how(self):
        for sides in ("periodic", "periodic_springs"):
            with PeriodicWorkspace(TREMOLO, sides=sides) as work, self.subTest(sides):
                run = work.run("run")
                verified = work.command("verify", run)
                self.assertEqual(0, verified.returncode, verified.stdout + verified.stderr)
                explained = work.command("explain", work.case).stdout
                self.assertIn(f'[boundary] sides = "{sides}"', explained)
                self.assertNotIn("left", explained)

    def test_acceptance_springs_of_flat_ground_carry_its_shear_stress_across(self):
        # The sides of sheared ground carry shear stress too, for which springs must give way: 1.3 % of the motion.
        found = {}
        for sides in ("periodic", "periodic_springs"):
            with PeriodicWorkspace(TREMOLO, sides=sides) as work:
                found[sides] = motion(work.run("run"))
        wrapped, springs = found.values()
        self.assertLess(np.abs(springs - wrapped).max(), 0.02 * np.abs(wrapped).max())

    def test_what_is_moved_by_whole_cells_moves_the_same(self):
        here, there = with_inclusion(4.0, "periodic"), with_inclusion(11.0, "periodic")
        self.assertGreater(np.abs(here[:, 1]).max(), 0.05 * np.abs(here).max(), "the inclusion scatters next to nothing")
        self.assertLess(np.abs(here - there).max(), 1e-9 * np.abs(here).max())

    def test_springs_do_nearly_the_same(self):
        wrapped, springs = with_inclusion(4.0, "periodic"), with_inclusion(4.0, "periodic_springs")
        self.assertLess(np.linalg.norm(springs - wrapped), 0.03 * np.linalg.norm(wrapped))

    def test_modes_give_the_same_bits(self):
        with PeriodicWorkspace(TREMOLO, sides="periodic_springs") as work:
            window = arrays(work.run("window", "--mode", "window"))
            lockstep = arrays(work.run("lockstep", "--mode", "lockstep"))
        self.assertEqual([], [name for name in window if window[name] != lockstep[name]])

    def test_a_side_has_no_free_field_to_ask_for(self):
        with PeriodicWorkspace(TREMOLO, sides="periodic") as work:
            refused = work.command("column", work.case, "--side", "left", "--model", "fe", "--out", work.path / "left.h5")
            self.assertNotEqual(0, refused.returncode)
            self.assertIn("its sides are periodic", refused.stdout + refused.stderr)


if __name__ == "__main__":
    unittest.main()
