"""The model before it shakes: soils, water table, monitors, lines, sliding masses, boundaries, mesh size, dimensions, and the
incident wave."""

import numpy as np
from matplotlib.colors import ListedColormap
from matplotlib.lines import Line2D
from matplotlib.patches import Arc, Patch

from tremolo import bodies, style
from tremolo.pictures import profile, water
from tremolo.pictures.labels import Labels


def preview(run, folder):
    return style.save(drawn(run), folder, "model.png")


def drawn(run):
    """The figure."""
    position = run.field(0, "position")
    low, high = _box(run, position)
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
    labels = Labels(ax)
    _soils(ax, run, position)
    bodies.draw(ax, run, 0)
    profile.draw(ax, run, low, high)
    tops = _surfaces(run, position, low, high)
    _boundaries(ax, run, low, high, tops)
    _dimensions(ax, low, high, tops)
    _incident_wave(ax, run, low, width)
    labels.keep_free(*ax.texts, ax.get_legend())
    labels.keep_free_along([(low[0], tops[0]), low, (high[0], low[1]), (high[0], tops[1])])
    for name in run.bodies:
        labels.keep_free_along(np.vstack([run.body(name).outline, run.body(name).outline[:1]]))
    for name in run.linings:
        labels.keep_free_along(np.vstack([run.lining(name).nodes, run.lining(name).nodes[:1]]))
    _water_table(ax, labels, run, low, high)
    _structures(labels, run)
    _sliding_masses(ax, labels, run)
    _monitors(ax, labels, run)
    _lines(ax, labels, run)
    return figure


def _box(run, position):
    """Corners of the model's box below its highest soil, m. Particles end half their size before it."""
    half = 0.5 * np.max(style.sizes(run, 0))
    low, high = position.min(axis=0) - half, position.max(axis=0) + half
    box = run.attribute("box")
    return (low, high) if box is None else (np.array(box[:2]), np.array([box[2], min(box[3], high[1])]))


def _surfaces(run, position, low, high):
    """y of the ground's surface at the left and at the right side, m: that of the free field, where there is one."""
    size = np.max(style.sizes(run, 0))
    strip = max(size, 0.02 * (high[0] - low[0]))
    sides = position[:, 0] < low[0] + strip, position[:, 0] > high[0] - strip
    tops = np.array([position[beside, 1].max() + 0.5 * size for beside in sides])
    levels = np.array(run.attribute("surface_levels", tops))
    return np.where(np.abs(levels - tops) < size, levels, tops)


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
        cells = f"mesh size {mesh:g} m" if np.isclose(finest, mesh) else f"mesh size {mesh:g} to {finest:g} m"
        handles.append(Line2D([], [], linestyle="", label=f"{cells}, {len(position):,} particles"))
    ax.legend(handles=handles, loc="lower right", handlelength=1.2)


def _supports(run):
    """What holds the sides, and what the base: "free field", "transmitting base"."""
    is_on = {effect["name"]: effect["on"] for effect in run.plan.get("effects", [])}
    if is_on.get("periodic sides"):
        sides = "periodic"
    else:
        sides = "free field" if run.shaking_table is None else "wall"
    return sides, "transmitting base" if run.shaking_table is None else "shaking table"


def _boundaries(ax, run, low, high, tops):
    """What stands around the model; dashed are sides that carry the tractions of Eq. (6)."""
    sides, base = _supports(run)
    line = dict(color="#333333", linewidth=1.2)
    for x, top in zip((low[0], high[0]), tops):
        ax.plot([x, x], [low[1], top], **line, linestyle="-" if sides == "wall" else (0, (4, 2)))
    ax.plot([low[0], high[0]], [low[1], low[1]], **line)
    gap = 0.015 * (high[0] - low[0])
    middle = 0.5 * (low[1] + min(tops))
    text = dict(fontsize=8, color="#333333")
    ax.text(low[0] - gap, middle, sides, rotation=90, ha="right", va="center", **text)
    ax.text(high[0] + gap, middle, sides, rotation=270, ha="left", va="center", **text)
    ax.text(0.5 * (low[0] + high[0]), low[1] + gap, base, ha="center", va="bottom", **text)


def _dimension(ax, start, end, aside=0.0):
    """A length between two points above or beside each other; written along it, at a distance (m) right of it."""
    ax.annotate("", start, end, arrowprops=dict(arrowstyle="<->", linewidth=0.7, shrinkA=0, shrinkB=0))
    across, up = np.array(end) - start
    ax.text(start[0] + 0.5 * across + aside, start[1] + 0.5 * up, f"{max(across, up):.4g} m", ha="center", va="center", fontsize=8,
            rotation=90 if up else 0, bbox=dict(color="white", pad=0.8))


def _dimensions(ax, low, high, tops):
    width = high[0] - low[0]
    y = low[1] - 0.05 * width
    _dimension(ax, (low[0], y), (high[0], y))
    for x, outwards, top in zip((low[0], high[0]), (-width, width), tops):
        _dimension(ax, (x + 0.07 * outwards, low[1]), (x + 0.07 * outwards, top), aside=0.018 * outwards)


def _incident_wave(ax, run, low, width):
    """An arrow along the travelling direction under the base, and its angle from the vertical."""
    angle = run.attribute("angle_deg")
    if angle is None or run.shaking_table is not None:
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


def _structures(labels, run):
    for name in run.bodies:
        outline = run.body(name).outline
        labels.add(name, 0.5 * (outline.min(axis=0) + outline.max(axis=0)), over=True)
    for name in run.linings:
        labels.add(name, run.lining(name).nodes.mean(axis=0), over=True)


def _monitors(ax, labels, run):
    points = {name: (run.monitor(name)["x"][0], run.monitor(name)["y"][0]) for name in run.monitors if len(run.monitor(name))}
    labels.keep_free_at(list(points.values()))
    for name, point in points.items():
        ax.plot(*point, marker="v", color="black", markersize=5, clip_on=False)
        labels.add(name, point)


def _lines(ax, labels, run):
    for name in run.lines:
        places = [(point["x"][0], point["y"][0]) for point in run.line(name) if len(point)]
        if places:
            ax.plot(*np.transpose(places), ".-", color="black", markersize=2, linewidth=0.5)
            labels.keep_free_at(places, width=2.0)
            labels.add(name, places[len(places) // 2])


def _sliding_masses(ax, labels, run):
    """Their outlines, also where they lie above the ground."""
    for name in run.sliding_masses:
        outline = run.sliding_mass(name).outline
        ring = np.vstack([outline, outline[:1]])
        labels.keep_free_along(ring)
        ax.plot(*ring.T, color=style.COLOURS[3], linewidth=1.0, linestyle="--")
        labels.add(name, outline[np.argmin(outline[:, 1])], color=style.COLOURS[3])


def _water_table(ax, labels, run, low, high):
    """A line from side to side, with its name."""
    points = water.line(run, low[0], high[0])
    if points is None:
        return
    labels.keep_free_along(points)
    labels.keep_free(water.draw(ax, points))
    level, middle = run.attribute("water_table"), low[0] + 0.22 * (high[0] - low[0])
    name = "phreatic surface" if level is None else f"water table, y = {level:.4g} m"
    labels.add(name, (middle, np.interp(middle, *points.T)), color=style.COLOURS[0])
