#!/usr/bin/python3
"""Makes the numbers and pictures of docs/materials/gallery.md: soil tests over reference curves and closed forms.

    tests/cost/materials/gallery.py build/release/bin/tremolo [--reference DIR] [--only SECTION ...]

Writes the test files of docs/materials/tests, the pictures of docs/materials/pictures/gallery_*.png, and what stands
between the markers `<!-- SECTION -->` and `<!-- /SECTION -->` of the page. The reference curves are those of
TREMOLO_REFERENCE; without them it says so and stops.
"""

import argparse
import os
import sys
import tempfile
from pathlib import Path

from gallery_runs import PAGES, ROOT, Gallery, write_between  # first: it finds the package for the others

from gallery_closed_laws import drucker_prager, hyperbolic, linear_elastic, mohr_coulomb, multi_yield_clay
from gallery_cost import cost
from gallery_sands import calibration, cyclic, loops, monotonic, replays, strength

SANDS = {
    f"{law}-{part.__name__}": (lambda gallery, part=part, law=law: part(gallery, law))
    for law in ("pm4sand", "pdmy03")
    for part in (cyclic, replays, loops, monotonic, strength)
}
OTHERS = (calibration, mohr_coulomb, drucker_prager, multi_yield_clay, hyperbolic, linear_elastic, cost)
SECTIONS = SANDS | {part.__name__: part for part in OTHERS}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("tremolo", type=Path, help="the program")
    default = os.environ.get("TREMOLO_REFERENCE", ROOT / "../shared/reference")
    parser.add_argument("--reference", type=Path, default=Path(default), help="folder of the reference data")
    parser.add_argument(
        "--only", nargs="+", choices=SECTIONS, default=list(SECTIONS), metavar="SECTION", help="these alone"
    )
    arguments = parser.parse_args()
    reference = arguments.reference / "materials"
    if not (reference / "manifest.json").exists():
        sys.exit(f"gallery: {reference}: no reference curves here; set TREMOLO_REFERENCE or --reference")
    (PAGES / "pictures").mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as folder:
        gallery = Gallery(arguments.tremolo.resolve(), reference, Path(folder))
        for section in arguments.only:
            print(section, flush=True)
            write_between(PAGES / "gallery.md", section, SECTIONS[section](gallery))


if __name__ == "__main__":
    main()
