"""The report of a run in a real browser: it plays, zooms, and obeys the keyboard, at the width of a desk and of a telephone.

    usage: test_report.py TREMOLO SOURCE_DIR
"""

import functools
import sys
import unittest
from pathlib import Path

TREMOLO, SOURCE = sys.argv.pop(1), Path(sys.argv.pop(1))
sys.path[:0] = [str(SOURCE / "python"), str(Path(__file__).parent)]
sys.path[:0] = [str(Path(__file__).parents[1] / folder) for folder in ("runs", "structures")]

import browser
from small_case import Workspace
from structure_cases import TunnelWorkspace

try:
    import jinja2  # noqa: F401
    import plotly  # noqa: F401
    MISSING = browser.MISSING
except ImportError as error:
    MISSING = f"a report cannot be made: {error} (scripts/setup.sh installs python3-jinja2 and python3-plotly)"

FRAME = "#panels .frame"
RANGE = "const a = document.querySelector(arguments[0])._fullLayout.xaxis.range; return [a[0], a[1]];"
SOURCE_OF_FRAME = f"return document.querySelector('{FRAME}')._fullLayout.images[0].source;"


def keys(*words):
    return [browser.key(word) if word.isupper() else word for word in words]


def setUpModule():
    if MISSING:
        raise unittest.SkipTest(MISSING)
    global page
    page = browser.Browser()
    unittest.addModuleCleanup(page.close)


@functools.cache
def box():
    """A box with two monitors, which have spectral ratios, after its first run and `verify`."""
    work = Workspace(TREMOLO)
    unittest.addModuleCleanup(work.__exit__)
    text = work.case.read_text()
    work.case.write_text(text.replace("[output]", '[[monitor]]\nname = "deep"\npoint = [10.0, -8.0]\n\n[output]'))
    verified = work.command("verify", work.run("first"))
    assert verified.returncode == 0, verified.stdout + verified.stderr
    return work


@functools.cache
def report(name):
    """The page of the box's first run, of two of its runs ("two"), or of a tunnel in saturated sand."""
    if name == "tunnel":
        tunnel = TunnelWorkspace(TREMOLO, duration=0.4)
        unittest.addModuleCleanup(tunnel.__exit__)
        written = tunnel.run("wet", "--report") / "report.html"
        assert written.exists(), "tremolo run --report wrote none"
        return written
    runs = [box().path / "first"]
    if name == "two":
        runs.append(box().run("second", "--angle", "0"))
    written = box().path / f"{name}.html"
    told = box().command("report", *runs, "--out", written)
    assert told.returncode == 0, told.stderr
    assert str(written) in told.stdout
    return written


class Player(unittest.TestCase):
    def test_plays_to_the_end_and_shows_other_images(self):
        page.open(report("box"))
        page.find("#scrub").send_keys(*keys("HOME"))
        first = page.run(SOURCE_OF_FRAME)
        self.assertTrue(first.startswith("data:image/webp;base64,"))
        last = page.run("return Number(document.getElementById('scrub').max);")
        self.assertGreater(last, 10)
        page.show("#play").click()
        self.assertEqual("true", page.find("#play").get_attribute("aria-pressed"))
        page.wait(f"return document.getElementById('scrub').value === '{last}'")
        page.wait("return document.getElementById('play').textContent === 'Play'")
        self.assertNotEqual(first, page.run(SOURCE_OF_FRAME))
        self.assertIn("t = 1.00 s", page.find("#now").text)
        self.assertEqual([], page.complaints())

    def test_acceptance_obeys_the_keyboard_and_the_field(self):
        page.open(report("tunnel"))
        scrub = page.find("#scrub")
        scrub.send_keys(*keys("HOME", "ARROW_RIGHT", "ARROW_RIGHT"))
        self.assertEqual("2", page.run("return document.getElementById('scrub').value"))
        scrub.send_keys(*keys("ARROW_LEFT"))
        self.assertEqual("1", page.run("return document.getElementById('scrub').value"))
        scrub.send_keys(*keys("HOME"))
        self.assertEqual("0", page.run("return document.getElementById('scrub').value"))
        scrub.send_keys(" ")
        page.wait("return document.getElementById('scrub').value !== '0'")
        fields = page.run("return [...document.getElementById('field').options].map((option) => option.text)")
        self.assertEqual(["horizontal acceleration", "size of the displacement", "pore pressure ratio r_u"], fields)
        page.find("#field").send_keys(fields[2])
        page.wait("return document.querySelector('#panels figcaption').textContent.includes('pore pressure ratio r_u (1)')")
        self.assertIn("pore pressure ratio", page.find(FRAME).get_attribute("aria-label"))
        self.assertEqual([], page.complaints())


class Charts(unittest.TestCase):
    def test_zoom_by_drag_and_by_keys(self):
        from selenium.webdriver.common.action_chains import ActionChains

        page.open(report("box"))
        chart = '[data-chart="history-surface"]'
        whole = page.run(RANGE, chart)
        element = page.show(chart)
        # From a third to two thirds of the width: a third of the time is left.
        wide = element.size["width"] / 6
        drag = ActionChains(page.driver).move_to_element_with_offset(element, -int(wide), 0).click_and_hold()
        drag.move_by_offset(int(2 * wide), 0).release().perform()
        page.wait(f"return document.querySelector('{chart}')._fullLayout.xaxis.range[0] > {whole[0]}")
        low, high = page.run(RANGE, chart)
        self.assertLess(high - low, 0.5 * (whole[1] - whole[0]))
        # The unzoomed pictures below share the axis of time.
        self.assertEqual([low, high], page.run(RANGE.replace("xaxis", "xaxis3"), chart))
        element.send_keys("0")
        page.wait(f"return document.querySelector('{chart}')._fullLayout.xaxis.range[1] === {whole[1]}")
        element.send_keys("+")
        page.wait(f"return document.querySelector('{chart}')._fullLayout.xaxis.range[1] < {whole[1]}")
        low, high = page.run(RANGE, chart)
        self.assertAlmostEqual(0.5 * (whole[1] - whole[0]), high - low)
        self.assertEqual([], page.complaints())

    def test_have_axes_with_units_and_words(self):
        page.open(report("box"))
        for chart in page.run("return [...document.querySelectorAll('.chart')].map((c) => [c.getAttribute('aria-label'), "
                              "Object.keys(c._fullLayout).filter((k) => /^[xy]axis/.test(k)).map((k) => c._fullLayout[k].title.text)])"):
            self.assertGreater(len(chart[0]), 20)
            named = [title for title in chart[1] if title and "(" in title]
            self.assertGreaterEqual(len(named), 1 if "passes" in chart[0] else 2, chart)
        self.assertEqual(0, page.run("return [...document.images].filter((image) => !image.alt).length"))
        self.assertIn("exact", page.find("#verified").text)

    def test_acceptance_values_under_the_pointer(self):
        from selenium.webdriver.common.action_chains import ActionChains

        page.open(report("box"))
        element = page.show('[data-chart="response-surface"]')
        ActionChains(page.driver).move_to_element(element).perform()
        page.wait("return document.querySelector('[data-chart=\"response-surface\"] .hoverlayer').textContent.includes('horizontal')")

    def test_acceptance_ratio_over_another_monitor_is_the_reciprocal(self):
        page.open(report("box"))
        ratio = "return document.getElementById('ratio').data.map((line) => [line.name, line.y])"
        (name, one), = page.run(ratio)
        self.assertEqual("surface", name)
        page.find("#reference").send_keys("surface")
        page.wait("return document.getElementById('ratio').data[0].name === 'deep'")
        (_, other), = page.run(ratio)
        both = [(a, b) for a, b in zip(one, other) if a is not None and b is not None]
        self.assertGreater(len(both), 20)
        for a, b in both:
            self.assertAlmostEqual(1.0, a * b, places=9)


class Page(unittest.TestCase):
    def test_acceptance_of_two_runs_has_both_and_their_difference(self):
        page.open(report("two"))
        self.assertEqual(["first", "second", "second less first"],
                         page.run("return [...document.querySelectorAll('#panels figcaption')].map((c) => c.textContent.split(':')[0])"))
        self.assertIn("second against first", page.find("#differences").text)
        dashes = page.run("const chart = document.querySelector('[data-chart=\"history-surface\"]');"
                          "return [...new Set(chart.data.map((line) => line.line.dash))]")
        self.assertEqual(["solid", "dash"], dashes)

    def test_needs_no_network_and_is_small(self):
        self.assertLess(report("box").stat().st_size, 4_000_000)
        page.open(report("box"))
        fetched = page.run("return performance.getEntriesByType('resource').map((entry) => entry.name)")
        self.assertEqual([], [name for name in fetched if not name.startswith(("data:", "blob:"))])


class AcceptanceScreensAndPaper(unittest.TestCase):
    def test_of_two_runs_or_of_a_tunnel_is_small(self):
        for name in ("two", "tunnel"):
            self.assertLess(report(name).stat().st_size, 4_000_000)

    def test_fits_a_desk_and_a_telephone_in_both_schemes(self):
        for name, width, dark in (("two", 1400, False), ("two", 400, True), ("tunnel", 400, False)):
            with self.subTest(name=name, width=width):
                page.open(report(name), width, scheme="dark" if dark else "light")
                self.assertLessEqual(page.run("return document.documentElement.scrollWidth"), width)
                self.assertTrue(page.run("return document.getElementById('trouble').hidden"))
                ground, text = page.run("const s = getComputedStyle(document.body); return [s.backgroundColor, s.color]")
                self.assertEqual(dark, ground != "rgb(255, 255, 255)")
                self.assertEqual(text, page.run("const d = document.createElement('p'); document.body.append(d); "
                                                "d.style.color = document.querySelector('.chart')._fullLayout.font.color; "
                                                "return getComputedStyle(d).color"))
                self.assertEqual([], page.complaints())

    def test_prints_dark_on_white_as_wide_as_paper(self):
        page.open(report("box"), scheme="dark")
        look = "const l = document.querySelector('[data-chart=energy]')._fullLayout; return [l.width, l.font.color]"
        screen = page.run(look)
        page.run("addEventListener('beforeprint', () => { window.printed = (() => { " + look + " })(); })")
        page.command("Page.printToPDF")
        self.assertEqual([660, "#000000"], page.wait("return window.printed"))
        page.wait("return document.querySelector('[data-chart=energy]')._fullLayout.width > 1000")
        self.assertEqual(screen, page.run(look))
        self.assertEqual([], page.complaints())


if __name__ == "__main__":
    unittest.main()
