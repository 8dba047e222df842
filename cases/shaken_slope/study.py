#!/usr/bin/env python3
"""How far the clay slides under harmonic motions of the table, beside Newmark's rigid block: a Markdown table and pictures.

    cases/shaken_slope/study.py [TREMOLO [FOLDER]]      default: build/release/bin/tremolo, runs/shaken_slope

The yield coefficient is that of the slope itself, on a table whose acceleration grows slowly. Runs what is not in FOLDER yet.
"""

import subprocess
import sys
from pathlib import Path

import numpy as np

CASE = Path(__file__).resolve().parent / "case.toml"
sys.path.insert(0, str(CASE.parents[2] / "python"))

from tremolo import style
from tremolo.extract.newmark import driving, sliding_displacement
from tremolo.variants import cpu_time, run_variant, variant

GRAVITY = 9.81  # m/s2
RATE = 0.05  # g/s, of the table's growing acceleration
SLID = 0.005  # m, by which the yield coefficient is found
RECORD, DURATION = 'file = "motion.csv"\n', "duration_s = 4.5\n"
LEVELS = (0.3, 0.4, 0.5, 0.6)  # g
CELLS = {
    "0.05 m": {},
    "0.025 m": {"size = 0.05\n": "size = 0.025\n"},
}
PARTS = {"0.05 m": (2.0, 3.0, 5.0), "0.025 m": (3.0,)}  # cells: frequencies, Hz


def slid(run):
    """Time (s) and how far the mass has slid down the slope, to the left, relative to the table (m)."""
    mass, table = run.sliding_mass("slope"), run.shaking_table
    return mass["time"], table["ux"] - mass["ux"]


def yield_coefficient(run):
    """k_y from a run whose table begins at rest and accelerates at RATE t g.

    A rigid block that begins to slide at t_y has slid RATE g (t - t_y)^3/6 at t; t is when the mass has slid by SLID.
    """
    time, way = slid(run)
    sooner = (6.0 * SLID / (RATE * GRAVITY)) ** (1.0 / 3.0)
    return RATE * (float(np.interp(SLID, way, time)) - sooner)


def newmark(run, k_y):
    """Time (s) and the displacement of Newmark's rigid block on the table (m)."""
    table = run.shaking_table
    return table["time"], sliding_displacement(table["time"], driving(table["ax"], -1), k_y * GRAVITY)


def ramp(tremolo, folder, cells):
    """The run under the growing acceleration."""
    time = np.arange(0.0, 7.0, 0.01)
    np.savetxt(folder / "ramp.csv", np.column_stack([time, RATE * GRAVITY * time]), delimiter=",", header="t (s),a (m/s2)", comments="")
    changes = {RECORD: 'file = "ramp.csv"\n', DURATION: "duration_s = 6.0\n", **CELLS[cells]}
    return run_variant(tremolo, CASE, changes, folder, f"ramp_{cells[:-2]}")


def shaken(tremolo, folder, level, frequency, cells):
    """The run under a harmonic motion."""
    name = f"{level}g_{frequency:g}Hz"
    if not (folder / f"{name}.csv").exists():
        recipe = folder / f"{name}_motion.toml"
        changes = {
            "amplitude = 4.905 ": f"amplitude = {level * GRAVITY} ",
            "frequency = 3.0 ": f"frequency = {frequency} ",
            "samples = 901\n": "samples = 1201\n",
        }
        recipe.write_text(variant(CASE.with_name("motion.toml"), changes))
        subprocess.run([tremolo, "motion", "--synthesise", recipe, "--out", folder / f"{name}.csv"], check=True, stdout=subprocess.DEVNULL)
    changes = {RECORD: f'file = "{name}.csv"\n', DURATION: "duration_s = 6.0\n", **CELLS[cells]}
    return run_variant(tremolo, CASE, changes, folder, f"{name}_{cells[:-2]}")


def picture(run, k_y, folder):
    """Sliding of a run and of Newmark's block, and the accelerations."""
    figure, (accelerations, ways) = style.plt.subplots(2, 1, figsize=(7.6, 4.6), sharex=True, layout="constrained")
    for name, series in (("table", run.shaking_table), ("sliding mass", run.sliding_mass("slope"))):
        accelerations.plot(series["time"], series["ax"] / GRAVITY, linewidth=0.7, label=name)
    accelerations.axhline(k_y, color="0.4", linewidth=0.8, linestyle="--", label=f"$k_y$ = {k_y:.3f}")
    ways.plot(*slid(run), label="clay")
    ways.plot(*newmark(run, k_y), "--", color="0.3", label="rigid block")
    accelerations.set_ylabel("acceleration (g)")
    ways.set(xlabel="t (s)", ylabel="slid (m)", xlim=(0.0, 4.5))
    for ax in (accelerations, ways):
        ax.legend(loc="upper right" if ax is accelerations else "upper left")
    return style.save(figure, folder, "sliding.png")


def main():
    tremolo = sys.argv[1] if len(sys.argv) > 1 else "build/release/bin/tremolo"
    folder = Path(sys.argv[2] if len(sys.argv) > 2 else "runs/shaken_slope")
    folder.mkdir(parents=True, exist_ok=True)
    print("| cells | table | k_y | slid, m | rigid block, m | rigid block over slid | CPU time, s |\n| --- | --- | --- | --- | --- | --- | --- |")
    for cells, frequencies in PARTS.items():
        with ramp(tremolo, folder, cells) as run:
            k_y = yield_coefficient(run)
        for frequency in frequencies:
            for level in LEVELS:
                with shaken(tremolo, folder, level, frequency, cells) as run:
                    way, block = slid(run)[1][-1], newmark(run, k_y)[1][-1]
                    print(f"| {cells} | {level} g, {frequency:g} Hz | {k_y:.3f} | {way:.4f} | {block:.4f} | {block / way:.2f} "
                          f"| {cpu_time(run):.0f} |", flush=True)
                    if (cells, frequency, level) == ("0.05 m", 3.0, 0.5):
                        path = picture(run, k_y, folder)
    print(path)


if __name__ == "__main__":
    main()
