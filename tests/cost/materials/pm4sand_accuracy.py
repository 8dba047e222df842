#!/usr/bin/python3
"""Picture of what accuracy costs with PM4Sand.

    <build>/bin/cost/cost_pm4sand_accuracy > accuracy.csv
    tests/cost/materials/pm4sand_accuracy.py accuracy.csv docs/materials/pictures/pm4sand_accuracy.png
"""

import csv
import math
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[3] / "python"))

from matplotlib.lines import Line2D
from tremolo.style import COLOURS, plt

RING = {"marker": "o", "markersize": 8, "markerfacecolor": "none", "linestyle": "none"}
DEFAULT_STRAIN, DEFAULT_TOLERANCE = 1e-5, 1e-4


def read(path):
    with open(path) as lines:
        return [{name: float(value) for name, value in row.items()} for row in csv.DictReader(lines)]


def power(value):
    return f"$10^{{{round(math.log10(value))}}}$"


def legend_below(ax, *more):
    """Legend under the axes, out of the curves, with what else is drawn."""
    handles = [*ax.get_legend_handles_labels()[0], *more]
    ax.legend(handles=handles, loc="upper center", bbox_to_anchor=(0.5, -0.16), ncols=3, columnspacing=1.2)


def draw_cycles(ax, rows):
    for color, tolerance in zip(COLOURS[3::-1], (1e-2, 1e-3, 1e-4, 1e-5)):
        for strain, line in ((DEFAULT_STRAIN, "o-"), (1e-2, "o:")):
            chosen = [r for r in rows if r["tolerance"] == tolerance and r["largest_strain"] == strain]
            label = f"tolerance {power(tolerance)}" if strain == DEFAULT_STRAIN else None
            ax.loglog([r["increment"] for r in chosen], [r["cycles_error"] for r in chosen], line, color=color,
                      markersize=3, label=label)
    ax.set(title=r"cycles to 3 % strain, 14.2 converged; sub-steps $\leq 10^{-5}$", xlabel="increment of shear strain",
           ylabel="error (cycles)")
    legend_below(ax, Line2D([], [], color="0.4", linestyle=":", label="sub-steps of any size,\nall tolerances"))


def draw_work(ax, rows):
    for color, increment in zip(COLOURS, (1e-6, 1e-5, 1e-4, 1e-3)):
        chosen = [r for r in rows if r["increment"] == increment and r["largest_strain"] == DEFAULT_STRAIN]
        time = [1e-3 * r["microseconds"] for r in chosen]
        error = [100.0 * r["stress_error"] for r in chosen]
        ax.loglog(time, error, "o-", color=color, markersize=3, label=f"increments {power(increment)}")
        default = [i for i, r in enumerate(chosen) if r["tolerance"] == DEFAULT_TOLERANCE]
        ax.loglog([time[i] for i in default], [error[i] for i in default], color=color, **RING)
    ax.set(title="error in stress against time", xlabel="time of 6 cycles of 0.1 % and 2 of 1 % strain (ms)",
           ylabel="error (% of the initial vertical stress)")
    ax.set_xticks([4, 6, 10, 20, 40], ["4", "6", "10", "20", "40"], minor=False)
    ax.set_xticks([], minor=True)
    legend_below(ax, Line2D([], [], color="0.4", label=f"tolerance {power(DEFAULT_TOLERANCE)}", **RING))


def main(source, picture):
    rows = read(source)
    figure, (cycles, work) = plt.subplots(1, 2, figsize=(9.0, 4.2), layout="constrained")
    draw_cycles(cycles, rows)
    draw_work(work, rows)
    for ax in (cycles, work):
        ax.grid(color="0.92", linewidth=0.5)
    figure.savefig(picture, dpi=110)


if __name__ == "__main__":
    main(*sys.argv[1:3])
