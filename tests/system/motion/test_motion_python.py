"""`tremolo motion` against Python: a motion that h5py wrote in two lines, and response spectra of the package.

    usage: test_motion_python.py TREMOLO SOURCE_DIR
"""

import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import h5py
import numpy as np

SOURCE = Path(sys.argv.pop())
TREMOLO = sys.argv.pop()
sys.path.insert(0, str(SOURCE / "python"))

from tremolo.response_spectrum import response_spectrum


class MotionOfPython(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.path = Path(self.folder.name)
        t = 0.01 * np.arange(1500)
        self.acceleration = np.exp(-(((t - 6.0) / 2.0) ** 2)) * np.sin(9.0 * t) + 0.2 * np.sin(31.0 * t) * (t < 9.0)

    def tearDown(self):
        self.folder.cleanup()

    def run_motion(self, *arguments):
        done = subprocess.run([TREMOLO, "motion", *arguments], check=True, capture_output=True, text=True)
        return done.stdout

    def test_two_lines_of_h5py(self):
        with h5py.File(self.path / "a.h5", "w") as f:
            f["motion"] = self.acceleration
            f["motion"].attrs.update(dt=0.01, unit="m/s2", kind="outcrop")
        out = self.run_motion(self.path / "a.h5", "--out", self.path / "a.csv")
        self.assertIn("acceleration in m/s2, 1500 samples every 0.01 s (14.99 s), outcrop", out)
        table = np.genfromtxt(self.path / "a.csv", delimiter=",", skip_header=1)
        np.testing.assert_array_equal(table[:, 1], self.acceleration)

    def test_response_spectrum_is_that_of_the_package(self):
        lines = [f"{0.01 * i!r},{a!r}" for i, a in enumerate(self.acceleration.tolist())]
        (self.path / "a.csv").write_text("t,a (m/s2)\n" + "\n".join(lines) + "\n")
        self.run_motion(self.path / "a.csv", "--response", self.path / "r.csv", "--damping", "0.07")
        table = np.genfromtxt(self.path / "r.csv", delimiter=",", names=True)
        ours = response_spectrum(self.acceleration, 0.01, table["period"], 0.07)
        np.testing.assert_allclose(table["acceleration"], ours, rtol=1e-7)


if __name__ == "__main__":
    unittest.main()
