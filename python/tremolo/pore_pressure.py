"""Pictures of ground below a water table: a free field that `tremolo column` wrote, and the monitors of a run.

r_u is the excess pore pressure over the vertical effective stress before shaking. Effective stress is positive in
compression.
"""

from pathlib import Path
from typing import NamedTuple

import numpy as np

from tremolo import style
from tremolo.column import histories
from tremolo.run import Run


class Trace(NamedTuple):
    """The water's history at a point."""

    label: str
    time: np.ndarray  # s
    ratio: np.ndarray  # r_u
    effective: np.ndarray  # vertical effective stress, Pa
    shear: np.ndarray  # sxy, Pa


def draw_ratio(ax, traces, title):
    """r_u over time."""
    for trace in traces:
        ax.plot(trace.time, trace.ratio, linewidth=0.7, label=trace.label)
    ax.set(ylabel="$r_u$")
    if traces:
        ax.set_xlim(traces[0].time[0], traces[0].time[-1])
        ax.legend(title=title, loc="lower right", ncols=3)


def draw_paths(ax, traces):
    """Effective stress paths."""
    for trace in traces:
        ax.plot(trace.effective / 1e3, trace.shear / 1e3, linewidth=0.4, label=trace.label)
    ax.set(xlabel="vertical effective stress (kPa)", ylabel="shear stress (kPa)")


def draw_settlement(ax, time, settlement):
    ax.plot(time, 1e3 * settlement)
    ax.set(xlabel="t (s)", ylabel="settlement (mm)", xlim=(time[0], time[-1]))


def read(path):
    """(levels, histories, water, settlement, initial); None where the ground has no pore pressure."""
    with Run(path) as run:
        water = run.table("water")
        return None if water is None else (*histories(run), water, run.table("settlement"), run.table("initial"))


def over_depth_and_time(water):
    """Times, levels and r_u as an array [level][time]."""
    times, levels = np.unique(water["time"]), np.unique(water["y"])
    return times, levels, water["pore_pressure_ratio"].reshape(len(times), len(levels)).T


def draw(path):
    """The figure: r_u over depth and time, its histories, settlement, and stress paths. None where there is no pore
    pressure."""
    content = read(path)
    if content is None:
        return None
    levels, histories, water, settlement, initial = content
    surface = initial["y"].max()
    figure, axes = style.plt.subplot_mosaic(
        [["map", "map", "depth"], ["ratio", "ratio", "stress"], ["down", "down", "paths"]],
        figsize=(11.0, 8.4),
        layout="constrained",
        width_ratios=[1.0, 1.0, 0.9],
    )
    times, y, ratio = over_depth_and_time(water)
    mesh = axes["map"].pcolormesh(times, surface - y, ratio, shading="nearest", cmap=style.SEQUENTIAL, vmin=0.0, vmax=1.0)
    axes["map"].set(ylabel="depth (m)", xlim=(times[0], times[-1]))
    axes["map"].invert_yaxis()
    figure.colorbar(mesh, ax=axes["map"], label="$r_u$")
    drawn = [
        Trace(f"{surface - level:.4g} m", *(history[name] for name in ("time", "pore_pressure_ratio", "effective_stress", "sxy")))
        for level, history in zip(levels, histories)
        if np.abs(history["pore_pressure_ratio"]).max() >= 1e-6  # neither dry nor the drained surface
    ]
    draw_ratio(axes["ratio"], drawn, "depth")
    draw_paths(axes["paths"], drawn)
    draw_settlement(axes["down"], settlement["time"], settlement["settlement"])
    axes["depth"].plot(initial["peak_pore_pressure_ratio"], surface - initial["y"])
    axes["depth"].set(xlabel="largest $r_u$", xlim=(0, None))
    axes["stress"].plot(initial["effective_stress"] / 1e3, surface - initial["y"], label="effective stress")
    axes["stress"].plot(initial["pore_pressure"] / 1e3, surface - initial["y"], label="pore pressure")
    axes["stress"].set(xlabel="before shaking (kPa)")
    axes["stress"].legend()
    for name in ("depth", "stress"):
        axes[name].set(ylabel="depth (m)")
        axes[name].invert_yaxis()
    return figure


def picture(path):
    """OUT_water.png beside OUT.h5; None where there is no pore pressure."""
    path = Path(path)
    figure = draw(path)
    return None if figure is None else style.save(figure, path.parent, path.stem + "_water.png")


def wet_monitors(run):
    """Series of the monitors that have pore pressure, by name."""
    series = {name: run.monitor(name) for name in run.monitors}
    return {
        name: one for name, one in series.items()
        if len(one) > 1 and "pore_pressure" in one.columns and one["pore_pressure"].any()
    }


def traces(monitors):
    return [
        Trace(name, series["time"], series["pore_pressure_ratio"], -series["syy"], series["sxy"])
        for name, series in monitors.items()
    ]


def monitors(run, folder):
    """r_u and pore pressure at the monitors, their effective stress paths and settlement; pore_water.png. None where no
    monitor has pore pressure."""
    wet = wet_monitors(run)
    if not wet:
        return None
    figure, axes = style.plt.subplot_mosaic(
        [["ratio", "paths"], ["pressure", "paths"], ["down", "paths"]], figsize=(11.0, 6.0), layout="constrained",
        width_ratios=[1.4, 1.0],
    )
    draw_ratio(axes["ratio"], traces(wet), "monitor")
    draw_paths(axes["paths"], traces(wet))
    for series in wet.values():
        axes["pressure"].plot(series["time"], series["pore_pressure"] / 1e3, linewidth=0.7)
        draw_settlement(axes["down"], series["time"], -series["uy"])
    axes["pressure"].set(ylabel="pore pressure (kPa)", xlim=axes["down"].get_xlim())
    return style.save(figure, folder, "pore_water.png")
