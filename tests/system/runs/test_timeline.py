"""Who waits for whom in a run: in the summary, in run.h5, in words and as a picture.

    usage: test_timeline.py TREMOLO PYTHON_PACKAGE_DIR
"""

import sys
import unittest
from pathlib import Path

TREMOLO, PACKAGE = sys.argv.pop(1), sys.argv.pop(1)
sys.path[:0] = [PACKAGE, str(Path(__file__).parent)]

from small_case import Workspace
from tremolo import Run
from tremolo.timeline import timelines


class TimelineOfARun(unittest.TestCase):
    def test_accounts_for_the_time_of_each_process_and_is_told_and_drawn(self):
        for mode in ("window", "lockstep"):
            with Workspace(TREMOLO) as work, self.subTest(mode):
                folder = work.run("run", "--mode", mode)
                with Run(folder) as run:
                    lines = timelines(run)
                    processes = run.table("processes")
                # The clock starts when all are there and ends at BYE: at most the life of the process.
                self.assertEqual(list(processes["process"]), list(lines))
                for process, wall in zip(processes["process"], processes["wall_time"]):
                    self.assertLess(lines[process].end, wall)
                    for seconds in lines[process].activities.values():
                        self.assertGreaterEqual(seconds.min(), 0.0)
                        self.assertLessEqual(seconds.max(), lines[process].slice * (1 + 1e-9))
                # All of them live through the same run; a source may leave only after the domain.
                for line in lines.values():
                    self.assertGreater(line.end, 0.9 * lines["domain"].end)
                self.assertGreater(lines["domain"].total("computing"), 0.0)
                told = work.command("timeline", folder)
                self.assertEqual(0, told.returncode, told.stdout + told.stderr)
                self.assertIn("domain: of ", told.stdout)
                self.assertIn("the free fields were done after ", told.stdout)
                self.assertGreater((folder / "pictures" / "timeline.png").stat().st_size, 10_000)

    def test_a_run_that_failed_has_none_and_it_is_said(self):
        with Workspace(TREMOLO) as work:
            told = work.command("timeline", work.path / "nowhere")
            self.assertNotEqual(0, told.returncode)
            self.assertIn("no such run", told.stdout + told.stderr)


if __name__ == "__main__":
    unittest.main()
