"""The slope under an oblique wave through the `tremolo` command, small: gravity stage, softening soil, two wave fields.

    usage: test_slope.py TREMOLO PYTHON_PACKAGE_DIR
"""

import sys
import unittest
from pathlib import Path

TREMOLO, PACKAGE = sys.argv.pop(1), sys.argv.pop(1)
sys.path[:0] = [PACKAGE, str(Path(__file__).parent)]

import numpy as np
from small_case import SlopeWorkspace
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

    def test_without_motion_it_stays_at_rest(self):
        with SlopeWorkspace(TREMOLO, velocity=1e-12, duration=1.0) as work:
            run = Run(work.run("run"))
            for index in range(len(run.times)):
                self.assertLess(np.max(np.abs(run.field(index, "velocity"))), 1e-5)

    def test_another_motion_replaces_that_of_the_case(self):
        with SlopeWorkspace(TREMOLO, duration=0.3) as work:
            write_record(work.path / "own.AT2", 0.01)
            write_record(work.path / "other.AT2", 0.1)
            text = work.case.read_text()
            pulse = next(line for line in text.splitlines() if line.startswith("pulse"))
            work.case.write_text(text.replace(pulse, 'file = "own.AT2"\nquantity = "acceleration"'))
            folder = work.run("run", "--motion", work.path / "other.AT2", "--angle", "0")
            self.assertIn("other.AT2", (folder / "case.toml").read_text())
            run = Run(folder)
            self.assertEqual(0.0, run.attribute("angle_deg"))
            self.assertGreater(np.max(np.abs(run.field(len(run.times) - 1, "velocity"))), 1e-3)


if __name__ == "__main__":
    unittest.main()
