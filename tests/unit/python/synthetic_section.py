"""Cuts in a synthetic run: one at the foot of a structure, and a ring around its hole, whose moment goes as 2 theta and with time."""

import h5py
import numpy as np

CENTRE, INNER, OUTER, COUNT = np.array([35.0, -5.0]), 2.0, 3.0, 12
MOMENT, THRUST = 2e4, -4e5  # N, N/m
ANGLES = 2.0 * np.pi * np.arange(COUNT) / COUNT


def _add(file, name, structure, cuts, rows, numbered):
    """cuts [cuts, 4]; rows(k): x, y, tilt, n, q, m of a cut."""
    times = np.arange(0.0, 2.0, 0.005)
    columns, units, values = ["time"], ["s"], [times]
    for k in range(len(cuts)):
        for column, unit, value in zip(("x", "y", "tilt", "n", "q", "m"), ("m", "m", "rad", "N/m", "N/m", "N"), rows(k, times)):
            columns.append(f"{column}{k}" if numbered else column)
            units.append(unit)
            values.append(np.broadcast_to(value, times.shape))
    series = file.create_dataset(f"sections/{name}", data=np.column_stack(values))
    series.attrs["columns"] = np.array([c.encode() for c in columns])
    series.attrs["units"] = np.array([u.encode() for u in units])
    series.attrs["structure"] = np.bytes_(structure)
    series.attrs["cuts"] = np.ravel(cuts)
    if numbered:
        series.attrs["centre"] = CENTRE


def add(path, structure):
    """Adds /sections/foot and /sections/ring to a run file with a structure."""
    out = np.column_stack([np.cos(ANGLES), np.sin(ANGLES)])
    cuts = np.column_stack([CENTRE + INNER * out, CENTRE + OUTER * out])
    middles = CENTRE + 0.5 * (INNER + OUTER) * out

    def of_ring(k, times):
        return middles[k, 0], middles[k, 1], 0.0, THRUST, 0.0, MOMENT * np.cos(2.0 * ANGLES[k]) * np.sin(times)

    def of_foot(k, times):
        return 33.0, -8.0, 1e-3 * times, THRUST, 1e3 * times, MOMENT * np.sin(times)

    with h5py.File(path, "a") as file:
        file.attrs["section_names"] = np.array([b"foot", b"ring"])
        _add(file, "foot", structure, [[32.0, -8.0, 34.0, -8.0]], of_foot, numbered=False)
        _add(file, "ring", structure, cuts, of_ring, numbered=True)
