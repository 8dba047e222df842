"""Error against CPU time of boxes of four widths, by absorber: one panel a scene and angle.

    usage: plot_absorbers.py CSV PNG         the CSV is what cost_absorbers prints
"""

import csv
import sys
from collections import defaultdict

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter

STYLES = {"dashpots": "k--", "springs 0.5": "C0-", "springs 1": "C1-", "springs 2": "C2-", "layers 5": "C3-", "layers 10": "C4-",
          "layers 10, base springs 1": "C5-"}
SCENES = {"weight moved by 12 m": "settlement, weight moved by 12 m", "canyon": "motion, canyon", "block": "motion, heavy block",
          "slope": "motion, slope"}


def read(table):
    """Width (m), CPU time (s) and error (%) by scene and angle, and by absorber."""
    curves = defaultdict(lambda: defaultdict(list))
    with open(table) as file:
        for row in csv.DictReader(file):
            point = float(row["width_m"]), float(row["cpu_s"]), 100.0 * float(row["error"])
            curves[row["scene"], float(row["angle_deg"])][row["absorber"]].append(point)
    return curves


def draw(axes, curves):
    for absorber, points in curves.items():
        widths, times, errors = zip(*points)
        axes.plot(times, errors, STYLES[absorber] + "o", markersize=4, label=absorber)
        for width, time, error in points if absorber == "dashpots" else ():
            axes.annotate(f"{width:g} m", (time, error), textcoords="offset points", xytext=(3, 5), fontsize=7)
    axes.set(xscale="log", yscale="log")
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_major_locator(LogLocator(subs=(1, 2, 5)))
        axis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
        axis.set_minor_formatter(NullFormatter())
    axes.grid(alpha=0.3)


def main(table, picture):
    curves = read(table)
    figure, panels = plt.subplots(2, len(SCENES), figsize=(15.0, 8.0), layout="constrained")
    for row, angle in zip(panels, (0.0, 15.0)):
        for axes, (scene, name) in zip(row, SCENES.items()):
            if (scene, angle) in curves:
                draw(axes, curves[scene, angle])
                axes.set_title(name if scene.startswith("weight") else f"{name}, SV at {angle:g} degrees")
            else:
                axes.axis("off")
                axes.legend(*panels[0][0].get_legend_handles_labels(), loc="center", title="absorber")
        row[0].set_ylabel("error (%)")
    for axes in panels[1]:
        axes.set_xlabel("CPU time (s)")
    panels[0][0].set_xlabel("CPU time (s)")
    figure.savefig(picture, dpi=100)


if __name__ == "__main__":
    main(*sys.argv[1:])
