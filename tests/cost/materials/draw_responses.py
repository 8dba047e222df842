#!/usr/bin/python3
"""Pictures of the laws' responses for docs/materials.

    <build>/bin/cost/cost_materials_responses > responses.csv
    tests/cost/materials/draw_responses.py responses.csv docs/materials/pictures
"""
import csv
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

SHEAR = ("shear strain, %", "shear stress, kPa")
COMPRESSION = ("axial strain, %", "axial stress, kPa")

# file: its panels (data, title, axis labels, logarithmic strain)
PICTURES = {
    "linear-elastic.png": [
        ("elastic_oedometer", "oedometer: one line, K0 = nu/(1 - nu)", ("vertical strain, %", "stress, kPa"), False),
        ("elastic_shear", "large simple shear: where the rate form ends", SHEAR, False),
    ],
    "mohr-coulomb.png": [
        ("mc_compression", "softening, plane-strain compression at 50 kPa", COMPRESSION, False),
        ("mc_shear", "drained simple shear at 100 kPa, K0 = 0.5", SHEAR, False),
    ],
    "drucker-prager.png": [
        ("dp_compression", "plane-strain compression at 100 kPa, phi = 30, psi = 0", COMPRESSION, False),
        ("dp_mobilised", "friction mobilised in plane strain, psi = 0",
         ("friction angle given, degrees", "mobilised, degrees"), False),
    ],
    "multi-yield-clay.png": [
        ("clay_loops", "cycles of 0.2, 0.5 and 2 %, s_u = 50 kPa", SHEAR, False),
        ("clay_strength", "static shear is part of the strength", SHEAR, False),
    ],
    "hysteretic.png": [
        ("hysteretic_loops", "loops", SHEAR, False),
        ("hysteretic_modulus", "modulus", ("shear strain, %", "G/Gmax"), True),
        ("hysteretic_damping", "damping of the Masing loop", ("shear strain, %", "damping ratio, %"), True),
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


def style(series):
    """Exact solutions wide and grey, coarse steps as dots, the rest as lines."""
    if series in ("exact", "Mohr-Coulomb"):
        return {"color": "0.75", "lw": 4}
    if series == "steps of 1 %":
        return {"ls": "none", "marker": "o", "ms": 4, "color": "C3"}
    return {"lw": 1.2}


def draw(panels, wanted, picture):
    figure, axes = plt.subplots(1, len(wanted), figsize=(9.5 if len(wanted) == 2 else 11.5, 3.6))
    for axis, (name, title, labels, logarithmic) in zip(axes, wanted):
        order = sorted(panels[name].items(), key=lambda item: item[0] not in ("exact", "Mohr-Coulomb"))
        for series, (x, y) in order:
            axis.plot(x, y, label=series, **style(series))
        axis.set(xlabel=labels[0], ylabel=labels[1])
        axis.set_title(title, fontsize=9)
        axis.grid(alpha=0.3)
        if logarithmic:
            axis.set_xscale("log")
        if len(order) > 1:
            axis.legend(fontsize=7)
    figure.tight_layout()
    figure.savefig(picture, dpi=110)
    plt.close(figure)


def main(source, folder):
    panels = read(source)
    for picture, wanted in PICTURES.items():
        draw(panels, wanted, pathlib.Path(folder) / picture)


if __name__ == "__main__":
    main(*sys.argv[1:3])
