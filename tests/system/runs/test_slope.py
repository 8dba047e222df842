"""The slope under an oblique wave through the `tremolo` command, small: gravity stage, softening soil, two wave fields.

    usage: test_slope.py TREMOLO PYTHON_PACKAGE_DIR
"""

import sys
import unittest
from pathlib import Path

TREMOLO, PACKAGE = sys.argv.pop(1), sys.argv.pop(1)
sys.path[:0] = [PACKAGE, str(Path(__file__).parent)]

import numpy as np
from small_case import SLOPE_BOXES, SlopeWorkspace, refine
from tremolo import Run


def write_record(path, peak_g):
    """A second of a 2 Hz sine in PEER's format."""
    samples = peak_g * np.sin(2.0 * np.pi * 2.0 * 0.02 * np.arange(51))
    path.write_text("PEER\nsine\nACCELERATION IN UNITS OF G\nNPTS= 51, DT= .02 SEC\n"
                    + "\n".join(f"{a:.6e}" for a in samples) + "\n")


class Slope(unittest.TestCase):
    def test_a_strong_wave_makes_it_yield_and_the_ledger_closes(self):
        with SlopeWorkspace(TREMOLO) as work:
            folder = work.run("run")
            run = Run(folder)
            self.assertEqual("complete", run.status)
            self.assertEqual(["domain", "left-base", "right"], sorted(run.table("processes")["process"]))
            plastic = run.field(len(run.times) - 1, "equivalent_plastic_strain")
            self.assertGreater(np.max(plastic), 0.01)
            energy = run.energy
            self.assertGreater(energy["plastic"][-1], 0.0)
            self.assertGreaterEqual(np.min(np.diff(energy["plastic"])), 0.0)
            self.assertLess(np.max(np.abs(energy["residual"])), 0.02 * np.max(energy["input"]))
            self.assertGreater(np.min(np.diff(energy["time"])), 0.0, "a row was written twice")
            self.assertGreater(np.min(np.diff(run.times)), 0.0, "a frame was written twice")
            failure = work.command("failure", folder)
            self.assertEqual(0, failure.returncode, failure.stderr)
            self.assertIn("15 degrees", failure.stdout)

    def test_a_blended_base_takes_the_field_of_each_side_at_its_end(self):
        def ricker(t):
            a = (np.pi * 2.0 * (t - 0.7)) ** 2
            return 0.01 * (1.0 - 2.0 * a) * np.exp(-a)

        with SlopeWorkspace(TREMOLO, velocity=0.01) as work:
            text = work.case.read_text().replace("angle_deg = 15.0", "angle_deg = 0.0")
            work.case.write_text(text.replace('form = "incident"', 'form = "blended"'))
            run = Run(work.run("run"))
            self.assertEqual(["domain", "left-base", "right-base"], sorted(run.table("processes")["process"]))
            lockstep = Run(work.run("lockstep", "--mode", "lockstep"))
            self.assertTrue(np.array_equal(run.boundary["traction"], lockstep.boundary["traction"]))
            boundary = run.boundary
            base = boundary["normal"][:, 1] == -1.0
            share = boundary["position"][base, 0] / 40.0
            t = boundary["time"][:, None]
            # What comes down again has been at the surface: 6 m above the base at the left, 14 m at the right.
            speed = np.sqrt(40e6 / (2.0 * 1.28) / 1700.0)
            exact = ricker(t) + (1.0 - share) * ricker(t - 12.0 / speed) + share * ricker(t - 28.0 / speed)
            self.assertLess(np.max(np.abs(boundary["free_field_velocity"][:, base, 0] - exact)), 1e-3 * 0.02)

    def test_without_motion_it_stays_at_rest(self):
        with SlopeWorkspace(TREMOLO, velocity=1e-12, duration=1.0) as work:
            run = Run(work.run("run"))
            for index in range(len(run.times)):
                self.assertLess(np.max(np.abs(run.field(index, "velocity"))), 1e-5)

    def test_acceptance_on_three_levels_particles_are_cut_where_they_enter_finer_cells(self):
        with refine(SlopeWorkspace(TREMOLO, velocity=2.0), *SLOPE_BOXES) as work:
            run = Run(work.run("run", "--threads", "1"))
            last = len(run.times) - 1
            sizes = [run.field(index, "size") for index in (0, last)]
            for of_frame in sizes:
                self.assertEqual({0.5, 0.25, 0.125}, set(of_frame))
            self.assertGreater(len(sizes[1]), len(sizes[0]))
            self.assertEqual(0, (len(sizes[1]) - len(sizes[0])) % 3, "one particle becomes four")
            # What each particle stood for at the start: cuts share it out, and no soil is lost.
            self.assertAlmostEqual(np.sum(sizes[0] ** 2), np.sum(sizes[1] ** 2), places=9)
            energy = run.energy
            self.assertLess(np.max(np.abs(energy["residual"])), 1e-3 * np.max(energy["input"]))
            picture = work.command("plot", work.path / "run", "--out", work.path / "pictures")
            self.assertEqual(0, picture.returncode, picture.stderr)

    def test_on_three_levels_it_stays_at_rest(self):
        with refine(SlopeWorkspace(TREMOLO, velocity=1e-12, duration=0.5), *SLOPE_BOXES) as work:
            run = Run(work.run("run"))
            for index in range(len(run.times)):
                self.assertLess(np.max(np.abs(run.field(index, "velocity"))), 1e-8)

    def test_another_motion_replaces_that_of_the_case(self):
        with SlopeWorkspace(TREMOLO, duration=0.3) as work:
            write_record(work.path / "own.AT2", 0.01)
            write_record(work.path / "other.AT2", 0.1)
            text = work.case.read_text()
            pulse = next(line for line in text.splitlines() if line.startswith("pulse"))
            work.case.write_text(text.replace(pulse, 'file = "own.AT2"\nkind = "incident"\nquantity = "acceleration"'))
            folder = work.run("run", "--motion", work.path / "other.AT2", "--angle", "0")
            self.assertIn("other.AT2", (folder / "case.toml").read_text())
            run = Run(folder)
            self.assertEqual(0.0, run.attribute("angle_deg"))
            self.assertGreater(np.max(np.abs(run.field(len(run.times) - 1, "velocity"))), 1e-3)


if __name__ == "__main__":
    unittest.main()
