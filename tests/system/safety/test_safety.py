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
BLOCK = SOURCE / "cases" / "block_on_slope" / "case.toml"
PUBLISHED = 1.4


def safety(*arguments):
    return subprocess.run([TREMOLO, "safety", *map(str, arguments)], capture_output=True, text=True)


class Safety(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.path = Path(self.folder.name)

    def tearDown(self):
        self.folder.cleanup()

    def changed(self, *changes, case=CASE):
        text = case.read_text()
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
        left, right, depth = map(float, re.search(
            r"lies between x = (\S+) and (\S+) m, down to (\S+) m below", done.stdout).groups())
        self.assertTrue(10.0 < left < 22.0 and 40.0 < right < 50.0 and 3.0 < depth < 10.0, done.stdout)

    def test_acceptance_a_tunnel_behind_the_slip_leaves_the_factor(self):
        ring = ('[[lining]]\nname = "ring"\ncircle = { centre = [46.0, 2.0], radius = 2.2 }\nthickness = 0.3\nyoung = 30e9\n'
                'poisson = 0.2\ndensity = 2500.0\nfriction = 0.3\n\n[mesh]')
        case = self.changed(("[mesh]", ring))
        self.assertEqual(safety(case, "--floor", "1.33").returncode, 0)  # 1.38 without the tunnel
        self.assertEqual(safety(case, "--floor", "1.43").returncode, 1)

    def test_a_floor_is_one_trial_with_a_status(self):
        case = self.changed(("size = 1.0", "size = 2.5"))
        done = safety(case, "--floor", "1.1", "--out", self.path / "out")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertIn("factor of safety at least 1.1", done.stdout)
        self.assertEqual(done.stdout.count("F ="), 1)
        self.assertFalse((self.path / "out" / "mechanism.csv").exists())
        done = safety(case, "--floor", "1.8", "--out", self.path / "out")
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        self.assertIn("factor of safety below 1.8", done.stdout)
        self.assertTrue((self.path / "out" / "mechanism.png").exists())

    def test_stages_have_factors_of_their_own(self):
        load = '\n[[stage]]\nkind = "load"\nname = "hall"\nx_m = [46.0, 52.0]\npressure_pa = 400e3\n'
        case = self.changed(("size = 1.0", "size = 2.5"), ("residual = 1e-4\n", "residual = 1e-4\n" + load))
        bare = safety(case, "--stage", "gravity", "--floor", "1.2")
        self.assertEqual(bare.returncode, 0, bare.stdout + bare.stderr)
        self.assertIn("at the end of stage 'gravity'", bare.stdout)
        for stage in (["--stage", "hall"], []):  # the last one is the default
            loaded = safety(case, *stage, "--floor", "1.2")
            self.assertEqual(loaded.returncode, 1, loaded.stdout + loaded.stderr)
            self.assertIn("at the end of stage 'hall'", loaded.stdout)
        shaken = safety(case, "--stage", "shaking")
        self.assertEqual(shaken.returncode, 2)
        self.assertIn("'shaking'; possible are gravity, hall", shaken.stderr)

    def test_soil_between_two_points(self):
        case = self.changed(("size = 1.0", "size = 2.5"))
        done = safety(case, "--from", "30,0", "--to", "36,3", "--tolerance", "0.1", "--out", self.path / "out")
        self.assertEqual(done.returncode, 2)
        self.assertIn("at least four cells, 10 m", done.stderr)
        done = safety(case, "--from", "50,10", "--to", "60,10", "--tolerance", "0.1", "--out", self.path / "out")
        self.assertEqual(done.returncode, 0, done.stderr)  # level ground
        self.assertIn("nothing fails: the ground stands with its strength divided by 10", done.stdout)
        done = safety(case, "--from", "10,0", "--to", "40,10", "--floor", "1.8", "--out", self.path / "out")
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn("only soil between x = 10 and 40 m may fail", done.stdout)
        self.assertIn("it ends at 40,10", done.stdout)
        self.assertTrue((self.path / "out" / "mechanism.png").exists())
        done = safety(case, "--from", "10,0", "--to", "40,30")
        self.assertEqual(done.returncode, 2)
        self.assertIn("--to 40,30: the nearest soil is", done.stderr)

    def test_a_structure_that_slides_is_named(self):
        # The slope has 20 degrees, whose tangent is 0.364; its rock is strong.
        rock = ('model = "linear_elastic"', 'model = "mohr_coulomb"\ncohesion_peak = 1e6\ncohesion_residual = 1e6\n'
                'friction_peak_deg = 30.0\nfriction_residual_deg = 30.0\nsoftening = 0.0')
        done = safety(self.changed(rock, case=BLOCK), "--floor", "1.5")
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        self.assertIn("soil and friction do not hold block", done.stdout)
        done = safety(self.changed(rock, ("friction = 0.3", "friction = 0.5"), case=BLOCK), "--floor", "1.5")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_what_has_no_factor(self):
        elastic = self.changed(
            ('model = "mohr_coulomb"', 'model = "linear_elastic"'), ("cohesion_peak = 9.81e3", "#"),
            ("cohesion_residual = 9.81e3\n", ""), ("friction_peak_deg = 20.0\n", ""),
            ("friction_residual_deg = 20.0\n", ""), ("softening = 0.0\n", ""))
        done = safety(elastic)
        self.assertEqual(done.returncode, 2)
        self.assertIn('case.toml: no soil has a strength that could be reduced', done.stderr)
        weightless = self.changed(('[[stage]]\nkind = "gravity"\nresidual = 1e-4\n', ""))
        done = safety(weightless)
        self.assertEqual(done.returncode, 2)
        self.assertIn('the case needs a [[stage]] of kind = "gravity"', done.stderr)
        done = safety(CASE, "--tolerance", "0")
        self.assertEqual(done.returncode, 2)
        self.assertIn("--tolerance", done.stderr)


unittest.main(argv=sys.argv[:1])
