"""What a report shows of a soil test, a free field alone, a site under several models, a swap of models, a ladder of cost, or a sweep: the panels of its picture as
charts that zoom, and its numbers as tables."""

from pathlib import Path
from typing import NamedTuple

import numpy as np

from tremolo import cost, figures, swap
from tremolo.run import Run
from tremolo.site import suite_tables
from tremolo.site import tables as site_tables
from tremolo.site.read import Site
from tremolo.soil_test import record
from tremolo.report import panels
from tremolo.report.facts import Table
from tremolo.report.kinds import kind_of
from tremolo.sweep import pictures, site_responses, statistics
from tremolo.sweep.plan import COMPLETE, Plan, in_words


class Study(NamedTuple):
    title: str
    kind: str  # in words
    charts: list
    maps: list  # (picture as a data URI, words): what is coloured over an area
    tables: list
    file: str = ""  # the text of the file that says what was done
    warnings: tuple = ()  # sentences, above all else
    leading: tuple = ()  # tables above the charts


def _number(value):
    if isinstance(value, str):
        return value
    return "-" if value is None or not np.isfinite(value) else f"{value:.5g}"


def _columns(table, caption):
    """A table of a file, column by column."""
    names = list(table)
    return Table([name.replace("_", " ") for name in names], [[_number(cell) for cell in row] for row in zip(*table.values())], caption)


def _drawn(path, key):
    """Charts and maps of the study's pictures."""
    return panels.drawn(figures.of_study(path).values(), key)


def _swap(path, key):
    entries = swap.read(path)
    charts, maps = _drawn(path, key)
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
    charts, maps = _drawn(path, key)
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


def _sweep(path, key):
    sweep = statistics.Sweep(Plan(path))
    charts, maps = _drawn(path, key)
    names = statistics.responses(sweep)
    labels = [pictures.label(name, sweep.columns[name].unit).replace("$", "") for name in names]
    tables = [_sweep_groups(sweep, names, labels), *_sweep_pairs(sweep, names, labels), *_sweep_lines(sweep, names, labels),
              *_sweep_curves(sweep), _sweep_runs(sweep, names, labels)]
    study = Path(sweep.plan.study)
    text = study.read_text(encoding="utf-8") if study.exists() else ""
    return Study(sweep.plan.title, "sweep", charts, maps, tables, text)


def _sweep_groups(sweep, names, labels):
    """Median and spread of each response over the runs that differ in the motion alone."""
    colour = [sweep.colour_key] if sweep.colour_key else []
    rest = [key for key, _ in sweep.groups()[0].rest]
    rows = []
    for group in sweep.groups():
        row = [in_words(group.colour)] * len(colour) + [in_words(value) for _, value in group.rest]
        for name in names:
            count, median, low, high = sweep.spread(name, group)
            row.append(f"{median:.4g} ({low:.4g} to {high:.4g}), {count} of {len(group.runs)}" if count else f"none of {len(group.runs)}")
        rows.append(row or ["all"])
    return Table([*colour, *rest, *labels], rows, "Median (16 to 84 %) and number of the runs that differ in the motion alone")


def _sweep_pairs(sweep, names, labels):
    """Each value of the axis with colours against the first one."""
    if not sweep.colour_key:
        return []
    rows = [
        [label, in_words(pair.colour), str(pair.pairs), str(pair.smaller), str(pair.larger), str(pair.alike), _number(pair.median)]
        for name, label in zip(names, labels) for pair in statistics.compared(sweep, name)
    ]
    headings = ["response", sweep.colour_key, "pairs", "smaller", "larger", "alike", "median difference"]
    caption = f"Against {sweep.colour_key} = {in_words(sweep.colours[0])}, all else alike; a failure that comes is earlier than one that does not"
    return [Table(headings, rows, caption)]


def _sweep_lines(sweep, names, labels):
    """The lines of responses over the intensity."""
    if sweep.intensity is None:
        return []
    rows = []
    for name, label in zip(names, labels):
        for colour in sweep.colours:
            runs = [number for number in sweep.complete if sweep.has_colour(number, colour)]
            line = statistics.fitted(sweep.numbers(sweep.intensity)[runs], sweep.numbers(name)[runs])
            if line:
                rows.append([label, "all" if colour is None else in_words(colour), str(line.runs), _number(line.factor), _number(line.power),
                             _number(line.deviation)])
    headings = ["response y", sweep.colour_key or "runs", "runs", "factor", "power", "standard deviation of ln y"]
    return [Table(headings, rows, f"Lines y = factor x^power, x: {pictures.INTENSITIES[sweep.intensity]}")] if rows else []


_CURVES = {"spectra": "Response spectra, 5 %", "amplification": "Response spectrum of the surface over that of the outcrop",
           "amplification_fourier": "Smoothed Fourier amplitudes, surface over what lies below (Konno & Ohmachi)",
           "profile_vs": "Vs at small strain", "profile": "Peak acceleration and strain"}


def _sweep_curves(sweep):
    """Medians and deviations of site responses."""
    if not sweep.plan.has_site_responses or not sweep.complete:
        return []
    found = suite_tables.of_suite(site_responses.families(sweep))
    return [_columns(table, f"{_CURVES[name]}: median and standard deviation of the logarithm") for name, table in found.items()]


def _sweep_runs(sweep, names, labels):
    columns = [sweep.columns[name] for name in ("run", *sweep.plan.varied(), *names)]
    rows = []
    for number, (status, message) in enumerate(zip(sweep.columns["status"].values, sweep.columns["message"].values)):
        row = [in_words(value) if isinstance(value, (str, list)) else _number(value) for value in (column.values[number] for column in columns)]
        rows.append([*row, status if status == COMPLETE else f"{status}: {message}".removesuffix(": ")])
    return Table(["run", *sweep.plan.varied(), *labels, "status"], rows, "Runs")


def _soiltest(path, key):
    test = record.read(path)
    charts, maps = _drawn(path, key)
    facts = {name: value for name, value in test.about.items() if name not in ("title", "test_file")}
    rows = [[name.replace("_", " "), _number(value).replace("_", " ")] for name, value in facts.items()]
    about = Table(["what", "value"], rows, "Test, SI units")
    tables = [about, _columns(test.summary, "Summary, SI units")]
    if test.parameters:
        tables.append(_columns(test.parameters, "Parameters in force"))
    return Study(str(test.about["title"]), "soil test", charts, maps, tables, str(test.about["test_file"]))


def _column(path, key):
    charts, maps = _drawn(path, key)
    with Run(path) as run:
        tables = [_columns(run.table("profile"), "Profile of peak values, SI units")]
        leading = [_columns(run.table(name), caption) for name, caption in (
            ("site", "Site, SI units"), ("layers", "Layers, SI units"), ("measures", "Motion measures, SI units"))]
        warnings = (run.table("warnings") or {"text": []})["text"]
        return Study(run.title, f"free field alone, model {run.attribute('model')}", charts, maps, tables, run.case, tuple(warnings),
                     tuple(leading))


_SITE_CAPTIONS = {"models": "Models", "site": "Site", "layers": "Layers", "measures": "Motion measures",
                  "spectra": "Response spectra of the surface, 5 %", "amplification": "Amplification, smoothed (Konno & Ohmachi)"}


def _caption(name):
    kind, _, model = name.rpartition("_")
    return _SITE_CAPTIONS.get(name) or {"profile": "Profile of peak values", "strain_compatible": "Strain-compatible soil"}[kind] + ", " + model


def _site(path, key):
    site = Site(path)
    charts, maps = _drawn(path, key)
    tables = {name: _columns(table, _caption(name)) for name, table in site_tables.of_site(site).items() if name != "amplification_raw"}
    leading = [tables.pop(name) for name in ("models", "site", "layers")]
    warnings = [f"{model}: {text}" for model, text in site.warnings()]
    warnings += [f"{model} cannot compute this site: {why}" for model, why in site.refused.items()]
    return Study(site.title, "site response under " + ", ".join(site.models), charts, maps, list(tables.values()), site.first.run.case,
                 tuple(warnings), tuple(leading))


_READERS = {"swap": _swap, "cost": _cost, "sweep": _sweep, "soiltest": _soiltest, "column": _column, "site": _site}


def read(path, number):
    """The study at a path. number: which of a report's studies it is.

    Raises OSError and ValueError for what cannot be read.
    """
    try:
        return _READERS[kind_of(path)](path, f"study-{number}")
    except (LookupError, TypeError) as error:
        raise ValueError(f"{path}: cannot be read, the file is damaged: {error!r}") from error
