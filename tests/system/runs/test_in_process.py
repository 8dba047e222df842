"""`run --in-process`: all participants are threads of one process, and nothing else changes.

    usage: test_in_process.py TREMOLO PYTHON_PACKAGE_DIR
"""

import os
import signal
import subprocess
import sys
import unittest
from pathlib import Path

TREMOLO, PACKAGE = sys.argv.pop(1), sys.argv.pop(1)
sys.path[:0] = [PACKAGE, str(Path(__file__).parent)]

from run_files import arrays, wait_for_frames
from small_case import SlopeWorkspace, Workspace
from tremolo import Run


class InProcess(unittest.TestCase):
    def assert_same_bits(self, work, *arguments):
        threads = arrays(work.run("threads", "--in-process", *arguments))
        processes = arrays(work.run("processes", *arguments))
        self.assertEqual(threads.keys(), processes.keys())
        self.assertGreater(len(threads), 50)
        self.assertEqual([], [name for name in threads if threads[name] != processes[name]])

    def test_two_waves_and_a_softening_slope_give_the_same_bits(self):
        with SlopeWorkspace(TREMOLO, duration=0.5) as work:
            self.assert_same_bits(work, "--threads", "2")

    def test_a_column_in_lockstep_gives_the_same_bits(self):
        with Workspace(TREMOLO, angle=0.0, side="fe", duration=0.3) as work:
            self.assert_same_bits(work, "--mode", "lockstep")

    def test_records_and_replays(self):
        with Workspace(TREMOLO, duration=0.3) as work:
            work.case.write_text(work.case.read_text() + "\n[record]\nexchange = true\n")
            recorded = work.run("recorded", "--in-process")
            replayed = work.run("replayed", "--in-process", "--replay", recorded)
            names = [name for name in arrays(recorded) if name not in ("case", "plan")]
            live, again = arrays(recorded), arrays(replayed)
            self.assertEqual([], [name for name in names if live[name] != again[name]])

    def test_a_program_of_ones_own_is_refused_before_anything_starts(self):
        with Workspace(TREMOLO) as work:
            (work.path / "mine").write_text("#!/bin/sh\n")
            (work.path / "mine").chmod(0o755)
            left = next(line for line in work.case.read_text().splitlines() if line.startswith("left"))
            work.case.write_text(work.case.read_text().replace(left, 'left = { model = "external", program = "mine" }'))
            refused = work.command("run", work.case, "--out", work.path / "run", "--in-process")
            self.assertEqual(1, refused.returncode)
            self.assertIn("mine is a program of its own", refused.stderr)

    def test_ctrl_c_leaves_a_readable_file(self):
        with Workspace(TREMOLO, duration=60.0, every=0.01) as work:
            run = subprocess.Popen([TREMOLO, "run", str(work.case), "--out", str(work.path / "run"), "--in-process"],
                                   stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
            wait_for_frames(work)
            self.assertEqual("", Path(f"/proc/{run.pid}/task/{run.pid}/children").read_text())
            self.assertGreater(len(os.listdir(f"/proc/{run.pid}/task")), 2)
            run.send_signal(signal.SIGINT)
            said, _ = run.communicate(timeout=20)
            self.assertEqual(130, run.returncode, said)
            self.assertIn("interrupted by Ctrl-C", said)
            self.assertTrue(Run(work.path / "run").status.startswith("aborted"))


if __name__ == "__main__":
    unittest.main()
