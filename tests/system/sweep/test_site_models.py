"""`tremolo sweep` of site responses: several models of each, and what is refused.

    usage: test_site_models.py TREMOLO SOURCE_DIR
"""

import json
import sys
import unittest

TREMOLO, _ = sys.argv.pop(1), sys.argv.pop(1)

from layer_study import CASE, COUNT, SIGMA, STUDY, Workspace


class Models(unittest.TestCase):
    STUDY = STUDY.replace('"wave"', '"wave", "eql"').replace(f"count = {COUNT}", "count = 2") + "motion.pulse.velocity = [1e-3, 2e-3]\n"

    def test_each_is_a_row_and_an_addition_keeps_the_others(self):
        with Workspace(TREMOLO, self.STUDY.replace('"wave", "eql"', '"wave"')) as work:
            self.assertEqual(0, work.sweep().returncode)
            before = work.made()
            work.study.write_text(self.STUDY)
            done = work.sweep()
            self.assertEqual(0, done.returncode, done.stdout + done.stderr)
            self.assertIn("8 runs, 4 of them done", done.stdout)
            rows = work.rows()
            self.assertEqual(["wave", "eql"] * 4, [row["model"] for row in rows])
            after = work.made()
            self.assertEqual(before, {name: after[name] for name in before})
            # Without curves both are one model.
            for wave, eql in zip(rows[::2], rows[1::2]):
                self.assertAlmostEqual(1.0, float(eql["surface.pga_m_s2"]) / float(wave["surface.pga_m_s2"]), places=6)
            heading = (work.out / "tables/spectra.csv").read_text().splitlines()[0]
            self.assertIn("wave_motion.pulse.velocity=0.001_surface_median_g", heading)
            self.assertEqual("model", json.loads((work.out / "sweep.json").read_text())["measures"]["colour"])


class Refused(unittest.TestCase):
    def refusal(self, study, text, case=CASE):
        with Workspace(TREMOLO, study, case) as work:
            done = work.sweep()
            self.assertFalse(work.out.exists())
            self.assertEqual(2, done.returncode, done.stdout + done.stderr)
            self.assertIn(text, done.stderr)

    def test_places_are_those_of_the_study(self):
        self.refusal(STUDY.replace("usgs_c", "usgs_e"), "study.toml:6:30: [axes] 'random_profile.site_class' = \"usgs_e\": ")
        self.refusal(STUDY.replace(f"[{SIGMA}]", "[2.0]"), "study.toml:7:28: [axes] 'random_profile.sigma_ln' = 2.0: 'sigma_ln' = 2 is out of range")
        self.refusal(STUDY.replace('random_profile.site_class = ["usgs_c"]\n', "").replace(f"random_profile.sigma_ln = [{SIGMA}]\n", ""),
                     "missing 'site_class', or each of")

    def test_a_model_that_cannot_take_the_case(self):
        self.refusal(STUDY.replace('"wave"', '"ode"'), "[ode]", CASE.replace("angle_deg = 0.0", "angle_deg = 10.0").replace("vp = 400.0", "vp = 500.0"))


if __name__ == "__main__":
    unittest.main()
