"""What a path holds that a report can be made of."""

from pathlib import Path

import h5py

_FOLDERS = {"swap.json": "swap", "cost.json": "cost", "sweep.json": "sweep"}
_FILES = {"tests": "soiltest", "histories": "column"}


def kind_of(path):
    """"swap", "cost", "sweep", "soiltest" or "column" where the path is what that command wrote; otherwise "run"."""
    path = Path(path)
    if path.is_dir() and not (path / "run.h5").exists():
        return next((kind for name, kind in _FOLDERS.items() if (path / name).exists()), "run")
    if path.is_file() and h5py.is_hdf5(path):
        with h5py.File(path, "r") as file:
            if "schema_version" not in file.attrs:
                return next((kind for name, kind in _FILES.items() if name in file), "run")
    return "run"


def alike(paths):
    """Whether the paths are all runs or all studies of one run or soil. Raises ValueError where they are mixed."""
    found = {kind_of(path) == "run" for path in paths}
    if len(found) > 1:
        raise ValueError(f"{' '.join(map(str, paths))}: a report is of runs, or of studies (swap, cost, sweep, soil test, column), not of both")
    return found.pop()
