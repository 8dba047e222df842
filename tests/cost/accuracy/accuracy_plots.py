#!/usr/bin/env python3
"""Draws the studies of docs/accuracy-and-cost.md into a folder.

    cost_travelling_pulse > pulse.csv
    accuracy_plots.py docs/pictures --pulse pulse.csv --slope runs/w7-regular runs/w7-plain
"""

import argparse
import csv
import json
import sys
from collections import defaultdict
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[3] / "python"))

from tremolo import Run, style

LINES = {
    "FE lumped": ("k", "--"),
    "APIC musl": (style.COLOURS[0], "-"),
    "FE lumped, the domain's step": ("0.5", ":"),
    "APIC usl": (style.COLOURS[0], ":"),
    "FLIP musl": (style.COLOURS[1], "-"),
    "FLIP usl": (style.COLOURS[1], ":"),
    "FLIP musl blended": (style.COLOURS[3], "-"),
    "APIC musl 3x3 particles": (style.COLOURS[2], "-"),
}


def pulse(path, folder):
    """Error, phase and amplitude after ten wavelengths against cells per wavelength, and error against work."""
    schemes = defaultdict(list)
    with open(path, encoding="utf-8", newline="") as file:
        for row in csv.DictReader(file):
            schemes[row["scheme"]].append({key: float(value) for key, value in row.items() if key != "scheme"})
    figure, axes = style.plt.subplots(1, 3, figsize=(10.5, 3.8), layout="constrained")
    for scheme, (colour, line) in LINES.items():
        cells, error, phase, amplitude = (
            np.array([row[key] for row in schemes[scheme]])
            for key in ("cells_per_wavelength", "relative_error", "phase_periods", "amplitude")
        )
        look = {"color": colour, "linestyle": line, "marker": "o", "markersize": 3, "label": scheme}
        axes[0].loglog(cells, 100 * error, **look)
        axes[1].loglog(cells, np.maximum(360 * np.abs(phase), 0.36), **look)
        axes[2].semilogx(cells, 100 * amplitude, **look)
    axes[0].set_ylabel("error, relative L2 (%)")
    axes[1].set_ylabel("phase (degrees; 0.36 and less drawn as 0.36)")
    axes[2].set_ylabel("amplitude (%)")
    ticks = [8, 12, 16, 24, 32, 48]
    for ax in axes:
        ax.set(xlabel="cells to the wavelength", xticks=ticks, xticklabels=ticks)
        ax.minorticks_off()
    axes[2].legend(fontsize=6.5)
    figure.suptitle("SV pulse after ten wavelengths", fontsize=9)
    return style.save(figure, folder, "cost_pulse.png")


def crest(folder):
    """Cell size and velocity, time and displacement of the crest of every rung of a ladder."""
    study = json.loads((folder / "cost.json").read_text())
    for rung in study["rungs"]:
        with Run(folder / rung["folder"]) as run:
            series = run.monitor("crest")
            yield rung["size"], series["time"], np.hypot(series["ux"], series["uy"])


def slope(regular, plain, folder):
    """Displacement of the crest over time for every cell size, softening scaled to the cells and not."""
    figure, axes = style.plt.subplots(1, 2, figsize=(9.6, 3.6), sharey=True, layout="constrained")
    for ax, ladder, title in zip(axes, (regular, plain), ("softening scaled to the cells", "softening as given")):
        for size, time, displacement in crest(ladder):
            ax.plot(time, displacement, label=f"h = {size:g} m")
        ax.set(xlabel="t (s)", title=title)
        ax.legend(loc="upper left")
    axes[0].set_ylabel("displacement of the crest (m)")
    return style.save(figure, folder, "cost_slope_softening.png")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--pulse", type=Path)
    parser.add_argument("--slope", type=Path, nargs=2)
    given = parser.parse_args()
    if given.pulse:
        print(pulse(given.pulse, given.folder))
    if given.slope:
        print(slope(*given.slope, given.folder))


if __name__ == "__main__":
    main()
