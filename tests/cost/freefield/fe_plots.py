#!/usr/bin/env python3
"""Draws the response of PRENOLIN's profile P1 into a folder.

    cost_fe_prenolin $TREMOLO_REFERENCE/records/prenolin_P1_sem2dpack/inputp1 > p1.csv
    fe_plots.py docs/free-fields/pictures p1.csv
"""

import argparse
import csv
import pathlib
from collections import defaultdict

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

def prenolin(path, folder):
    history = defaultdict(list)
    peak = defaultdict(list)
    with open(path, encoding="utf-8") as file:
        for kind, name, *numbers in csv.reader(file):
            (history if kind == "history" else peak)[name].append([float(x) for x in numbers])
    figure, axes = plt.subplots(1, 3, figsize=(11.0, 3.8), width_ratios=[1.7, 0.8, 1.2])
    for name, style in (("linear", "C7-"), ("hyperbolic", "C3-")):
        rows = list(zip(*history[name]))
        axes[0].plot(rows[0], rows[2], style, label=f"surface, {name}", linewidth=0.9)
        depth, strain = zip(*peak[name])
        axes[1].plot([100.0 * s for s in strain], depth, style, label=name)
    rows = list(zip(*history["hyperbolic"]))
    axes[0].plot(rows[0], rows[1], "k:", label="base", linewidth=0.9)
    axes[0].set(xlabel="time (s)", ylabel="acceleration (m/s²)", xlim=(0.0, 3.0), ylim=(-6.0, 4.0))
    axes[0].legend(fontsize=8, loc="lower right")
    axes[1].set(xlabel="peak shear strain (%)", ylabel="depth (m)", ylim=(20.0, 0.0), xlim=(0.0, None))
    axes[1].legend(fontsize=8)
    axes[2].plot([100.0 * g for g in rows[4]], [s / 1e3 for s in rows[5]], "C3-", linewidth=0.9)
    axes[2].set(xlabel="shear strain (%)", ylabel="shear stress (kPa)")
    for axis in axes:
        axis.grid(True, alpha=0.4)
    figure.tight_layout()
    figure.savefig(folder / "fe-prenolin-p1.png", dpi=110)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("table", type=pathlib.Path)
    arguments = parser.parse_args()
    prenolin(arguments.table, arguments.folder)


if __name__ == "__main__":
    main()
