"""Places that are not what a command needs: each is refused in one line that names it and what is in the way.

    usage: test_places.py TREMOLO PYTHON_PACKAGE_DIR
"""

import os
import subprocess
import sys
import unittest
from pathlib import Path

TREMOLO, PACKAGE = sys.argv.pop(1), sys.argv.pop(1)
sys.path[:0] = [str(Path(__file__).parent)]

from small_case import Workspace

RAW = ("filesystem error", "json.exception", "terminate called", "std::", "basic_")
PLACES = {"file/x": "file is no folder", "dangling": "dangling is a link to nowhere, which is no folder",
          "dangling/x": "dangling is a link to nowhere, which is no folder", "loop": "loop is a link to loop, which is no folder",
          "a" * 300: "File name too long"}
# Writes below OUT or to it; reads IN.
WRITERS = ("run {case} --out {place}", "swap {case} --models wave,fe --out {place}", "cost {case} --out {place}", "keygen {place} domain")
FILE_WRITERS = ("wave {case} --points points.txt --times 0:0.1:0.05 --out {place}", "soiltest {test} --out {place}.csv", "calibrate {fit} --out {place}",
                "motion {record} --out {place}.csv", "docs {place}")
NOT_THERE = ("file/x", "dangling", "loop", "missing/x")
IN_PYTHON = ("plot {place}", "compare {place} {place}", "timeline {place}", "failure {place}")  # they start slowly
READERS = (*IN_PYTHON, "check {place}", "explain {place}", "run {place}", "resume {place}", "verify {place}",
           "export {place}:left out.csv", "motion {place}", "soiltest {place}", "calibrate {place}",
           "import {place} --out out.h5", "wave {case} --points {place} --times 0:0.1:0.05 --out out.csv", "join {place} --role left --keys {place}")


class Places(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.work = cls.enterClassContext(Workspace(TREMOLO, size=2.0, duration=0.1))
        (cls.work.path / "file").write_text("")
        (cls.work.path / "dangling").symlink_to("nowhere")
        (cls.work.path / "loop").symlink_to("loop")
        (cls.work.path / "points.txt").write_text("x,y\n0.0,0.0\n")
        (cls.work.path / "record.csv").write_text("t,a (m/s2)\n0,0\n0.1,1\n0.2,-1\n0.3,0\n")
        cases = Path(__file__).resolve().parents[3] / "cases/soiltests"
        cls.names = {"case": cls.work.case, "record": "record.csv", "test": cases / "pm4sand_dr55_cyclic.toml",
                     "fit": cases / "hostun_calibration.toml"}

    def refused(self, template, place, **environment):
        """The output of a command that must say why it does nothing, in words."""
        command = template.format(place=place, **self.names).split()
        done = subprocess.run([TREMOLO, *command], cwd=self.work.path, capture_output=True, text=True, timeout=60,
                              env={**os.environ, **environment})
        output = done.stdout + done.stderr
        self.assertIn(done.returncode, (1, 2), f"{command}: {output}")
        for word in (*RAW, "Traceback"):
            self.assertNotIn(word, output, command)
        return done.stderr

    def named(self, template, place):
        with self.subTest(template, place=place):
            self.assertIn(place.split("/")[0], self.refused(template, place))

    def test_a_folder_that_cannot_be_made_is_named_with_what_is_in_the_way(self):
        for place, reason in PLACES.items():
            for template in WRITERS:
                with self.subTest(template, place=place):
                    error = self.refused(template, place)
                    self.assertIn(reason, error)
                    self.assertIn(place.split("/")[0], error)
                    self.assertEqual(1, error.count("\n"), error)

    def test_a_file_that_cannot_be_written_is_named(self):
        self.expect_unwritten("dangling/x", "missing/x")

    def test_acceptance_a_file_that_cannot_be_written_anywhere_is_named(self):
        self.expect_unwritten("file/x", "loop/x", "a" * 300)

    def expect_unwritten(self, *places):
        for place in places:
            for template in FILE_WRITERS:
                self.named(template, place)

    def test_what_is_not_there_to_be_read_is_named(self):
        self.expect_unread("dangling", "missing/x")

    def test_acceptance_what_is_not_there_anywhere_is_named(self):
        self.expect_unread("file/x", "loop")

    def expect_unread(self, *places):
        for place in places:
            for template in READERS:
                if place == "missing/x" or template not in IN_PYTHON:
                    self.named(template, place)

    def test_acceptance_what_is_not_there_is_named_by_all_that_start_slowly(self):
        for place in NOT_THERE:
            for template in IN_PYTHON:
                self.named(template, place)

    def test_folders_and_pipes_are_no_files(self):
        (self.work.path / "folder").mkdir()
        os.mkfifo(self.work.path / "pipe")  # nobody ever writes to it
        imported = " --out out.h5 --velocity-unit m/s --stress-unit Pa --stress-sign tension --depth-positive down --vertical-positive up"
        readers = [template for template in READERS if not template.startswith("import")]
        for template in (*readers, "motion --synthesise {place}", "run {case} --replay {place}:left",
                         "import {place}" + imported, "import {record} {record} --opensees {place}" + imported):
            for place in ("folder", "pipe"):
                if template.startswith("resume") and place == "folder":
                    continue  # a run's folder, in which nothing is
                with self.subTest(template, place=place):
                    self.assertIn(place, self.refused(template, place))

    def test_a_folder_for_temporary_files_that_is_none_is_named(self):
        for template in ("run {case} --out {place}", "conform {place}"):
            with self.subTest(template):
                self.assertIn("TMPDIR = /nowhere/at/all is no folder",
                              self.refused(template, "new", TMPDIR="/nowhere/at/all", XDG_RUNTIME_DIR="/nowhere/at/all"))

    def test_the_damaged_cost_of_a_rung_is_named(self):
        out = self.work.path / "rungs"
        arguments = ["cost", self.work.case, "--out", out, "--knob", "mesh.size=2", "--knob", "time.fraction=0.5"]
        first = self.work.command(*arguments)
        self.assertEqual(0, first.returncode, first.stdout + first.stderr)
        [file] = out.glob("*/rung.json")
        for text in ("{", "[]", '{"cpu_s": "x", "updates": 1}', '{"cpu_s": 1}', '{"cpu_s": -1, "updates": 1}'):
            file.write_text(text)
            again = self.work.command(*arguments)
            self.assertEqual(1, again.returncode, again.stdout)
            self.assertIn(f"{file} is damaged; remove its folder, and the run is made again\n", again.stderr)


if __name__ == "__main__":
    unittest.main()
