"""Structures: drawn into maps, and their histories."""

import numpy as np
from matplotlib.patches import PathPatch
from matplotlib.path import Path

from tremolo import style
from tremolo.pictures import linings, props

FILL = linings.FILL

# Column of the series without its direction, label.
FORCES = (("normal", "normal"), ("friction", "friction"), ("water", "excess pore pressure"), ("weight", "weight"))


def _ring(polygon, clockwise):
    """A closed path along a polygon in one sense: a hole runs against its outline."""
    x, y = polygon.T
    double_area = np.sum(x * np.roll(y, -1) - np.roll(x, -1) * y)
    corners = polygon[::-1] if (double_area < 0.0) != clockwise else polygon
    return Path(np.vstack([corners, corners[:1]]), closed=True)


def shape(outline, hole):
    """The path of a structure, which leaves its hole open; hole is None where there is none."""
    rings = [_ring(outline, clockwise=False)]
    if hole is not None:
        rings.append(_ring(hole, clockwise=True))
    return Path.make_compound_path(*rings)


def draw(ax, run, index):
    """Fills all structures and linings where they are in a frame, leaves their holes open, and draws props."""
    for name in run.bodies:
        ax.add_patch(PathPatch(shape(*run.body(name).corners(run.times[index])), **FILL))
    linings.draw(ax, run, run.times[index])
    props.draw(ax, run, run.times[index])


def _millimetres(values):
    """(factor, unit) in which lengths (m) are shown."""
    return (1e3, "mm") if np.max(np.abs(values)) < 0.1 else (1.0, "m")


def _legend_above(ax):
    """On the right above the axes, where it hides no line."""
    ax.legend(loc="lower right", bbox_to_anchor=(1.0, 1.0), ncols=len(FORCES), borderaxespad=0.2)


def _motion(axes, body):
    time = body["time"]
    moved = {"horizontal": body["x"] - body["x"][0], "vertical": body["y"] - body["y"][0]}
    factor, unit = _millimetres(np.concatenate(list(moved.values())))
    for text, values in moved.items():
        axes["moved"].plot(time, factor * values, label=text)
    axes["moved"].set_ylabel(f"displacement ({unit})")
    _legend_above(axes["moved"])
    axes["tilt"].plot(time, np.degrees(body["tilt"]), color=style.COLOURS[2])
    axes["tilt"].set_ylabel("tilt (°)")


def _forces(axes, body, wet):
    for direction in "yx":
        ax = axes[direction]
        for number, (column, text) in enumerate(FORCES):
            force = body[f"{column}_{direction}"]
            if column == "water" and not wet:
                continue
            if column == "weight":
                if direction == "x":
                    continue
                text += " less lift" if wet else ""
            ax.plot(body["time"], force / 1e3, label=text, color=style.COLOURS[number], linewidth=0.8)
    axes["y"].set_ylabel("vertical force (kN/m)")
    axes["x"].set_ylabel("horizontal force (kN/m)")
    _legend_above(axes["y"])


def histories(run, folder):
    """bodies.png, a column a structure: how far it has moved (up is positive), its tilt (counter-clockwise), and the forces on it.
    None where no structure has moved yet."""
    bodies = {name: run.body(name) for name in run.bodies}
    bodies = {name: body for name, body in bodies.items() if len(body) > 1}
    if not bodies:
        return None
    rows = ("moved", "tilt", "y", "x")
    figure, axes = style.plt.subplots(
        len(rows), len(bodies), figsize=(2.0 + 5.0 * len(bodies), 8.0), squeeze=False, sharex=True, layout="constrained",
        height_ratios=[1.0, 0.7, 1.3, 1.0],
    )
    for column, (name, body) in enumerate(bodies.items()):
        own = dict(zip(rows, axes[:, column]))
        _motion(own, body)
        _forces(own, body, wet=run.has_field("pore_pressure_ratio") or np.any(body["water_y"]))
        own["moved"].set_title(f"{name}: {body.mass / 1e3:.4g} t/m", loc="left")
        own["x"].set_xlabel("t (s)")
        own["x"].set_xlim(body["time"][0], body["time"][-1])
        for ax in own.values():
            ax.axhline(0.0, color="0.6", linewidth=0.5, zorder=0)
    return style.save(figure, folder, "bodies.png")
