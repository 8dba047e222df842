"""The work-precision diagram that `tremolo cost` measures: error against CPU time and against cell size."""

import json
import re
from pathlib import Path

import numpy as np

from tremolo import style

MARKERS = "os^Dv<>Ph*X"


def families(rungs):
    """Rungs by all but their cell size, each from coarse to fine."""
    grouped = {}
    for rung in rungs:
        grouped.setdefault(rung["family"], []).append(rung)
    return {family: sorted(members, key=lambda rung: -rung["size"]) for family, members in grouped.items()}


def short(family):
    """The setting without the tables that its keys stand in."""
    return re.sub(r"\b\w+\.(?=\w+ = )", "", family) or "all"


def draw_front(ax, rungs):
    """A step line: below and left of it no rung was measured."""
    front = sorted((rung for rung in rungs if rung["front"]), key=lambda rung: rung["cpu_s"])
    ax.step(
        [rung["cpu_s"] for rung in front], [100 * rung["error"] for rung in front], where="post", color="0.75", linewidth=4,
        zorder=0, label="Pareto front",
    )


def draw_slope(ax, sizes, errors, order):
    """A line of the order `order` below the points."""
    ends = np.array([min(sizes), max(sizes)])
    ax.plot(ends, 0.6 * min(errors) * (ends / ends[0]) ** order, ":", color="0.4", label=f"order {order}")


def read(folder):
    """What `tremolo cost` measured: cost.json."""
    return json.loads((Path(folder) / "cost.json").read_text())


def draw(folder):
    """The figure: error against CPU time, and against cell size."""
    study = read(folder)
    rungs = [rung for rung in study["rungs"] if "error" in rung]
    if not rungs:
        raise ValueError(f"{folder}: no rung has an error")
    figure, (time_axes, size_axes, names) = style.plt.subplots(
        1, 3, figsize=(11.0, 4.2), width_ratios=[1.0, 1.0, 0.55], layout="constrained"
    )
    draw_front(time_axes, rungs)
    for number, (family, members) in enumerate(families(rungs).items()):
        look = {"color": style.COLOURS[number % len(style.COLOURS)], "marker": MARKERS[number % len(MARKERS)], "markersize": 4}
        errors = [100 * rung["error"] for rung in members]
        time_axes.loglog([rung["cpu_s"] for rung in members], errors, label=short(family), **look)
        size_axes.loglog([rung["size"] for rung in members], errors, **look)
    sizes = sorted({rung["size"] for rung in rungs})
    if len(sizes) > 1:
        draw_slope(size_axes, sizes, [100 * rung["error"] for rung in rungs], 2)
        size_axes.legend(loc="lower right")
    if "target" in study:
        time_axes.axhline(100 * study["target"], color="0.4", linestyle="--", linewidth=0.8)
    if "prediction" in study:
        predicted = study["prediction"]
        time_axes.plot(predicted["cpu_s"], 100 * predicted["error"], "k*", markersize=11, markerfacecolor="none", label="predicted")
    time_axes.set(xlabel="CPU time (s)", ylabel="error, relative L2 (%)")
    size_axes.set(xlabel="cell size h (m)", xticks=sizes, xticklabels=[f"{size:.3g}" for size in sizes])
    size_axes.minorticks_off()
    names.axis("off")
    names.legend(*time_axes.get_legend_handles_labels(), loc="center left", fontsize=7)
    figure.suptitle(f"{study['title']}\n{study['error_of']}", fontsize=8)
    return figure


def picture(folder):
    """cost.png in the folder that holds cost.json."""
    return style.save(draw(folder), Path(folder), "cost.png")
