"""What a report shows of a soil test, a free field alone, a swap of models, or a ladder of cost: the panels of its picture as
charts that zoom, and its numbers as tables."""

from pathlib import Path
from typing import NamedTuple

import h5py
import numpy as np

from tremolo import column, cost, pore_pressure, soil_record, soiltest, style, swap
from tremolo.report import panels
from tremolo.report.facts import Table
from tremolo.report.kinds import kind_of


class Study(NamedTuple):
    title: str
    kind: str  # in words
    charts: list
    maps: list  # (picture as a data URI, words): what is coloured over an area
    tables: list
    file: str = ""  # the text of the file that says what was done


def _number(value):
    if isinstance(value, str):
        return value
    return "-" if value is None or not np.isfinite(value) else f"{value:.5g}"


def _columns(table, caption):
    """A table of a file, column by column."""
    names = list(table)
    return Table([name.replace("_", " ") for name in names], [[_number(cell) for cell in row] for row in zip(*table.values())], caption)


def _drawn(figures, key):
    """Charts and maps of figures."""
    charts, maps = [], []
    for number, figure in enumerate(figures):
        charts += panels.charts(figure, f"{key}-{number}")
        if panels.has_map(figure):
            maps.append((panels.image(figure), "the whole picture"))
        style.plt.close(figure)
    return charts, maps


def _swap(path, key):
    entries = swap.read(path)
    charts, maps = _drawn([swap.draw(path)], key)
    monitors = list(next((entry["monitors"] for entry in entries if not entry["refused"]), {}))
    rows = [
        [entry["model"], _number(entry["source_cpu_s"]), _number(entry["domain_cpu_s"]),
         *(_number(100.0 * entry["monitors"][monitor]) for monitor in monitors), ""]
        if not entry["refused"] else [entry["model"], "-", "-", *("-" for _ in monitors), entry["refused"]]
        for entry in entries
    ]
    headings = ["model", "CPU time of the free fields (s)", "CPU time of the domain (s)",
                *(f"difference at {monitor} (%)" for monitor in monitors), "refused"]
    title = f"Free-field models of {Path(path).resolve().name}"
    return Study(title, "swap of free-field models", charts, maps, [Table(headings, rows, "Models")])


def _cost(path, key):
    study = cost.read(path)
    charts, maps = _drawn([cost.draw(path)], key)
    rows = [
        [rung["folder"], _number(rung["size"]), _number(rung["cpu_s"]) if "cpu_s" in rung else "-",
         _number(100.0 * rung["error"]) if "error" in rung else "-", "yes" if rung.get("front") else ""]
        for rung in study["rungs"]
    ]
    tables = [Table(["setting", "cell size (m)", "CPU time (s)", "error (%)", "on the front"], rows, f"Rungs; {study['error_of']}")]
    fits = [[fit["family"] or "all", str(fit["points"]), _number(fit["order"])] for fit in study.get("fits", [])]
    if fits:
        tables.append(Table(["family", "rungs", "order of the error in the cell size"], fits, "Orders"))
    return Study(study["title"], "ladder of error and cost", charts, maps, tables)


def _soiltest(path, key):
    test = soil_record.read(path)
    charts, maps = _drawn([soiltest.draw(test)], key)
    facts = {name: value for name, value in test.about.items() if name not in ("title", "test_file")}
    rows = [[name.replace("_", " "), _number(value).replace("_", " ")] for name, value in facts.items()]
    about = Table(["what", "value"], rows, "Test, SI units")
    tables = [about, _columns(test.summary, "Summary, SI units")]
    if test.parameters:
        tables.append(_columns(test.parameters, "Parameters in force"))
    return Study(str(test.about["title"]), "soil test", charts, maps, tables, str(test.about["test_file"]))


def _column(path, key):
    figures = [figure for figure in (column.draw(path), pore_pressure.draw(path)) if figure is not None]
    charts, maps = _drawn(figures, key)
    with h5py.File(path, "r") as file:
        profile = column.table(file["profile"])
    return Study(Path(path).stem, "free field alone", charts, maps, [_columns(profile, "Profile of peak values, SI units")])


_READERS = {"swap": _swap, "cost": _cost, "soiltest": _soiltest, "column": _column}


def read(path, number):
    """The study at a path. number: which of a report's studies it is.

    Raises OSError and ValueError for what cannot be read.
    """
    try:
        return _READERS[kind_of(path)](path, f"study-{number}")
    except (LookupError, TypeError) as error:
        raise ValueError(f"{path}: cannot be read, the file is damaged: {error!r}") from error
