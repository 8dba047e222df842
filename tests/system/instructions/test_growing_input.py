"""Reading does not look at all pairs: callgrind counts the instructions that four times the input takes. They are four
times as many where work grows in proportion, and sixteen times as many where each is held against each other. Boxes of
a stack do meet in pairs; whether two polygons overlap, which takes far longer, is asked once for each polygon.

    test_growing_input.py GROWING_INPUT
"""

import sys

from callgrind import Counted, require_valgrind

WORKS = {"strip": ("tremolo::scene::intersects_itself*", 4000),
         "stack": ("tremolo::scene::overlap(*", 250),
         "tables": ("tremolo::scene::parse(*", 1000)}


def main():
    require_valgrind()
    for work, (function, size) in WORKS.items():
        small, large = (Counted(sys.argv[1], f"{work}:{count}", function).instructions for count in (size, 4 * size))
        print(f"{work} of {size} and {4 * size}: {small} and {large} instructions, {large / small:.2f} times as many")
        assert large <= 4.6 * small


main()
