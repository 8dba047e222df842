"""What a path holds that a report can be made of."""

from pathlib import Path

import h5py

from tremolo.run import text

_FOLDERS = {"site.json": "site", "swap.json": "swap", "cost.json": "cost", "sweep.json": "sweep"}
_CONTENTS = {"column": "column", "soil test": "soiltest"}


def kind_of(path):
    """"site", "swap", "cost", "sweep", "soiltest" or "column" where the path is what that command wrote; otherwise "run"."""
    path = Path(path)
    if path.is_dir() and not (path / "run.h5").exists():
        return next((kind for name, kind in _FOLDERS.items() if (path / name).exists()), "run")
    if path.is_file() and h5py.is_hdf5(path):
        with h5py.File(path, "r") as file:
            return _CONTENTS.get(text(file.attrs.get("content", "")), "run")
    return "run"
