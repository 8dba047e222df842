"""The picture of a free field with pore water: what `tremolo column` writes of ground below a water table."""

from pathlib import Path

import h5py
import numpy as np

from tremolo import style
from tremolo.column import table


def read(path):
    """(levels, histories, water, settlement, initial); None where the ground has no pore pressure."""
    with h5py.File(path, "r") as file:
        if "water" not in file:
            return None
        levels = file["levels/y"][()]
        histories = [table(file[f"histories/{number:03}"]) for number in range(len(levels))]
        return levels, histories, table(file["water"]), table(file["settlement"]), table(file["initial"])


def over_depth_and_time(water):
    """Times, levels and r_u as an array [level][time]."""
    times, levels = np.unique(water["time"]), np.unique(water["y"])
    return times, levels, water["pore_pressure_ratio"].reshape(len(times), len(levels)).T


def picture(path):
    """r_u over depth and time, its histories, settlement, and stress paths; OUT_water.png beside OUT.h5. None where there
    is no pore pressure."""
    path = Path(path)
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
    for level, history in zip(levels, histories):
        if np.abs(history["pore_pressure_ratio"]).max() < 1e-6:  # dry, or the drained surface
            continue
        label = f"{surface - level:.4g} m"
        axes["ratio"].plot(history["time"], history["pore_pressure_ratio"], linewidth=0.7, label=label)
        axes["paths"].plot(history["effective_stress"] / 1e3, history["sxy"] / 1e3, linewidth=0.4, label=label)
    axes["ratio"].set(ylabel="$r_u$", xlim=(times[0], times[-1]))
    if axes["ratio"].lines:
        axes["ratio"].legend(title="depth", loc="lower right", ncols=3)
    axes["down"].plot(settlement["time"], 1e3 * settlement["settlement"])
    axes["down"].set(xlabel="t (s)", ylabel="settlement (mm)", xlim=(times[0], times[-1]))
    axes["depth"].plot(initial["peak_pore_pressure_ratio"], surface - initial["y"])
    axes["depth"].set(xlabel="largest $r_u$", xlim=(0, None))
    axes["stress"].plot(initial["effective_stress"] / 1e3, surface - initial["y"], label="effective stress")
    axes["stress"].plot(initial["pore_pressure"] / 1e3, surface - initial["y"], label="pore pressure")
    axes["stress"].set(xlabel="before shaking (kPa)")
    axes["stress"].legend()
    for name in ("depth", "stress"):
        axes[name].set(ylabel="depth (m)")
        axes[name].invert_yaxis()
    axes["paths"].set(xlabel="vertical effective stress (kPa)", ylabel="shear stress (kPa)")
    return style.save(figure, path.parent, path.stem + "_water.png")
