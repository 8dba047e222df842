"""The model before it shakes: soils, monitors, lines, sliding masses, boundaries, mesh size, dimensions, and the incident wave."""

import numpy as np
from matplotlib.colors import ListedColormap
from matplotlib.lines import Line2D
from matplotlib.patches import Arc, Patch

from tremolo import bodies, style
from tremolo.pictures import profile


def preview(run, folder):
    position = run.field(0, "position")
    low, high = position.min(axis=0), position.max(axis=0)
    width, height = high - low
    top = max([high[1], *(run.body(name).outline[:, 1].max() for name in run.bodies)])
    bounds = (low[0] - 0.12 * width, low[1] - 0.27 * width, high[0] + 0.12 * width, top + 0.05 * width)
    figure, axes = style.map_axes(bounds, 1, 1)
    ax = axes[0, 0]
    for side in ("left", "bottom"):
        ax.spines[side].set_visible(False)
    ax.set(xlabel="", ylabel="", xticks=[], yticks=[])
    figure.suptitle(run.title, fontsize=10)
    style.fix_layout(figure)
    _soils(ax, run, position)
    bodies.draw(ax, run, 0)
    bodies.label(ax, run)
    tops = [position[beside, 1].max() for beside in _edges(position, low, high)]
    profile.draw(ax, run, low, high)
    _boundaries(ax, low, high, tops)
    _dimensions(ax, low, high, tops)
    _incident_wave(ax, run, low, width)
    _monitors(ax, run)
    _lines(ax, run)
    _sliding_masses(ax, run)
    return style.save(figure, folder, "model.png")


def _soils(ax, run, position):
    names = run.attribute("soil_names") or ["soil"]
    soil = run.field(0, "soil") if run.has_field("soil") else np.zeros(len(position))
    colours = [style.SOIL_COLOURS[i % len(style.SOIL_COLOURS)] for i in range(len(names))]
    style.fill_particles(
        ax, position, soil, style.sizes(run, 0), cmap=ListedColormap(colours), vmin=-0.5, vmax=len(names) - 0.5
    )
    handles = [Patch(color=colour, label=name) for colour, name in zip(colours, names)]
    mesh = run.attribute("mesh_size")
    if mesh:
        finest = mesh * np.min(style.sizes(run, 0)) / style.spacing(run)
        cells = f"mesh size {mesh:g} m" if finest == mesh else f"mesh size {mesh:g} to {finest:g} m"
        handles.append(Line2D([], [], linestyle="", label=f"{cells}, {len(position):,} particles"))
    ax.legend(handles=handles, loc="lower right", handlelength=1.2)


def _edges(position, low, high):
    """Which particles lie at the left and at the right side."""
    strip = 0.02 * (high[0] - low[0])
    return position[:, 0] < low[0] + strip, position[:, 0] > high[0] - strip


def _boundaries(ax, low, high, tops):
    """Faces that carry the tractions of Eq. (6)."""
    line = dict(color="#333333", linewidth=1.2)
    ax.plot([low[0], low[0]], [low[1], tops[0]], **line, linestyle=(0, (4, 2)))
    ax.plot([high[0], high[0]], [low[1], tops[1]], **line, linestyle=(0, (4, 2)))
    ax.plot([low[0], high[0]], [low[1], low[1]], **line)
    gap = 0.015 * (high[0] - low[0])
    middle = 0.5 * (low[1] + min(tops))
    text = dict(fontsize=8, color="#333333")
    ax.text(low[0] - gap, middle, "free field", rotation=90, ha="right", va="center", **text)
    ax.text(high[0] + gap, middle, "free field", rotation=270, ha="left", va="center", **text)
    ax.text(0.5 * (low[0] + high[0]), low[1] + gap, "transmitting base", ha="center", va="bottom", **text)


def _dimension(ax, start, end, text):
    ax.annotate("", start, end, arrowprops=dict(arrowstyle="<->", linewidth=0.7, shrinkA=0, shrinkB=0))
    middle = 0.5 * (np.array(start) + np.array(end))
    ax.text(*middle, text, ha="center", va="center", fontsize=8, bbox=dict(color="white", pad=0.8))


def _dimensions(ax, low, high, tops):
    width = high[0] - low[0]
    y = low[1] - 0.05 * width
    _dimension(ax, (low[0], y), (high[0], y), f"{width:.0f} m")
    for x, top in zip((low[0] - 0.07 * width, high[0] + 0.07 * width), tops):
        _dimension(ax, (x, low[1]), (x, top), f"{top - low[1]:.0f} m")


def _incident_wave(ax, run, low, width):
    """An arrow along the travelling direction under the base, and its angle from the vertical."""
    angle = run.attribute("angle_deg")
    if angle is None:
        return
    length = 0.14 * width
    direction = np.array([np.sin(np.radians(angle)), np.cos(np.radians(angle))])
    foot = np.array([low[0] + 0.06 * width, low[1] - 0.25 * width])
    ax.annotate(
        "", foot + length * direction, foot,
        arrowprops=dict(arrowstyle="-|>", color=style.COLOURS[1], linewidth=2.0, mutation_scale=14),
    )
    front = 0.05 * width * np.array([direction[1], -direction[0]])
    for part in (0.2, 0.35, 0.5):
        middle = foot + part * length * direction
        ax.plot(*np.transpose([middle - front, middle + front]), color=style.COLOURS[1], linewidth=0.8)
    if angle > 0:
        ax.plot([foot[0], foot[0]], [foot[1], foot[1] + length], color="#333333", linewidth=0.7, linestyle=":")
        ax.add_patch(Arc(foot, 1.7 * length, 1.7 * length, theta1=90 - angle, theta2=90, color="#333333", linewidth=0.7))
    ax.text(
        foot[0] + 0.09 * width, foot[1] + 0.3 * length,
        f"incident {run.attribute('wave', '')} wave,\n$\\beta$ = {angle:g}° from the vertical", va="center", fontsize=9,
    )


def _monitors(ax, run):
    for name in run.monitors:
        monitor = run.monitor(name)
        if len(monitor) == 0:
            continue
        point = monitor["x"][0], monitor["y"][0]
        ax.plot(*point, marker="v", color="black", markersize=5, clip_on=False)
        ax.annotate(name, point, xytext=(0, 5), textcoords="offset points", ha="center", va="bottom", fontsize=8)


def _lines(ax, run):
    for name in run.lines:
        places = [(point["x"][0], point["y"][0]) for point in run.line(name) if len(point)]
        if places:
            ax.plot(*np.transpose(places), ".-", color="black", markersize=2, linewidth=0.5)
            ax.annotate(name, places[len(places) // 2], xytext=(4, 0), textcoords="offset points", va="center", fontsize=8)


def _sliding_masses(ax, run):
    """Their outlines, also where they lie above the ground."""
    for name in run.sliding_masses:
        outline = run.sliding_mass(name).outline
        ax.plot(*np.vstack([outline, outline[:1]]).T, color=style.COLOURS[3], linewidth=1.0, linestyle="--")
        ax.annotate(name, outline[np.argmin(outline[:, 1])], xytext=(0, -4), textcoords="offset points", ha="center", va="top",
                    fontsize=8, color=style.COLOURS[3])
