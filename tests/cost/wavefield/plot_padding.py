"""Error of the wavefield against CPU time, one point a window length: plot_padding.py padding.csv OUT.png."""

import csv
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

COLOURS = ["#0072B2", "#D55E00", "#009E73", "#CC79A7"]


def main(table, picture):
    with open(table, newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    figure, ax = plt.subplots(figsize=(7.2, 4.0), layout="constrained", dpi=110)
    for colour, ground in zip(COLOURS, dict.fromkeys(row["ground"] for row in rows)):
        mine = [row for row in rows if row["ground"] == ground]
        given = [row for row in mine if row["padding"] != "0"]
        chosen = [row for row in mine if row["padding"] == "0"]
        ax.loglog([float(row["cpu_s"]) for row in given], [max(float(row["error"]), 1e-16) for row in given], "o-",
                  color=colour, label=ground, markersize=4)
        ax.loglog([float(row["cpu_s"]) for row in chosen], [max(float(row["error"]), 1e-16) for row in chosen], "*",
                  color=colour, markersize=11)
    ax.set(xlabel="CPU time, 81 levels, velocity, stress and rates (s)", ylabel="largest error of surface velocity / peak")
    ax.set_title("window of 1, 2, 4 ... 64 times signal and record; star: as chosen by itself", fontsize=9)
    ax.legend(fontsize=8, frameon=False)
    ax.spines[["top", "right"]].set_visible(False)
    figure.savefig(picture)


if __name__ == "__main__":
    main(*sys.argv[1:])
