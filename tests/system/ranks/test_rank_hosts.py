"""Ranks of a domain on two machines: the bits of one process, and a death there or a line that is cut ends the run here.

    usage: test_rank_hosts.py TREMOLO SOURCE_DIR mpi|alone

The machines are network namespaces, ssh a stand-in that starts its command in the other one (tests/system/hosts). Where no
namespace can be made, these tests are skipped, and say so.
"""

import os
import signal
import subprocess
import sys
import unittest
from pathlib import Path

TREMOLO, SOURCE, BUILD = sys.argv.pop(1), Path(sys.argv.pop(1)), sys.argv.pop(1)
sys.path[:0] = [str(SOURCE / "python"), *(str(Path(__file__).parents[1] / folder) for folder in ("resume", "hosts", "faults"))]

import two_hosts
from broken_run import SlopeWorkspace, checkpoints, differences, with_checkpoints
from fault_lab import await_until
from processes import alive, variable

LACKING = two_hosts.lacking() if BUILD == "mpi" else "this build has no MPI"


def ranks_in(namespace):
    """Process ids of ranks in a network namespace, by rank."""
    listed = subprocess.run(["ip", "netns", "pids", namespace], capture_output=True, text=True, check=True).stdout
    ranks = {variable(int(pid), "OMPI_COMM_WORLD_RANK"): int(pid) for pid in listed.split()}
    return {int(rank): pid for rank, pid in ranks.items() if rank is not None}


@unittest.skipIf(LACKING, LACKING)
class RanksOnTwoMachines(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.work = cls.enterClassContext(with_checkpoints(SlopeWorkspace(TREMOLO, duration=1.2), every_steps=40))
        cls.whole = cls.work.run("whole", "--threads", 1)
        cls.hosts = cls.enterClassContext(two_hosts.TwoHosts())
        stubs = two_hosts.put_stubs(cls.work.path / "bin", cls.hosts.there)
        cls.environment = {**os.environ, "PATH": f"{stubs}:{os.environ['PATH']}"}
        # A line that is cut is noticed within 6 s instead of 30.
        options = " ".join(f"--mca oob_tcp_keepalive_{name} 2" for name in ("time", "intvl", "probes"))
        cls.work.case.write_text(f'{cls.work.case.read_text()}\n[hosts.domain]\nstart = "ssh"\nmachines = ["{cls.hosts.there_address}:2"]\n'
                                 f'options = "{options}"\n\n[coupling]\nstep_deadline_s = 4.0\n')

    def started(self, *words):
        command = two_hosts.inside(self.hosts.here, [TREMOLO, *words, "--threads", 1])
        return subprocess.Popen(command, cwd=self.work.path, env=self.environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)

    def in_its_steps(self, name):
        """A run of three ranks after its first checkpoint, and the processes of those on the other machine."""
        run = self.started("run", self.work.case, "--out", name, "--ranks", 3)
        await_until(lambda: checkpoints(self.work.path / name) or run.poll() is not None, "a checkpoint")
        there = ranks_in(self.hosts.there)
        if not there:
            run.kill()
            self.fail(run.communicate()[0])
        return run, there

    def assert_failed(self, run, *words):
        output = run.communicate(timeout=60)[0]
        self.assertEqual(1, run.returncode, output)
        for text in words:
            self.assertRegex(output, text)

    def test_give_the_bits_of_one_and_others_go_on_after_a_death_there(self):
        run, there = self.in_its_steps("killed")
        self.assertEqual([2], sorted(there), "rank 0 and the next are here, and there is the last")
        os.kill(there[2], signal.SIGKILL)
        self.assert_failed(run, f"process rank 2 with PID {there[2]} on node {self.hosts.there_address} exited on signal 9", "tremolo resume")
        resumed = self.started("resume", "killed", "--ranks", 4)
        output = resumed.communicate(timeout=120)[0]
        self.assertEqual(0, resumed.returncode, output)
        self.assertIn(f"as 4 ranks, 2 here, 2 on {self.hosts.there_address}", output)
        self.assertEqual([], differences(self.work.path / "killed", self.whole))

    def test_acceptance_a_line_that_stays_down_ends_both_sides(self):
        run, there = self.in_its_steps("cut")
        self.hosts.line("down")
        try:
            self.assert_failed(run, r"the hub waits for the velocities of step \d+ of domain 'domain'")
            await_until(lambda: not any(map(alive, there.values())), "the end of the ranks there")
        finally:
            self.hosts.line("up")

    def test_the_end_of_the_run_ends_those_there(self):
        run, there = self.in_its_steps("ended")
        run.kill()
        run.communicate(timeout=60)
        await_until(lambda: not any(map(alive, there.values())), "the end of the ranks there")

    def test_another_case_there_is_refused(self):
        """A folder that the machines do not share: over the file of the run lies another one there."""
        other = self.work.path / "other.toml"
        other.write_text(self.work.case.read_text().replace("duration_s = 1.2", "duration_s = 1.1"))
        hide = self.work.path / "bin" / "ssh"
        text = hide.read_text()
        try:
            hide.write_text(text.replace('sh -c "$*"', f'unshare --mount sh -c "mount --bind {other} {self.work.path}/split/case.toml; $*"'))
            run = self.started("run", self.work.case, "--out", "split", "--ranks", 3)
            self.assert_failed(run, "rank 2 of the domain, on .*: .*split/case.toml is another one than that of rank 0")
        finally:
            hide.write_text(text)


if __name__ == "__main__":
    unittest.main()
