#!/usr/bin/env python3
"""How far the tunnel rises, and what that depends on: a Markdown table, uplift.png and displacement.png.

    cases/tunnel_uplift/study.py [TREMOLO [FOLDER]]      default: build/release/bin/tremolo, runs/tunnel_uplift

Runs what is not in FOLDER yet.
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

PERIOD = 1.0 / 0.75  # s, of the motion
SHAKEN = 18.5 * PERIOD  # s
SHORT = 9.5 * PERIOD  # s, of the coarse variants
COMPARED = 8.0  # s
DRAWN = ("main", "coarse", "periodic", "undrained", "two")
FREE_FIELD = """left = { model = "mpm" }
right = { model = "mpm" }
base = { model = "mpm", form = "total" }
"""
REFINED = "[[refine]]\nbox = [17.0, -11.0, 28.0, 0.0]\nlevel = 1\n"
TWICE_REFINED = REFINED + "\n[[refine]]\nbox = [18.5, -9.5, 26.5, 0.0]\nlevel = 2\n"
STEP = "fraction = 0.8 "
WATER = "level = 0.0\n\n[soil.sand]"
SOIL = 'library = "hostun_dr45"'


def coarse(duration, size=1.0, refined=""):
    """Cells of one size, or with a finer box, and water of 0.22 GPa."""
    return {
        REFINED: refined,
        "size = 1.0\n": f"size = {size}\n",
        WATER: WATER.replace("\n\n", "\nbulk_modulus = 2.2e8\n\n"),
        'file = "motion.csv" ': 'file = "short.csv" ',
        "duration_s = 23.0 ": f"duration_s = {min(duration, SHORT) - 0.1:.3f} ",
        "duration_s = 12.0\n": f"duration_s = {max(duration - SHORT, 0.0) + 0.1:.3f}\n",
    }


def sides(distance):
    """Sides this far from the tunnel's axis, m, instead of 22.5 m."""
    left, right = 22.5 - distance, 22.5 + distance
    return {
        "polygon = [[0.0, -16.0], [45.0, -16.0], [45.0, 0.0], [0.0, 0.0]]":
            f"polygon = [[{left}, -16.0], [{right}, -16.0], [{right}, 0.0], [{left}, 0.0]]",
        "box = [0.0, -16.0, 45.0, 0.0]": f"box = [{left}, -16.0, {right}, 0.0]",
        "point = [5.5, -5.5]": f"point = [{left + 5.5}, -5.5]",
        "point = [5.5, 0.0]": f"point = [{left + 5.5}, 0.0]",
    }


COARSE = coarse(COMPARED + 1.05 * PERIOD)
TWO = coarse(COMPARED + 1.05 * PERIOD, 2.0)
ALONE = {FREE_FIELD: FREE_FIELD.replace(" }", ", spring = false }")}
ELEMENTS = {FREE_FIELD: FREE_FIELD.replace('"mpm"', '"fe"')}
OBLIQUE = {"angle_deg = 0.0\n": "angle_deg = 15.0\n"}
VARIANTS = {
    "finest": ("cells of 0.25 m around the tunnel", {REFINED: TWICE_REFINED}),
    "main": ("as it is", {}),
    "coarse": ("coarse", coarse(SHORT + 4.0)),
    "alone": ("as it is, dashpots alone", ALONE),
    "coarse_alone": ("coarse, dashpots alone", coarse(SHORT + 4.0) | ALONE),
    "half": ("cells of 0.5 m around the tunnel", coarse(COMPARED + 1.05 * PERIOD, refined=REFINED)),
    "quarter": ("cells of 0.25 m around the tunnel, water of 0.22 GPa", coarse(COMPARED + 1.05 * PERIOD, refined=TWICE_REFINED)),
    "step": ("time step 0.5 of the critical", COARSE | {STEP: "fraction = 0.5 "}),
    "smooth": ("friction 0", COARSE | {"friction = 0.4": "friction = 0.0"}),
    "heavy": ("1900 kg/m³", COARSE | {"density = 300.0 ": "density = 1900.0 "}),
    "fe": ("free field `fe`", COARSE | ELEMENTS),
    "fe_15": ("the same, the wave at 15 degrees", COARSE | ELEMENTS | OBLIQUE),
    "periodic": ("periodic sides", COARSE | {FREE_FIELD: 'sides = "periodic"\nbase = { model = "mpm", form = "total" }\n'}),
    "near": ("sides at 12.5 m", COARSE | sides(12.5)),
    "far": ("sides at 32.5 m", COARSE | sides(32.5)),
    "undrained": ("undrained", COARSE | {"permeability = 1e-4\n": 'permeability = 1e-4\ndrainage = "undrained"\n'}),
    "two": ("cells of 2 m, sides at 22 m", TWO | sides(22.0)),
    "two_far": ("cells of 2 m, sides at 32 m", TWO | sides(32.0)),
    "two_pdmy03": ("cells of 2 m, PDMY03, 57 %", TWO | sides(22.0) | {SOIL: 'library = "pdmy03_dr57"'}),
    "two_pm4sand": ("cells of 2 m, PM4Sand, 55 %", TWO | sides(22.0) | {SOIL: 'library = "pm4sand_dr55"'}),
    "two_elastic": ("cells of 2 m, elastic, E = 100 MPa", TWO | sides(22.0) | {"rigid = true\n": "young = 100e6\npoisson = 0.3\n"}),
}


def uplift(run):
    """Time (s) and rise of the axis (m) over the ground's rock, mean of a cycle."""
    tunnel = run.body("tunnel")
    time = tunnel["time"]
    window = max(1, round(PERIOD / np.median(np.diff(time))))
    kernel = np.ones(window) / window
    rise = np.convolve(tunnel["y"] - tunnel["y"][0], kernel, mode="valid")
    return time[window - 1 :], rise


def rate(time, rise, begin, end):
    """Mean speed between two times, m/s."""
    return float(np.interp(end, time, rise) - np.interp(begin, time, rise)) / (end - begin)


def net_lift(run, begin, end):
    """Mean force of water and gravity on the tunnel between two times, N/m."""
    tunnel = run.body("tunnel")
    chosen = (tunnel["time"] >= begin) & (tunnel["time"] < end)
    return float((tunnel["water_y"] + tunnel["weight_y"])[chosen].mean())


def liquefied(run, monitor):
    """Time at which r_u of a monitor first reaches 0.9, s; nan if it never does."""
    table = run.monitor(monitor)
    reached = np.flatnonzero(table["pore_pressure_ratio"] >= 0.9)
    return float(table["time"][reached[0]]) if len(reached) else float("nan")


def synthesise(tremolo, folder):
    """Writes the case's motion and the shorter one of the coarse variants."""
    (folder / "motion.csv").write_bytes(CASE.with_name("motion.csv").read_bytes())
    if not (folder / "short.csv").exists():
        recipe = folder / "short_motion.toml"
        recipe.write_text(variant(CASE.with_name("motion.toml"), {"cycles = 18.5 ": "cycles = 9.5 ", "samples = 2481": "samples = 1281"}))
        subprocess.run([tremolo, "motion", "--synthesise", recipe, "--out", folder / "short.csv"], check=True, stdout=subprocess.DEVNULL)


def displacement(run, folder):
    """Vertical displacement of the soil at the end."""
    rise = run.field(len(run.times) - 1, "displacement")[:, 1]
    return final_map(run, rise, folder, "displacement.png", "rise of the soil (m)", diverging=True)


def row(label, run, reference):
    """A line of the table, and the run's rise at 8 s, from which the others differ."""
    time, rise = uplift(run)
    at = float(np.interp(COMPARED, time, rise))
    shaken = next((end for end in (SHAKEN, SHORT) if time[-1] > end + PERIOD), None)
    ended = "– | –"
    if shaken:
        ratio = rate(time, rise, shaken + PERIOD, time[-1]) / rate(time, rise, 3.0, shaken)
        ended = f"{np.interp(shaken, time, rise):.2f} | {ratio:.3f}"
    print(
        f"| {label} | {liquefied(run, 'free field'):.1f} | {net_lift(run, COMPARED, COMPARED + PERIOD) / 1e3:.0f} | {at:.3f} "
        f"| {100.0 * (at / (reference or at) - 1.0):+.0f} % | {ended} | {cpu_time(run) / 60.0:.1f} |",
        flush=True,
    )
    return at


def main():
    tremolo = sys.argv[1] if len(sys.argv) > 1 else "build/release/bin/tremolo"
    folder = Path(sys.argv[2] if len(sys.argv) > 2 else "runs/tunnel_uplift")
    folder.mkdir(parents=True, exist_ok=True)
    synthesise(tremolo, folder)
    figure, (lifted, ratios) = style.plt.subplots(2, 1, figsize=(7.6, 5.2), sharex=True, layout="constrained")
    print("| variant | r_u = 0.9 in the free field, s | net lift at 8 s, kN/m | rise at 8 s, m | against the finest | rise when the shaking ends, m | rate after over rate during | CPU time, min |")
    print("| --- | --- | --- | --- | --- | --- | --- | --- |")
    finest = None
    for name, (label, changes) in VARIANTS.items():
        with run_variant(tremolo, CASE, changes, folder, name) as run:
            at = row(label, run, finest)
            finest = finest or at
            if name in DRAWN:
                lifted.plot(*uplift(run), color=style.COLOURS[DRAWN.index(name)], label=label)
            if name == "main":
                drawn = displacement(run, folder)
                for monitor in ("free field", "beside", "below", "above"):
                    table = run.monitor(monitor)
                    ratios.plot(table["time"], table["pore_pressure_ratio"], linewidth=0.6, label=monitor)
    lifted.set_ylabel("rise of the axis (m)")
    lifted.legend()
    ratios.set(xlabel="t (s)", ylabel="$r_u$", ylim=(-0.6, 1.2), xlim=(0.0, 35.0))
    ratios.legend(ncols=4, loc="lower right")
    for ax in (lifted, ratios):
        ax.axvline(SHAKEN, color="0.6", linewidth=0.6, zorder=0)
    print(drawn, style.save(figure, folder, "uplift.png"), sep="\n")


if __name__ == "__main__":
    main()
