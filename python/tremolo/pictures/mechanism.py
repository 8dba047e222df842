"""The soil that fails in a strength reduction: where it strains and how it moves."""

import numpy as np
from matplotlib.cm import ScalarMappable
from matplotlib.colors import Normalize

from tremolo import style

ARROWS = 24  # along the longer side of the picture


def _spread(position, count):
    """Indices of particles, one nearest to each point of an even lattice that soil is near to."""
    low, high = position.min(axis=0), position.max(axis=0)
    step = (high - low).max() / count
    cells = np.floor((position - low) / step).astype(int)
    centres = low + (cells + 0.5) * step
    distance = np.hypot(*(position - centres).T)
    order = np.lexsort((distance, cells[:, 1], cells[:, 0]))
    _, first = np.unique(cells[order], axis=0, return_index=True)
    return order[first]


def _title(trials):
    stands, fails = (trials["factor"][trials["stands"] == side] for side in (1, 0))
    answer = f"factor of safety {stands.max():.3g}" if len(stands) else f"factor of safety below {fails.min():.3g}"
    return f"{answer}: velocity of the soil where it is {fails.min():.4g}"


def picture(folder, ends=()):
    """Draws mechanism.png beside mechanism.csv, with the verticals through the points (m) between which soil may fail, and
    returns its path."""
    table = np.genfromtxt(folder / "mechanism.csv", delimiter=",", names=True)
    trials = np.atleast_1d(np.genfromtxt(folder / "safety.csv", delimiter=",", names=True))
    position = np.column_stack([table["x_m"], table["y_m"]])
    velocity = np.column_stack([table["vx_over_fastest"], table["vy_over_fastest"]])
    strain = table["equivalent_plastic_strain"]
    values, label = strain, "equivalent plastic strain (1)"
    if not strain.any():  # it is a structure that moves, and the soil with it
        values, label = np.hypot(*velocity.T), "velocity over the fastest (1)"
    margin = 0.02 * np.ptp(position[:, 0])
    bounds = (*(position.min(axis=0) - margin), *(position.max(axis=0) + margin))
    figure, axes = style.map_axes(bounds, 1, 1)
    ax = axes[0, 0]
    top = float(np.percentile(values, 99.0)) or 1.0
    scale = Normalize(0.0, top)
    figure.colorbar(ScalarMappable(scale, style.SEQUENTIAL), ax=ax, label=label, extend="max",
                    shrink=0.8, aspect=18, pad=0.015)
    ax.set_title(_title(trials), loc="left")
    style.fix_layout(figure)
    style.fill_particles(ax, position, values, table["size_m"], cmap=style.SEQUENTIAL, norm=scale)
    drawn = _spread(position, ARROWS)
    drawn = drawn[np.hypot(*velocity[drawn].T) > 0.05]
    length = 1.5 * np.ptp(position, axis=0).max() / ARROWS
    ax.quiver(*position[drawn].T, *(velocity[drawn].T * length), angles="xy", scale_units="xy", scale=1.0,
              color="white", width=0.003, headwidth=4)
    for x, y in ends:
        ax.axvline(x, color="grey", linestyle="--")
        ax.plot(x, y, "o", color="grey", markersize=4)
    return style.save(figure, folder, "mechanism.png")
