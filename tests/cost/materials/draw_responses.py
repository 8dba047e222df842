#!/usr/bin/python3
"""Pictures of the laws' responses for docs/materials.

    <build>/bin/cost/cost_materials_responses > responses.csv
    tests/cost/materials/draw_responses.py responses.csv docs/materials/pictures
"""
import csv
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[3] / "python"))

import numpy as np
from tremolo.style import COLOURS, plt

SHEAR = ("shear strain (%)", "shear stress (kPa)")
COMPRESSION = ("axial strain (%)", "axial stress (kPa)")
# Above it a cone matched to triaxial compression has no strength limit in plane strain: its slope in sqrt(J2) over p,
# 6 sin(phi)/(sqrt(3) (3 - sin(phi))), reaches 1.
UNLIMITED = float(np.degrees(np.arcsin(3.0 * np.sqrt(3.0) / (6.0 + np.sqrt(3.0)))))

# file: its panels (data, title, axis labels, logarithmic strain)
PICTURES = {
    "linear-elastic.png": [
        ("elastic_oedometer", "oedometer: one line, $K_0 = \\nu/(1 - \\nu)$", ("vertical strain (%)", "stress (kPa)"),
         False),
        ("elastic_shear", "large simple shear: where the rate form ends", SHEAR, False),
    ],
    "mohr-coulomb.png": [
        ("mc_compression", "softening, plane-strain compression at 50 kPa", COMPRESSION, False),
        ("mc_shear", "drained simple shear at 100 kPa, $K_0$ = 0.5", SHEAR, False),
    ],
    "drucker-prager.png": [
        ("dp_compression", "plane-strain compression at 100 kPa, φ = 30°, ψ = 0", COMPRESSION, False),
        ("dp_mobilised", "friction mobilised in plane strain, ψ = 0",
         ("friction angle given (degrees)", "mobilised (degrees)"), False),
    ],
    "multi-yield-clay.png": [
        ("clay_loops", "cycles of 0.2, 0.5 and 2 %, $s_u$ = 50 kPa", SHEAR, False),
        ("clay_strength", "static shear is part of the strength", SHEAR, False),
    ],
    "hysteretic.png": [
        ("hysteretic_loops", "loops", SHEAR, False),
        ("hysteretic_modulus", "modulus", ("shear strain (%)", "G / Gmax"), True),
        ("hysteretic_damping", "damping of the Masing loop", ("shear strain (%)", "damping ratio (%)"), True),
    ],
}


def read(path):
    """(x, y) of every series of every panel, in order of first appearance."""
    panels = {}
    with open(path) as lines:
        for row in csv.DictReader(lines):
            x, y = panels.setdefault(row["picture"], {}).setdefault(row["series"], ([], []))
            x.append(float(row["x"]))
            y.append(float(row["y"]))
    return panels


def look(series):
    """Exact solutions wide and grey, coarse steps as dots, the rest as lines."""
    if series in ("exact", "Mohr-Coulomb"):
        return {"color": "0.72", "linewidth": 3.5}
    if series == "steps of 1 %":
        return {"linestyle": "none", "marker": "o", "markersize": 4, "color": COLOURS[1]}
    return {}


def label(series):
    """A series of the table in the letters of the field."""
    return series.replace("psi =", "ψ =").replace(" s_u", " $s_u$")


def end_where_unlimited(ax, x, y):
    """The curve up to the angle from which on there is no limit, and that angle."""
    below = np.asarray(y) < 90.0
    ax.axvline(UNLIMITED, color="0.75", linewidth=0.6, zorder=0)
    ax.annotate(f"no limit from {UNLIMITED:.1f}° on", (UNLIMITED, 90.0), (-6, 0), textcoords="offset points",
                ha="right", va="center", fontsize=8)
    return [*np.asarray(x)[below], UNLIMITED], [*np.asarray(y)[below], 90.0]


def draw_panel(ax, name, series_of_panel, title, labels, logarithmic):
    order = sorted(series_of_panel.items(), key=lambda item: item[0] not in ("exact", "Mohr-Coulomb"))
    for series, (x, y) in order:
        if name == "dp_mobilised" and max(y) >= 90.0:
            x, y = end_where_unlimited(ax, x, y)
        ax.plot(x, y, label=label(series), **look(series))
    ax.set(xlabel=labels[0], ylabel=labels[1], title=title)
    ax.grid(color="0.92", linewidth=0.5)
    if logarithmic:
        ax.set_xscale("log")
    if len(order) > 1:
        ax.legend()


def draw(panels, wanted, picture):
    size = (9.5 if len(wanted) == 2 else 11.5, 3.6)
    figure, axes = plt.subplots(1, len(wanted), figsize=size, layout="constrained")
    for ax, (name, *description) in zip(axes, wanted):
        draw_panel(ax, name, panels[name], *description)
    figure.savefig(picture, dpi=110)
    plt.close(figure)


def main(source, folder):
    panels = read(source)
    for picture, wanted in PICTURES.items():
        draw(panels, wanted, Path(folder) / picture)


if __name__ == "__main__":
    main(*sys.argv[1:3])
