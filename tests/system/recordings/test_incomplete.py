"""Recordings that were cut short: marked with the step and the reason, readable, served only as far as they go; a full disk is
loud; damaged files are refused.

    usage: test_incomplete.py TREMOLO SOURCE_DIR
"""

import os
import random
import resource
import signal
import subprocess
import sys
import time
import unittest
from pathlib import Path

TREMOLO, SOURCE = sys.argv.pop(1), Path(sys.argv.pop(1))
sys.path[:0] = [str(SOURCE / "python"), str(Path(__file__).parent)]

import h5py
import numpy as np
from recorded_case import BoxWorkspace, differences, model, record, text

FIELDS = {"left": model("fe"), "right": model("wave"), "base": model("wave")}


def recorded_box(**changes):
    """The recording is more than twice as large as the run file."""
    settings = {key: changes.pop(key) for key in ("on_full_disk",) if key in changes}
    work = record(BoxWorkspace(TREMOLO, **{**FIELDS, "duration": 1.6, **changes}), **settings)
    work.case.write_text(work.case.read_text().replace("history_every_s = 0.005", "history_every_s = 0.1"))
    return work

LONG = {"duration": 60.0}


def start(work, **options):
    return subprocess.Popen([TREMOLO, "run", str(work.case), "--out", str(work.path / "run")], text=True,
                            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, **options)


def status(folder):
    with h5py.File(folder / "exchange.h5") as file:
        return text(file.attrs["status"])


def domain_steps(folder):
    with h5py.File(folder / "exchange.h5", locking=False) as file:
        return len(file["domain/time"])


def wait_until_recorded(work, steps):
    """Until the file on the disk holds so many steps of the domain."""
    deadline = time.monotonic() + 60.0
    while time.monotonic() < deadline:
        try:
            if domain_steps(work.path / "run") >= steps:
                return
        except (OSError, KeyError):
            pass
        time.sleep(0.05)
    raise AssertionError(f"{steps} steps were not recorded within 60 s")


def child_named(pid, name):
    children = [int(p) for p in Path(f"/proc/{pid}/task/{pid}/children").read_text().split()]
    return next(p for p in children if Path(f"/proc/{p}/comm").read_text().strip() == name)


class Killed(unittest.TestCase):
    def test_a_killed_participant_is_named_in_the_recording_which_serves_a_shorter_run(self):
        for victim, word in (("tremolo-column", "'left'"), ("tremolo-domain", "'domain'")):
            with recorded_box(**LONG) as work:
                run = start(work)
                wait_until_recorded(work, 800)
                os.kill(child_named(run.pid, victim), signal.SIGKILL)
                output, _ = run.communicate(timeout=20)
                self.assertEqual(1, run.returncode, output)
                self.assertRegex(status(work.path / "run"), rf"^aborted at step \d+: {word} .*(killed|signal 9|SIGKILL)")
                step = int(status(work.path / "run").split()[3].rstrip(":"))
                self.assertEqual(step, domain_steps(work.path / "run"))

                refused = work.command("run", work.case, "--replay", f"{work.path / 'run'}:left", "--out", work.path / "no")
                self.assertEqual(1, refused.returncode)
                self.assertRegex(refused.stderr, rf"but the case asks for it from .* to 60 s; the recording is not complete: "
                                                 rf"aborted at step \d+: {word}")
                # A run that needs no more than is held is served, with a warning, and is what it would have been live.
                work.case.write_text(work.case.read_text().replace("duration_s = 60.0", "duration_s = 0.5"))
                live = work.run("live")
                again = work.command("run", work.case, "--replay", f"{work.path / 'run'}:left", "--out", work.path / "again")
                self.assertEqual(0, again.returncode, again.stdout + again.stderr)
                self.assertRegex(again.stdout + again.stderr, r"warning: .*exchange\.h5 is not complete \(aborted at step")
                self.assertEqual([], differences(work.path / "again", live))

    def test_a_killed_launcher_leaves_a_readable_recording_that_is_not_complete(self):
        with recorded_box(**LONG) as work:
            run = start(work)
            wait_until_recorded(work, 800)
            run.send_signal(signal.SIGKILL)
            run.communicate(timeout=20)
            self.assertEqual("running", status(work.path / "run"))
            exported = work.command("export", f"{work.path / 'run'}:left", "left.csv")
            self.assertEqual(0, exported.returncode, exported.stderr)
            self.assertIn("is not complete: running", exported.stdout)
            refused = work.command("run", work.case, "--replay", f"{work.path / 'run'}:left", "--out", work.path / "no")
            self.assertRegex(refused.stderr, "the recording is not complete: running")

    def test_ctrl_c_is_said_in_the_recording(self):
        with recorded_box(**LONG) as work:
            run = start(work)
            wait_until_recorded(work, 400)
            run.send_signal(signal.SIGINT)
            run.communicate(timeout=20)
            self.assertEqual(130, run.returncode)
            self.assertRegex(status(work.path / "run"), r"^aborted at step \d+: interrupted by Ctrl-C")


class FullDisk(unittest.TestCase):
    def limited(self, work, limit):
        run = start(work, preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit)))
        output, _ = run.communicate(timeout=120)
        return run.returncode, output

    def check_what_is_held(self, work, live):
        """Every step that is there is the right one."""
        with h5py.File(work.path / "run/exchange.h5") as cut, h5py.File(live / "exchange.h5") as whole:
            for name in ("sources/left/total/velocity", "sources/left/total/stress_rate", "domain/velocity"):
                steps = len(cut[name])
                self.assertLess(steps, len(whole[name]))
                np.testing.assert_array_equal(cut[name][:], whole[name][:steps])

    def test_by_default_the_run_stops_and_says_why(self):
        with recorded_box() as work:
            live = work.run("live")
            size = (live / "exchange.h5").stat().st_size
            self.assertLess((live / "run.h5").stat().st_size, size // 2, "the limit must hit the recording alone")
            code, output = self.limited(work, size // 2)
            self.assertEqual(1, code, output)
            self.assertRegex(output, r"the exchange cannot be recorded any more: .*exchange\.h5: .*File too large.*on_full_disk = \"stop\"")
            self.assertRegex(status(work.path / "run"), r"^aborted at step \d+: .*File too large")
            self.check_what_is_held(work, live)

    def test_where_the_case_says_so_the_run_goes_on_without_the_recording(self):
        with recorded_box(on_full_disk="go_on") as work:
            live = work.run("live")
            code, output = self.limited(work, (live / "exchange.h5").stat().st_size // 2)
            self.assertEqual(0, code, output)
            self.assertRegex(output, r"warning: the exchange is not recorded any more: .*File too large.*; the run goes on")
            self.assertRegex(status(work.path / "run"), r"^aborted at step \d+: .*File too large")
            self.check_what_is_held(work, live)
            self.assertEqual([], differences(work.path / "run", live))
            refused = work.command("run", work.case, "--replay", work.path / "run", "--out", work.path / "no")
            self.assertRegex(refused.stderr, "the recording is not complete: aborted at step .*File too large")

    @unittest.skipUnless(os.geteuid() == 0, "mounting a small file system needs root")
    def test_a_small_file_system_that_fills_up(self):
        with recorded_box(**LONG) as work:
            disk = work.path / "run"
            disk.mkdir()
            mounted = subprocess.run(["mount", "-t", "tmpfs", "-o", "size=3m", "tmpfs", disk], capture_output=True, text=True)
            if mounted.returncode != 0:
                self.skipTest(f"cannot mount a tmpfs here: {mounted.stderr.strip()}")
            try:
                run = start(work)
                output, _ = run.communicate(timeout=120)
                self.assertEqual(1, run.returncode, output)
                self.assertIn("No space left on device", output)
                self.assertRegex(status(disk), rf"^aborted at step {domain_steps(disk)}: .*No space left on device")
                with h5py.File(disk / "exchange.h5") as file:
                    self.assertGreater(len(file["sources/left/total/velocity"]), 100)
            finally:
                subprocess.run(["umount", disk], check=True)


class Damaged(unittest.TestCase):
    def test_damaged_values_are_refused_wherever_they_stand(self):
        """Bytes of the chunks that hold values are overwritten, at places of a printed seed."""
        seed = 20261121
        generator = random.Random(seed)
        with recorded_box(duration=0.3) as work:
            live = work.run("live")
            recording = (live / "exchange.h5").read_bytes()
            chunks = []
            with h5py.File(live / "exchange.h5") as file:
                for name in ("velocity", "stress", "velocity_rate", "stress_rate"):
                    dataset = file["sources/left/total"][name].id
                    found = [dataset.get_chunk_info(i) for i in range(dataset.get_num_chunks())]
                    chunks += [(chunk.byte_offset, chunk.size) for chunk in found]
            damaged = work.path / "exchange.h5"
            for trial in range(20):
                content = bytearray(recording)
                offset, size = generator.choice(chunks)
                at = offset + generator.randrange(size)
                content[at] ^= 1 << generator.randrange(8)
                damaged.write_bytes(content)
                result = work.command("export", f"{damaged}:left", "out.csv")
                self.assertEqual(1, result.returncode, f"seed {seed}, trial {trial}: byte {at}")
                self.assertRegex(result.stderr, r"^tremolo: .*exchange\.h5: cannot read step \d+: ")

    def test_a_recording_that_was_cut_off_is_refused(self):
        with recorded_box(duration=0.3) as work:
            recording = (work.run("live") / "exchange.h5").read_bytes()
            for length in (0, 100, 5000, len(recording) // 2, len(recording) - 1):
                (work.path / "exchange.h5").write_bytes(recording[:length])
                result = work.command("export", f"{work.path / 'exchange.h5'}:left", "out.csv")
                self.assertEqual(1, result.returncode, length)
                self.assertIn("exchange.h5: cannot open the recording", result.stderr)


if __name__ == "__main__":
    unittest.main()
