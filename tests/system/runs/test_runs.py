"""Whole runs through the `tremolo` command: modes, free fields, energy, verification.

    usage: test_runs.py TREMOLO PYTHON_PACKAGE_DIR
"""

import functools
import json
import sys
import unittest
from pathlib import Path

TREMOLO, PACKAGE = sys.argv.pop(1), sys.argv.pop(1)
sys.path[:0] = [PACKAGE, str(Path(__file__).parent)]

import numpy as np
from run_files import arrays
from small_case import Workspace
from tremolo import Run


@functools.cache
def as_it_is():
    """The small box, and its run with one thread and windows."""
    work = Workspace(TREMOLO)
    unittest.addModuleCleanup(work.__exit__)
    return work, work.run("as_it_is", "--mode", "window", "--threads", "1")


class Modes(unittest.TestCase):
    def test_window_and_lockstep_write_the_same_bits(self):
        work, run = as_it_is()
        window, lockstep = arrays(run), arrays(work.run("lockstep", "--mode", "lockstep"))
        self.assertEqual(window.keys(), lockstep.keys())
        self.assertGreater(len(window), 50)
        self.assertEqual([], [name for name in window if window[name] != lockstep[name]])

    def test_a_base_blended_from_equal_fields_is_the_total_one(self):
        with Workspace(TREMOLO, base="blended") as blended:
            self.assertEqual(arrays(as_it_is()[1])["boundary/traction"], arrays(blended.run("run"))["boundary/traction"])

    def test_thread_count_does_not_change_a_bit(self):
        work, run = as_it_is()
        one, two = arrays(run), arrays(work.run("two", "--threads", "2"))
        self.assertEqual([], [name for name in one if one[name] != two[name]])


class Physics(unittest.TestCase):
    def test_a_run_agrees_with_the_exact_wave_and_says_so(self):
        work, run = as_it_is()
        verified = work.command("verify", run)
        self.assertEqual(0, verified.returncode, verified.stdout + verified.stderr)
        self.assertTrue((run / "verify.json").exists())

    def test_verify_fails_above_the_tolerance_of_the_case(self):
        with Workspace(TREMOLO, tolerance=1e-4) as work:
            verified = work.command("verify", work.run("run"))
            self.assertEqual(1, verified.returncode, verified.stdout + verified.stderr)

    def test_acceptance_the_error_falls_at_second_order(self):
        errors = []
        for size in (1.0, 0.5):
            with Workspace(TREMOLO, size=size, tolerance=1.0) as work:
                run = work.run("run")
                work.command("verify", run)
                report = json.loads((run / "verify.json").read_text())
                errors.append(next(r["relative_l2"] for r in report["regions"] if r["name"] == "whole"))
        self.assertGreater(np.log2(errors[0] / errors[1]), 1.8, errors)

    def test_energy_closes(self):
        energy = Run(as_it_is()[1]).energy
        self.assertLess(np.max(np.abs(energy["residual"])), 0.02 * np.max(energy["kinetic"]))
        self.assertLessEqual(np.max(np.diff(energy["dashpots"])), 0.0)

    def test_matched_layers_let_the_free_field_in(self):
        """In both modes, to the bit; and what they take up is in the energy."""
        with Workspace(TREMOLO) as work:
            text = work.case.read_text()
            for side in ("left", "right", "base"):
                text = text.replace(f'{side} = {{ model = "wave"', f'{side} = {{ model = "wave", absorber = "matched_layer"')
            work.case.write_text(text.replace("size = 1.0", "size = 1.0\nlayer_cells = 6"))
            layers = work.run("layers")
            lockstep = arrays(work.run("lockstep", "--mode", "lockstep"))
            window = arrays(layers)
            self.assertEqual([], [name for name in window if window[name] != lockstep[name]])
            verified = work.command("verify", layers)
            self.assertEqual(0, verified.returncode, verified.stdout + verified.stderr)
            self.assertIn("matched layers", Run(layers).table("timings")["pass"])
            energy = Run(layers).energy
            self.assertLess(np.max(np.abs(energy["residual"])), 0.02 * np.max(energy["kinetic"]))

    def test_a_monitors_acceleration_is_the_derivative_of_its_velocity(self):
        with Workspace(TREMOLO, order="usl") as work:
            usl = Run(work.run("run")).monitor("surface")
        for order, surface in (("usl", usl), ("musl", Run(as_it_is()[1]).monitor("surface"))):
            derivative = np.gradient(surface["vx"], surface["time"])
            error = np.linalg.norm(surface["ax"] - derivative) / np.linalg.norm(derivative)
            self.assertLess(error, 0.05, order)

    def test_column_and_wave_are_interchangeable_at_vertical_incidence(self):
        difference, = self.column_beside_wave(0.25)
        self.assertLess(difference, 1e-3)

    def test_acceptance_the_difference_of_column_and_wave_is_of_second_order(self):
        """It is the column's own error."""
        coarse, fine = self.column_beside_wave(0.25, 0.125)
        self.assertGreater(np.log2(coarse / fine), 1.8, (coarse, fine))

    def column_beside_wave(self, *sizes):
        """Relative L2 of the motion at the surface, by the size of the column's elements, m."""

        def history(**changes):
            with Workspace(TREMOLO, angle=0.0, **changes) as work:
                return Run(work.run("run")).monitor("surface")["vx"]

        exact = history(side="wave")
        self.assertGreater(np.max(np.abs(exact)), 0.19)
        return [np.linalg.norm(history(side="fe", element=size) - exact) / np.linalg.norm(exact) for size in sizes]


if __name__ == "__main__":
    unittest.main()
