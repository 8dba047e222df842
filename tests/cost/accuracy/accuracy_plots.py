#!/usr/bin/env python3
"""Draws the studies of docs/accuracy-and-cost.md and docs/dispersion.md into a folder.

    cost_travelling_pulse > pulse.csv
    cost_dispersion > dispersion.csv
    cost_manufactured > manufactured.csv
    cost_scatterer > scatterer.csv
    accuracy_plots.py docs/pictures --pulse pulse.csv --manufactured manufactured.csv --scatterer scatterer.csv \\
        --slope runs/softening-scaled runs/softening-as-given runs/uniform
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
    "FE lumped same step": ("0.5", ":"),
    "APIC usl": (style.COLOURS[0], ":"),
    "FLIP musl": (style.COLOURS[1], "-"),
    "FLIP usl": (style.COLOURS[1], ":"),
    "APIC musl 3x3 particles": (style.COLOURS[2], "-"),
}


def rows(path):
    """Rows of a table as dictionaries, numbers as such."""
    with open(path, encoding="utf-8", newline="") as file:
        for row in csv.DictReader(file):
            yield {key: value if key in ("scheme", "scene", "mesh", "boxes") else float(value) for key, value in row.items()}


def pulse(path, folder):
    """Error, phase and amplitude after ten wavelengths against cells per wavelength."""
    schemes = defaultdict(list)
    for row in rows(path):
        schemes[row["scheme"]].append(row)
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


def dispersion(path, folder):
    """Error of pulses with plain and reduced dispersion against cells per wavelength, a panel for each wave."""
    scenes = defaultdict(list)
    for row in rows(path):
        scenes[row["scene"]].append(row)
    panels = {
        "ten wavelengths along an axis": ("SV along an axis", "P along an axis"),
        "six wavelengths at 45 degrees": ("SV at 45 degrees", "P at 45 degrees"),
        "surface and base": ("SV reflected by a free surface", "SV left behind by the base"),
    }
    figure, axes = style.plt.subplots(1, 3, figsize=(10.5, 3.8), layout="constrained", sharey=True)
    ticks = [8, 12, 16, 24, 32, 48]
    for ax, (title, names) in zip(axes, panels.items()):
        for name, colour in zip(names, style.COLOURS):
            cells = [row["cells_per_wavelength"] for row in scenes[name]]
            for scheme, line in (("plain", ":"), ("reduced", "-")):
                ax.loglog(cells, [100 * row[scheme] for row in scenes[name]], color=colour, linestyle=line, marker="o",
                          markersize=3, label=f"{name}, {scheme}")
        ax.set(title=title, xlabel="cells to the wavelength", xticks=ticks, xticklabels=ticks)
        ax.minorticks_off()
        ax.legend(fontsize=6)
    axes[0].set_ylabel("error, relative L2 (%)")
    return style.save(figure, folder, "dispersion.png")


def manufactured(path, folder):
    """Error of displacement against cells along the block, a panel for each amplitude."""
    panels = defaultdict(lambda: defaultdict(list))
    for row in rows(path):
        if row["scheme"].endswith("musl"):
            label = f"{row['scheme'].split()[0]}, {row['particles_per_cell']:.0f} a direction"
            if row["boxes"] == "deforming":
                label += ", boxes follow the soil"
            panels[row["amplitude"]][label].append((row["cells"], row["relative_error"]))
    figure, axes = style.plt.subplots(1, len(panels), figsize=(10.5, 3.6), sharey=True, layout="constrained")
    for ax, (amplitude, curves) in zip(axes, panels.items()):
        for label, points in curves.items():
            cells, error = np.array(points).T
            particles = int(label.split()[1])
            ax.loglog(
                cells,
                100 * error,
                ":" if "follow" in label else "-" if label.startswith("APIC") else "--",
                color=style.COLOURS[particles - 1],
                marker="o",
                markersize=3,
                label=label,
            )
        slope = 100 * 0.03 * (8 / cells) ** 2
        ax.loglog(cells, slope, "k-.", linewidth=0.8, label="second order")
        ax.set(xlabel="cells along the block", title=f"A/L = {amplitude:g}", xticks=cells)
        ax.set_xticklabels([f"{n:.0f}" for n in cells])
        ax.minorticks_off()
    axes[0].set_ylabel("error of displacement (% of A)")
    axes[-1].legend(fontsize=6, loc="center left", bbox_to_anchor=(1.0, 0.5))
    return style.save(figure, folder, "cost_manufactured.png")


def scatterer(path, folder):
    """Error against CPU time of uniform and graded meshes."""
    meshes = defaultdict(list)
    for row in rows(path):
        meshes[row["mesh"]].append(row)
    figure, ax = style.plt.subplots(figsize=(5.2, 3.8), layout="constrained")
    for mesh, look in (("uniform", "o-"), ("graded", "s--"), ("graded with sub-cycling", "^:")):
        table = meshes[mesh]
        ax.loglog([r["cpu_s"] for r in table], [100 * r["relative_error"] for r in table], look, label=mesh)
        for r in table:
            point = (r["cpu_s"], 100 * r["relative_error"])
            ax.annotate(f"{r['coarsest']:g} m", point, fontsize=7, xytext=(5, 4), textcoords="offset points")
    ax.set(xlabel="CPU time (s)", ylabel="error (%)", title="coarsest cells; the finest of graded meshes are 0.25 m")
    ax.legend()
    return style.save(figure, folder, "cost_scatterer.png")


def crest(folder):
    """Time and displacement of the crest in a run."""
    with Run(folder) as run:
        series = run.monitor("crest")
        return series["time"], np.hypot(series["ux"], series["uy"])


def slope(regular, plain, finest, folder):
    """Displacement of the crest over time for every cell size, softening scaled to the cells and not; the finest
    run, with the cells that the softening is given for, belongs to both."""
    figure, axes = style.plt.subplots(1, 2, figsize=(9.6, 3.6), sharey=True, layout="constrained")
    for ax, ladder, title in zip(axes, (regular, plain), ("softening scaled to the cells", "softening as given")):
        for rung in json.loads((ladder / "cost.json").read_text())["rungs"]:
            ax.plot(*crest(ladder / rung["folder"]), label=f"h = {rung['size']:g} m")
        ax.plot(*crest(finest), "k", label="h = 0.25 m")
        ax.set(xlabel="t (s)", title=title)
        ax.legend(loc="upper left")
    axes[0].set_ylabel("displacement of the crest (m)")
    return style.save(figure, folder, "cost_slope_softening.png")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--pulse", type=Path)
    parser.add_argument("--dispersion", type=Path)
    parser.add_argument("--manufactured", type=Path)
    parser.add_argument("--scatterer", type=Path)
    parser.add_argument("--slope", type=Path, nargs=3, metavar=("SCALED", "AS_GIVEN", "FINEST"))
    given = parser.parse_args()
    if given.pulse:
        print(pulse(given.pulse, given.folder))
    if given.dispersion:
        print(dispersion(given.dispersion, given.folder))
    if given.manufactured:
        print(manufactured(given.manufactured, given.folder))
    if given.scatterer:
        print(scatterer(given.scatterer, given.folder))
    if given.slope:
        print(slope(*given.slope, given.folder))


if __name__ == "__main__":
    main()
