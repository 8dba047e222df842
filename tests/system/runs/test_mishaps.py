"""What goes wrong in the hands of a user: each mishap ends soon, with a message that names it.

    usage: test_mishaps.py TREMOLO PYTHON_PACKAGE_DIR
"""

import os
import resource
import shutil
import signal
import subprocess
import sys
import time
import unittest
from pathlib import Path

import numpy as np

TREMOLO, PACKAGE = sys.argv.pop(1), sys.argv.pop(1)
sys.path[:0] = [PACKAGE, str(Path(__file__).parent)]

from run_files import wait_for_frames
from processes import children
from small_case import SlopeWorkspace, Workspace
from tremolo import Run

LONG = {"duration": 60.0, "every": 0.01}


def start(work, **options):
    return subprocess.Popen([TREMOLO, "run", str(work.case), "--out", str(work.path / "run")], text=True,
                            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, **options)


def program(pid):
    return Path(f"/proc/{pid}/comm").read_text().strip()


class Mishaps(unittest.TestCase):
    def test_ctrl_c_ends_all_processes_and_leaves_a_readable_file(self):
        with Workspace(TREMOLO, **LONG) as work:
            run = start(work)
            wait_for_frames(work)
            started = children(run.pid)
            self.assertEqual(2, len(started))
            run.send_signal(signal.SIGINT)
            before = time.monotonic()
            run.communicate(timeout=20)
            self.assertLess(time.monotonic() - before, 10.0)
            self.assertEqual(130, run.returncode)
            self.assertEqual([], [pid for pid in started if Path(f"/proc/{pid}").exists()])
            result = Run(work.path / "run")
            self.assertTrue(result.status.startswith("aborted"), result.status)
            self.assertGreaterEqual(len(result.times), 3)

    def test_the_session_stands_in_no_command_line(self):
        with Workspace(TREMOLO, **LONG) as work:
            run = start(work)
            wait_for_frames(work)
            for pid in children(run.pid):
                words = Path(f"/proc/{pid}/environ").read_bytes().split(b"\0")
                [session] = [word.removeprefix(b"TREMOLO_SESSION=") for word in words if word.startswith(b"TREMOLO_SESSION=")]
                self.assertEqual(16, len(session))
                for process in (pid, run.pid):
                    self.assertNotIn(session, Path(f"/proc/{process}/cmdline").read_bytes())
            run.send_signal(signal.SIGINT)
            run.communicate(timeout=20)

    def killed(self, victim):
        with Workspace(TREMOLO, **LONG) as work:
            run = start(work)
            wait_for_frames(work)
            pid = next(p for p in children(run.pid) if program(p) == victim)
            os.kill(pid, signal.SIGKILL)
            output, _ = run.communicate(timeout=20)
            self.assertNotIn(run.returncode, (0, None))
            result = Run(work.path / "run")
            self.assertTrue(result.status.startswith("aborted"), result.status)
            self.assertGreaterEqual(len(result.times), 3)
            return output

    def test_a_killed_source_is_named(self):
        self.assertRegex(self.killed("tremolo-wave"), "left-right-base.*(killed|signal 9|SIGKILL)")

    def test_a_killed_domain_is_named(self):
        self.assertRegex(self.killed("tremolo-domain"), "domain.*(killed|signal 9|SIGKILL)")

    def test_a_crash_is_told_in_words(self):
        with Workspace(TREMOLO, **LONG) as work:
            run = start(work)
            wait_for_frames(work)
            run.send_signal(signal.SIGSEGV)
            output, _ = run.communicate(timeout=20)
            self.assertEqual(-signal.SIGSEGV, run.returncode)
            self.assertIn(f"tremolo: run {work.case} --out {work.path / 'run'} crashed (Segmentation fault). A damaged file", output)

    def test_a_picture_whose_program_crashes_is_told_in_words(self):
        with Workspace(TREMOLO, duration=0.1) as work:
            folder = work.run("run")
            package = work.path / "crashing"
            package.mkdir()
            (package / "sitecustomize.py").write_text("import os, signal, sys\nif 'tremolo' in sys.argv or '-m' in sys.orig_argv:\n"
                                                      "    os.kill(os.getpid(), signal.SIGSEGV)\n")
            done = subprocess.run([TREMOLO, "plot", folder], env={**os.environ, "PYTHONPATH": str(package)}, capture_output=True, text=True)
            self.assertEqual(1, done.returncode)
            self.assertIn("tremolo: python3 -m tremolo plot crashed (Segmentation fault). A damaged file can do that", done.stderr)

    def test_ground_that_finds_no_rest_leaves_a_frame_of_how_it_moves(self):
        with SlopeWorkspace(TREMOLO) as work:
            text = work.case.read_text().replace("cohesion_peak = 4e3", "cohesion_peak = 100.0").replace("friction_peak_deg = 45", "friction_peak_deg = 30")
            work.case.write_text(text.replace('kind = "gravity"', 'kind = "gravity"\nmax_time_s = 4.0'))
            done = work.command("run", work.case, "--out", "run")
            self.assertEqual(1, done.returncode)
            self.assertRegex(done.stderr, r"the gravity stage did not come to rest: residual .* after 4 s .*; the frame in run\.h5 shows where the "
                                          "ground moves")
            with Run(work.path / "run") as run:
                self.assertIn("aborted: the gravity stage did not come to rest", run.status)
                self.assertEqual([0.0], list(run.times))
                frame = run.frame(0)
                speed, (x, y) = np.hypot(*frame["velocity"].T), frame["position"].T
            # The slope slides: soil above its toe moves, towards it, and that at the base does not.
            moves = (x > 12.0) & (x < 24.0) & (y > 0.0)
            self.assertGreater(np.median(speed[moves]), 20.0 * np.median(speed[y < -5.0]))
            self.assertLess(np.median(frame["velocity"][moves, 0]), 0.0)
            self.assertEqual(0, work.command("plot", "run").returncode)

    def test_a_full_disk_is_said(self):
        limit = 200_000  # bytes a file may have: a few frames

        def small_files():
            resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit))

        with Workspace(TREMOLO, **LONG) as work:
            run = start(work, preexec_fn=small_files)
            output, _ = run.communicate(timeout=60)
            self.assertNotEqual(0, run.returncode)
            # A source keeps its steps in a file too, which may be too large first.
            self.assertRegex(output, "(run.h5|cannot keep the free field in).*: File too large")

    def test_acceptance_a_launcher_killed_as_it_begins_leaves_no_run_file_that_cannot_be_read(self):
        with Workspace(TREMOLO, **LONG) as work:
            named = 0
            for attempt in range(20):
                shutil.rmtree(work.path / "run", ignore_errors=True)
                run = start(work)
                while not list((work.path / "run").glob("run.h5*")):
                    time.sleep(0.0005)
                time.sleep(0.0015 * attempt)
                run.kill()
                run.communicate(timeout=20)
                time.sleep(0.05)  # the kernel kills the domain
                if (work.path / "run/run.h5").exists():
                    named += 1
                    self.assertEqual("running", Run(work.path / "run").status)
            self.assertGreater(named, 5)

    @unittest.skipIf(os.geteuid() != 0, "needs root to mount a file system")
    def test_a_full_file_system_is_told_with_the_systems_reason(self):
        self.expect_the_systems_reason(3)

    @unittest.skipIf(os.geteuid() != 0, "needs root to mount a file system")
    def test_acceptance_so_is_one_that_holds_many_frames(self):
        self.expect_the_systems_reason(39)

    def expect_the_systems_reason(self, megabytes):
        with Workspace(TREMOLO, size=0.5, duration=20.0, every=0.001) as work:
            disk = work.path / "disk"
            disk.mkdir()
            mounted = subprocess.run(["mount", "-t", "tmpfs", "-o", f"size={megabytes}m", "tmpfs", disk], capture_output=True)
            if mounted.returncode != 0:
                self.skipTest(mounted.stderr.decode())
            try:
                result = work.command("run", work.case, "--out", disk / "run")
                self.assertEqual(1, result.returncode, result.stderr)
                self.assertRegex(result.stderr, r"disk/run/run\.\S*: .*: No space left on device")
                self.assertNotIn("Bad file descriptor", result.stderr)
                self.assertGreaterEqual(len(Run(disk / "run").times), 3)
            finally:
                subprocess.run(["umount", disk], check=True)

    @unittest.skipIf(os.geteuid() != 0, "needs root to become a user who may write nothing")
    def test_an_unwritable_folder_is_no_full_disk(self):
        with Workspace(TREMOLO) as work:
            work.path.chmod(0o555)
            run = start(work, user=65534, group=65534, extra_groups=())
            output, _ = run.communicate(timeout=20)
            self.assertEqual(1, run.returncode, output)
            self.assertIn("run: Permission denied", output)
            self.assertNotIn("full", output)
            work.path.chmod(0o777)
            (work.path / "run").mkdir(mode=0o555)
            run = start(work, user=65534, group=65534, extra_groups=())
            output, _ = run.communicate(timeout=20)
            self.assertEqual(1, run.returncode, output)
            self.assertIn("Permission denied", output)
            self.assertNotIn("full", output)

    def test_a_wrong_key_is_refused_with_its_place_and_the_nearest_key(self):
        with Workspace(TREMOLO) as work:
            work.case.write_text(work.case.read_text().replace("size = 1.0", "siz = 1.0"))
            result = work.command("run", work.case, "--out", work.path / "run")
            self.assertEqual(2, result.returncode)
            self.assertRegex(result.stderr, r"case\.toml:\d+:\d+: \[mesh\] unknown key 'siz', did you mean 'size'\?")
            self.assertFalse((work.path / "run").exists())

    def test_a_missing_motion_file_is_refused(self):
        with Workspace(TREMOLO) as work:
            result = work.command("run", work.case, "--motion", work.path / "none.AT2", "--out", work.path / "run")
            self.assertEqual(2, result.returncode, result.stderr)
            self.assertIn("none.AT2", result.stderr)

    def test_a_missing_case_is_refused(self):
        with Workspace(TREMOLO) as work:
            result = work.command("run", work.path / "none.toml")
            self.assertEqual(2, result.returncode, result.stderr)
            self.assertIn("none.toml", result.stderr)

    def test_a_run_does_not_overwrite_another(self):
        with Workspace(TREMOLO, duration=0.1) as work:
            folder = work.run("run")
            result = work.command("run", work.case, "--out", folder)
            self.assertNotEqual(0, result.returncode)
            self.assertIn("not an empty folder", result.stderr)


if __name__ == "__main__":
    unittest.main()
