"""The table of a sweep, a row a run: sweep.csv, and sweep.h5 with the same columns and their units."""

import csv
import json

import h5py
import numpy as np

from tremolo.sweep import measures
from tremolo.sweep.plan import COMPLETE, FAILED, MISSING

MOTION = {"pga": "m/s2", "pgv": "m/s", "arias": "m/s", "significant_duration": "s", "mean_period": "s"}
MOTION_NAMES = {"pga": "pga_m_s2", "pgv": "pgv_m_s", "arias": "arias_m_s", "significant_duration": "significant_duration_s",
                "mean_period": "mean_period_s"}


class Column:
    """A name, a unit ("" of words), and a value a run: numbers, or texts; None where a run has none."""

    def __init__(self, name, unit, values):
        self.name, self.unit, self.values = name, unit, values

    @property
    def is_number(self):
        return bool(self.unit)

    def numbers(self):
        """As an array, NaN where there is none."""
        return np.array([np.nan if value is None else value for value in self.values], dtype=float)


def _of_axis(key, unit, values):
    if all(isinstance(value, (int, float)) and not isinstance(value, bool) for value in values):
        return Column(key, unit or "1", values)
    return Column(key, "", [value if isinstance(value, str) else json.dumps(value) for value in values])


def columns(plan):
    """All columns of the table: run, axes, incident motion, status, message, replayed, measures."""
    results = [run.result() or {"status": MISSING, "message": "", "replayed": None, "measures": {}} for run in plan.runs]
    found = [Column("run", "", [run.name for run in plan.runs])]
    found += [_of_axis(key, plan.units[key], [run.values[i] for run in plan.runs]) for i, key in enumerate(plan.keys)]
    if any(run.motion for run in plan.runs):
        found += [Column(MOTION_NAMES[name], unit, [(run.motion or {}).get(name) for run in plan.runs]) for name, unit in MOTION.items()]
    found += [Column(name, "", [result[name] or "" for result in results]) for name in ("status", "message", "replayed")]
    names = list(dict.fromkeys(name for result in results for name in result["measures"]))
    found += [Column(name, measures.unit(name), [result["measures"].get(name) for result in results]) for name in names]
    return found


def write(plan):
    """Writes both files; returns their paths."""
    found = columns(plan)
    as_csv, as_hdf5 = plan.folder / "sweep.csv", plan.folder / "sweep.h5"
    with open(as_csv, "w", newline="", encoding="utf-8") as stream:
        writer = csv.writer(stream)
        writer.writerow([column.name for column in found])
        writer.writerows([["" if value is None else value for value in row] for row in zip(*(column.values for column in found))])
    with h5py.File(as_hdf5, "w") as file:
        file.attrs.update({"content": "sweep", "schema_version": "1.0", "title": plan.title})
        group = file.create_group("runs")
        group.attrs["columns"] = [column.name for column in found]
        group.attrs["units"] = [column.unit or "1" for column in found]
        for column in found:
            values = column.numbers() if column.is_number else np.array(column.values, dtype=h5py.string_dtype())
            group.create_dataset(column.name, data=values).attrs["unit"] = column.unit or "1"
    return as_csv, as_hdf5


def counts(plan):
    """How many runs are complete, failed, missing."""
    states = [run.status() for run in plan.runs]
    return tuple(states.count(state) for state in (COMPLETE, FAILED, MISSING))
