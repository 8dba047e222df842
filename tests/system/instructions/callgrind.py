"""Counts of instructions by callgrind."""

import re
import shutil
import subprocess
import sys
import tempfile

SKIPPED = 77


def require_valgrind():
    if shutil.which("valgrind") is None:
        print("valgrind is not installed: skipped")
        sys.exit(SKIPPED)


class Counted:
    """What functions take while a program runs a model; the program prints how many updates of a particle it made.

    None of them may call another one: that would end the count.
    """

    def __init__(self, program, model, *functions):
        self._folder = tempfile.TemporaryDirectory()
        self._counts = f"{self._folder.name}/out"
        run = subprocess.run(
            ["valgrind", "--tool=callgrind", f"--callgrind-out-file={self._counts}", *(f"--toggle-collect={function}" for function in functions),
             program, model],
            capture_output=True, text=True)
        if "unrecognised instruction" in run.stderr:
            print("valgrind does not know this processor's instructions: skipped")
            sys.exit(SKIPPED)
        assert run.returncode == 0, run.stderr
        self.instructions = int(re.search(r"Collected : (\d+)", run.stderr)[1])
        assert self.instructions > 0, f"callgrind has found no {' or '.join(functions)}"
        self.updates = int(run.stdout)

    def share_within(self, function):
        """Of the instructions, those within a function that the first one calls."""
        table = subprocess.run(["callgrind_annotate", "--inclusive=yes", "--threshold=100", self._counts],
                               capture_output=True, text=True, check=True).stdout
        line = next(line for line in table.splitlines() if function in line)
        return int(line.split("(")[0].replace(",", "")) / self.instructions
