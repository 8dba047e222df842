"""`tremolo watch` in a real browser: the page follows a run that goes on, keeps to those who have the token, and aborts the run.

    usage: test_watch.py TREMOLO SOURCE_DIR
"""

import os
import signal
import subprocess
import sys
import time
import unittest
import urllib.error
import urllib.request
from pathlib import Path

TREMOLO, SOURCE = sys.argv.pop(1), Path(sys.argv.pop(1))
sys.path[:0] = [str(SOURCE / "python"), str(Path(__file__).parent), str(Path(__file__).parents[1] / "runs")]

import browser
from small_case import Workspace
from tremolo.run import Run

FRAMES = "return Number(document.getElementById('scrub').max)"


def setUpModule():
    if browser.MISSING:
        raise unittest.SkipTest(browser.MISSING)


def got(address, method="GET"):
    with urllib.request.urlopen(urllib.request.Request(address, method=method), timeout=20) as answer:
        return answer.read().decode()


class WatchedRun(unittest.TestCase):
    """A run that is watched while it goes on: minutes, were it not aborted."""

    EVERY = 80.0  # s; at most 50 frames: a report shows all of them

    def setUp(self):
        self.work = Workspace(TREMOLO, duration=4000.0, every=self.EVERY)
        self.work.case.write_text(self.work.case.read_text().replace("history_every_s = 0.005", "history_every_s = 0.5"))
        self.addCleanup(self.work.__exit__)
        self.run_ = self.start("run", self.work.case, "--out", self.work.path / "long")
        while not (self.work.path / "long").is_dir():
            self.assertIsNone(self.run_.poll(), "the run has ended")
            time.sleep(0.05)
        self.watch = self.start("watch", self.work.path / "long")
        self.address = self.watch.stdout.readline().strip()

    def start(self, *words):
        process = subprocess.Popen([TREMOLO, *map(str, words)], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        self.addCleanup(process.stdout.close)
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        return process


class AcceptancePage(WatchedRun):
    def test_page_follows_the_run_and_aborts_it(self):
        self.assertRegex(self.address, r"^http://127\.0\.0\.1:\d+/\?token=\S{20,}$")
        for refused in (self.address.split("?")[0], self.address[:-1] + "!", self.address.replace("/?", "/abort?")[:-1]):
            with self.assertRaises(urllib.error.HTTPError) as told:
                got(refused, "POST" if "abort" in refused else "GET")
            self.assertEqual(403, told.exception.code)
            told.exception.close()

        page = browser.Browser()
        self.addCleanup(page.close)
        while "progress" not in got(self.address):
            time.sleep(0.5)
        page.open(self.address)
        # The page is loaded again when sections begin: at first the run has no histories.
        page.wait("return document.querySelector('[data-chart=\"energy\"] .plot-container') !== null", 60)
        first = page.run(FRAMES)
        page.run("window.same_page = true")
        page.wait(f"return Number(document.getElementById('scrub').max) > {first}", 60)
        # It was made anew in place: what looked at the last frame looks at the new last one, a zoom stays.
        self.assertTrue(page.run("return window.same_page"))
        page.find("#scrub").send_keys(browser.key("END"))
        chart = '[data-chart="energy"]'
        page.show(chart).send_keys("+")
        zoom = page.run(f"return document.querySelector('{chart}')._fullLayout.xaxis.range[0]")
        self.assertGreater(zoom, 0.0)
        told, last = page.find("#told").text, page.run(FRAMES)
        page.wait(f"return Number(document.getElementById('scrub').max) > {last}", 60)
        page.wait("const s = document.getElementById('scrub'); return s.value === s.max")
        self.assertEqual(zoom, page.run(f"return document.querySelector('{chart}')._fullLayout.xaxis.range[0]"))
        self.assertRegex(told, r"simulated \d+\.\d\d of 4000\.00 s, \d+ frames; running")
        self.assertGreater(page.run("return document.getElementById('progress').value"), 0.0)

        page.show("#abort").click()
        page.driver.switch_to.alert.accept()
        self.run_.wait(60)
        self.assertNotEqual(0, self.run_.returncode)
        page.wait("return document.getElementById('live') === null", 60)
        self.assertTrue(Run(self.work.path / "long").status.startswith("aborted"))
        self.assertIn("the run has ended (aborted", self.watch.stdout.readline())
        self.assertEqual([], page.complaints())


class Watch(WatchedRun):
    EVERY = 8.0  # s; the first page is there sooner

    def test_ends_with_its_command_and_then_says_so_on_the_page(self):
        while "progress" not in got(self.address):
            time.sleep(0.5)
        os.kill(self.watch.pid, signal.SIGINT)
        self.watch.wait(20)
        for _ in range(100):
            try:
                got(self.address)
            except OSError:
                break
            time.sleep(0.1)
        else:
            self.fail("the page is still served")
        self.assertIsNone(self.run_.poll(), "the run ended with the page")


class Refused(unittest.TestCase):
    def test_what_is_not_there(self):
        told = subprocess.run([TREMOLO, "watch", "/nowhere"], capture_output=True, text=True, timeout=60)
        self.assertEqual((1, "tremolo: /nowhere: no such folder; start the run first\n"), (told.returncode, told.stderr))


if __name__ == "__main__":
    unittest.main()
