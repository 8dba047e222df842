"""A dry elastic step pays for nothing that the scene does not ask for: callgrind counts its instructions a particle
against those of the plain loop of tests/cost/mpm_domain, which knows nothing but dry elastic soil.

    test_instructions.py STEPS

The domain takes 336.4 instructions and the plain loop 674.0 with GCC 12, -O3 and -march=x86-64-v3. At commit 40863b7 it took
324.0, and 323.9 with every other effect compiled out: what came since is the same step by as many ranks as there are, whose
totals are exact, the work of the boundary among them, and whose faces are looked up in one list.
"""

import sys

from callgrind import Counted, require_valgrind

LARGEST_RATIO = 0.5
STEPS = {"domain": "tremolo::mpm_domain::Stepper::step()", "plain": "tremolo::cost::PlainStep::step(double)"}


def main():
    require_valgrind()
    counts = [Counted(sys.argv[1], model, step) for model, step in STEPS.items()]
    domain, plain = (count.instructions / count.updates for count in counts)
    print(f"instructions a particle and step: domain {domain:.1f}, plain loop {plain:.1f}, ratio {domain / plain:.4f}")
    assert domain <= LARGEST_RATIO * plain, f"the ratio is {domain / plain:.4f}; allowed: {LARGEST_RATIO}"


main()
