"""The figures of a study, by the name of their picture: what `tremolo plot` writes and a report draws as charts."""

from pathlib import Path

from tremolo import column, cost, outputs, pore_pressure, style, swap
from tremolo.report.kinds import kind_of
from tremolo.site import pictures as site_pictures
from tremolo.site.read import Site
from tremolo.soil_test import drawing, record
from tremolo.sweep import pictures as sweep_pictures
from tremolo.sweep import site_responses
from tremolo.sweep.plan import Plan
from tremolo.sweep.statistics import Sweep


def _sweep(path):
    sweep = Sweep(Plan(path))
    found = {"sweep": sweep_pictures.draw(sweep)}
    return found | (site_responses.draw(sweep) if sweep.plan.has_site_responses else {"histories": sweep_pictures.draw_histories(sweep)})


_FIGURES = {
    "column": lambda path: {path.stem: column.draw(path), path.stem + "_water": pore_pressure.draw(path)},
    "site": lambda path: site_pictures.of_site(Site(path)),
    "soiltest": lambda path: {path.stem: drawing.draw(record.read(path))},
    "swap": lambda path: {"swap": swap.draw(path)},
    "cost": lambda path: {"cost": cost.draw(path)},
    "sweep": _sweep,
}


def of_study(path):
    """Name -> figure of what `tremolo column`, `soiltest`, `swap`, `cost` or `sweep` wrote."""
    found = _FIGURES[kind_of(path)](Path(path))
    return {name: figure for name, figure in found.items() if figure is not None}


def write(path, folder=None):
    """Writes them; yields their paths. folder: pictures/ beside a file, or in the folder of a study, unless given."""
    path = Path(path)
    folder = outputs.made_folder(folder or (path if path.is_dir() else path.parent) / "pictures")
    for name, figure in of_study(path).items():
        yield style.save(figure, folder, f"{name}.png")
