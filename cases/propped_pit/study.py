#!/usr/bin/env python3
"""What the strut bears, what the walls bend, and how far walls and building go, in variants of the pit: a Markdown table.

    cases/propped_pit/study.py [TREMOLO [FOLDER]]      default: build/release/bin/tremolo, runs/propped_pit

Runs what is not in FOLDER yet.
"""

import sys
from pathlib import Path

import numpy as np

CASE = Path(__file__).resolve().parent / "case.toml"
sys.path.insert(0, str(CASE.parents[2] / "python"))

from tremolo import Run
from tremolo.variants import cpu_time, run_variant

TEXT = CASE.read_text()
PROP = TEXT[TEXT.index("[[prop]]"):TEXT.index("[[section]]")]
STAGE = TEXT[TEXT.index('[[stage]]\nkind = "construction"\nname = "strut"'):TEXT.index('[[stage]]\nkind = "construction"\nname = "dig to 6 m"')]
BUILDING = TEXT[TEXT.index('[[structure]]\nname = "building"'):TEXT.index("[[prop]]")]
SIDES = 'left = { model = "mpm" }\nright = { model = "mpm" }\nbase = { model = "mpm", form = "blended" }\n'
ELEMENTS = {SIDES: SIDES.replace('"mpm"', '"fe"')}  # `mpm` knows vertical incidence only
# Two cells thick, as the walls.
SLAB = """[[structure]]
name = "base slab"
polygon = [[-5.0, -6.0], [5.0, -6.0], [5.0, -5.0], [-5.0, -5.0]]
density = 2400.0
young = 6.5e9
poisson = 0.2
friction = 0.5

[[section]]
name = "slab"
structure = "base slab"
from = [0.0, -6.0]
to = [0.0, -5.0]

"""
SLAB_STAGE = """[[stage]]
kind = "construction"
name = "base slab"
place = ["base slab"]

"""
WITH_SLAB = {"[[prop]]\n": SLAB + "[[prop]]\n", '[[stage]]\nkind = "shaking"\n': SLAB_STAGE + '[[stage]]\nkind = "shaking"\n'}
# Folder: label, changes.
VARIANTS = {
    "main": ("as it is", {}),
    "slack": ("strut without prestress", {"prestress = -50e3                # N/m\n": ""}),
    "stiff": ("prestress of 150 kN/m", {"prestress = -50e3 ": "prestress = -150e3 "}),
    "weak": ("strut that yields at 120 kN/m", {"yield = 800e3\n": "yield = 120e3\n"}),
    "cantilever": ("no strut", {PROP: "", STAGE: ""}),
    "alone": ("no building", {BUILDING: ""}),
    "slab": ("base slab of 1 m", WITH_SLAB),
    "fe": ("free field `fe`", ELEMENTS),
    "oblique": ("free field `fe`, 15 degrees", ELEMENTS | {"angle_deg = 0.0\n": "angle_deg = 15.0\n"}),
}


def stage(run, name):
    """The run of a static stage."""
    return Run(next(folder for folder in (run.path.parent / "stages").iterdir() if folder.name.split(" ", 1)[1] == name))


def row(run, label):
    """A row of the table: compression of the strut, moments that stretch the side of the pit as negative."""
    cells = [label]
    if run.props:
        dug = stage(run, "dig to 6 m").prop("strut").force[-1]
        force = run.prop("strut").force
        cells += [f"{-value / 1e3:.0f}" for value in (dug, -np.abs(force).max(), force[-1])]
    else:
        cells += ["–"] * 3
    for name in ("west", "east"):
        moment = run.section(name)["m"] / 1e3
        cells += [f"{moment[0]:.0f}", f"{moment[np.argmax(np.abs(moment))]:.0f}"]
    if "building" in run.bodies:
        body = run.body("building")
        cells += [f"{1e3 * (body['y'][0] - body['y'][-1]):.1f}", f"{np.degrees(body['tilt'][-1]):.3f}"]
    else:
        cells += ["–"] * 2
    return cells + [f"{cpu_time(run) / 60.0:.0f}"]


def main(tremolo="build/release/bin/tremolo", folder="runs/propped_pit"):
    Path(folder).mkdir(parents=True, exist_ok=True)
    headings = ["variant", "strut when dug, kN/m", "largest", "at the end", "M west when dug, kNm/m", "largest", "M east when dug", "largest",
                "building settles, mm", "tilts, degrees", "CPU time, min"]
    print(f"| {' | '.join(headings)} |\n|{' --- |' * len(headings)}")
    for name, (label, changes) in VARIANTS.items():
        with run_variant(tremolo, CASE, changes, folder, name) as run:
            print(f"| {' | '.join(row(run, label))} |", flush=True)


if __name__ == "__main__":
    main(*sys.argv[1:])
