"""`tremolo sweep --slurm` against a real Slurm, which the test starts for itself on this machine.

    usage: test_slurm.py TREMOLO SOURCE_DIR
"""

import json
import os
import signal
import sys
import time
import unittest
from pathlib import Path

TREMOLO, SOURCE = sys.argv.pop(1), Path(sys.argv.pop(1))
sys.path[:0] = [str(SOURCE / "python"), str(Path(__file__).parent)]

import small_slurm
from small_sweep import STUDY, SweepWorkspace

# Long enough for a task to be met while it goes on.
LONG = 'case = "case.toml"\n[axes]\nmotion.angle_deg = [0, 5, 10]\nmesh.size = [0.5]\n'
PATIENCE = 120.0  # s
lacking = small_slurm.missing()


@unittest.skipIf(lacking, f"{', '.join(lacking)} not installed: scripts/setup.sh installs slurm-wlm and munge")
class Slurm(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.slurm = small_slurm.SmallSlurm()
        cls.slurm.__enter__()
        cls.addClassCleanup(cls.slurm.__exit__)

    def workspace(self, study, **changes):
        work = SweepWorkspace(TREMOLO, study, **changes)
        self.addCleanup(work.__exit__)
        work.environment = self.slurm.environment
        return work

    def wait_for(self, what, there):
        end = time.monotonic() + PATIENCE
        while not there():
            self.assertLess(time.monotonic(), end, f"no {what}; the queue: {self.queue()}")
            time.sleep(0.1)

    def queue(self):
        return self.slurm.command("squeue", "--array", "--noheader", "--format=%i %T").stdout

    def jobs(self, work):
        return json.loads((work.out / "slurm.json").read_text())

    def submitted(self, work):
        """The first job, when it is known."""
        self.wait_for("job", lambda: (work.out / "slurm.json").exists() and (work.out / "slurm.json").read_text().endswith("}"))
        return next(iter(self.jobs(work)))

    def test_two_arrays_and_the_table_of_the_pool(self):
        work = self.workspace(STUDY)
        said = work.swept("--slurm", "--comment=sweep", "--jobs", 2)
        self.assertRegex(said, r"submitted to Slurm: \d+, \d+")
        rows = work.rows()
        self.assertEqual(["complete"] * 6, [row["status"] for row in rows])
        self.assertEqual(["", "0001", "0001", "", "0004", "0004"], [row["replayed"] for row in rows])
        self.assertFalse((work.out / "slurm.json").exists())
        pool = self.workspace(STUDY)
        pool.swept()
        measures = [name for name in rows[0] if name.startswith("surface.")]
        self.assertEqual([[row[name] for name in measures] for row in pool.rows()], [[row[name] for name in measures] for row in rows])

    def test_acceptance_an_interrupted_command_watches_its_jobs_again(self):
        work = self.workspace(LONG, duration=2.0)
        first = work.start("--slurm", "")
        job = self.submitted(work)
        os.killpg(first.pid, signal.SIGINT)
        said = first.communicate()[0]
        self.assertEqual(130, first.returncode, said)
        self.assertIn(f"scancel {job} ends them", said)
        self.assertIn(job, self.queue())
        again = work.swept("--slurm", "")
        self.assertIn(f"jobs of an earlier command go on: {job}", again)
        self.assertEqual(["complete"] * 3, [row["status"] for row in work.rows()])

    def test_acceptance_a_cancelled_task_is_a_row_and_a_requeued_one_is_made_anew(self):
        work = self.workspace(LONG, duration=3.0)
        command = work.start("--slurm", "", "--jobs", 1)
        job = self.submitted(work)
        self.wait_for("run", lambda: f"{job}_0 RUNNING" in self.queue())
        self.wait_for("start", lambda: (work.out / "log" / "0001.txt").exists())
        self.assertEqual(0, self.slurm.command("scancel", f"{job}_1").returncode)
        requeued = self.slurm.command("scontrol", "requeue", f"{job}_0")
        self.assertEqual(0, requeued.returncode, requeued.stderr)
        # Slurm holds a requeued task back for two minutes of grace.
        self.wait_for("requeued task", lambda: f"{job}_0 PENDING" in self.queue())
        moved = self.slurm.command("scontrol", "update", f"JobId={job}_0", "StartTime=now")
        self.assertEqual(0, moved.returncode, moved.stderr)
        said = command.communicate()[0]
        self.assertEqual(1, command.returncode, said)
        rows = work.rows()
        self.assertEqual(["complete", "failed", "complete"], [row["status"] for row in rows], said)
        self.assertIn(f"task {job}_1 left the queue, where it was last PENDING, as cancelled tasks do", rows[1]["message"])

    def test_options_that_slurm_refuses_are_its_own_words(self):
        work = self.workspace(STUDY)
        done = work.sweep("--slurm", "--partition=nowhere")
        self.assertEqual(1, done.returncode)
        self.assertIn("sbatch: ", done.stderr)
        self.assertIn("partition", done.stderr)


if __name__ == "__main__":
    unittest.main()
