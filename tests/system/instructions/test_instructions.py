"""A dry elastic step pays for nothing that the scene does not ask for: callgrind counts its instructions a particle
against those of the plain loop of tests/cost/mpm_domain, which knows nothing but dry elastic soil.

    test_instructions.py STEPS

The bound is the ratio at commit 40863b7 with GCC 12, -O3 and -march=x86-64-v3: the domain took 324.0 instructions and
the plain loop 674.0. A build of that domain with every other effect compiled out took 323.9.
"""

import re
import shutil
import subprocess
import sys
import tempfile

SKIPPED = 77
LARGEST_RATIO = 0.481
STEPS = {"domain": "tremolo::mpm_domain::Stepper::step()", "plain": "tremolo::cost::PlainStep::step(double)"}


def instructions(program, which):
    """Instructions of one update of one particle."""
    step = STEPS[which]
    with tempfile.TemporaryDirectory() as folder:
        run = subprocess.run(
            ["valgrind", "--tool=callgrind", f"--callgrind-out-file={folder}/out", f"--toggle-collect={step}", program, which],
            capture_output=True, text=True)
    if "unrecognised instruction" in run.stderr:
        print("valgrind does not know this processor's instructions: skipped")
        sys.exit(SKIPPED)
    assert run.returncode == 0, run.stderr
    count = int(re.search(r"Collected : (\d+)", run.stderr)[1])
    assert count > 0, f"callgrind has found no {step}"
    return count / int(run.stdout)


def main():
    if shutil.which("valgrind") is None:
        print("valgrind is not installed: skipped")
        sys.exit(SKIPPED)
    domain, plain = (instructions(sys.argv[1], which) for which in STEPS)
    print(f"instructions a particle and step: domain {domain:.1f}, plain loop {plain:.1f}, ratio {domain / plain:.4f}")
    assert domain <= LARGEST_RATIO * plain, f"the ratio is {domain / plain:.4f}; allowed: {LARGEST_RATIO}"


main()
