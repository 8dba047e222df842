"""What a scene does not ask for costs nothing: instructions of a dry elastic step, counted by callgrind, against a build that
has every other effect compiled out.

    test_instructions.py USUAL_STEPS DRY_ELASTIC_STEPS
"""

import re
import shutil
import subprocess
import sys
import tempfile

SKIPPED = 77
ALLOWED = 0.01
STEP = "tremolo::mpm_domain::Stepper::step()"


def instructions(program):
    """Of one update of one particle."""
    with tempfile.TemporaryDirectory() as folder:
        run = subprocess.run(
            ["valgrind", "--tool=callgrind", f"--callgrind-out-file={folder}/out", f"--toggle-collect={STEP}", program],
            capture_output=True, text=True)
    if "unrecognised instruction" in run.stderr:
        print("valgrind does not know this processor's instructions: skipped")
        sys.exit(SKIPPED)
    assert run.returncode == 0, run.stderr
    count = int(re.search(r"Collected : (\d+)", run.stderr)[1])
    assert count > 0, f"callgrind has found no {STEP}"
    return count / int(run.stdout)


def main():
    if shutil.which("valgrind") is None:
        print("valgrind is not installed: skipped")
        sys.exit(SKIPPED)
    usual, bare = (instructions(program) for program in sys.argv[1:3])
    print(f"instructions a particle and step: {usual:.1f}, with every other effect compiled out {bare:.1f}")
    assert usual <= (1.0 + ALLOWED) * bare, f"{100 * (usual / bare - 1):.2f} % more; allowed: {100 * ALLOWED:.0f} %"


main()
