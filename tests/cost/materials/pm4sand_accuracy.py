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

from tremolo.style import plt

DEFAULT_STRAIN, DEFAULT_TOLERANCE = 1e-5, 1e-4


def read(path):
    with open(path) as lines:
        return [{name: float(value) for name, value in row.items()} for row in csv.DictReader(lines)]


def power(value):
    return f"$10^{{{round(math.log10(value))}}}$"


def main(source, picture):
    rows = read(source)
    figure, (count, work) = plt.subplots(1, 2, figsize=(9.0, 3.6), layout="constrained")

    for color, tolerance in zip(("C3", "C1", "C0", "C2"), (1e-2, 1e-3, 1e-4, 1e-5)):
        for strain, line in ((DEFAULT_STRAIN, "o-"), (1e-2, "o:")):
            chosen = [r for r in rows if r["tolerance"] == tolerance and r["largest_strain"] == strain]
            label = f"tolerance {power(tolerance)}" if strain == DEFAULT_STRAIN else None
            count.loglog([r["increment"] for r in chosen], [r["cycles_error"] for r in chosen], line, color=color,
                         ms=3, label=label)
    count.set(title="error in cycles to 3 % strain", xlabel="increment of shear strain", ylabel="cycles, of 14.2")
    count.set_ylim(top=1e5)
    count.legend(title=r"sub-steps $\leq 10^{-5}$ (dotted: any size)", fontsize=8, title_fontsize=8)

    for color, increment in zip(("C0", "C1", "C2", "C4"), (1e-6, 1e-5, 1e-4, 1e-3)):
        chosen = [r for r in rows if r["increment"] == increment and r["largest_strain"] == DEFAULT_STRAIN]
        time = [1e-3 * r["microseconds"] for r in chosen]
        error = [100.0 * r["stress_error"] for r in chosen]
        work.loglog(time, error, "o-", color=color, ms=3, label=f"increments {power(increment)}")
        work.loglog(*[[values[i] for i, r in enumerate(chosen) if r["tolerance"] == DEFAULT_TOLERANCE]
                      for values in (time, error)], "o", color=color, ms=8, mfc="none")
    work.set(title="error in stress against time", xlabel="time of 6 cycles of 0.1 % and 2 of 1 % (ms)",
             ylabel="% of the initial vertical stress")
    work.set_xticks([4, 6, 10, 20, 40], ["4", "6", "10", "20", "40"], minor=False)
    work.set_xticks([], minor=True)
    work.legend(title=r"ring: tolerance $10^{-4}$", fontsize=8, title_fontsize=8)

    for axes in (count, work):
        axes.grid(alpha=0.25)
    figure.savefig(picture, dpi=110)


if __name__ == "__main__":
    main(*sys.argv[1:3])
