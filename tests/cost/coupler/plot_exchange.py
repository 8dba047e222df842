"""Draws what time_interpolation and exchange_window print.

    build/bin/cost/cost_time_interpolation > interpolation.csv
    build/bin/cost/cost_exchange_window > window.csv
    python3 tests/cost/coupler/plot_exchange.py interpolation.csv window.csv docs/free-fields/pictures/exchange.png
"""

import csv
import math
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

interpolation, window, picture = sys.argv[1:]
rows = list(csv.DictReader(open(interpolation)))
windows = list(csv.DictReader(open(window)))
colour = {"linear": "tab:orange", "hermite": "tab:blue"}
label = {"linear": "linear", "hermite": "cubic Hermite"}
values_per_step = {"linear": 5, "hermite": 10}

figure, (left, middle, right) = plt.subplots(1, 3, figsize=(12, 3.8), layout="constrained")
for method in ("linear", "hermite"):
    for signal, marker in (("harmonic", "o"), ("ricker", "^")):
        picked = [r for r in rows if r["method"] == method and r["signal"] == signal]
        x = [float(r["omega_dt"]) for r in picked]
        error = [float(r["error"]) for r in picked]
        left.loglog(x, error, marker, color=colour[method], mfc="none" if signal == "ricker" else None,
                    label=f"{label[method]}, {signal}")
        if signal == "ricker":
            middle.loglog([2.0 * math.pi / w * values_per_step[method] for w in x], error, marker + "-",
                          color=colour[method], mfc="none", label=label[method])
    theory = (lambda w: w**2 / 8) if method == "linear" else (lambda w: w**4 / 384)
    left.loglog(x, [theory(w) for w in x], "-", color=colour[method], lw=1)
left.set_xlabel(r"$\omega\,\Delta t$ of the source (1)")
left.set_ylabel("relative error (1)")
left.set_title(r"lines: $(\omega\Delta t)^2/8$, $(\omega\Delta t)^4/384$", fontsize=10)
left.legend(fontsize=7)
middle.set_xlabel("values sent a point and period (1)")
middle.set_ylabel("relative error of a Ricker pulse (1)")
middle.set_title("what is sent for it", fontsize=10)
middle.legend(fontsize=8)
steps = [int(r["window_steps"]) for r in windows if r["mode"] == "window"]
right.loglog(steps, [float(r["cpu_us"]) for r in windows if r["mode"] == "window"], "s-", color="tab:green", label="window")
lockstep = next(float(r["cpu_us"]) for r in windows if r["mode"] == "lockstep")
right.axhline(lockstep, color="tab:red", ls="--", label="lockstep")
right.set_ylim(1, 2 * lockstep)
right.set_xlabel("coupling window: steps in a frame (1)")
right.set_ylabel("CPU time of a domain step (µs)")
right.set_title("exchange of 160 faces, 81 levels", fontsize=10)
right.legend(fontsize=8)
for axes in (left, middle, right):
    axes.grid(True, which="major", alpha=0.3)
figure.savefig(picture, dpi=110)
