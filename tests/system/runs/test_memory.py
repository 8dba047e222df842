"""The memory of a process is bounded: four times the levels, or four times the motion, of a source and twelve times the history of a
domain leave the peak of its resident memory (VmHWM) where it was.

    usage: test_memory.py TREMOLO PYTHON_PACKAGE_DIR
"""

import re
import subprocess
import sys
import time
import unittest
from pathlib import Path

TREMOLO, PACKAGE = sys.argv.pop(1), sys.argv.pop(1)
sys.path[:0] = [str(Path(__file__).parent)]

import processes
from small_case import CASE, Workspace

MEBIBYTE = 1024  # KiB


class DeepWorkspace(Workspace):
    """The small box with cells of 5 m, as deep as wanted, under waves of 1 Hz."""

    template = CASE.replace("-10.0", "-{depth}.0").replace("frequency = 3.0", "frequency = 1.0").replace("[halfspace]", "{ground}")
    defaults = {**Workspace.defaults, "size": 5.0, "depth": 10, "ground": "[halfspace]"}


def peaks(**settings):
    """The largest resident memory of each process of a run, KiB."""
    most = {}
    with DeepWorkspace(TREMOLO, every=settings["duration"], **settings) as work:
        run = subprocess.Popen([TREMOLO, "run", work.case, "--out", work.path / "run"], stdout=subprocess.DEVNULL, stderr=subprocess.STDOUT)
        while run.poll() is None:
            for process in processes.children(run.pid):
                status = processes.status(process)
                if peak := re.search(r"VmHWM:\s*(\d+) kB", status):
                    name = re.search(r"Name:\s*(\S+)", status)[1]
                    most[name] = max(most.get(name, 0), int(peak[1]))
            time.sleep(0.005)
        assert run.returncode == 0, (settings, run.returncode)
    return most


class Memory(unittest.TestCase):
    def test_of_a_domain_does_not_go_with_its_history(self):
        # 110 s more make 22,000 rows more, which are 1.3 kB each.
        short, long = (peaks(duration=duration)["tremolo-domain"] for duration in (10.0, 120.0))
        self.assertLess(long - short, 8 * MEBIBYTE, f"{short} KiB in 10 s, {long} KiB in 120 s")


class AcceptanceMemory(unittest.TestCase):
    def test_of_a_source_does_not_go_with_its_levels(self):
        # 100 s in steps of 0.01 s: a level takes 0.8 MB, so that 32 levels more than fill what is computed at a time.
        shallow, deep = (peaks(duration=100.0, depth=depth)["tremolo-wave"] for depth in (80, 320))
        self.assertLess(deep - shallow, 16 * MEBIBYTE, f"{shallow} KiB at 80 m, {deep} KiB at 320 m")

    def test_of_a_source_does_not_go_with_the_motion(self):
        # 2400 s more make 380,000 steps more, of which a level takes 31 MB, and a Fourier window of one of them 16 MB or more.
        short, long = (peaks(duration=duration, depth=80)["tremolo-wave"] for duration in (800.0, 3200.0))
        self.assertLess(long - short, 16 * MEBIBYTE, f"{short} KiB in 800 s, {long} KiB in 3200 s")

    def test_of_a_source_in_constant_damping_hardly_goes_with_the_motion(self):
        # Its tails ask for windows of 16 times the time: 100 MB for each 800 s. Only the slow part of the motion is computed so.
        damping = '[damping]\nmodel = "hysteretic"\n\n[halfspace]\ndamping = 0.02'
        short, long = (peaks(duration=duration, depth=80, ground=damping)["tremolo-wave"] for duration in (800.0, 3200.0))
        self.assertLess(long - short, 32 * MEBIBYTE, f"{short} KiB in 800 s, {long} KiB in 3200 s")


if __name__ == "__main__":
    unittest.main()
