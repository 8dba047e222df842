#!/usr/bin/env python3
"""Excess pore pressure of the column and of the slope in its container against the centrifuge's, and what it depends on: the tables
of README.md, pressures.png and displacement.png.

    cases/leap_ucd_2017/study.py [TREMOLO [FOLDER]]      default: build/release/bin/tremolo, runs/leap_ucd_2017

Runs what is not in FOLDER yet.
"""

import sys
from pathlib import Path

CASE = Path(__file__).resolve().parent / "case.toml"
sys.path.insert(0, str(CASE.parents[2] / "python"))

import numpy as np
from tremolo import pore_pressure, style
from tremolo.pictures.maps import final_map
from tremolo.variants import cpu_time, run_column, run_variant

DEPTHS = (4.0, 3.0, 2.0, 1.0)  # m
# Means over some seconds of sensors good to 2 kPa, at these times (s).
MEASURED = {16.0: (35.5, 26.4, 18.0, 8.7), 94.0: (14.7, 13.7, 12.3, 8.2), 150.0: (8.1, 7.5, 7.0, 3.9), 197.0: (4.5, 4.8, 4.5, 2.2)}
OVERBURDEN = 995.8 * 9.81e-3  # kPa a metre, buoyant
REST = '\n[[stage]]\nkind = "rest"\nduration_s = 190.0\n'
VARIANTS = {
    "main": ("as it is", {}),
    "coarse": ("elements of 0.5 m", {"element_size = 0.25": "element_size = 0.5"}),
    "weaker": ("0.15 g", {'file = "motion.csv" ': 'scale = 0.882\nfile = "motion.csv" '}),
    "stronger": ("0.20 g", {'file = "motion.csv" ': 'scale = 1.176\nfile = "motion.csv" '}),
    "open": ("twice the permeability", {"permeability = 1.27e-4 ": "permeability = 2.54e-4 "}),
    "tight": ("half of it", {"permeability = 1.27e-4 ": "permeability = 6.35e-5 "}),
    "weak": ("contraction rate 0.2", {"contraction_rate = 0.44 ": "contraction_rate = 0.2 "}),
    "strong": ("0.8", {"contraction_rate = 0.44 ": "contraction_rate = 0.8 "}),
    "no_rest": ("shaking that goes on, no rest", {REST: "", "duration_s = 14.5 ": "duration_s = 204.5 "}),
}


def column(tremolo, folder, name, changes, case=CASE):
    """Time (s), excess pore pressure [depth][time] (kPa) and settlement (m) of a variant."""
    (folder / "motion.csv").write_bytes(case.with_name("motion.csv").read_bytes())
    out, _ = run_column(tremolo, case, changes, folder, name, "fe", "--depths", ",".join(map(str, (0.0, *DEPTHS))), "--every", "0.1",
                        "--duration", "204.5")
    levels, histories, _, settlement, _ = pore_pressure.read(out)
    at = [histories[int(np.argmin(np.abs(levels + depth)))] for depth in DEPTHS]
    return at[0]["time"], np.array([1e-3 * history["pore_pressure"] for history in at]), settlement["settlement"]


def container(tremolo, folder):
    """Likewise of the soil within 3 m of mid-slope in the container, at the times of the frames; how far its surface has gone downhill
    (m), and CPU time (s)."""
    with run_variant(tremolo, CASE.with_name("container.toml"), {}, folder, "container") as run:
        place = run.field(0, "position")
        middle = np.abs(place[:, 0]) < 3.0
        rows = [middle & (np.abs(place[:, 1] + depth) < 0.26) for depth in DEPTHS]
        pressure = [[1e-3 * run.field(frame, "excess_pore_pressure")[row].mean() for frame in range(len(run.times))] for row in rows]
        surface = middle & (place[:, 1] > -0.3)
        moved = [run.field(frame, "displacement")[surface, 0].mean() for frame in range(len(run.times))]
        final_map(run, np.hypot(*run.field(len(run.times) - 1, "displacement").T), folder, "displacement.png", "displacement (m)")
        return run.times, np.array(pressure), np.array(moved), cpu_time(run)


def means(time, pressure, when):
    """Means over 3 s about a time, kPa, or what is nearest to it."""
    near = np.abs(time - when) < max(1.5, 1.001 * np.abs(time - when).min())
    return pressure[:, near].mean(axis=1)


def largest_miss(time, pressure):
    """The largest difference to what was measured, as a share of the overburden at its depth."""
    shares = [np.abs(means(time, pressure, when) - measured) / (OVERBURDEN * np.array(DEPTHS)) for when, measured in MEASURED.items()]
    return float(np.max(shares))


def picture(time, pressure, slope, without, folder):
    figure, axes = style.plt.subplots(len(DEPTHS), 1, figsize=(7.6, 7.6), sharex=True, layout="constrained")
    for number, (ax, depth) in enumerate(zip(axes, DEPTHS)):
        ax.plot(time, pressure[number], linewidth=0.7, color=style.COLOURS[0], label="column")
        ax.plot(slope[0], slope[1][number], linewidth=0.7, color=style.COLOURS[2], label="slope in its container")
        ax.plot(without[0], without[1][number], linewidth=0.7, color="0.6", label="without a rest")
        ax.errorbar(list(MEASURED), [row[number] for row in MEASURED.values()], yerr=2.0, fmt="o", color=style.COLOURS[1], markersize=4,
                    capsize=3, label="centrifuge")
        ax.axhline(OVERBURDEN * depth, color="0.6", linewidth=0.6, linestyle=":", zorder=0)
        ax.set_title(f"{depth:g} m deep; dotted: $\\sigma'_v$ before the shaking", loc="left", fontsize=9)
        ax.set_ylabel("excess p (kPa)")
    axes[0].legend()
    axes[-1].set(xlabel="t (s)", xlim=(0.0, 204.0))
    return style.save(figure, folder, "pressures.png")


def main():
    tremolo = sys.argv[1] if len(sys.argv) > 1 else "build/release/bin/tremolo"
    folder = Path(sys.argv[2] if len(sys.argv) > 2 else "runs/leap_ucd_2017")
    folder.mkdir(parents=True, exist_ok=True)
    found = {name: column(tremolo, folder, name, changes) for name, (_, changes) in VARIANTS.items()}
    time, pressure, _ = found["main"]
    slope = container(tremolo, folder)
    print("| excess pore pressure, kPa | 4 m | 3 m | 2 m | 1 m |\n| --- | --- | --- | --- | --- |")
    for when, measured in MEASURED.items():
        print(f"| {when:g} s, centrifuge | " + " | ".join(f"{value:g}" for value in measured) + " |")
        print("| column | " + " | ".join(f"{value:.1f}" for value in means(time, pressure, when)) + " |")
        print("| slope in its container | " + " | ".join(f"{value:.1f}" for value in means(*slope[:2], when)) + " |")
    at_end, last = np.interp([16.0, slope[0][-1]], slope[0], slope[2])
    print(f"\nLargest miss of the slope {100.0 * largest_miss(*slope[:2]):.0f} % of the overburden; downhill {at_end:.2f} m at 16 s, "
          f"{last:.2f} m at the end; {slope[3] / 60.0:.1f} min of CPU time")
    print("\n| variant | largest miss, share of the overburden | at 94 s, 4 m, kPa | settlement, mm |\n| --- | --- | --- | --- |")
    for name, (label, _) in VARIANTS.items():
        time, pressure, settlement = found[name]
        print(f"| {label} | {100.0 * largest_miss(time, pressure):.0f} % | {means(time, pressure, 94.0)[0]:.1f} | {1e3 * settlement[-1]:.0f} |")
    print(picture(*found["main"][:2], slope, found["no_rest"][:2], folder))


if __name__ == "__main__":
    main()
