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


def main(table, picture):
    curves = defaultdict(list)
    with open(table) as file:
        for row in csv.DictReader(file):
            if row["absorber"] in ("dashpots", "layers"):
                curves[row["base"], row["absorber"]].append((float(row["width_m"]), 100.0 * float(row["error"])))
    figure, axes = plt.subplots(figsize=(7.0, 4.2), layout="constrained")
    axes.plot(*zip(*curves["incident", "dashpots"]), "k--o", label="dashpots, any field")
    for (base, absorber), points in curves.items():
        if absorber == "layers":
            axes.plot(*zip(*points), "-o", markersize=4, label=f"layers, {LAYERS[base]}")
    axes.set(xscale="log", yscale="log", xlabel="width of the box (m), slope of 10 m in its middle",
             ylabel="error of particle velocity (%)")
    ticks = sorted({width for points in curves.values() for width, _ in points})
    axes.set_xticks(ticks, [f"{width:g}" for width in ticks])
    axes.minorticks_off()
    axes.set_yticks([1, 2, 5, 10, 20], ["1", "2", "5", "10", "20"])
    axes.grid(alpha=0.3)
    axes.legend(fontsize=8)
    figure.savefig(picture, dpi=120)


if __name__ == "__main__":
    main(*sys.argv[1:])
