"""What a path that is no run is instead, and which command draws it."""

from pathlib import Path

import h5py

_FOLDERS = {"swap.json": ("a swap", "python3 -m tremolo swap"), "cost.json": ("a cost ladder", "python3 -m tremolo cost-picture")}
_FILES = {"tests": ("a soil test", "python3 -m tremolo soiltest"), "histories": ("a free field alone", "python3 -m tremolo column")}


def require_run(path):
    """Raises ValueError, with what to do instead, where the path is a result that has no report."""
    path = Path(path)
    found = None
    if path.is_dir() and not (path / "run.h5").exists():
        found = next((kind for name, kind in _FOLDERS.items() if (path / name).exists()), None)
    elif path.is_file() and h5py.is_hdf5(path):
        with h5py.File(path, "r") as file:
            if "schema_version" not in file.attrs:
                found = next((kind for name, kind in _FILES.items() if name in file), None)
    if found:
        raise ValueError(f"{path}: is {found[0]}, and a report is of runs; its picture: {found[1]} {path}")
