"""Contact costs what its nodes do: callgrind counts the instructions of contact in the steps of a block on flat ground, for
blocks and grounds of several widths. They grow by as much for each contact node, and not with the ground.

    test_contact.py STEPS [BLOCKS]

BLOCKS are so many of the blocks, the narrow ones first, that are counted on the large ground as well: all, unless said otherwise.
"""

import sys

from callgrind import Counted, require_valgrind

CALLS = ("meet(", "meet_remapped", "move", "follow_sort", "fastest_point")
CONTACT = [f"tremolo::mpm_domain::Contact::{name}*" for name in CALLS]
BLOCKS = (8, 16, 32)  # cells across
GROUND, LARGE_GROUND = 60, 120  # cells; the second has four times the particles


def main():
    require_valgrind()
    taken, met = [], []
    count = lambda block, ground: Counted(sys.argv[1], f"block:{block}:{ground}", *CONTACT)
    on_large_ground = BLOCKS[: int(sys.argv[2])] if len(sys.argv) > 2 else BLOCKS
    for block in BLOCKS:
        contact = count(block, GROUND)
        print(f"block of {block} cells, {contact.updates} contact nodes met: {contact.instructions} instructions")
        taken.append(contact.instructions)
        met.append(contact.updates)
        if block in on_large_ground:
            large = count(block, LARGE_GROUND)
            print(f"on the large ground: {large.instructions} instructions")
            assert large.updates == contact.updates
            assert large.instructions <= 1.01 * contact.instructions
    each = [(b - a) / (m - n) for a, b, n, m in zip(taken, taken[1:], met, met[1:])]
    print(f"instructions for one more node: {each[0]:.0f} and {each[1]:.0f}")
    assert abs(each[1] / each[0] - 1.0) < 0.05


main()
