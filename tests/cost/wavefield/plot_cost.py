"""Draws what `cost_wavefield --benchmark_out=cost.json --benchmark_out_format=json` measured.

usage: plot_cost.py cost.json picture.png
"""

import json
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt


def cpu_seconds(runs, name):
    rows = [run for run in runs if run["name"].split("/")[0] == name]
    return [int(run["name"].split("/")[1]) for run in rows], [1e-3 * run["cpu_time"] for run in rows]


def main(measured, picture):
    with open(measured, encoding="utf-8") as stream:
        runs = json.load(stream)["benchmarks"]
    panels = [
        ("layers (100 points)", {"undamped": "layers", "Kelvin-Voigt": "layers_kelvin_voigt"}),
        (
            "points (5 layers)",
            {"velocity": "points", "velocity, hysteretic": "points_hysteretic", "velocity and stress": "points_with_stress"},
        ),
        ("samples (100 points, 5 layers)", {"undamped": "samples"}),
    ]
    figure, axes = plt.subplots(1, 3, figsize=(10.5, 3.3))
    for axis, (label, lines) in zip(axes, panels):
        for text, name in lines.items():
            axis.loglog(*cpu_seconds(runs, name), "o-", markersize=4, label=text)
        axis.set_xlabel(label)
        axis.grid(True, which="both", linewidth=0.3)
        axis.legend(fontsize=8)
    axes[0].set_ylabel("CPU time, s")
    figure.suptitle("LayeredField::sample, 16384 samples a point where not on the axis", fontsize=10)
    figure.tight_layout()
    figure.savefig(picture, dpi=110)


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2])
