"""The common look of all pictures, and particles drawn as filled squares."""

import matplotlib

matplotlib.use("Agg")

import matplotlib.pyplot as plt
import numpy as np

from tremolo import outputs

DIVERGING = "RdBu_r"
SEQUENTIAL = "viridis"
# Okabe & Ito (2008): distinguishable with every kind of colour vision.
COLOURS = ["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#F0E442", "#000000"]
SOIL_COLOURS = ["#E2CFA6", "#C08F5C", "#9FB3A2", "#8C8FA8", "#D9A79A", "#B7B27A"]

plt.rcParams.update(
    {
        "figure.dpi": 150,
        "savefig.dpi": 150,
        "font.size": 9,
        "axes.titlesize": 9,
        "axes.labelsize": 9,
        "legend.fontsize": 8,
        "legend.frameon": False,
        "axes.prop_cycle": matplotlib.cycler(color=COLOURS),
        "axes.spines.top": False,
        "axes.spines.right": False,
        "lines.linewidth": 1.0,
        "image.interpolation": "nearest",
    }
)


def spacing(run):
    """Distance of neighbouring particles of the coarsest cells at the start, m."""
    return run.attribute("particle_size") or run.attribute("mesh_size") / 2.0


def sizes(run, index):
    """Side of the particles of a frame, m: one of all, or one each on a graded mesh."""
    return run.field(index, "size") if run.has_field("size") else spacing(run)


def extent(run, indices):
    """(xmin, ymin, xmax, ymax) of the particles and structures of some frames, with a margin, m."""
    points = [run.field(i, "position") for i in indices]
    points += [run.body(name).corners(run.times[i])[0] for name in run.bodies for i in indices]
    points += [run.lining(name).faces(run.times[i])[0] for name in run.linings for i in indices]
    low = np.min([p.min(axis=0) for p in points], axis=0)
    high = np.max([p.max(axis=0) for p in points], axis=0)
    margin = 0.02 * (high[0] - low[0])
    return low[0] - margin, low[1] - margin, high[0] + margin, high[1] + margin


def aspect_of(bounds):
    """Height over width of (xmin, ymin, xmax, ymax)."""
    return (bounds[3] - bounds[1]) / (bounds[2] - bounds[0])


def map_axes(bounds, rows, columns, highest=np.inf):
    """A grid of axes of equal aspect, as high as their maps need, but no higher than `highest` inches each; all share the
    bounds."""
    aspect = aspect_of(bounds)
    width = columns * min(7.2 if columns == 1 else 5.2, highest / aspect)
    panel = (0.78 if columns == 1 else 0.86) * width / columns * aspect + 0.3
    figure, axes = plt.subplots(
        rows, columns, figsize=(width, rows * panel + 0.4), squeeze=False, sharex=True, sharey=True,
        layout="constrained",
    )
    for ax in axes.flat:
        ax.set_aspect("equal")
        ax.set_xlim(bounds[0], bounds[2])
        ax.set_ylim(bounds[1], bounds[3])
    for ax in axes[-1]:
        ax.set_xlabel("x (m)")
    for ax in axes[:, 0]:
        ax.set_ylabel("y (m)")
    return figure, axes


def fix_layout(figure):
    """Lays the figure out for good; what is drawn later no longer moves the axes."""
    figure.draw_without_rendering()
    figure.set_layout_engine("none")


def fill_particles(ax, position, values, size, **colouring):
    """Particles as squares of `size` metres, one of all or one each, that leave no gap, coloured by value.

    The marker's area follows from the scale of the axes: their limits and its layout must be final (fix_layout).
    """
    points_per_metre = ax.get_window_extent().width / np.ptp(ax.get_xlim()) * 72.0 / ax.figure.dpi
    return ax.scatter(
        position[:, 0], position[:, 1], c=values, s=(1.25 * size * points_per_metre) ** 2, marker="s", linewidths=0,
        rasterized=True, **colouring,
    )


def save(figure, folder, name):
    """Writes the picture and returns its path. Raises ValueError where there is a file that is none of tremolo's pictures."""
    path = outputs.writable(folder / name)
    figure.savefig(path, metadata={"Software": outputs.SOFTWARE} if path.suffix == ".png" else None)
    plt.close(figure)
    return path
