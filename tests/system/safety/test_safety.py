"""`tremolo safety` as a user calls it: the slope of cases/static_slope against Griffiths and Lane (1999), and cases that
have no factor of safety.

    test_safety.py TREMOLO SOURCE_DIR
"""

import csv
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SOURCE = Path(sys.argv.pop())
TREMOLO = sys.argv.pop()
CASE = SOURCE / "cases" / "static_slope" / "case.toml"
PUBLISHED = 1.4


def safety(*arguments):
    return subprocess.run([TREMOLO, "safety", *map(str, arguments)], capture_output=True, text=True)


class Safety(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.path = Path(self.folder.name)

    def tearDown(self):
        self.folder.cleanup()

    def changed(self, *changes):
        text = CASE.read_text()
        for old, new in changes:
            self.assertIn(old, text)
            text = text.replace(old, new)
        path = self.path / "case.toml"
        path.write_text(text)
        return path

    def test_factor_and_mechanism(self):
        done = safety(self.changed(("size = 1.0", "size = 2.5")), "--out", self.path / "out", "--tolerance", "0.02")
        self.assertEqual(done.returncode, 0, done.stderr)
        factor, fails = map(float, re.search(r"stands with (\S+), fails with (\S+)", done.stdout).groups())
        self.assertLess(abs(factor / PUBLISHED - 1.0), 0.1)  # four cells of height
        with open(self.path / "out" / "safety.csv") as file:
            trials = [(float(row["factor"]), row["stands"] == "1") for row in csv.DictReader(file)]
        self.assertAlmostEqual(max(f for f, stands in trials if stands), factor, delta=1e-3)
        self.assertAlmostEqual(min(f for f, stands in trials if not stands), fails, delta=1e-3)
        with open(self.path / "out" / "mechanism.csv") as file:
            rows = [{key: float(value) for key, value in row.items()} for row in csv.DictReader(file)]
        speed = [(row["vx_over_fastest"] ** 2 + row["vy_over_fastest"] ** 2) ** 0.5 for row in rows]
        self.assertAlmostEqual(max(speed), 1.0, places=3)
        fastest = rows[speed.index(max(speed))]
        self.assertTrue(14.0 < fastest["x_m"] < 44.0, fastest)  # the slope itself
        self.assertGreater((self.path / "out" / "mechanism.png").stat().st_size, 10000)

    def test_what_has_no_factor(self):
        elastic = self.changed(
            ('model = "mohr_coulomb"', 'model = "linear_elastic"'), ("cohesion_peak = 9.81e3", "#"),
            ("cohesion_residual = 9.81e3\n", ""), ("friction_peak_deg = 20.0\n", ""),
            ("friction_residual_deg = 20.0\n", ""), ("softening = 0.0\n", ""))
        done = safety(elastic)
        self.assertNotEqual(done.returncode, 0)
        self.assertIn('case.toml: no soil has a cohesion and a friction angle that could be reduced', done.stderr)
        weightless = self.changed(('[[stage]]\nkind = "gravity"\nresidual = 1e-4\n', ""))
        done = safety(weightless)
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("the case needs", done.stderr)
        done = safety(CASE, "--tolerance", "0")
        self.assertEqual(done.returncode, 2)
        self.assertIn("--tolerance", done.stderr)


unittest.main(argv=sys.argv[:1])
