"""A domain that ranks share: `tremolo run --ranks N` gives the bits of one process, a rank that dies ends the run
with its name, and others go on from its checkpoint.

    usage: test_ranks.py TREMOLO SOURCE_DIR mpi|alone
"""

import os
import signal
import subprocess
import sys
import time
import unittest
from pathlib import Path

TREMOLO, SOURCE, BUILD = sys.argv.pop(1), Path(sys.argv.pop(1)), sys.argv.pop(1)
sys.path[:0] = [str(SOURCE / "python"), *(str(Path(__file__).parents[1] / folder) for folder in ("resume", "stages", "structures", "sweep"))]

from berm_case import BermWorkspace, stage
from broken_run import BoxWorkspace, SlopeWorkspace, checkpoints, differences, with_checkpoints
from processes import alive, children, ranks_below
from rest_case import rest
from small_case import SLOPE_BOXES, refine, subcycled
from small_sweep import SweepWorkspace
from structure_cases import AnchoredWorkspace


def ranks_of(launcher):
    """Process ids by rank."""
    return {rank: process for child in children(launcher) for rank, process in ranks_below(child).items()}


@unittest.skipUnless(BUILD == "mpi", "this build has no MPI")
class Ranks(unittest.TestCase):
    """The small slope: gravity, softening, two wave fields, incident base."""

    @classmethod
    def setUpClass(cls):
        work = SlopeWorkspace(TREMOLO, duration=1.2)
        cls.work = cls.enterClassContext(with_checkpoints(work, every_steps=40))
        cls.whole = cls.work.run("whole", "--threads", 1)

    def killed(self, name, rank):
        """The folder of a run of two ranks of which one was killed after the first checkpoint, and its output."""
        folder = self.work.path / name
        command = [TREMOLO, "run", str(self.work.case), "--out", str(folder), "--ranks", "2", "--oversubscribe", "--threads", "1"]
        with subprocess.Popen(command, cwd=self.work.path, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True) as run:
            while run.poll() is None and not checkpoints(folder):
                time.sleep(0.005)
            ranks = ranks_of(run.pid)
            self.assertEqual([0, 1], sorted(ranks), "the run was over before")
            os.kill(ranks[rank], signal.SIGKILL)
            began = time.monotonic()
            output = run.communicate(timeout=60)[0]
            self.assertLess(time.monotonic() - began, 10.0, "longer than the coupler promises")
        self.assertEqual(1, run.returncode, output)
        deadline = time.monotonic() + 5.0
        while any(map(alive, ranks.values())) and time.monotonic() < deadline:
            time.sleep(0.01)
        self.assertEqual([], [process for process in ranks.values() if alive(process)])
        return folder, output

    def give_the_bits_of_one(self, *options):
        name = "_".join(map(str, options)).replace("-", "")
        self.assertEqual([], differences(self.work.run(name, *options, "--oversubscribe", "--threads", 1), self.whole))

    def end_with_its_name(self, rank):
        folder, output = self.killed(f"killed_{rank}", rank)
        self.assertIn("'domain' exited with code 137 before the run was over", output)
        self.assertIn(f"rank {rank} ", output)
        self.assertIn("tremolo resume", output)
        return folder

    def resume_with(self, folder, count):
        result = self.work.command("resume", folder, "--ranks", count, "--oversubscribe", "--threads", 1)
        self.assertEqual(0, result.returncode, result.stdout + result.stderr)
        self.assertEqual([], differences(folder, self.whole))

    def test_two_give_the_bits_of_one(self):
        self.give_the_bits_of_one("--ranks", 2)

    def test_acceptance_three_and_two_in_lockstep_give_the_bits_of_one(self):
        self.give_the_bits_of_one("--ranks", 3)
        self.give_the_bits_of_one("--ranks", 2, "--mode", "lockstep")

    def test_a_rank_that_dies_ends_the_run_with_its_name_and_three_go_on(self):
        self.resume_with(self.end_with_its_name(1), 3)

    def test_acceptance_the_first_rank_dies_and_one_process_goes_on(self):
        self.resume_with(self.end_with_its_name(0), 1)


class WideAnchored(AnchoredWorkspace):
    """Half of the tiles touch the anchored block."""

    template = AnchoredWorkspace.template.replace("8.0", "24.0")


def sharpened(work):
    """Reduces the dispersion of a case."""
    work.case.write_text(work.case.read_text().replace("[mesh]\n", '[mesh]\ndispersion = "reduced"\n'))
    return work


@unittest.skipUnless(BUILD == "mpi", "this build has no MPI")
class Joined(unittest.TestCase):
    """What the first rank alone works out, such as a block with an anchor, and what all ranks work out as a whole."""

    def give_the_bits_of_one(self, work):
        with with_checkpoints(work, every_steps=100) as work:
            whole = work.run("whole", "--threads", 1)
            shared = work.run("shared", "--threads", 1, "--ranks", 2, "--oversubscribe")
            self.assertEqual([], differences(shared, whole))

    def test_structure_and_anchor(self):
        self.give_the_bits_of_one(WideAnchored(TREMOLO, duration=0.4))

    def test_acceptance_levels(self):
        self.give_the_bits_of_one(refine(SlopeWorkspace(TREMOLO, duration=0.5), *SLOPE_BOXES))

    def test_acceptance_levels_with_steps_of_their_own(self):
        self.give_the_bits_of_one(subcycled(refine(SlopeWorkspace(TREMOLO, duration=0.5), *SLOPE_BOXES)))

    def test_acceptance_reduced_dispersion(self):
        self.give_the_bits_of_one(sharpened(BoxWorkspace(TREMOLO, duration=0.5)))

    def test_acceptance_a_berm_that_comes_and_goes(self):
        berm = stage("construction", "berm", 'place = ["berm"]', 0.2)
        dug = stage("construction", "dug", 'remove = ["berm"]', 0.2)
        self.give_the_bits_of_one(BermWorkspace(TREMOLO, rest(0.2) + berm + rest(0.2, name='"between"') + dug, shaking=0.5))


@unittest.skipUnless(BUILD == "mpi", "this build has no MPI")
class OfASweep(unittest.TestCase):
    """A sweep gives the ranks to each of its runs."""

    STUDY = 'case = "case.toml"\n[axes]\nsoil.box.young = [40e6, 80e6]\n'

    @unittest.skipIf(os.cpu_count() < 2, "one processor")
    def test_they_give_the_table_of_one_process(self):
        tables = []
        for options in ([], ["--ranks", 2]):
            with SweepWorkspace(TREMOLO, self.STUDY) as work:
                work.swept(*options)
                measures = [name for name in work.rows()[0] if name.startswith("surface.")]
                tables.append([[row[name] for name in measures] for row in work.rows()])
                self.assertEqual(bool(options), "as 2 ranks" in (work.out / "log/0001.txt").read_text())
        self.assertEqual(*tables)


class Refused(unittest.TestCase):
    def refused(self, work, *options):
        result = work.command("run", work.case, "--out", "refused", *options)
        self.assertEqual(1, result.returncode, result.stdout + result.stderr)
        self.assertFalse((work.path / "refused").exists())
        return result.stderr

    @unittest.skipUnless(BUILD == "alone", "this build has MPI")
    def test_without_mpi(self):
        with SlopeWorkspace(TREMOLO) as work:
            self.assertIn("--ranks 2: this build has no MPI: configure it with -DTREMOLO_MPI=ON", self.refused(work, "--ranks", 2))

    @unittest.skipUnless(BUILD == "mpi", "this build has no MPI")
    def test_more_ranks_than_processors(self):
        with SlopeWorkspace(TREMOLO) as work:
            self.assertIn("--oversubscribe starts them all the same", self.refused(work, "--ranks", 4096))


if __name__ == "__main__":
    unittest.main()
