"""The water table or the phreatic surface of a model, as drawings have it."""

import numpy as np
from matplotlib.patheffects import withStroke

from tremolo import style

MARK = 0.06  # where the triangle stands, as a share of the width


def line(run, left, right):
    """Its points (x, y) between two x (m), from left to right; None where the model has no water."""
    level, points = run.attribute("water_table"), run.attribute("phreatic_line")
    if level is not None:
        return np.array([[left, level], [right, level]])
    return None if points is None else np.reshape(points, (-1, 2))


def draw(ax, points):
    """The line, with the triangle of drawings on it, which is returned."""
    x, y = points.T
    light = [withStroke(linewidth=2.2, foreground="white")]  # soil under it may be as dark as the line
    ax.plot(x, y, color=style.COLOURS[0], linewidth=0.9, linestyle=(0, (6, 2)), path_effects=light)
    at = x[0] + MARK * (x[-1] - x[0])
    return ax.text(at, np.interp(at, x, y), "$\\nabla$", ha="center", va="bottom", fontsize=8, color=style.COLOURS[0],
                   path_effects=light)
