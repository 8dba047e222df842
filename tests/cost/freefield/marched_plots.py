#!/usr/bin/env python3
"""Draws the work-precision diagram of the column at an angle.

    cost_marched_work_precision > wp.csv
    marched_plots.py wp.csv docs/free-fields/pictures/marched-work-precision.png
"""

import csv
import sys
from collections import defaultdict

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

MARKS = {"element": "o-", "step": "s-", "tolerance": "^-"}
LABELS = {"element": "element, m", "step": "step, s", "tolerance": "tolerance"}

runs = defaultdict(lambda: defaultdict(list))
with open(sys.argv[1], encoding="utf-8") as file:
    for row in csv.DictReader(file):
        value = {"element": row["element_m"], "step": row["step_s"], "tolerance": row["tolerance"]}[row["varied"]]
        runs[row["ground"]][row["varied"]].append((float(row["cpu_s"]), float(row["error"]), float(value)))

figure, axes = plt.subplots(1, len(runs), figsize=(11.0, 4.0), sharey=True)
for axis, (ground, series) in zip(axes, runs.items(), strict=True):
    for varied, points in series.items():
        cost, error, values = zip(*points, strict=True)
        axis.loglog(cost, error, MARKS[varied], label=LABELS[varied], markersize=5)
        for x, y, value in points:
            axis.annotate(f"{value:.3g}", (x, y), fontsize=6, xytext=(4, 3), textcoords="offset points")
    axis.set_title(ground, fontsize=10)
    axis.set_xlabel("CPU time (s)")
    axis.grid(True, which="major", alpha=0.4)
axes[0].set_ylabel("difference of surface velocity, RMS / RMS")
axes[0].legend(fontsize=8)
figure.tight_layout()
figure.savefig(sys.argv[2], dpi=110)
