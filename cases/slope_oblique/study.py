#!/usr/bin/env python3
"""When the slope fails under the vertical and the oblique wave, and what that depends on: a Markdown table.

    cases/slope_oblique/study.py [TREMOLO [FOLDER [RECORD.AT2 ...]]]    default: build/release/bin/tremolo, runs/slope_oblique

Runs what is not in FOLDER yet, on one thread each. Records are further motions, on the coarse mesh; they are taken as the
incident wave, as the synthetic motions are.
"""

import subprocess
import sys
from pathlib import Path

CASE = Path(__file__).resolve().parent / "case.toml"
sys.path.insert(0, str(CASE.parents[2] / "python"))

from tremolo.failure import failure_time
from tremolo.variants import run_variant, variant

SEEDS = (265, 304)  # of motion.toml: two more that meet its targets
STRAINS = (0.05, 0.1, 0.2)
WHOLE = "box = [0.0, -20.0, 90.0, 10.0]\n"
LEFT = 'left = { model = "wave", surface = 0.0 }'
RIGHT = 'right = { model = "wave", surface = 10.0 }'
BASE = 'base = { model = "wave", form = "incident" }'


def layered(line):
    """A line of [boundary] with a matched layer."""
    return line.replace(" }", ', absorber = "matched_layer" }')


def without_springs(line):
    """A line of [boundary] with dashpots alone."""
    return line.replace(" }", ", spring = false }")


def yielding(line, thickness):
    """A line of [boundary] whose free field is a column of the slope's soil."""
    return line.replace("wave", "fe").replace(" }", f', profile = [{{ thickness = {thickness}, soil = "slope" }}] }}')


MESHES = {"fine": ("1, 0.5, 0.25 m", {}), "coarse": ("2, 1, 0.5 m", {"size = 1.0\n": "size = 2.0\n"})}
VOLUMES = {
    "cell": ("of a cell", {}),
    "particle": ("of a particle", {WHOLE: f'{WHOLE}dilatation = "particle"\n'}),
}
ALONE = {line: without_springs(line) for line in (LEFT, RIGHT, BASE)}
FORMS = {
    "springs": ("`incident`, springs", {}),
    "dashpots": ("`incident`, dashpots alone", ALONE),
    "blended": (
        "`blended`, layers",
        {LEFT: layered(LEFT), RIGHT: layered(RIGHT), BASE: layered(BASE.replace("incident", "blended"))},
    ),
    "yielding": ("`incident`, springs, sides that yield", {LEFT: yielding(LEFT, 20.0), RIGHT: yielding(RIGHT, 30.0)}),
}

DURATIONS = {"fine": 11.5}  # s: by then all of them have failed
OURS = ("motion.AT2", *(f"seed {seed}" for seed in SEEDS))
PARTS = (  # mesh, change of volume, forms, motions: all where none are named
    ("fine", "cell", tuple(FORMS), OURS),
    ("coarse", "cell", tuple(FORMS), None),
    ("coarse", "particle", ("springs", "dashpots"), OURS),
)


def motions(tremolo, folder, records):
    """File and duration (s) of each motion, by its name; the synthetic ones are written into the folder."""
    (folder / "motion.AT2").write_bytes(CASE.with_name("motion.AT2").read_bytes())
    found = {"motion.AT2": ("motion.AT2", 16.0)}
    for seed in SEEDS:
        file = f"seed_{seed}.AT2"
        if not (folder / file).exists():
            recipe = folder / f"seed_{seed}.toml"
            recipe.write_text(variant(CASE.with_name("motion.toml"), {"seed = 249\n": f"seed = {seed}\n"}))
            subprocess.run([tremolo, "motion", "--synthesise", recipe, "--out", folder / file], check=True, stdout=subprocess.DEVNULL)
        found[f"seed {seed}"] = (file, 16.0)
    for record in records:
        found[record.stem] = (str(record.resolve()), 20.0)
    return found


def in_words(times):
    """Times of failure by growing strain, s: that at 0.1, and in brackets those at 0.05 and 0.2."""
    less, at, more = ("stands" if time is None else f"{time:.1f}" for time in times)
    return f"{at} ({less}, {more})"


def earlier(vertical, oblique, angle):
    """Which of two times of failure is the earlier one."""
    vertical, oblique = (1e9 if time is None else time for time in (vertical, oblique))
    return "neither" if abs(vertical - oblique) < 0.05 else "0°" if vertical < oblique else f"{angle}°"


def print_row(tremolo, folder, source, motion, form, mesh, volume, angles):
    """A line of the table, from one run for each angle."""
    file, duration = source
    failures = []
    for angle in angles:
        changes = {
            'file = "motion.AT2"': f'file = "{file}"',
            "duration_s = 16.0": f"duration_s = {DURATIONS.get(mesh, duration)}",
            "angle_deg = 15.0": f"angle_deg = {angle}.0",
            **MESHES[mesh][1], **VOLUMES[volume][1], **FORMS[form][1],
        }
        with run_variant(tremolo, CASE, changes, folder, f"{Path(file).stem}_{form}_{mesh}_{volume}_{angle}") as run:
            failures.append([failure_time(run, strain) for strain in STRAINS])
    cells = [in_words(failures[0])]
    for angle, times in zip(angles[1:], failures[1:]):
        cells += [in_words(times), earlier(failures[0][1], times[1], angle)]
    cells += ["–"] * (5 - len(cells))
    print(f"| {motion} | {FORMS[form][0]} | {MESHES[mesh][0]} | {VOLUMES[volume][0]} | {' | '.join(cells)} |", flush=True)


def main():
    tremolo = sys.argv[1] if len(sys.argv) > 1 else "build/release/bin/tremolo"
    folder = Path(sys.argv[2] if len(sys.argv) > 2 else "runs/slope_oblique")
    folder.mkdir(parents=True, exist_ok=True)
    found = motions(tremolo, folder, [Path(record) for record in sys.argv[3:]])

    print("| motion | base and sides | cells | change of volume | 0°: fails at, s | 15° | earlier | 30° | earlier |")
    print("| --- | --- | --- | --- | --- | --- | --- | --- | --- |")
    for mesh, volume, forms, names in PARTS:
        for motion in names or found:
            for form in forms:
                angles = (0, 15, 30) if volume == "cell" and form in ("springs", "yielding") else (0, 15)
                print_row(tremolo, folder, found[motion], motion, form, mesh, volume, angles)


if __name__ == "__main__":
    main()
