"""`tremolo soiltest --plot` draws what the test has; a file that is broken is told so.

    usage: test_soiltest_pictures.py TREMOLO SOURCE_DIR
"""

import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import matplotlib.image

SOURCE = Path(sys.argv.pop())
TREMOLO = sys.argv.pop()

SAND = """title = "loose sand"
[soil]
model = "pm4sand"
density = 1900.0
relative_density = 0.35
shear_modulus_coefficient = 476.0
contraction_rate = 0.53
[test]
kind = "direct_simple_shear"
drainage = "constant_volume"
vertical_stress = 101.3e3
strain_increment = 1e-4
[loading]
"""
LOADINGS = {
    "cyclic": 'kind = "cyclic_stress"\nstress_ratio = [0.14]\nlargest_strain = 0.02\n',
    "strength": 'kind = "cyclic_stress"\nstress_ratio = [0.14, 0.2]\nlargest_strain = 0.055\n',
    "modulus": 'kind = "modulus_curve"\nstrain_amplitude = [1e-5, 1e-4, 1e-3]\ncycles = 2\n',
    "monotonic": 'kind = "monotonic"\nstrain = 0.02\n',
}


class SoilTestPictures(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.addCleanup(self.temporary.cleanup)
        self.folder = Path(self.temporary.name)

    def soiltest(self, name):
        test = self.folder / f"{name}.toml"
        test.write_text(SAND + LOADINGS[name])
        out = test.with_suffix(".h5")
        done = subprocess.run(
            [TREMOLO, "soiltest", test, "--out", out, "--plot"], check=True, capture_output=True, text=True
        )
        self.assertIn(str(out.with_suffix(".png")), done.stdout)
        return out

    def test_pictures(self):
        for name in LOADINGS:
            with self.subTest(name):
                pixels = matplotlib.image.imread(self.soiltest(name).with_suffix(".png"))
                self.assertGreater(pixels.shape[1], 800)
                self.assertGreater(pixels[..., :3].std(), 0.02)

    def test_broken_file(self):
        out = self.soiltest("monotonic")
        whole = out.read_bytes()
        out.write_bytes(whole[: len(whole) // 3])
        done = subprocess.run(
            [sys.executable, "-m", "tremolo", "soiltest", out], capture_output=True, text=True, check=False,
            env=os.environ | {"PYTHONPATH": str(SOURCE / "python"), "PYTHONDONTWRITEBYTECODE": "1"},
        )
        self.assertEqual(done.returncode, 1)
        self.assertIn(f"tremolo: {out}: cannot be read as HDF5", done.stderr)
        self.assertEqual(done.stderr.count("\n"), 1, done.stderr)


if __name__ == "__main__":
    unittest.main()
