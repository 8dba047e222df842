"""The points of a run whose histories are stored: monitors, and the points of lines, which are called LINE#0, LINE#1, ..."""

from dataclasses import dataclass

import numpy as np

from tremolo.run import Series


TABLE = "shaking table"  # its motion is found by this name, as that of a point


@dataclass
class StoredPoint:
    """name; series: its history; start: x, y (m) before the shaking."""

    name: str
    series: Series
    start: np.ndarray


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


def find(run, text):
    """The stored point of a name, or the one that began nearest to "X,Y" (m), and a sentence that says which; "" for a name.

    Raises ValueError where there is no such name, or no stored point began within two cells of the place.
    """
    if text == TABLE and run.shaking_table is not None:
        return StoredPoint(TABLE, run.shaking_table, np.full(2, np.nan)), ""
    known = stored(run)
    if not known:
        raise ValueError(f"{run.path}: stores no history of any point: put [[monitor]] or [[line]] into the case and run it again")
    for point in known:
        if point.name == text:
            return point, ""
    place = _place(text)
    if place is None:
        raise ValueError(f"{run.path}: stores no point '{text}'; it has {_names(run)}. A place is written X,Y")
    distances = [float(np.hypot(*(point.start - place))) for point in known]
    nearest = int(np.argmin(distances))
    point, distance = known[nearest], distances[nearest]
    where = f"'{point.name}', which began at {point.start[0]:g},{point.start[1]:g}, {distance:.3g} m away"
    if distance > 2.0 * run.attribute("mesh_size"):
        raise ValueError(f"{run.path}: stores no history near {text}: the nearest is that of {where}. Put a [[monitor]] there into the "
                         "case and run it again")
    return point, f"{text}: the nearest point stored is {where}"
