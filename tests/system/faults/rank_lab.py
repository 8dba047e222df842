"""Runs of several ranks under attack: finds mpirun and its ranks, and looks that they leave nothing behind."""

import os
import signal
import subprocess
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "runs"))
from fault_lab import Attack, require, results
from processes import alive, ranks_below, variable

DURATION = 0.5  # s: some 270 steps
CHECKPOINTS = '\n[checkpoint]\nevery_steps = 40\n'
# A rigid block and an elastic wall on the crest of a wider slope, with a prop between them: the first rank has them.
STRUCTURES = """
[[structure]]
name = "block"
polygon = [[58.0, 7.0], [62.0, 7.0], [62.0, 10.0], [58.0, 10.0]]
density = 1500.0
rigid = true
friction = 0.5

[[structure]]
name = "wall"
polygon = [[65.0, 6.0], [67.0, 6.0], [67.0, 11.0], [65.0, 11.0]]
density = 1700.0
young = 40e6
poisson = 0.2
friction = 0.5

[[prop]]
name = "strut"
from = { structure = "block", at = [62.0, 9.5] }
to = { structure = "wall", at = [65.0, 9.5] }
stiffness = 1e6
"""


def with_structures(text):
    """The slope twice as wide, with structures."""
    return text.replace("[40.0, ", "[80.0, ").replace(", 40.0, 8.0]", ", 80.0, 8.0]") + STRUCTURES


class RankAttack(Attack):
    """A run of several ranks, one thread each; `rank 0`, `rank 1`, ... are participants, and `domain` is mpirun."""

    def __init__(self, tremolo, ranks, structures=False, **options):
        self.count = ranks
        self._shared_memory = None
        super().__init__(tremolo, more=CHECKPOINTS, options=of_ranks(ranks), change=with_structures if structures else None,
                         **{"duration": DURATION, **options})

    def participants(self):
        super().participants()
        if "domain" in self._seen:
            for rank, pid in ranks_below(self._seen["domain"]).items():
                self._seen[f"rank {rank}"] = pid
            folder = variable(self._seen["domain"], "TREMOLO_SHARED_MEMORY")
            self._shared_memory = Path(folder) if folder else self._shared_memory
        return {name: pid for name, pid in self._seen.items() if alive(pid)}

    def wait(self, limit, since=None):
        seconds = super().wait(limit, since)
        # A launcher that is killed leaves its folder to the next run.
        if self._shared_memory and self.process.returncode != -signal.SIGKILL:
            require(not self._shared_memory.exists(), f"{self._shared_memory} is left")
        return seconds

    def checkpoints(self):
        folder = self.out / "checkpoints"
        return sorted(one for one in folder.iterdir() if one.suffix != ".part") if folder.is_dir() else []

    def resume(self, tremolo, ranks, expected):
        """Goes on with another number of ranks, to the results of the undisturbed run."""
        done = subprocess.run([tremolo, "resume", str(self.out), *of_ranks(ranks)], capture_output=True, text=True, env=self._environment,
                              timeout=120.0)
        require(done.returncode == 0, f"cannot be resumed with {ranks} ranks:\n{done.stdout}{done.stderr}")
        state, found = results(self.out)
        differ = [name for name in expected if found.get(name) != expected[name]]
        require(state == "complete" and not differ, f"resumed with {ranks} ranks: {state}, other bits in {differ[:5]}")

    def stop(self, victim):
        os.kill(self.pid(victim), signal.SIGSTOP)

    def go_on(self, victim):
        os.kill(self.pid(victim), signal.SIGCONT)


def of_ranks(count):
    return ("--ranks", str(count), "--oversubscribe", "--threads", "1")


def has_mpi(tremolo, case):
    """Whether the build can start ranks."""
    said = subprocess.run([tremolo, "run", case, "--ranks", "4096"], capture_output=True, text=True).stderr
    return "has no MPI" not in said
