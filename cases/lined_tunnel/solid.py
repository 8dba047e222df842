#!/usr/bin/env python3
"""A lining of 0.6 m as a beam and as an elastic structure of particles: what both cost for their errors, a Markdown table.

    cases/lined_tunnel/solid.py [TREMOLO [FOLDER]]      default: build/release/bin/tremolo, runs/lined_tunnel

Runs what is not in FOLDER yet.
"""

import sys
from pathlib import Path

import numpy as np
from study import ALONE, BONDED, CASE, CENTRE, LINING, OUTER, exact, ovaling, run_variant, shear_strain
from tremolo.variants import cpu_time

THICKNESS, YOUNG, NU = 0.6, 30e9, 0.2
PLANE = YOUNG / (1.0 - NU**2)
SECTION = PLANE * THICKNESS, PLANE * THICKNESS**3 / 12.0
SOLID = f"""[[structure]]
name = "ring"
circle = {{ centre = [0.0, -15.0], radius = {OUTER} }}
hole_circle = {{ centre = [0.0, -15.0], radius = {OUTER - THICKNESS} }}
density = 2500.0
young = {YOUNG:g}
poisson = {NU}
friction = 0.6
adhesion = 1e7

[[section]]
name = "around"
structure = "ring"
ring = {{ centre = [0.0, -15.0], inner = {OUTER - THICKNESS - 0.05:g}, outer = {OUTER + 0.05:g}, count = 48 }}

"""
BEAM = BONDED | {"thickness = 0.3 ": f"thickness = {THICKNESS} "}
# Folder: label, changes, cells through the wall.
VARIANTS = {
    "beam": ("beam, cells of 0.5 m", BEAM, "–"),
    "solid": ("particles, cells of 0.25 m", {LINING: SOLID, "level = 1\n": "level = 2\n"}, f"{THICKNESS / 0.25:.1f}"),
}


def around(section, force):
    """As ovaling(), of a ring of cuts."""
    values = getattr(section, force)
    return np.abs(2.0 * ((values - values[0]) @ np.exp(2j * np.radians(section.angles))) / len(section.angles))


def main():
    tremolo = sys.argv[1] if len(sys.argv) > 1 else "build/release/bin/tremolo"
    folder = Path(sys.argv[2] if len(sys.argv) > 2 else "runs/lined_tunnel")
    folder.mkdir(parents=True, exist_ok=True)
    strain = shear_strain(run_variant(tremolo, CASE, ALONE, folder, "free"))[1].max()
    thrust, moment = exact(SECTION, OUTER - 0.5 * THICKNESS, THICKNESS, True)
    print("| ring | cells through the wall | M, kNm/m | over that of the beam's closed form | N, kN/m | likewise | steps | CPU time, min |")
    print("| --- | --- | --- | --- | --- | --- | --- | --- |")
    for key, (label, changes, cells) in VARIANTS.items():
        run = run_variant(tremolo, CASE, changes, folder, key)
        found = {force: float((ovaling(run.lining("ring"), force) if key == "beam" else around(run.section("around"), force)).max())
                 for force in ("moment", "axial_force")}
        print(f"| {label} | {cells} | {found['moment'] / 1e3:.1f} | {found['moment'] / (strain * moment):.3f} "
              f"| {found['axial_force'] / 1e3:.1f} | {found['axial_force'] / (strain * thrust):.3f} | {run.plan['steps']} | {cpu_time(run) / 60.0:.1f} |",
              flush=True)


if __name__ == "__main__":
    main()
