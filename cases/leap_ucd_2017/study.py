#!/usr/bin/env python3
"""Excess pore pressure of the column against the centrifuge's, and what it depends on: the tables of README.md and pressures.png.

    cases/leap_ucd_2017/study.py [TREMOLO [FOLDER]]      default: build/release/bin/tremolo, runs/leap_ucd_2017

Runs what is not in FOLDER yet.
"""

import subprocess
import sys
from pathlib import Path

CASE = Path(__file__).resolve().parent / "case.toml"
sys.path.insert(0, str(CASE.parents[2] / "python"))

import numpy as np
from tremolo import pore_pressure, style
from tremolo.variants import variant

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
    out = folder / f"{name}.h5"
    if not out.exists():
        written = folder / f"{name}.toml"
        written.write_text(variant(case, changes))
        (folder / "motion.csv").write_bytes(case.with_name("motion.csv").read_bytes())
        subprocess.run([tremolo, "column", written, "--model", "fe", "--out", out, "--depths", ",".join(map(str, (0.0, *DEPTHS))),
                        "--every", "0.1", "--duration", "204.5"], check=True, stdout=subprocess.DEVNULL)
    levels, histories, _, settlement, _ = pore_pressure.read(out)
    at = [histories[int(np.argmin(np.abs(levels + depth)))] for depth in DEPTHS]
    return at[0]["time"], np.array([1e-3 * history["pore_pressure"] for history in at]), settlement["settlement"]


def means(time, pressure, when):
    """Means over 3 s about a time, kPa."""
    return pressure[:, np.abs(time - when) < 1.5].mean(axis=1)


def largest_miss(time, pressure):
    """The largest difference to what was measured, as a share of the overburden at its depth."""
    shares = [np.abs(means(time, pressure, when) - measured) / (OVERBURDEN * np.array(DEPTHS)) for when, measured in MEASURED.items()]
    return float(np.max(shares))


def picture(time, pressure, without, folder):
    figure, axes = style.plt.subplots(len(DEPTHS), 1, figsize=(7.6, 7.6), sharex=True, layout="constrained")
    for number, (ax, depth) in enumerate(zip(axes, DEPTHS)):
        ax.plot(time, pressure[number], linewidth=0.7, color=style.COLOURS[0], label="column")
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
    print("| excess pore pressure, kPa | 4 m | 3 m | 2 m | 1 m |\n| --- | --- | --- | --- | --- |")
    for when, measured in MEASURED.items():
        print(f"| {when:g} s, centrifuge | " + " | ".join(f"{value:g}" for value in measured) + " |")
        print("| column | " + " | ".join(f"{value:.1f}" for value in means(time, pressure, when)) + " |")
    print("\n| variant | largest miss, share of the overburden | at 94 s, 4 m, kPa | settlement, mm |\n| --- | --- | --- | --- |")
    for name, (label, _) in VARIANTS.items():
        time, pressure, settlement = found[name]
        print(f"| {label} | {100.0 * largest_miss(time, pressure):.0f} % | {means(time, pressure, 94.0)[0]:.1f} | {1e3 * settlement[-1]:.0f} |")
    print(picture(*found["main"][:2], found["no_rest"][:2], folder))


if __name__ == "__main__":
    main()
