"""A particle of soil followed through the frames of a run: the history of a point for which the case has no monitor.

A particle is known by its place before the shaking, X = x - u: frames keep no numbers, and where particles are cut their order
changes. Its strain is the fit of least squares over the particles n of its own soil around it, as that of a monitor
(mpm_domain/process/output/followed_point.hpp),

    G = sum (u_n - u) (X_n - X)^T [sum (X_n - X) (X_n - X)^T]^-1,    exx = G_xx, eyy = G_yy, gxy = G_xy + G_yx.

On a shaking table frames are seen from the table; its motion is added, so that the history is one in space, as a monitor's.
"""

import numpy as np

# Columns of a history by the field of frames that holds them.
FIELDS = {"position": ("m", ["x", "y"]), "displacement": ("m", ["ux", "uy"]), "velocity": ("m/s", ["vx", "vy"]),
          "acceleration": ("m/s2", ["ax", "ay"]), "stress": ("Pa", ["sxx", "syy", "szz", "sxy"]), "pore_pressure": ("Pa", ["pore_pressure"]),
          "pore_pressure_ratio": ("1", ["pore_pressure_ratio"])}
MOVING_WITH_TABLE = ("ux", "uy", "vx", "vy", "ax", "ay")
REACH = 1.6  # sizes of a particle: the eight around it on an even grid


class FrameSeries:
    """A history with a row a frame; columns and units as those of a monitor, as far as the frames hold them."""

    def __init__(self, columns, units):
        self._values, self.units = columns, units
        self.columns = list(columns)

    def __getitem__(self, column):
        return self._values[column]

    def __len__(self):
        return len(self._values["time"])


def starts(run, frame):
    """Places of a frame's particles before the shaking, [N, 2], m."""
    return run.field(frame, "position") - run.field(frame, "displacement")


def sizes(run, frame):
    """Side of each particle, m."""
    if run.has_field("size"):
        return run.field(frame, "size")
    return np.full(len(run.field(frame, "soil")), run.attribute("particle_size", run.attribute("mesh_size") / 2.0))


def _strain(run, frame, index, start):
    """exx, eyy, gxy of a particle; NaN where too few lie around it."""
    moved, soil, size = run.field(frame, "displacement"), run.field(frame, "soil"), sizes(run, frame)
    offset = start - start[index]
    near = (np.hypot(*offset.T) < REACH * size[index]) & (soil == soil[index]) & (size == size[index])
    matrix = offset[near].T @ offset[near]
    if not np.linalg.det(matrix) > 1e-6 * np.trace(matrix) ** 2:
        return [np.nan] * 3
    gradient = np.linalg.solve(matrix, offset[near].T @ (moved[near] - moved[index])).T
    return [gradient[0, 0], gradient[1, 1], gradient[0, 1] + gradient[1, 0]]


def series(run, start):
    """The history of the particle that began at a place, x, y (m)."""
    fields = [field for field in FIELDS if run.has_field(field)]
    units = {"time": "s"} | {name: FIELDS[field][0] for field in fields for name in FIELDS[field][1]}
    units |= dict.fromkeys(("exx", "eyy", "gxy"), "1")
    rows = []
    for frame, time in enumerate(run.times):
        all_starts = starts(run, frame)
        index = int(np.argmin(np.hypot(*(all_starts - start).T)))
        values = [value for field in fields for value in np.atleast_1d(run.field(frame, field)[index])]
        rows.append([time, *values, *_strain(run, frame, index, all_starts)])
    columns = dict(zip(units, np.array(rows).T))
    if (table := run.shaking_table) is not None:
        for name in MOVING_WITH_TABLE:
            if name in columns:
                columns[name] = columns[name] + np.interp(run.times, table["time"], table[name])
    return FrameSeries(columns, units)
