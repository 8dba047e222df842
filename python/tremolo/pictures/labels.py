"""Labels that keep out of each other's way: each takes the first of its places at which nothing is written yet."""

import itertools

import numpy as np
from matplotlib.text import Text
from matplotlib.transforms import Bbox

# Where a label may stand around its point, those that please most first: directions, and distances in points of print.
DIRECTIONS = [(0, 1), (1, 0), (-1, 0), (0, -1), (1, 1), (-1, 1), (1, -1), (-1, -1)]
DISTANCES = (5, 14, 26, 42, 62)
JOINED = 14  # from this distance on a line joins label and point
ALIGNMENTS = {-1: ("right", "top"), 0: ("center", "center"), 1: ("left", "bottom")}


class Labels:
    """The labels of axes whose limits and layout are final (style.fix_layout)."""

    def __init__(self, ax):
        self._ax, self._taken = ax, []

    def keep_free(self, *artists):
        """Nothing is written over these texts and legends."""
        self._taken += [artist.get_window_extent(self._renderer()) for artist in artists]

    def keep_free_at(self, points, width=5.0):
        """Nothing is written over these points [points, 2]; width of what stands there, in points of print."""
        self._take(self._ax.transData.transform(np.reshape(points, (-1, 2))), width)

    def keep_free_along(self, corners):
        """Nothing is written over the line through these points [points, 2]."""
        places = self._ax.transData.transform(corners)
        for start, end in zip(places, places[1:]):
            steps = np.linspace(0.0, 1.0, 2 + int(np.hypot(*(end - start)) / 4.0))[:, None]  # of 4 pixels at most
            self._take(start + steps * (end - start), width=1.0)

    def add(self, name, point, over=False, **looks):
        """Writes a name beside a point, at the first place where none is free.

        over: on the point itself, if that place is free.
        """
        text = self._ax.annotate(name, point, xytext=(0, 0), textcoords="offset points", annotation_clip=False,
                                 arrowprops=dict(arrowstyle="-", linewidth=0.4, shrinkA=0, shrinkB=2), **dict(fontsize=8) | looks)
        places = [(0, (0, 0))] * over + list(itertools.product(DISTANCES, DIRECTIONS))
        for distance, (across, up) in [*places, places[0]]:
            text.xyann = distance * across, distance * up
            text.set(ha=ALIGNMENTS[across][0], va=ALIGNMENTS[up][1])
            text.update_positions(self._renderer())
            box = Text.get_window_extent(text, self._renderer())  # that of the annotation would hold its line too
            if self._is_free(box):
                break
        text.arrow_patch.set_visible(distance >= JOINED)
        self._taken.append(box)
        return text

    def _take(self, places, width):
        half = 0.5 * width * self._ax.figure.dpi / 72.0
        self._taken += [Bbox([place - half, place + half]) for place in places]

    def _is_free(self, box):
        page = self._ax.figure.bbox
        inside = box.x0 >= page.x0 and box.x1 <= page.x1 and box.y0 >= page.y0 and box.y1 <= page.y1
        return inside and not any(box.overlaps(other) for other in self._taken)

    def _renderer(self):
        return self._ax.figure.canvas.get_renderer()
