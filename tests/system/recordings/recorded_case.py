"""Cases whose exchange is recorded, and what is compared between runs."""

import sys
from pathlib import Path

sys.path[:0] = [str(Path(__file__).parents[1] / "runs"), str(Path(__file__).parents[1] / "freefields")]

import h5py
import small_case
from free_field_cases import BoxWorkspace, model

__all__ = ["BoxWorkspace", "SlopeWorkspace", "arrays", "differences", "model", "record", "text"]

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
        if isinstance(item, h5py.Dataset) and not name.startswith(("timings", "processes", "case", "plan")):
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
