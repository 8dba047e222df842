"""A sweep that is interrupted, or killed, leaves no process and goes on where it was.

    usage: test_sweep_stops.py TREMOLO SOURCE_DIR
"""

import os
import signal
import sys
import time
import unittest
from pathlib import Path

TREMOLO, SOURCE = sys.argv.pop(1), Path(sys.argv.pop(1))
sys.path[:0] = [str(SOURCE / "python"), str(Path(__file__).parent)]

from small_sweep import SweepWorkspace, alive

# Runs that have no free field in common, long enough to be met while they go on.
STUDY = 'case = "case.toml"\n[axes]\nmotion.angle_deg = [0, 5, 10]\nmesh.size = [0.5]\n'
PATIENCE = 60.0  # s


class Stops(unittest.TestCase):
    def first_line_of_a_run(self, process):
        for line in process.stdout:
            if line.startswith("  1/3"):
                return
        self.fail("no run has ended")

    def wait_until_alone(self, session):
        end = time.monotonic() + PATIENCE
        while alive(session) and time.monotonic() < end:
            time.sleep(0.05)
        self.assertEqual([], alive(session))

    def stopped(self, work, stop, *, status):
        """Stops a sweep after its first run; what it says then."""
        process = work.start("--jobs", 1)
        self.first_line_of_a_run(process)
        time.sleep(0.1)  # the second run goes on
        stop(process)
        said = process.communicate()[0]
        self.assertEqual(status, process.returncode, said)
        self.wait_until_alone(process.pid)
        return said

    def expect_the_rest(self, work, before):
        """The runs that had ended stand, the others are made."""
        said = work.swept("--jobs", 2)
        self.assertIn("1 of them done", said)
        after = work.made()
        self.assertEqual(["0001", "0002", "0003"], sorted(after))
        self.assertEqual(before["0001"], after["0001"])
        self.assertEqual(["complete"] * 3, [row["status"] for row in work.rows()])

    def expect_a_second_one_is_refused(self, work, first):
        """While the first one is held, so that it cannot end while the second one waits for the folder."""
        os.killpg(first.pid, signal.SIGSTOP)
        try:
            second = work.sweep()
        finally:
            os.killpg(first.pid, signal.SIGCONT)
        self.assertEqual(1, second.returncode)
        self.assertIn("is in use", second.stderr)

    def test_two_at_a_time_are_refused_and_ctrl_c(self):
        def stop(process):
            self.expect_a_second_one_is_refused(work, process)
            os.killpg(process.pid, signal.SIGINT)

        with SweepWorkspace(TREMOLO, STUDY, duration=1.5) as work:
            said = self.stopped(work, stop, status=130)
            self.assertIn("the same command goes on from here", said)
            self.assertNotIn("Traceback", said)
            self.expect_the_rest(work, work.made())

    def test_killed(self):
        with SweepWorkspace(TREMOLO, STUDY, duration=1.5) as work:
            self.stopped(work, lambda process: process.kill(), status=-signal.SIGKILL)
            self.expect_the_rest(work, work.made())


if __name__ == "__main__":
    unittest.main()
