"""Runs over two machines: processes started by hand, through ssh and by Slurm; slow lines, cut lines, deaths and mistakes.

    usage: test_hosts.py TREMOLO [TESTCASE ...]

The machines are network namespaces (two_hosts.py); ssh and srun are stand-ins that start their command there. Where no
namespace can be made, these tests are skipped, and those over the loopback interface remain.
"""

import os
import re
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

TREMOLO = str(Path(sys.argv.pop(1)).resolve())
sys.path[:0] = [str(Path(__file__).resolve().parent.parent / folder) for folder in ("faults", "runs")]

import fault_lab
import small_case
import two_hosts

LACKING = two_hosts.lacking()
BY_HAND, BY_SSH, BY_SLURM = ('{ start = "join" }', f'{{ start = "ssh", host = "node2", command = "{TREMOLO}" }}',
                             f'{{ start = "slurm", command = "{TREMOLO}" }}')
STEP_DEADLINE = 30.0  # s
PATIENCE = 60.0       # s, for what must come


class Started:
    """A process whose output goes to a file."""

    def __init__(self, words, folder, namespace=None, **environment):
        self.file = Path(tempfile.mkstemp(dir=folder)[1])
        with open(self.file, "w") as output:
            self.process = subprocess.Popen(two_hosts.inside(namespace, words), stdout=output, stderr=subprocess.STDOUT, cwd=folder,
                                            env={**os.environ, **environment})

    def output(self):
        return self.file.read_text(errors="replace")

    def find(self, pattern):
        """Waits for words in the output."""
        return fault_lab.await_until(lambda: re.search(pattern, self.output()) or self.must_run(), pattern)

    def must_run(self):
        if self.process.poll() is not None:
            raise AssertionError(f"ended too early:\n{self.output()}")

    def child(self):
        pid = self.process.pid
        return int(fault_lab.await_until(lambda: Path(f"/proc/{pid}/task/{pid}/children").read_text(), "a child").split()[0])

    def end(self):
        """Exit status, once it has ended."""
        return self.process.wait(PATIENCE)


class Workspace:
    """A folder with keys, stand-ins of ssh and srun, and the small slope with its sides placed by [hosts]."""

    def __init__(self, hosts=None, address="127.0.0.1", step_deadline=STEP_DEADLINE, connect_deadline=20.0, **sides):
        self._folder = tempfile.TemporaryDirectory(prefix="th-")
        self.path = Path(self._folder.name)
        self.hosts = hosts
        self.started = []
        self.stubs = two_hosts.put_stubs(self.path / "bin", hosts and hosts.there)
        text = small_case.SLOPE.format(velocity=0.5, duration=1.0) + fault_lab.COUPLING.format(
            mode="window", window=8, connect=connect_deadline, step=step_deadline)
        text += f'\n[hosts]\nendpoint = "tcp://{address}:*"\n' + "".join(f"{side} = {way}\n" for side, way in sides.items())
        self.case = self.path / "case.toml"
        self.case.write_text(text)
        self.keys = self.path / "keys"
        subprocess.run([TREMOLO, "keygen", str(self.keys), "left-base", "right"], check=True, capture_output=True)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        for started in self.started:
            started.process.kill()
            started.process.wait()
        self._folder.cleanup()

    def start(self, words, there=False, **environment):
        namespace = self.hosts and (self.hosts.there if there else self.hosts.here)
        self.started.append(Started(words, self.path, namespace, PATH=f"{self.stubs}:{os.environ['PATH']}",
                                    **environment))
        return self.started[-1]

    def run(self, *options):
        return self.start([TREMOLO, "run", self.case, "--out", self.path / "run", "--threads", 1, *(options or ("--keys", self.keys))])

    def join(self, run, name="left-base", *options):
        """Does on the other machine what the run says."""
        words = run.find(rf"on its machine: tremolo (join \S+ --role {name} --keys \S+)\n").group(1).split()
        return self.start([TREMOLO, *words, *options], there=True)

    def frames(self):
        """Waits until the run is in the midst of its steps."""
        import h5py

        def there():
            try:
                with h5py.File(self.path / "run" / "run.h5") as file:
                    return len(file["frames"]) >= 2
            except (OSError, KeyError):
                return False

        fault_lab.await_until(there, "the second frame")

    def results(self):
        return fault_lab.results(self.path / "run")


class HostsTest(unittest.TestCase):
    _undisturbed = None

    @classmethod
    def undisturbed(cls):
        """What all processes on one machine compute."""
        if HostsTest._undisturbed is None:
            with Workspace(left=BY_HAND) as work:
                run = work.run("--local")
                assert run.end() == 0, run.output()
                HostsTest._undisturbed = work.results()
        return HostsTest._undisturbed

    def assert_same_bits(self, work, run):
        self.assertEqual(0, run.end(), run.output())
        state, found = work.results()
        expected_state, expected = self.undisturbed()
        self.assertEqual((expected_state, "complete"), (state, "complete"))
        self.assertEqual(expected.keys(), found.keys())
        self.assertGreater(len(found), 20)
        self.assertEqual([], [name for name in expected if expected[name] != found[name]])

    def assert_failed(self, started, *patterns):
        self.assertNotEqual(0, started.end(), started.output())
        for pattern in patterns:
            self.assertRegex(started.output(), pattern)


class OverLoopback(HostsTest):
    def test_process_started_by_hand(self):
        with Workspace(left=BY_HAND) as work:
            run = work.run()
            joined = work.join(run, "left-base", "--case", work.case)
            self.assert_same_bits(work, run)
            self.assertEqual(0, joined.end(), joined.output())
            self.assertRegex(run.output(), r"left-base .* elsewhere")

    def test_job_script_starts_processes_on_its_nodes(self):
        with Workspace(left=BY_SLURM, right=BY_SLURM) as work:
            script = work.path / "job.sh"
            script.write_text(subprocess.run([TREMOLO, "sbatch", str(work.case), "--keys", str(work.keys)], check=True,
                                             capture_output=True, text=True).stdout)
            self.assertIn("#SBATCH --nodes=3\n", script.read_text())
            job = work.start(["bash", script], SLURM_JOB_ID="1", SLURM_JOB_NUM_NODES="3", SLURM_CPUS_ON_NODE="1")
            self.assertEqual(0, job.end(), job.output())
            next((work.path / "runs").iterdir()).rename(work.path / "run")
            self.assert_same_bits(work, job)

    def test_mistakes_are_told_and_leave_the_run_waiting(self):
        with Workspace(left=BY_HAND) as work:
            run = work.run()
            other = work.path / "other.toml"
            other.write_text(work.case.read_text().replace("velocity = 0.5", "velocity = 0.6"))
            self.assert_failed(work.join(run, "left-base", "--case", other), r"another case.*velocity = 0\.6")
            self.assert_failed(work.join(run, "left-base", "--run", "0" * 16), "meant for run 0{16}")
            words = run.find(r"tremolo (join \S+ --role )left-base( --keys \S+)\n").groups()
            right = f"{words[0]}right{words[1]}".split()
            self.assert_failed(work.start([TREMOLO, *right, "--deadline", "1"]), "the hub does not know this key")
            joined = work.join(run)
            self.assert_same_bits(work, run)
            self.assertEqual(0, joined.end(), joined.output())

    def test_what_ssh_says_is_told(self):
        with Workspace(left=BY_SSH) as work:
            (work.stubs / "ssh").write_text("#!/bin/sh\necho ssh: no route to node2 >&2\nexit 255\n")
            self.assert_failed(work.run(), "'left-base' exited with code 255", "no route to node2")

    def test_keys_are_needed(self):
        with Workspace(left=BY_HAND) as work:
            self.assert_failed(work.run("--mode", "window"), "it needs CURVE keys")


@unittest.skipIf(LACKING, LACKING)
class OverTwoMachines(HostsTest):
    def workspace(self, hosts, **more):
        return Workspace(hosts, hosts.here_address, **{"left": BY_HAND, **more})

    def test_by_hand_and_through_ssh(self):
        with two_hosts.TwoHosts() as hosts, self.workspace(hosts, right=BY_SSH) as work:
            run = work.run()
            joined = work.join(run)
            self.assert_same_bits(work, run)
            self.assertEqual(0, joined.end(), joined.output())

    def test_acceptance_slow_line_that_loses_packets(self):
        with two_hosts.TwoHosts(delay=0.05, loss=0.01, seed=7) as hosts:
            with self.workspace(hosts, left=BY_SSH) as work:
                self.assert_same_bits(work, work.run())
            sent, lost = hosts.packets()
            self.assertGreater(lost, 0, f"of {sent} packets none was lost: nothing was tried")

    def test_acceptance_line_that_is_down_for_5_s(self):
        with two_hosts.TwoHosts() as hosts, self.workspace(hosts) as work:
            run = work.run()
            joined = work.join(run)
            work.frames()
            hosts.line("down")
            time.sleep(5.0)
            run.must_run()
            hosts.line("up")
            self.assert_same_bits(work, run)
            self.assertEqual(0, joined.end(), joined.output())

    def test_acceptance_line_that_stays_down_ends_both_sides(self):
        with two_hosts.TwoHosts() as hosts, self.workspace(hosts, step_deadline=8.0) as work:
            run = work.run()
            joined = work.join(run)
            work.frames()
            hosts.line("down")
            self.assert_failed(run, "waits for source 'left-base'.*last sign of life of 'left-base'")
            self.assert_failed(joined, "source 'left-base' waits for credit or BYE.*last sign of life of the hub")
            self.assertRegex(work.results()[0], "^aborted")

    def test_death_on_the_other_machine_is_told_here(self):
        with two_hosts.TwoHosts() as hosts, self.workspace(hosts) as work:
            run = work.run()
            joined = work.join(run)
            work.frames()
            os.kill(joined.child(), signal.SIGKILL)
            self.assert_failed(run, "'left-base' was killed by signal 9")
            self.assert_failed(joined, "'left-base' was killed by signal 9")

    def test_death_of_the_other_machines_processes_all_at_once(self):
        with two_hosts.TwoHosts() as hosts, self.workspace(hosts) as work:
            run = work.run()
            joined = work.join(run)
            work.frames()
            joined.process.kill()
            self.assert_failed(run, "the connection to 'left-base' on another machine is gone")

    def test_death_of_the_run_is_seen_there(self):
        with two_hosts.TwoHosts() as hosts, self.workspace(hosts) as work:
            run = work.run()
            joined = work.join(run)
            work.frames()
            run.process.kill()
            self.assert_failed(joined, "the run at tcp://.* is gone")

    def test_file_that_the_other_machine_lacks_is_named(self):
        with two_hosts.TwoHosts() as hosts, self.workspace(hosts) as work:
            data = work.path / "data"
            data.mkdir()
            (data / "motion.AT2").write_text("a record\nACCELERATION IN UNITS OF G\nNPTS= 200, DT= .01 SEC\n" + "0.0 0.01 -0.01 0.0\n" * 50)
            pulse = re.compile(r"pulse = .*\n")
            work.case.write_text(pulse.sub('file = "data/motion.AT2"\nkind = "incident"\n', work.case.read_text()))
            run = work.run()
            words = run.find(r"tremolo (join .*)\n").group(1)
            hidden = work.start(["unshare", "--mount", "sh", "-c", f"mount -t tmpfs none {data} && exec {TREMOLO} {words}"], there=True)
            self.assert_failed(hidden, f"{data}/motion.AT2 is missing on this machine")


if __name__ == "__main__":
    unittest.main()
