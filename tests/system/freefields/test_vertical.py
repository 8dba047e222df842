"""Two components of a shaking: an SV wave and, in [motion.vertical], a P wave that comes up beside it. In linear ground both
together move it by the sum of what each does alone.

    usage: test_vertical.py TREMOLO PYTHON_PACKAGE_DIR MY_FIELD
"""

import math
import sys
import unittest

TREMOLO, PACKAGE, _ = sys.argv.pop(1), sys.argv.pop(1), sys.argv.pop(1)
sys.path.insert(0, PACKAGE)

import numpy as np
from angle_cases import DEPTHS, PLASTIC, FlatWorkspace
from free_field_cases import LAYERED, BoxWorkspace, ColumnWorkspace, model, with_frames
from tremolo import Run

SMALL = 1e-6  # m/s; so that no particle moves by more than 1e-6 of a cell


def pulse(frequency, time, velocity):
    return f'pulse = {{ shape = "ricker", frequency = {frequency}, time = {time}, velocity = {velocity} }}'


SV, P = pulse(3.0, 0.8, SMALL), pulse(5.0, 0.7, 0.7 * SMALL)


def vertical(motion, angle, reference=None):
    return f"\n[motion.vertical]\n{motion}\nangle_deg = {angle!r}\n" + (f"reference = {reference}\n" if reference else "")


def worst(both, first, second):
    """Largest difference of series (places x times) from the sum, over their largest value in either run."""
    both, first, second = np.array(both), np.array(first), np.array(second)
    return np.abs(both - first - second).max() / max(np.abs(first).max(), np.abs(second).max())


DAMPED = LAYERED.split("[[region]]")[0].replace("vp =", "damping = 0.03\nvp =") + """
[damping]
model = "kelvin_voigt"
reference_hz = 3.0

[mesh]
size = 1.0
box = [0.0, -20.0, 1.0, 0.0]
"""


class Columns(unittest.TestCase):
    def columns(self, name, sv_angle, p_angle, motion=SV, p_motion=P):
        """Histories under both waves, and under each alone."""
        for text, angle, wave, beside in ((motion, sv_angle, "SV", vertical(p_motion, p_angle)), (motion, sv_angle, "SV", ""),
                                          (p_motion, p_angle, "P", "")):
            with ColumnWorkspace(TREMOLO, ground=DAMPED + beside, motion=text, size=1.0) as work:
                case = work.case.read_text().replace("angle_deg = 0.0", f"angle_deg = {angle!r}")
                case = case.replace('wave = "SV"', f'wave = "{wave}"')
                work.case.write_text(case.replace("relative_tolerance = 1e-7", "relative_tolerance = 1e-10"))
                yield work.histories(name, "--depths", "0,6", "--duration", "2.5", "--every", "0.005")

    def assert_sum(self, name, sv_angle, p_angle, **motions):
        runs = list(self.columns(name, sv_angle, p_angle, **motions))
        for series in ("vx", "vy", "ax", "ay", "sxy", "syy", "ux", "uy"):
            self.assertLess(worst(*([level[series] for level in run] for run in runs)), 1e-6, (name, series))

    def test_columns_move_by_the_sum(self):
        for name in ("wave", "eql", "fe", "mpm"):
            self.assert_sum(name, 0.0, 0.0)

    def test_adaptive_steps(self):
        """`ode` takes other steps under other motions, and errs by its tolerance. It keeps ten states to the shortest period of
        the motion, between which it is cubic: pulses of one frequency have the same ones."""
        self.assert_sum("ode", 0.0, 0.0, motion=pulse(3.0, 0.8, 0.1), p_motion=pulse(3.0, 0.9, 0.07))

    def test_at_angles(self):
        self.assert_sum("wave", 10.0, 35.0)
        self.assert_sum("fe", 10.0, math.degrees(math.asin(2.0 * math.sin(math.radians(10.0)))))

    def test_the_report_has_both_components(self):
        with ColumnWorkspace(TREMOLO, ground=DAMPED + vertical(P, 0.0), motion=SV + '\nkind = "outcrop"', size=1.0) as work:
            result = work.command("column", work.case, "--model", "fe", "--out", "out.h5")
            self.assertEqual(0, result.returncode, result.stderr)
            run = Run(work.path / "out.h5")
            surface = run.monitor("surface")
            self.assertIn(f"vertical at the surface {np.abs(surface['ay']).max():.4g} m/s2", result.stdout)
            measures = run.table("/measures")
            row = list(measures["place"]).index("surface, vertical")
            self.assertAlmostEqual(measures["pga"][row], np.abs(surface["ay"]).max(), delta=1e-6 * measures["pga"][row])
            spectra = run.table("/spectra")
            self.assertAlmostEqual(spectra["surface_vertical"][0], measures["pga"][row], delta=0.05 * measures["pga"][row])

    def test_acceptance_the_tables_of_a_site_have_both_components(self):
        with ColumnWorkspace(TREMOLO, ground=DAMPED + vertical(P, 0.0), motion=SV + '\nkind = "outcrop"', size=1.0) as work:
            result = work.command("column", work.case, "--models", "fe,wave", "--out", "site")
            self.assertEqual(0, result.returncode, result.stderr)
            names = (work.path / "site" / "tables" / "spectra.csv").read_text().split("\n")[0].split(",")
            self.assertIn("wave_vertical_g", names)


class Domain(unittest.TestCase):
    def velocities(self, motion, wave, angle, beside="", **changes):
        with BoxWorkspace(TREMOLO, ground=changes.pop("ground", BoxWorkspace.defaults["ground"]) + beside, **changes) as work:
            case = work.case.read_text()
            start = case.index("pulse")
            case = case[:start] + motion + case[case.index("\n", start):]
            case = case.replace('wave = "SV"', f'wave = "{wave}"')
            work.case.write_text(case.replace("angle_deg = 0.0", f"angle_deg = {angle!r}"))
            run = Run(work.run("run"))
            return {(name, series): run.monitor(name)[series] for name in ("surface", "inside") for series in ("vx", "vy")}

    def assert_sum(self, sv_angle, p_angle, **changes):
        both = self.velocities(SV, "SV", sv_angle, vertical(P, p_angle), **changes)
        first, second = self.velocities(SV, "SV", sv_angle, **changes), self.velocities(P, "P", p_angle, **changes)
        for key, series in both.items():
            if max(np.abs(first[key]).max(), np.abs(second[key]).max()) > 1e-9 * SMALL:
                self.assertLess(worst(series, first[key], second[key]), 1e-6, key)

    def test_waves_of_two_speeds_along_x(self):
        """Each face takes the sum of two fields, each with a delay of its own; between springs, dashpots and a total base."""
        self.assert_sum(15.0, 25.0, duration=1.1)

    def test_acceptance_an_incident_base(self):
        self.assert_sum(20.0, 10.0, duration=1.1, base=model("wave", form="incident"))

    def test_acceptance_columns_beside_it(self):
        self.assert_sum(0.0, 0.0, duration=1.1, left=model("fe"), right=model("fe"), base=model("fe"))

    def test_the_exact_field_is_that_of_both(self):
        ground = BoxWorkspace.defaults["ground"] + vertical(pulse(3.0, 0.5, 0.08), 40.0)
        with with_frames(BoxWorkspace(TREMOLO, ground=ground, angle=15.0)) as work:
            folder = work.run("run")
            result = work.command("verify", folder)
            self.assertEqual(0, result.returncode, result.stdout + result.stderr)

    def test_recorded_waves_are_served_again(self):
        """What `column --record` writes holds each wave with a slowness of its own."""
        ground = BoxWorkspace.defaults["ground"] + vertical(P, 25.0)
        with BoxWorkspace(TREMOLO, ground=ground, angle=15.0, duration=1.1) as work:
            exact = Run(work.run("run"))
            result = work.command("column", work.case, "--side", "left", "--model", "wave", "--record", "left.h5")
            self.assertEqual(0, result.returncode, result.stderr)
            exported = work.command("export", "left.h5", "sv.csv")
            self.assertIn("--field total+vertical exports it", exported.stdout)
            self.assertEqual(0, work.command("export", "left.h5", "p.csv", "--field", "total+vertical").returncode)
            case = work.case.read_text()
            for side in ("left", "right", "base"):
                case = case.replace(f'{side} = {{ model = "wave" }}', f'{side} = {{ model = "recording", file = "left.h5" }}')
            work.case.write_text(case)
            again = Run(work.run("again"))
            for series in ("vx", "vy"):
                expected = exact.monitor("inside")[series]
                np.testing.assert_allclose(again.monitor("inside")[series], expected, atol=1e-9 * np.abs(expected).max())

    def test_ground_that_yields_moves_alike_along_x(self):
        """Under both waves at one speed along x, flat ground is everywhere the same, later by the delay, and yields. Measured:
        4.3 %, under the SV wave alone 4.4 %."""
        rock = (760.0, 1900.0)
        beside = math.degrees(math.asin(rock[1] / rock[0] * math.sin(math.radians(15.0))))
        ground = PLASTIC + vertical('pulse = { shape = "ricker", frequency = 4.0, time = 0.6, velocity = 0.2 }', beside)
        surface = {}
        for text, name in ((ground, "both"), (PLASTIC, "SV")):
            with FlatWorkspace(TREMOLO, ground=text, velocity=0.4) as work:
                run = Run(work.run("run"))
                left, right = (run.monitor(f"{place}-{DEPTHS[0]}") for place in (4.0, 20.0))
                delay = math.sin(math.radians(15.0)) / rock[0] * 16.0
                time = left["time"][left["time"] < 1.15]
                later = np.array([np.interp(time + delay, right["time"], right[series]) for series in ("vx", "vy")])
                here = np.array([np.interp(time, left["time"], left[series]) for series in ("vx", "vy")])
                self.assertLess(np.linalg.norm(later - here), 0.06 * np.linalg.norm(here), name)
                surface[name] = left["vx"]
        self.assertGreater(np.abs(surface["both"] - surface["SV"]).max(), 0.02)


if __name__ == "__main__":
    unittest.main()
