"""Reports of a soil test, a free field alone, a swap and a ladder of cost, in a real browser.

    usage: test_studies.py TREMOLO SOURCE_DIR
"""

import re
import sys
import unittest
from pathlib import Path

TREMOLO, SOURCE = sys.argv.pop(1), Path(sys.argv.pop(1))
sys.path[:0] = [str(SOURCE / "python"), str(Path(__file__).parent), str(Path(__file__).parents[1] / "runs")]

import browser
from small_case import Workspace

LAYERS = """
[[profile]]
soil = "box"
thickness = 10.0
"""
CHARTS = """return [...document.querySelectorAll('[data-chart]')].map((c) => [c.getAttribute('aria-label'), c.data.length,
    c._fullLayout.xaxis.title.text, c._fullLayout.yaxis.title.text, c.data[0].type]);"""


def setUpModule():
    if browser.MISSING:
        raise unittest.SkipTest(browser.MISSING)
    global page, work
    page = browser.Browser()
    unittest.addModuleCleanup(page.close)
    work = Workspace(TREMOLO, angle=0.0)
    unittest.addModuleCleanup(work.__exit__)
    work.case.write_text(work.case.read_text() + LAYERS)


def done(*words):
    told = work.command(*words)
    assert told.returncode == 0, told.stdout + told.stderr
    return told.stdout


def opened(*studies, out=None):
    """The report of studies in the browser; returns its file."""
    path = work.path / done("report", *studies, *(["--out", out] if out else [])).strip().splitlines()[-1]
    page.open(path)
    return path


class Pages(unittest.TestCase):
    def tearDown(self):
        self.assertEqual([], page.complaints())

    def expect_charts(self, *headings):
        """The headings of the page's charts, each of which has a line or bars and named axes."""
        charts = page.run(CHARTS)
        self.assertEqual(list(headings), [re.sub(r"\. Keys.*", "", chart[0]) for chart in charts])
        for heading, lines, x, y, kind in charts:
            self.assertGreater(lines, 0, heading)
            self.assertTrue(x, heading)
            self.assertTrue(y or kind == "bar", heading)


class Studies(Pages):
    def test_soil_test(self):
        test = SOURCE / "cases/soiltests/pm4sand_dr55_cyclic.toml"
        done("soiltest", test, "--out", "dss.h5")
        self.assertEqual(work.path / "dss.html", opened("dss.h5"))
        self.expect_charts("shear stress (kPa) over shear strain (%)", "shear stress (kPa) over mean effective stress in the plane p' (kPa)",
                           "excess pore pressure ratio r_u over cycles", "shear strain (%) over cycles")
        self.assertIn("coefficient G_o of G", page.find("main").text)
        chart = "[data-chart='study-0-0-2']"
        whole = page.run(f"return [...document.querySelector(\"{chart}\")._fullLayout.xaxis.range]")
        page.show(chart).send_keys("+")
        page.wait(f"return document.querySelector(\"{chart}\")._fullLayout.xaxis.range[1] < {whole[1]}")

    def test_acceptance_free_field_alone(self):
        done("column", work.case, "--model", "fe", "--out", "alone.h5")
        opened("alone.h5")
        depth = "depth (m) over peak "
        self.expect_charts("acceleration (m/s²) over t (s)", "10 m deep, stress (kPa) over strain (%)",
                           *(depth + what for what in ("acceleration (m/s²)", "velocity (m/s)", "displacement (cm)", "strain (%)")),
                           depth + "shear / effective stress", "spectral acceleration, 5 % (m/s²) over period (s)",
                           "Fourier amplitude ratio over frequency (Hz)")
        # Depth grows downwards, as in the picture.
        self.assertTrue(page.run("const r = document.querySelector('[data-chart=\"study-0-0-2\"]')._fullLayout.yaxis.range; return r[0] > r[1]"))

    def test_acceptance_swap_and_ladder_below_each_other(self):
        done("swap", work.case, "--models", "wave,fe", "--out", work.path / "swapped")
        done("cost", work.case, "--knob", "mesh.size=2,1", "--out", work.path / "ladder")
        opened(work.path / "swapped", work.path / "ladder", out=work.path / "both.html")
        self.expect_charts("surface, v_x (m/s) over t (s)", "difference to wave, relative L2, %",
                           "error, relative L2 (%) over CPU time (s)", "error, relative L2 (%) over cell size h (m)")
        self.assertEqual(["wave", "fe"], page.run("return document.querySelector('[data-chart=\"study-0-0-1\"]').data[0].y"))
        self.assertIn("mesh.size=2 2 ", page.find("#study1").text)
        page.open(work.path / "both.html", 400, scheme="dark")
        self.assertLessEqual(page.run("return document.documentElement.scrollWidth"), 400)


class AcceptanceSweep(Pages):
    def test_sweep(self):
        study = work.path / "study.toml"
        study.write_text('case = "case.toml"\n[axes]\nmotion.angle_deg = [0, 15]\nmotion.pulse.velocity = [0.1, 0.2]\n')
        done("sweep", study, "--out", work.path / "swept")
        opened(work.path / "swept")
        responses = ["final displacement, surface (m)", "peak a_x, surface (m/s²)"]
        self.expect_charts(*(chart for response in responses for chart in (
            *(f"motion.pulse.velocity = {speed}, {response} over motion.angle_deg (degrees)" for speed in (0.1, 0.2)),
            f"{response} over PGV of the incident wave (m/s)")),
            *(f"motion.pulse.velocity = {speed}, |u|, surface (m) over t (s)" for speed in (0.1, 0.2)))
        self.assertEqual(["0", "15"], page.run("return document.querySelector('[data-chart]')._fullLayout.xaxis.ticktext"))
        text = page.find("main").text
        self.assertIn("Against motion.angle_deg = 0", text)
        self.assertIn("0004 15 0.2", text)
        page.open(work.path / "swept/report.html", 400, scheme="dark")
        self.assertLessEqual(page.run("return document.documentElement.scrollWidth"), 400)


if __name__ == "__main__":
    unittest.main()
