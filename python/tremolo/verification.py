"""The picture of `tremolo verify`: where the particle velocity departs from the exact field, and histories of both."""

import json
from pathlib import Path

import h5py
import numpy as np

from tremolo import style
from tremolo.run import text


def load(path):
    """verify.json and the tables of verify.h5 beside it."""
    path = Path(path)
    path = path / "verify.json" if path.is_dir() else path
    summary = json.loads(path.read_text())
    tables = {}
    with h5py.File(path.with_suffix(".h5"), "r") as file:
        file.visititems(
            lambda name, group: tables.update({name: {c: text(group[c][()]) for c in text(group.attrs["columns"])}})
            if "columns" in group.attrs
            else None
        )
    return path, summary, tables


def _error_map(ax, particles, size):
    position = np.column_stack([particles["x"], particles["y"]])
    error = 100.0 * particles["relative_error"]
    top = float(np.percentile(error, 99.5)) or 1.0
    return style.fill_particles(ax, position, error, size, cmap=style.SEQUENTIAL, vmin=0.0, vmax=top)


def _histories(axes, points, tables):
    for ax, name, x, y in zip(axes, points["name"], points["x"], points["y"]):
        table = tables[f"histories/{name}"]
        for direction, colour in (("x", style.COLOURS[0]), ("y", style.COLOURS[1])):
            ax.plot(table["time"], table[f"exact_v{direction}"], color=colour, linewidth=2.2, alpha=0.35, label=f"exact $v_{direction}$")
            ax.plot(table["time"], table[f"v{direction}"], color=colour, linewidth=0.9, label=f"computed $v_{direction}$")
        ax.set_title(f"{name}: x = {x:g} m, y = {y:g} m", loc="left")
        ax.set_xlabel("t (s)")
        ax.set_xlim(table["time"][0], table["time"][-1])
    axes[0].set_ylabel("particle velocity (m/s)")
    axes[-1].legend(loc="upper right", fontsize=7)


def picture(path):
    """Writes verify.png beside verify.json and returns its path."""
    path, summary, tables = load(path)
    particles, points = tables["particles"], tables["points"]
    low = particles["x"].min(), particles["y"].min()
    high = particles["x"].max(), particles["y"].max()
    columns = min(4, len(points["name"]))
    figure = style.plt.figure(figsize=(9.0, 3.0 + 8.0 * (high[1] - low[1]) / (high[0] - low[0])), layout="constrained")
    upper, lower = figure.subfigures(2, 1, height_ratios=[1.4, 1.0])
    ax = upper.subplots()
    margin = 0.01 * (high[0] - low[0])
    ax.set(xlabel="x (m)", ylabel="y (m)", xlim=(low[0] - margin, high[0] + margin), ylim=(low[1] - margin, high[1] + margin))
    ax.set_aspect("equal")
    figure.draw_without_rendering()
    drawn = _error_map(ax, particles, summary["mesh_size"] / 2.0)
    upper.colorbar(drawn, ax=ax, label="rms error of velocity\n(% of the domain's rms)", extend="max", shrink=0.8)
    regions = ", ".join(f"{r['name']} {100.0 * r['relative_l2']:.2f} %" for r in summary["regions"])
    ax.set_title(f"relative L2 error: {regions}", loc="left")
    _histories(np.atleast_1d(lower.subplots(1, columns, sharey=True)), points, tables)
    return style.save(figure, path.parent, "verify.png")
