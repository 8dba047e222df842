#!/usr/bin/env python3
"""Draws the work-precision diagram of the column by the method of lines.

    cost_ode_work_precision > wp.csv
    ode_plots.py wp.csv docs/free-fields/pictures/ode-work-precision.png
"""

import csv
import sys
from collections import defaultdict

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

runs = defaultdict(list)
with open(sys.argv[1], encoding="utf-8") as file:
    for row in csv.DictReader(file):
        runs[row["method"]].append((float(row["cpu_s"]), float(row["error"]), float(row["rtol"])))

figure, axis = plt.subplots(figsize=(6.5, 4.3))
for (method, points), mark in zip(runs.items(), "os^D"):
    cost, error, tolerance = zip(*points)
    axis.loglog(cost, error, mark + "-", label=method.replace("_", " "), markersize=5)
    for x, y, rtol in points:
        axis.annotate(f"{rtol:.0e}", (x, y), fontsize=6, xytext=(4, 3), textcoords="offset points")
axis.set_xlabel("CPU time (s), 200 cells, 40 s of motion")
axis.set_ylabel("error in time of surface velocity, RMS / RMS")
axis.set_title("MKZ column of 200 m; labels: relative tolerance", fontsize=10)
axis.grid(True, which="major", alpha=0.4)
axis.legend(fontsize=8)
figure.tight_layout()
figure.savefig(sys.argv[2], dpi=110)
