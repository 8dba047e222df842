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
CAP, LEAST, TOLERANCE = 1e-3, 1e-7, 1e-4  # the law's own


def read(path):
    """The rows of the study, each once: the law's own values are on both of its axes."""
    with open(path) as lines:
        rows = [{name: float(value) for name, value in row.items()} for row in csv.DictReader(lines)]
    return list({tuple(row[key] for key in list(row)[:4]): row for row in rows}.values())


def power(value):
    return f"$10^{{{round(math.log10(value))}}}$"


def legend_below(ax, *more):
    """Legend under the axes, out of the curves, with what else is drawn."""
    handles = [*ax.get_legend_handles_labels()[0], *more]
    ax.legend(handles=handles, loc="upper center", bbox_to_anchor=(0.5, -0.16), ncols=3, columnspacing=1.2)


def draw_cycles(ax, rows):
    """The error in cycles against the least sub-step, for two caps."""
    for color, increment in zip(COLOURS, (1e-5, 1e-4, 1e-3)):
        for cap, line in ((CAP, "o-"), (1e-5, "o:")):
            chosen = [r for r in rows if r["tolerance"] == TOLERANCE and r["largest_strain"] == cap
                      and r["increment"] == increment]
            chosen.sort(key=lambda r: r["smallest_strain"])
            label = f"increments {power(increment)}" if cap == CAP else None
            ax.loglog([r["smallest_strain"] for r in chosen], [max(r["cycles_error"], 1e-4) for r in chosen], line,
                      color=color, markersize=3, label=label)
    ax.set(title="cycles to 3 % strain, 14.2 converged", xlabel="least sub-step", ylabel="error (cycles)")
    legend_below(ax, Line2D([], [], color="0.4", linestyle=":", label=f"sub-steps of {power(1e-5)} at most"))


def draw_work(ax, rows):
    for color, increment in zip(COLOURS, (1e-6, 1e-5, 1e-4, 1e-3)):
        chosen = [r for r in rows if r["increment"] == increment and r["largest_strain"] == CAP
                  and r["smallest_strain"] == LEAST]
        chosen.sort(key=lambda r: r["tolerance"])
        time = [1e-3 * r["microseconds"] for r in chosen]
        error = [100.0 * r["stress_error"] for r in chosen]
        ax.loglog(time, error, "o-", color=color, markersize=3, label=f"increments {power(increment)}")
        own = [i for i, r in enumerate(chosen) if r["tolerance"] == TOLERANCE]
        ax.loglog([time[i] for i in own], [error[i] for i in own], color=color, **RING)
    ax.set(title="error in stress against time", xlabel="time of 6 cycles of 0.1 % and 2 of 1 % strain (ms)",
           ylabel="error (% of the initial vertical stress)")
    legend_below(ax, Line2D([], [], color="0.4", label=f"tolerance {power(TOLERANCE)}", **RING))


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
