"""Peaks along a line of a run, and histories, as columns of a table.

The largest absolute values over the rows of a history; displacement and strain since the start of shaking. The stress ratio
is the largest shear stress on horizontal planes, that at rest included, over the vertical effective stress at rest,

    max |tau_xy| / sigma'_v0,        sigma'_v0 = -sigma'_yy of the first row.
"""

import numpy as np

PEAKS = {"ax": "peak_ax_m_s2", "ay": "peak_ay_m_s2", "vx": "peak_vx_m_s", "vy": "peak_vy_m_s", "ux": "peak_ux_m", "uy": "peak_uy_m",
         "gxy": "peak_gxy", "sxy": "peak_sxy_Pa"}
SUFFIX = {"1": ""}  # of other units their own name
WEIGHTLESS = 1.0  # Pa: less is rounding


def with_unit(column, unit):
    """The name of a column with its unit: ax_m_s2, sxy_Pa."""
    suffix = SUFFIX.get(unit, unit.replace("/", "_"))
    return f"{column}_{suffix}" if suffix else column


def _common_rows(series, base):
    """How many rows of a history lie within the time of another's."""
    return int(np.count_nonzero(series["time"] <= base["time"][-1]))


def relative_displacement(series, base):
    """u of a point minus u of another at its times, [rows, 2], m, over the rows that both have."""
    time = series["time"][: _common_rows(series, base)]
    return np.column_stack([series[name][: len(time)] - np.interp(time, base["time"], base[name]) for name in ("ux", "uy")])


def history(series, base=None):
    """Columns of a point's history: name with unit -> array; relative to the base where there is one."""
    rows = len(series) if base is None else _common_rows(series, base)
    table = {with_unit(column, series.units[column]): series[column][:rows] for column in series.columns}
    if base is not None:
        moved = relative_displacement(series, base)
        table |= {"ux_relative_m": moved[:, 0], "uy_relative_m": moved[:, 1]}
    return table


def profile(points, base=None):
    """Columns of a table with a row a point: distance along the line from its first point, place at the start, peaks.

    points: of one line; base: the series that displacement is relative to, or None. Stress ratio is NaN in soil without
    weight.
    """
    start = np.array([point.start for point in points])
    table = {"distance_m": np.hypot(*(start - start[0]).T), "x_m": start[:, 0], "y_m": start[:, 1]}
    for column, name in PEAKS.items():
        table[name] = np.array([np.abs(point.series[column]).max() for point in points])
    if base is not None:
        moved = np.array([np.abs(relative_displacement(point.series, base)).max(axis=0) for point in points])
        table |= {"peak_ux_relative_m": moved[:, 0], "peak_uy_relative_m": moved[:, 1]}
    rest = np.array([-point.series["syy"][0] for point in points])
    rest[rest < WEIGHTLESS] = np.nan
    table |= {"vertical_effective_stress_Pa": rest, "stress_ratio": table["peak_sxy_Pa"] / rest}
    if "pore_pressure_ratio" in points[0].series.columns:
        table["peak_r_u"] = np.array([point.series["pore_pressure_ratio"].max() for point in points])
    return table
