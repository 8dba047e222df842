#!/usr/bin/python3
"""Picture of stress-strain loops and fitted curves.

    <build>/bin/cost/cost_materials_loops > loops.csv
    tests/cost/materials/draw_loops.py loops.csv docs/free-fields/pictures/masing-loops.png
"""
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt


def read(path):
    """Columns of each series by its name, in order of first appearance."""
    series = {}
    with open(path) as lines:
        for line in lines:
            name, *values = line.strip().split(",")
            if name not in ("model", "curve"):
                columns = series.setdefault(name, [[] for _ in values])
                for column, value in zip(columns, values):
                    column.append(float(value))
    return series


def main(source, picture):
    series = read(source)
    figure, (left, middle, right) = plt.subplots(1, 3, figsize=(11.5, 3.8))
    for name, style in (("masing", "k-"), ("iwan", "C1--")):
        strain, stress = series[name]
        label = {"masing": "MasingShear (exact rules)", "iwan": "IwanShear, 32 elements"}[name]
        left.plot([100 * g for g in strain], [t / 1e3 for t in stress], style, lw=1.0, label=label)
    left.set(xlabel="shear strain, %", ylabel="shear stress, kPa", title="one irregular path")
    left.legend(fontsize=7, loc="upper left")
    for name, style in (("darendeli", "ko"), ("mkz", "C0-")):
        strain, modulus, damping = series[name]
        label = {"darendeli": "Darendeli (2001), PI 15, 1 atm", "mkz": "fitted MKZ, Masing rules"}[name]
        percent = [100 * g for g in strain]
        middle.semilogx(percent, modulus, style, ms=3, label=label)
        right.semilogx(percent, [100 * d for d in damping], style, ms=3, label=label)
    middle.set(xlabel="shear strain, %", ylabel="G/Gmax", title="modulus")
    middle.legend(fontsize=7)
    right.set(xlabel="shear strain, %", ylabel="damping ratio, %", title="damping")
    right.legend(fontsize=7)
    for axes in (left, middle, right):
        axes.grid(alpha=0.3)
    figure.tight_layout()
    figure.savefig(picture, dpi=110)


if __name__ == "__main__":
    main(*sys.argv[1:3])
