#!/usr/bin/env python3
"""How far two buildings tilt and settle, and what that depends on: a Markdown table and pictures.

    cases/adjacent_buildings/study.py [TREMOLO [FOLDER]]      default: build/release/bin/tremolo, runs/adjacent_buildings

Runs what is not in FOLDER yet. All variants but `main` have water of 0.22 GPa and end at 26 s, and all
but `finest` and `finer` have cells of 1 m.
"""

import subprocess
import sys
from pathlib import Path

import numpy as np

CASE = Path(__file__).resolve().parent / "case.toml"
sys.path.insert(0, str(CASE.parents[2] / "python"))

from tremolo import style
from tremolo.pictures.maps import final_map
from tremolo.variants import cpu_time, run_variant, variant

SHAKEN = 16.0  # s
COARSE = {
    "size = 0.5\n": "size = 1.0\n",
    "level = 0.0\n\n[soil.sand]": "level = 0.0\nbulk_modulus = 2.2e8\n\n[soil.sand]",
    "duration_s = 20.0\n": "duration_s = 10.0\n",
}
TALL = "polygon = [[-6.25, -0.5], [-1.25, -0.5], [-1.25, 17.5], [-6.25, 17.5]]"
LOW = "polygon = [[1.25, -0.5], [13.25, -0.5], [13.25, 8.5], [1.25, 8.5]]"
WALLS = "density = 340.0                  # of walls and rooms together"
RECORD = 'file = "motion.csv" '
FREE_FIELD = """left = { model = "mpm" }
right = { model = "mpm" }
base = { model = "mpm", form = "total" }
"""
PERIODIC = {FREE_FIELD: 'sides = "periodic"\nbase = { model = "mpm", form = "total" }\n'}
# What a motion's recipe is changed by: file, amplitude (m/s2), frequency (Hz), cycles.
MOTIONS = (("0.20g.csv", 1.962, 0.75, 12), ("0.25g.csv", 2.4525, 0.75, 12), ("1Hz.csv", 2.943, 1.0, 16))


def box(left, bottom, width, height):
    """A line of a case file: a rectangle as a polygon."""
    right, top = left + width, bottom + height
    return f"polygon = [[{left}, {bottom}], [{right}, {bottom}], [{right}, {top}], [{left}, {top}]]"


ALONE = {FREE_FIELD: FREE_FIELD.replace(" }", ", spring = false }")}
ELEMENTS = {FREE_FIELD: FREE_FIELD.replace('"mpm"', '"fe"')}
OBLIQUE = {"angle_deg = 0.0\n": "angle_deg = 15.0\n"}
FINER = COARSE | {"size = 0.5\n": "size = 0.5\n"}
REFINED = "[[refine]]\nbox = [-9.0, -3.0, 16.0, 1.0]\nlevel = 2\n\n"
FINEST = COARSE | {"[boundary]\n": f"{REFINED}[boundary]\n"}
# Motions of nearly one strength on the finest cells, as sweep.toml has them on cells of 1 m.
SCALES = (0.90, 0.92, 0.94, 0.96, 0.98, 1.00, 1.02, 1.04, 1.06, 1.08)


def tall(width, gap=2.5, depth=0.5):
    return {TALL: box(-0.5 * gap - width, -depth, width, 17.5 + depth)}


def low(width, gap=2.5, depth=0.5):
    return {LOW: box(0.5 * gap, -depth, width, 8.5 + depth)}


def sides(left, right):
    """Another place of both sides."""
    return {
        "polygon = [[-18.0, -8.0], [26.0, -8.0], [26.0, 0.0], [-18.0, 0.0]]": box(left, -8.0, right - left, 8.0),
        "box = [-18.0, -8.0, 26.0, 0.0]": f"box = [{left}, -8.0, {right}, 0.0]",
        "point = [-15.75, -3.75]": f"point = [{left + 2.25}, -3.75]",
    }


def thickness(height):
    """Another thickness of the sand."""
    return {
        "polygon = [[-18.0, -8.0], [26.0, -8.0], [26.0, 0.0], [-18.0, 0.0]]": box(-18.0, -height, 44.0, height),
        "box = [-18.0, -8.0, 26.0, 0.0]": f"box = [-18.0, -{height}, 26.0, 0.0]",
        "reference = [0.0, -8.0]": f"reference = [0.0, -{height}]",
        "thickness = 8.0": f"thickness = {height}",
    }


def elastic(line, density):
    """A structure's outline and density lines, and stiffness in place of `rigid`."""
    return {f"{line}\n{density}\nrigid = true": f"{line}\ndensity = 340.0\nyoung = 10e6\npoisson = 0.3"}


def rough(line, density, friction):
    """Another friction of a structure with this outline and density."""
    return {f"{line}\n{density}\nrigid = true\nfriction = 0.4": f"{line}\ndensity = 340.0\nrigid = true\nfriction = {friction}"}


FASTER = COARSE | {"[boundary]\n": "[time]\nfraction = 0.8\n\n[boundary]\n"}
VARIANTS = {
    "main": ("as it is", {}),
    "finest": ("cells of 0.25 m to 3 m of depth", FINEST),
    "finer": ("cells of 0.5 m", FINER),
    "coarse": ("coarse", COARSE),
    "alone": ("dashpots alone", COARSE | ALONE),
    "step": ("time step 0.8 of the critical", FASTER),
    "step_periodic": ("the same, periodic sides", FASTER | PERIODIC),
    "step_near": ("the same, sides at 6 m", FASTER | sides(-12.0, 20.0)),
    "step_far": ("the same, sides at 24 m", FASTER | sides(-30.0, 38.0)),
    "width_3.75": ("tall one 3.75 m wide", COARSE | tall(3.75)),
    "width_4": ("4 m", COARSE | tall(4.0)),
    "width_4.25": ("4.25 m", COARSE | tall(4.25)),
    "width_4.5": ("4.5 m", COARSE | tall(4.5)),
    "width_6": ("6 m", COARSE | tall(6.0)),
    "gap_2": ("gap 2 m", COARSE | tall(5.0, 2.0) | low(12.0, 2.0)),
    "gap_4": ("gap 4 m", COARSE | tall(5.0, 4.0) | low(12.0, 4.0)),
    "gap_6": ("gap 6 m", COARSE | tall(5.0, 6.0) | low(12.0, 6.0)),
    "low_9": ("low one 9 m wide", COARSE | low(9.0)),
    "deep": ("foundations 1 m deep", COARSE | tall(5.0, depth=1.0) | low(12.0, depth=1.0)),
    "smooth": ("friction 0", COARSE | rough(TALL, WALLS, 0.0) | rough(LOW, "density = 340.0", 0.0)),
    "thin": ("4 m of sand", COARSE | thickness(4.0)),
    "thin_6": ("6 m of sand", COARSE | thickness(6.0)),
    "layer": ("matched layer at the base", COARSE | {'form = "total" }\n': 'form = "total", absorber = "matched_layer" }\n'}),
    "0.20g": ("0.20 g", COARSE | {RECORD: 'file = "0.20g.csv" '}),
    "0.25g": ("0.25 g", COARSE | {RECORD: 'file = "0.25g.csv" '}),
    "1Hz": ("1 Hz, 16 cycles", COARSE | {RECORD: 'file = "1Hz.csv" '}),
    "fe": ("free field `fe`", COARSE | ELEMENTS),
    "fe_15": ("the same, the wave at 15 degrees", COARSE | ELEMENTS | OBLIQUE),
    "periodic": ("periodic sides", COARSE | PERIODIC),
    "near": ("sides at 6 m", COARSE | sides(-12.0, 20.0)),
    "far": ("sides at 24 m", COARSE | sides(-30.0, 38.0)),
    "farther": ("sides at 36 m", COARSE | sides(-42.0, 50.0)),
    "farther_alone": ("the same, dashpots alone", COARSE | sides(-42.0, 50.0) | ALONE),
    "undrained": ("undrained", COARSE | {"permeability = 1e-4\n": 'permeability = 1e-4\ndrainage = "undrained"\n'}),
    "pm4sand": ("PM4Sand, 55 %", COARSE | {'library = "pdmy03_dr57"': 'library = "pm4sand_dr55"'}),
    "elastic": ("elastic, E = 10 MPa", COARSE | elastic(TALL, WALLS) | elastic(LOW, "density = 340.0")),
}


def scaled(scale):
    """The finest variant under a scaled motion, with a longer step, until 4 s after the shaking."""
    return FINEST | {
        RECORD: f"scale = {scale}\n{RECORD}",
        "[boundary]\n": f"{REFINED}[time]\nfraction = 0.8\n\n[boundary]\n",
        "duration_s = 20.0\n": "duration_s = 4.0\n",
    }


def tilt(run, name):
    """Tilt of a building over time, degrees, counter-clockwise positive."""
    return np.degrees(run.body(name)["tilt"])


def settlement(run, name):
    """How far the middle of a building's foundation has sunk over time, m."""
    body = run.body(name)
    half = 0.5 * np.ptp(body.outline[:, 1])
    base = body["y"] - half * np.cos(body["tilt"])
    return base[0] - base


def between(run):
    """Particles of the ground's surface between both buildings at the start."""
    start = run.field(0, "position")
    left, right = run.body("tall").outline[:, 0].max(), run.body("low").outline[:, 0].min()
    inside = (start[:, 0] > left) & (start[:, 0] < right) & (start[:, 1] > -run.attribute("mesh_size"))
    return np.flatnonzero(inside)


def rise(run):
    """Rise of the soil between both buildings at its surface at the times of the frames, m: its mean, and its mean over
    the corner of the tall building's foundation that it borders."""
    chosen = between(run)
    soil = np.array([run.field(i, "displacement")[chosen, 1].mean() for i in range(len(run.times))])
    body = run.body("tall")
    corner = int(np.argmin(body.outline @ [-1.0, 1.0]))
    sunk = np.array([body.outline[corner, 1] - body.corners(t)[0][corner, 1] for t in run.times])
    return soil, soil + sunk


def middle(run):
    """Rise at the end of the soil's surface in the middle third of the gap, m."""
    chosen = between(run)
    x = run.field(0, "position")[chosen, 0]
    inner = chosen[np.abs(x - x.mean()) < np.ptp(x) / 6.0]
    return float(run.field(len(run.times) - 1, "displacement")[inner, 1].mean())


def overlap_of(first, second):
    """How deep two convex outlines lie in each other, m; below zero the widest gap along one of their edges' normals."""

    def deepest(one, other):
        """The least over the edges of `one` of how far `other` reaches behind the edge."""
        edges = np.roll(one, -1, axis=0) - one
        outward = np.column_stack([edges[:, 1], -edges[:, 0]]) / np.hypot(*edges.T)[:, None]
        return min(float(np.max((corner - other) @ normal)) for corner, normal in zip(one, outward))

    return min(deepest(first, second), deepest(second, first))


def overlap(run):
    """The largest overlap (m) of both buildings at any time of the history; below zero their smallest distance."""
    both = run.body("tall"), run.body("low")
    return max(overlap_of(*(body.corners(t)[0] for body in both)) for t in both[0]["time"][::5])


def speed(run):
    """The largest speed (m/s) of a point of a building at the end of a run."""
    largest = 0.0
    for name in run.bodies:
        body = run.body(name)
        radius = np.hypot(*np.ptp(body.outline, axis=0)) / 2.0
        largest = max(largest, float(np.hypot(body["vx"][-1], body["vy"][-1]) + abs(body["spin"][-1]) * radius))
    return largest


def synthesise(tremolo, folder):
    """Writes the motions of all variants."""
    (folder / "motion.csv").write_bytes(CASE.with_name("motion.csv").read_bytes())
    for name, amplitude, frequency, cycles in MOTIONS:
        if (folder / name).exists():
            continue
        recipe = folder / name.replace(".csv", "_motion.toml")
        changes = {"amplitude = 2.943 ": f"amplitude = {amplitude} ", "frequency = 0.75 ": f"frequency = {frequency} ", "cycles = 12\n": f"cycles = {cycles}\n"}
        recipe.write_text(variant(CASE.with_name("motion.toml"), changes))
        subprocess.run([tremolo, "motion", "--synthesise", recipe, "--out", folder / name], check=True, stdout=subprocess.DEVNULL)


def histories(run, folder):
    """Tilt, settlement and the soil between them against time."""
    figure, (tilts, sunk, heave) = style.plt.subplots(3, 1, figsize=(7.6, 6.4), sharex=True, layout="constrained")
    for name, colour in zip(("tall", "low"), style.COLOURS):
        time = run.body(name)["time"]
        tilts.plot(time, tilt(run, name), color=colour, label=f"{name} one")
        sunk.plot(time, settlement(run, name), color=colour)
    soil, over = rise(run)
    heave.plot(run.times, soil, color=style.COLOURS[2], label="soil between them")
    heave.plot(run.times, over, color=style.COLOURS[3], label="over the foundation of the tall one")
    tilts.set_ylabel("tilt (°)")
    sunk.set_ylabel("settlement (m)")
    heave.set(xlabel="t (s)", ylabel="rise (m)", xlim=(0.0, run.times[-1]))
    for ax in (tilts, heave):
        ax.legend()
    for ax in (tilts, sunk, heave):
        ax.axvline(SHAKEN, color="0.6", linewidth=0.6, zorder=0)
    return style.save(figure, folder, "histories.png")


def final_displacement(run, folder):
    """Size of the displacement at the end, with both buildings in place."""
    size = np.hypot(*run.field(len(run.times) - 1, "displacement").T)
    return final_map(run, size, folder, "displacement.png", "displacement (m)")


def stress_path(run, folder):
    """Shear stress over mean effective stress under the tall building, with the lines of failure and of phase
    transformation in simple shear: |tau| = M (p' + p_res)/sqrt(3), M = 6 sin phi/(3 - sin phi)."""
    table = run.monitor("under the tall one")
    pressure = -(table["sxx"] + table["syy"] + table["szz"]) / 3e3
    figure, ax = style.plt.subplots(figsize=(5.2, 4.0), layout="constrained")
    ax.plot(pressure, table["sxy"] / 1e3, linewidth=0.5)
    reach = np.array([0.0, 1.05 * pressure.max()])
    for degrees, look, label in ((30.3, "-", "failure"), (25.3, "--", "phase transformation")):
        sine = np.sin(np.radians(degrees))
        line = 6.0 * sine / (3.0 - sine) * (reach + 2.852) / np.sqrt(3.0)
        ax.plot(reach, line, look, reach, -line, look, color="0.3", linewidth=0.8)
        ax.plot([], [], look, color="0.3", linewidth=0.8, label=label)
    ax.set(xlabel="mean effective stress (kPa)", ylabel="shear stress (kPa)")
    ax.legend()
    return style.save(figure, folder, "stress_path.png")


def ensemble(tremolo, folder):
    """Prints what the buildings do under each of the motions of nearly one strength, and mean and deviation of it."""
    rows = []
    for scale in SCALES:
        with run_variant(tremolo, CASE, scaled(scale), folder, f"finest_{scale:.2f}") as run:
            rows.append([tilt(run, "tall")[-1], tilt(run, "low")[-1], *(settlement(run, name)[-1] for name in ("tall", "low")), rise(run)[0][-1]])
    print("\n| motion | tilt of the tall one, ° | of the low one, ° | settlement of the tall one, m | of the low one, m | rise of the soil between, m |")
    print("| --- | --- | --- | --- | --- | --- |")
    labels = [f"{scale:.2f}" for scale in SCALES] + ["mean", "deviation"]
    for label, row in zip(labels, [*rows, np.mean(rows, axis=0), np.std(rows, axis=0, ddof=1)]):
        print(f"| {label} | " + " | ".join(f"{value:.2f}" for value in row) + " |")


def main():
    tremolo = sys.argv[1] if len(sys.argv) > 1 else "build/release/bin/tremolo"
    folder = Path(sys.argv[2] if len(sys.argv) > 2 else "runs/adjacent_buildings")
    folder.mkdir(parents=True, exist_ok=True)
    synthesise(tremolo, folder)
    print("| variant | tilt of the tall one, ° | of the low one, ° | settlement of the tall one, m | of the low one, m | rise of the soil between, m | in its middle, m | over the tall one's foundation, m | smallest distance, m | speed at the end, m/s | CPU time, min |")
    print("| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |")
    finest = None
    for name, (label, changes) in VARIANTS.items():
        with run_variant(tremolo, CASE, changes, folder, name) as run:
            soil, over = rise(run)
            sunk = [float(settlement(run, building)[-1]) for building in ("tall", "low")]
            finest = finest or sunk
            both = " | ".join(f"{s:.2f} ({100.0 * (s / f - 1.0):+.0f} %)" for s, f in zip(sunk, finest))
            print(
                f"| {label} | {tilt(run, 'tall')[-1]:.1f} | {tilt(run, 'low')[-1]:.2f} | {both} | {soil[-1]:.2f} "
                f"| {middle(run):.2f} | {over[-1]:.2f} | {round(-overlap(run), 2) + 0.0:.2f} | {speed(run):.1e} | {cpu_time(run) / 60.0:.1f} |",
                flush=True,
            )
            if name == "main":
                pictures = [make(run, folder) for make in (histories, final_displacement, stress_path)]
    ensemble(tremolo, folder)
    print(*pictures, sep="\n")


if __name__ == "__main__":
    main()
