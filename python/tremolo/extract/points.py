"""The points of a run: those whose histories are stored, which are monitors and the points of lines, called LINE#0, LINE#1, ...;
and any other place in the soil, whose particle is followed through the frames."""

from dataclasses import dataclass

import numpy as np

from tremolo.extract import followed
from tremolo.extract.followed import FrameSeries
from tremolo.run import Series


TABLE = "shaking table"  # its motion is found by this name, as that of a point
NEAR = 0.5  # cells: a place on a line lies no farther from one of its points


@dataclass
class StoredPoint:
    """name; series: its history; start: x, y (m) before the shaking."""

    name: str
    series: Series | FrameSeries
    start: np.ndarray

    @property
    def of_frames(self):
        """Whether its history has a row a frame only."""
        return isinstance(self.series, FrameSeries)


def _point(name, series):
    return StoredPoint(name, series, np.array([series["x"][0] - series["ux"][0], series["y"][0] - series["uy"][0]]))


def monitors(run):
    """Those that have a history, in the order of the file."""
    named = ((name, run.monitor(name)) for name in run.monitors)
    return [_point(name, series) for name, series in named if len(series) > 1]


def of_line(run, name):
    """The points of a line from one end to the other; none where it has no history yet."""
    return [_point(f"{name}#{number}", series) for number, series in enumerate(run.line(name)) if len(series) > 1]


def stored(run):
    return monitors(run) + [point for name in run.lines for point in of_line(run, name)]


def _place(text):
    """x, y of "X,Y"; None where it is something else."""
    try:
        x, y = (float(part) for part in text.split(","))
    except ValueError:
        return None
    return np.array([x, y]) if np.isfinite([x, y]).all() else None


def _names(run):
    lines = [f"{name}#0 to #{len(run.line(name)) - 1}" for name in run.lines]
    return ", ".join([*run.monitors, *lines, *([TABLE] if run.shaking_table is not None else [])])


def _stored_at(known, place):
    """The stored point that began nearest to a place, and its distance (m); None, inf where there is none."""
    if not known:
        return None, np.inf
    distances = [float(np.hypot(*(point.start - place))) for point in known]
    nearest = int(np.argmin(distances))
    return known[nearest], distances[nearest]


def _followed(run, text, place):
    """The particle that began nearest to a place of the soil, by the frames."""
    if len(run.times) < 2 or not run.has_field("displacement"):
        raise ValueError(f"{run.path}: stores no history near {text}, and has no frames with displacements by which soil could be "
                         "followed from there: put a [[monitor]] into the case and run it again")
    starts = followed.starts(run, 0)
    distances = np.hypot(*(starts - place).T)
    nearest = int(np.argmin(distances))
    if distances[nearest] > followed.sizes(run, 0)[nearest]:
        raise ValueError(f"{run.path}: there is no soil at {text}: the nearest began at {starts[nearest][0]:g},{starts[nearest][1]:g}, "
                         f"{distances[nearest]:.3g} m away")
    every = float(np.median(np.diff(run.times)))
    said = (f"{text}: no history is stored there; the soil that began at {starts[nearest][0]:g},{starts[nearest][1]:g} is followed "
            f"through the frames, every {every:.3g} s: peaks between them are missed, and a [[monitor]] would have "
            "them")
    return StoredPoint(text, followed.series(run, starts[nearest]), starts[nearest]), said


def find(run, text):
    """The stored point of a name; or of "X,Y" (m) the one that began there, and otherwise the soil that did, by the frames. And a
    sentence that says which; "" for a name.

    Raises ValueError where there is no such name, or no soil at the place.
    """
    if text == TABLE and run.shaking_table is not None:
        return StoredPoint(TABLE, run.shaking_table, np.full(2, np.nan)), ""
    known = stored(run)
    for point in known:
        if point.name == text:
            return point, ""
    place = _place(text)
    if place is None:
        raise ValueError(f"{run.path}: stores no point '{text}'; it has {_names(run) or 'none'}. A place is written X,Y")
    point, distance = _stored_at(known, place)
    if distance > NEAR * run.attribute("mesh_size", 0.0):  # a free field alone has no cells
        return _followed(run, text, place)
    where = f"'{point.name}', which began at {point.start[0]:g},{point.start[1]:g}, {distance:.3g} m away"
    return point, f"{text}: the nearest point stored is {where}"
