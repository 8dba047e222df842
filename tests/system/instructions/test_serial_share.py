"""Nearly all of a step is shared out among threads: callgrind counts the instructions of steps of the slope, with one
thread, and how many of them lie within loops that are shared out. All passes together leave less to one thread than
any one of them may.

    test_serial_share.py STEPS MODEL...
"""

import sys

from callgrind import Counted, require_valgrind

LARGEST_SHARE = 0.02
STEP = "tremolo::mpm_domain::Stepper::step()"
SHARED_OUT = "tremolo::mpm_domain::WorkerPool::take_tasks()"


def main():
    require_valgrind()
    for model in sys.argv[2:]:
        serial = 1.0 - Counted(sys.argv[1], model, STEP).share_within(SHARED_OUT)
        print(f"{model}: {100 * serial:.2f} % of a step's instructions are one thread's alone")
        assert 0.0 < serial <= LARGEST_SHARE, f"{model}: {serial:.4f}; allowed: {LARGEST_SHARE}"


main()
