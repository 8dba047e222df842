"""Error of the motion around a slope against the width of the box, by base field and absorber.

    usage: plot_base_forms.py CSV PNG        the CSV is what cost_base_forms prints
"""

import csv
import sys
from collections import defaultdict

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

LAYERS = {"incident": "incident", "step": "left total field, then right", "blend": "blended under the slope",
          "across": "blended over the whole base", "ends": "incident, blended to total at the ends",
          "local": "total field under the ground above"}


def read(table):
    """Width (m) and error (%) by angle, base field and absorber."""
    curves = defaultdict(lambda: defaultdict(list))
    with open(table) as file:
        for row in csv.DictReader(file):
            if row["absorber"] in ("dashpots", "layers"):
                curves[float(row["angle_deg"])][row["base"], row["absorber"]].append((float(row["width_m"]), 100.0 * float(row["error"])))
    return curves


def draw(axes, curves):
    colours = {base: f"C{i}" for i, base in enumerate(LAYERS)}
    at_one_place = len({tuple(points) for (base, absorber), points in curves.items() if absorber == "dashpots"}) == 1
    for (base, absorber), points in curves.items():
        if absorber == "layers":
            axes.plot(*zip(*points), "-o", color=colours[base], markersize=4, label=f"layers, {LAYERS[base]}")
        elif not at_one_place:
            axes.plot(*zip(*points), "--o", color=colours[base], markersize=3, label=f"dashpots, {LAYERS[base]}")
    if at_one_place:
        axes.plot(*zip(*curves["incident", "dashpots"]), "k--o", label="dashpots, any field")
    ticks = sorted({width for points in curves.values() for width, _ in points})
    axes.set(xscale="log", yscale="log", xlabel="width of the box (m), slope of 10 m in its middle")
    axes.set_xticks(ticks, [f"{width:g}" for width in ticks])
    axes.set_yticks([1, 2, 5, 10, 20], ["1", "2", "5", "10", "20"])
    axes.minorticks_off()
    axes.grid(alpha=0.3)
    axes.legend(fontsize=7, handlelength=4)


def main(table, picture):
    angles = read(table)
    figure, panels = plt.subplots(1, len(angles), figsize=(6.0 * len(angles), 5.0), layout="constrained", sharey=True, squeeze=False)
    for axes, (angle, curves) in zip(panels[0], sorted(angles.items())):
        draw(axes, curves)
        axes.set_title(f"SV at {angle:g} degrees")
    panels[0][0].set_ylabel("error of particle velocity (%)")
    figure.savefig(picture, dpi=120)


if __name__ == "__main__":
    main(*sys.argv[1:])
