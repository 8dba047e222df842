"""What reduced dispersion takes over the scheme without it: callgrind counts the instructions of a step of an elastic
square of 144 x 144 cells with APIC and `musl`. The bound is the ratio that was measured with GCC 12, -O3 and
-march=x86-64-v3, 1.259, of which 0.035 are the faces (boundary/closing/closing_elements.hpp).

    test_dispersion.py STEPS
"""

import sys

from callgrind import Counted, require_valgrind

LARGEST_RATIO = 1.263
STEP = "tremolo::mpm_domain::Stepper::step()"


def main():
    require_valgrind()
    counts = [Counted(sys.argv[1], f"dispersion:{which}", STEP) for which in ("plain", "reduced")]
    plain, reduced = (count.instructions / count.updates for count in counts)
    print(f"instructions a particle and step: plain {plain:.1f}, reduced {reduced:.1f}, ratio {reduced / plain:.4f}")
    assert reduced <= LARGEST_RATIO * plain, f"the ratio is {reduced / plain:.4f}; allowed: {LARGEST_RATIO}"


main()
