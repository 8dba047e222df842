"""A soil test as arrays: the file that `tremolo soiltest` writes, or a reference curve in the same form.

    test = read("dss.h5")
    test.about["law"]                     # words and numbers of /about
    test.histories["000"]["sig_xy"]       # Pa, tension positive
    test.lines["critical_state"]["q"]     # Pa, at test.lines["critical_state"]["p"]

    reference = read_reference("dss_kpa.csv")  # columns of one history; kPa in the file, Pa here
    own = read_reference("dss.csv", "Pa")      # what `tremolo soiltest --out dss.csv` wrote
"""

from dataclasses import dataclass, field
from pathlib import Path

import h5py
import numpy as np

from tremolo import links

STRAINS = ("eps_xx", "eps_yy", "gamma_xy")
STRESSES = ("sig_xx", "sig_yy", "sig_zz", "sig_xy")
STRESS_UNITS = {"kPa": 1e3, "Pa": 1.0}


@dataclass
class SoilTest:
    """The tables of one file; a table that the kind of test does not have is None."""

    path: Path
    about: dict
    histories: dict
    summary: dict
    parameters: dict = field(default_factory=dict)
    lines: dict = field(default_factory=dict)
    strength_curve: dict | None = None
    strength_target: dict | None = None
    modulus_curve: dict | None = None


def _plain(values):
    """Columns of text as lists of words."""
    if values.dtype.kind in "SO":
        return [(v.rstrip(b"\0").decode("utf-8") if isinstance(v, bytes) else str(v)) for v in values]
    return values


def _table(file, name):
    """Columns of a table by name, None where the file has no such table."""
    if name not in file:
        return None
    group = file[name]
    return {column: _plain(group[column][()]) for column in links.names(group) if isinstance(group[column], h5py.Dataset)}


def _held(file, group):
    return links.names(file[group]) if group in file else []


def _required(file, path, name):
    table = _table(file, name)
    if not table:
        raise ValueError(f"{path}: has no table /{name}: not a file that `tremolo soiltest` wrote")
    return table


def _soil_test(file, path):
    about = {name: column[0] for name, column in _required(file, path, "about").items()}
    histories = {name: _required(file, path, f"tests/{name}/history") for name in _held(file, "tests")}
    if not histories:
        raise ValueError(f"{path}: holds no test")
    for name, history in histories.items():
        missing = [c for c in ("step", "gamma_xy", "eps_yy", "sig_xy", "p", "q") if c not in history]
        if missing:
            raise ValueError(f"{path}: the history of test {name} has no column {', '.join(missing)}")
    return SoilTest(
        path=path,
        about=about,
        histories=histories,
        summary=_required(file, path, "summary"),
        parameters=_table(file, "parameters") or {},
        lines={name: _table(file, f"lines/{name}") for name in _held(file, "lines")},
        strength_curve=_table(file, "strength_curve"),
        strength_target=_table(file, "strength_target"),
        modulus_curve=_table(file, "modulus_curve"),
    )


def read(path):
    """Reads OUT.h5.

    Raises FileNotFoundError, OSError for what is not HDF5 and ValueError for HDF5 that is no soil test.
    """
    path = Path(path)
    if not path.exists():
        raise FileNotFoundError(f"{path}: no such soil test")
    if not path.is_file():  # opening a pipe would wait for its other end
        raise OSError(f"{path}: not a regular file")
    try:
        file = h5py.File(path, "r")
    except OSError as error:
        raise OSError(f"{path}: cannot be read as HDF5: {error}") from error
    with file:
        try:
            return _soil_test(file, path)
        except (OSError, RuntimeError, LookupError, TypeError, AttributeError, MemoryError) as error:
            raise ValueError(f"{path}: cannot be read, the file is damaged: {error}") from error


def _numbers(path):
    """The first line's words and the numbers below it, a row a line."""
    try:
        with open(path, encoding="utf-8") as file:
            names = file.readline().strip().split(",")
            lines = [line for line in file if line.strip()]
    except UnicodeDecodeError as error:
        raise ValueError(f"{path}: is no reference curve, but a binary file") from error
    missing = [c for c in (*STRAINS, "sig_xx", "sig_yy", "sig_xy") if c not in names]
    if missing:
        raise ValueError(f"{path}: is no reference curve, its first line has no column {', '.join(missing)}")
    if not lines:
        raise ValueError(f"{path}: has no row below its first line")
    rows = np.empty((len(lines), len(names)))
    for number, line in enumerate(lines):
        try:
            rows[number] = [float(cell) for cell in line.split(",")]
        except ValueError as error:
            raise ValueError(
                f"{path}: row {number + 1} is not {len(names)} numbers: '{line.strip()[:60]}'"
            ) from error
    return names, rows


def read_reference(path, stress_unit="kPa"):
    """Columns of a reference curve by name: strains as they are, stresses from `stress_unit` to Pa.

    Raises OSError, and ValueError with the file's name for what is no table of a history.
    """
    path = Path(path)
    names, rows = _numbers(path)
    if "step" in names:
        # The last row of some of them is there twice.
        rows = rows[np.diff(rows[:, names.index("step")], prepend=-1.0) > 0.0]
    columns = dict(zip(names, rows.T))
    for name in (*STRAINS, *STRESSES):
        if not np.isfinite(columns.get(name, 0.0)).all():
            raise ValueError(f"{path}: column {name} has a value that is not finite")
    for name in STRESSES:
        if name in columns:
            columns[name] = STRESS_UNITS[stress_unit] * columns[name]
    columns.setdefault("step", np.arange(float(len(rows))))
    return columns
