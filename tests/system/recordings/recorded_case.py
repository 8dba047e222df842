"""Cases whose exchange is recorded, and what is compared between runs."""

import sys
from pathlib import Path

sys.path[:0] = [str(Path(__file__).parents[1] / "runs"), str(Path(__file__).parents[1] / "freefields")]

import h5py
import numpy as np
import small_case
from free_field_cases import BoxWorkspace, model

__all__ = ["BoxWorkspace", "SlopeWorkspace", "arrays", "differences", "model", "record", "text", "write_csv", "write_opensees"]

SlopeWorkspace = small_case.SlopeWorkspace


def record(work, **settings):
    """Adds [record] to the case of a workspace."""
    lines = "".join(f"{key} = \"{value}\"\n" for key, value in settings.items())
    work.case.write_text(work.case.read_text() + "\n[record]\nexchange = true\n" + lines)
    return work


def arrays(folder):
    """Every dataset of a run that is a result: particles, monitors, faces, energy."""
    found = {}

    def visit(name, item):
        if isinstance(item, h5py.Dataset) and not name.startswith(("timings", "processes", "timeline", "case", "plan")):
            found[name] = item[()].tobytes()

    with h5py.File(folder / "run.h5") as file:
        file.visititems(visit)
    return found


def differences(folder, reference):
    """Names of the datasets that are not the same bits."""
    found, expected = arrays(folder), arrays(reference)
    assert len(expected) > 20, "the reference run holds next to nothing"
    return sorted(name for name in found.keys() | expected.keys() if found.get(name) != expected.get(name))


def text(value):
    return value.decode() if isinstance(value, bytes) else value


def write_csv(path, times, depths, values, names=("vx", "vy", "sxx", "syy", "sxy")):
    """A table for `tremolo import`. values: [times, depths, names]."""
    rows = np.array([[t, d, *values[i, k]] for i, t in enumerate(times) for k, d in enumerate(depths)])
    np.savetxt(path, rows, delimiter=",", header=",".join(["time", "depth", *names]), comments="", fmt="%.10g")


def write_opensees(folder, times, levels, values):
    """vel.out, stress.out and points.csv as OpenSees would write them of nodes on every second level and of quadrilaterals with four
    integration points between them, under gravity. values: [times, levels, 5]."""
    nodes, centres = range(0, len(levels), 2), range(1, len(levels), 2)
    scale = np.max(np.abs(values[:, :, 4]))
    static = np.array([-1.0, -2.0, 0.0] * 4) * scale
    stress = np.tile(values[:, centres][:, :, 2:], (1, 1, 4)) + static
    np.savetxt(folder / "vel.out", np.column_stack([times, values[:, nodes, :2].reshape(len(times), -1)]), fmt="%.6g")
    np.savetxt(folder / "stress.out", np.column_stack([times, stress.reshape(len(times), -1)]), fmt="%.12g")
    lines = [f"node,{i},{-levels[k]}" for i, k in enumerate(nodes)] + [f"element,{i},{-levels[k]}" for i, k in enumerate(centres)]
    (folder / "points.csv").write_text("\n".join(["kind,tag,depth", *lines]) + "\n")
