"""Ranks of a domain on the nodes of a Slurm job, in a real Slurm that the test starts for itself: the bits of one process, and the
death of a rank on another node ends the job with its name.

    usage: test_rank_slurm.py TREMOLO SOURCE_DIR mpi|alone
"""

import os
import signal
import subprocess
import sys
import unittest
from pathlib import Path

TREMOLO, SOURCE, BUILD = sys.argv.pop(1), Path(sys.argv.pop(1)), sys.argv.pop(1)
sys.path[:0] = [str(SOURCE / "python"), *(str(Path(__file__).parents[1] / folder) for folder in ("resume", "sweep", "faults"))]

import small_slurm
from broken_run import SlopeWorkspace, checkpoints, differences, with_checkpoints
from fault_lab import await_until
from processes import variable
from small_sweep import SweepWorkspace

LACKING = [*small_slurm.missing(), *([] if BUILD == "mpi" else ["MPI in this build"])]
# Both nodes are this machine, so ranks of one would take the files in memory of the other's for their own.
HOSTS = """
[hosts]
endpoint = "tcp://127.0.0.1:*"
slurm_options = "--nodes=2 --output=job.txt"
left = {{ start = "slurm", command = "{tremolo}" }}

[hosts.domain]
start = "slurm"
options = "--mca btl self,tcp"
"""


def process_of_rank(rank, job):
    for process in filter(str.isdigit, os.listdir("/proc")):
        if variable(process, "OMPI_COMM_WORLD_RANK") == str(rank) and variable(process, "SLURM_JOB_ID") == job:
            return int(process)
    return None


@unittest.skipIf(LACKING, f"{', '.join(LACKING)} not installed: scripts/setup.sh installs slurm-wlm, munge and Open MPI")
class RanksInAJob(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.work = cls.enterClassContext(with_checkpoints(SlopeWorkspace(TREMOLO, duration=1.2), every_steps=40))
        cls.whole = cls.work.run("whole", "--threads", 1)
        cls.slurm = cls.enterClassContext(small_slurm.SmallSlurm(nodes=2))
        cls.work.case.write_text(cls.work.case.read_text() + HOSTS.format(tremolo=TREMOLO))
        keys = cls.work.path / "keys"
        assert cls.work.command("keygen", keys, "left-base").returncode == 0
        script = cls.work.command("sbatch", cls.work.case, "--keys", keys, "--ranks", 3)
        assert script.returncode == 0, script.stderr
        (cls.work.path / "job.sh").write_text(script.stdout)

    def submitted(self):
        """The job's number, and the command that waits for its end."""
        command = subprocess.Popen(["sbatch", "--wait", "--parsable", "job.sh"], cwd=self.work.path, env=self.slurm.environment,
                                   stdout=subprocess.PIPE, text=True)
        return command.stdout.readline().strip(), command

    def said(self):
        return (self.work.path / "job.txt").read_text(errors="replace")

    def runs(self):
        folder = self.work.path / "runs"
        return sorted(folder.iterdir(), key=lambda run: run.stat().st_mtime) if folder.is_dir() else []

    def test_give_the_bits_of_one_with_a_free_field_beside_them(self):
        _, command = self.submitted()
        self.assertEqual(0, command.wait(timeout=120), self.said())
        self.assertIn("as 3 ranks on the nodes of the job", self.said())
        self.assertRegex(self.said(), "left-base .* by srun")
        self.assertEqual([], differences(self.runs()[-1], self.whole))

    def test_a_sweep_gives_each_of_its_runs_ranks(self):
        with SweepWorkspace(TREMOLO, 'case = "case.toml"\n[axes]\nmotion.angle_deg = [0]\n') as work:
            work.environment = self.slurm.environment
            work.swept("--slurm", "", "--ranks", 2)
            self.assertEqual(["complete"], [row["status"] for row in work.rows()])
            self.assertIn("as 2 ranks", (work.out / "log/0001.txt").read_text())

    def test_acceptance_a_rank_that_dies_on_another_node_ends_the_job_with_its_name(self):
        before = len(self.runs())
        job, command = self.submitted()
        await_until(lambda: command.poll() is not None or (len(self.runs()) > before and checkpoints(self.runs()[-1])), "a checkpoint")
        os.kill(process_of_rank(2, job), signal.SIGKILL)
        self.assertEqual(1, command.wait(timeout=60), self.said())
        self.assertRegex(self.said(), f"process rank 2 with PID \\d+ on node {self.slurm.nodes[1]} exited on signal 9")
        self.assertIn("tremolo resume", self.said())

    def test_outside_a_job_nothing_is_started(self):
        result = self.work.command("run", self.work.case, "--out", "outside", "--ranks", 3)
        self.assertEqual(1, result.returncode)
        self.assertIn("this is not a Slurm job", result.stderr)


if __name__ == "__main__":
    unittest.main()
