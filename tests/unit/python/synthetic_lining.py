"""A ring in a synthetic run: thrust at rest, and a moment that goes as 2 theta and with time."""

import h5py
import numpy as np

CENTRE, RADIUS, THICKNESS, COUNT, SEGMENTS = np.array([30.0, -5.0]), 3.0, 0.3, 32, 12
THRUST, MOMENT, PRESSURE, DRIFT = -4e5, 2e4, 1e5, 0.01  # N/m, N, Pa, m/s
HINGES = [0, 16]


def around(count, radius):
    angle = 2.0 * np.pi * np.arange(count) / count
    return CENTRE + radius * np.column_stack([np.cos(angle), np.sin(angle)])


def middle_angles():
    """rad, of the middles of the elements."""
    return 2.0 * np.pi * (np.arange(COUNT) + 0.5) / COUNT


def add(path, duration):
    """Adds /linings/ring to a run file; it drifts to the right."""
    times = np.arange(0.0, duration, 0.005)
    columns, units = ["time"], ["s"]
    rows = [times]
    nodes = around(COUNT, RADIUS)
    for k in range(COUNT):
        moment = MOMENT * np.sin(2.0 * middle_angles()[k]) * np.sin(times)
        for name, unit, values in (("x", "m", nodes[k, 0] + DRIFT * times), ("y", "m", nodes[k, 1]), ("n", "N/m", THRUST),
                                   ("q", "N/m", 0.1 * moment), ("m", "N", moment)):
            columns.append(f"{name}{k}")
            units.append(unit)
            rows.append(np.broadcast_to(values, times.shape))
    for k in range(SEGMENTS):
        for name, values in (("pressure", PRESSURE), ("shear", 0.1 * PRESSURE)):
            columns.append(f"{name}{k}")
            units.append("Pa")
            rows.append(np.full_like(times, values))
    with h5py.File(path, "a") as file:
        file.attrs["lining_names"] = np.array([b"ring"])
        series = file.create_dataset("linings/ring", data=np.column_stack(rows))
        series.attrs["columns"] = np.array([c.encode() for c in columns])
        series.attrs["units"] = np.array([u.encode() for u in units])
        series.attrs["nodes"] = nodes.ravel()
        series.attrs["segments"] = around(SEGMENTS, RADIUS + 0.5 * THICKNESS).ravel()
        series.attrs["hinges"] = np.array(HINGES, dtype=float)
        for name, value in (("thickness", THICKNESS), ("axial_stiffness", 9e9), ("shear_stiffness", np.inf),
                            ("bending_stiffness", 7e7), ("mass", 750.0)):
            series.attrs[name] = value
