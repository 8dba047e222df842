#!/usr/bin/python3
"""Picture of what accuracy costs with PDMY03.

    <build>/bin/cost/cost_pdmy03_accuracy > accuracy.csv
    tests/cost/materials/pdmy03_accuracy.py accuracy.csv docs/materials/pictures/pdmy03_accuracy.png
"""

import csv
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[3] / "python"))

from tremolo.style import plt


def read(path):
    """Columns of each relative density."""
    densities = {}
    with open(path) as lines:
        for row in csv.DictReader(lines):
            columns = densities.setdefault(float(row.pop("relative_density")), {name: [] for name in row})
            for name, value in row.items():
                columns[name].append(float(value))
    return densities


def main(source, picture):
    figure, (count, stress, time) = plt.subplots(1, 3, figsize=(9.6, 3.0), layout="constrained")
    for density, columns in read(source).items():
        label = f"$D_R$ {100 * density:.0f} %"
        increment = columns["increment"]
        count.loglog(increment, [abs(e) for e in columns["cycles_error"]], "o-", ms=3, label=label)
        stress.loglog(increment, [100 * e for e in columns["stress_error"]], "o-", ms=3, label=label)
        time.loglog(increment, columns["microseconds_per_cycle"], "o-", ms=3, label=label)
    count.set(title="error in cycles to 3 % strain", ylabel="cycles, of 12 to 15")
    stress.set(title="error in stress, cycles of 0.1 % strain", ylabel="% of the initial vertical stress")
    time.set(title="time of a cycle of 0.1 % strain", ylabel=r"$\mu$s")
    for axes in (count, stress, time):
        axes.set_xlabel("increment of shear strain")
        axes.axvline(2e-5, color="0.7", lw=0.8, ls="--", zorder=0)
        axes.grid(alpha=0.25)
    count.legend()
    figure.savefig(picture, dpi=110)


if __name__ == "__main__":
    main(*sys.argv[1:3])
