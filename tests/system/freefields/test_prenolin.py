"""The linear case of the PRENOLIN benchmark's profile P1 (Regnier et al. 2016, BSSA 106(5), 2112-2135): 20 m of 300 m/s on a rigid
base that moves as the record in the borehole, v(t). Waves go up and down without loss, so the surface moves as

    2 (v(t - T) - v(t - 3 T) + v(t - 5 T) - ...),    T = H/Vs,

with peaks of the ratio of both spectra at (2 n + 1) 3.75 Hz. The record is that of the reference data.

    usage: test_prenolin.py TREMOLO PYTHON_PACKAGE_DIR MY_FIELD
"""

import os
import sys
import unittest
from pathlib import Path

TREMOLO, PACKAGE, _ = sys.argv.pop(1), sys.argv.pop(1), sys.argv.pop(1)
sys.path.insert(0, PACKAGE)

import numpy as np
from free_field_cases import ColumnWorkspace

REFERENCE = Path(os.environ.get("TREMOLO_REFERENCE", "../shared/reference"))
RECORD = (REFERENCE / "records" / "prenolin_P1_sem2dpack" / "inputp1").resolve()
P1 = "\n[[profile]]\nthickness = 20.0\ndensity = 2000.0\nvs = 300.0\nvp = 700.0\n"
TRAVEL = 20.0 / 300.0  # s


def by_images(time, base):
    """The surface's velocity, from that of the base at equal times."""
    surface, sign, delay = np.zeros_like(base), 2.0, TRAVEL
    while delay < time[-1] - time[0]:
        surface += sign * np.interp(time - delay, time, base, left=0.0)
        sign, delay = -sign, delay + 2.0 * TRAVEL
    return surface


@unittest.skipUnless(RECORD.exists(), f"no {RECORD}")
class LinearP1(unittest.TestCase):
    def test_columns_against_the_method_of_images(self):
        """Over 5 s, 37 times up and down. Measured: 0.17 % (fe) and 0.19 % (ode) of the peak."""
        motion = f'file = "{RECORD}"\nquantity = "velocity"\nunit = "m/s"\nkind = "within"'
        with ColumnWorkspace(TREMOLO, ground=P1, motion=motion, size=0.25) as work:
            for name in ("fe", "ode"):
                surface, base = work.histories(name, "--depths", "0,20", "--duration", "5", "--every", "0.001")
                expected = by_images(base["time"], base["vx"])
                error = np.abs(surface["vx"] - expected).max() / np.abs(expected).max()
                self.assertLess(error, 0.005, name)


if __name__ == "__main__":
    unittest.main()
