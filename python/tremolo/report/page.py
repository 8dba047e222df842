"""Puts a report together: one HTML file with its pictures, charts and Plotly's own script in it."""

import base64
import functools
import gzip
import json
import tempfile
from pathlib import Path

from tremolo import drift, outputs
from tremolo.pictures import contact, linings, preview, sections, stages
from tremolo.report import checklist, facts, frames, kinds
from tremolo.run import Run

HERE = Path(__file__).parent


def require_libraries():
    """Jinja2 and plotly.offline. Raises ValueError where one is missing."""
    try:
        import jinja2
        import plotly.offline
    except ImportError as error:
        packages = "the Debian packages python3-jinja2 and python3-plotly (scripts/setup.sh installs them)"
        raise ValueError(f"a report needs {packages}: {error}") from error
    return jinja2, plotly.offline


def _titles(runs):
    """The folders' names, and whole paths where these are alike."""
    names = [run.name for run in runs]
    return names if len(set(names)) == len(names) else [str(run.path.parent) for run in runs]


def _drawn(run, picture):
    """One of the pictures of `tremolo plot` as a page holds it; None where the run has none."""
    with tempfile.TemporaryDirectory(prefix="tremolo_report_") as folder:
        path = picture(run, Path(folder))
        return None if path is None else "data:image/png;base64," + base64.b64encode(path.read_bytes()).decode("ascii")


def _drift(run, key):
    """How far sides and base have moved beyond their free field, as `tremolo plot` draws it; nothing without its table."""
    from tremolo.report import panels

    figure = drift.figure_of(run)
    return [] if figure is None else panels.drawn([figure], key)[0]


def _charts(runs, titles):
    """Charts by section."""
    from tremolo.report import charts  # needs Plotly, which write() asks for first

    names = charts.monitors(runs)
    structures = list(dict.fromkeys(name for run in runs for name in run.bodies if len(run.body(name)) > 1))
    lined = list(dict.fromkeys(name for run in runs for name in run.linings if len(run.lining(name))))
    cut = list(dict.fromkeys(name for run in runs for name in run.sections if len(run.section(name))))
    verified = {}
    for run, title in zip(runs, titles):
        if found := facts.verified(run):
            verified[title] = (found[0], [charts.exact(found[1], point) for point in found[1]["points"]["name"]])
    return {
        "monitors": [
            (name, [charts.history(runs, titles, name), charts.response(runs, titles, name), charts.fourier(runs, titles, name)])
            for name in names
        ],
        "structures": [charts.structure(runs, titles, name) for name in structures],
        "linings": [charts.lining(runs, titles, name) for name in lined],
        "sections": [charts.section(runs, titles, name) for name in cut],
        "props": charts.props(runs, titles),
        "water": charts.water(runs, titles),
        "drift": {title: found for i, (run, title) in enumerate(zip(runs, titles)) if (found := _drift(run, f"drift-{i}"))},
        "energy": charts.energy(runs, titles),
        "verified": verified,
        "activities": {title: charts.activities(run, i) for i, (run, title) in enumerate(zip(runs, titles))},
        "passes": charts.passes(runs, titles),
        "ratios": charts.ratios(runs, titles),
    }


def _figures(sections):
    """Key -> data and layout of every chart of the page."""
    found = [chart for _, own in sections["monitors"] for chart in own] + sections["structures"] + sections["linings"]
    found += sections["sections"]
    found += [chart for _, own in sections["verified"].values() for chart in own]
    found += [chart for own in sections["drift"].values() for chart in own]
    found += [sections["props"], sections["water"], sections["energy"], sections["passes"], *sections["activities"].values()]
    return {chart.key: _plain(chart.figure) for chart in found if chart is not None}


def _plain(figure):
    """A figure without Plotly's own template: the page has its colours."""
    figure.update_layout(template="none")
    return json.loads(figure.to_json())


def _json(content):
    """JSON that may stand in a script element."""
    return json.dumps(content, separators=(",", ":"), allow_nan=False).replace("</", "<\\/")


def _finite(content):
    """Gaps of a line are null; JSON has no NaN."""
    if isinstance(content, dict):
        return {key: _finite(value) for key, value in content.items()}
    if isinstance(content, list):
        return [_finite(value) for value in content]
    return None if isinstance(content, float) and content != content else content


@functools.cache
def _plotly():
    """Plotly's script, packed, in base 64. Level 9 would save 1 % more and take four times as long."""
    _, offline = require_libraries()
    return base64.b64encode(gzip.compress(offline.get_plotlyjs().encode("utf-8"), 6, mtime=0)).decode("ascii")


def _rendered(template, figures, **parts):
    """A page of a template, with style, script and Plotly in it.

    figures: what the page's script draws, by the names that it knows.
    """
    jinja2, _ = require_libraries()
    environment = jinja2.Environment(
        loader=jinja2.FileSystemLoader(HERE), autoescape=True, trim_blocks=True, lstrip_blocks=True, undefined=jinja2.StrictUndefined
    )
    return environment.get_template(template).render(
        style=(HERE / "page.css").read_text(encoding="utf-8"),
        script=(HERE / "page.js").read_text(encoding="utf-8"),
        content=figures,
        plotly=_plotly(),
        **parts,
    )


class Report:
    """The report of one run, or of several side by side.

    paths: folders of runs, or their run.h5; studies: what stands below them (_studies()).
    Raises ValueError for what is not a run, for a run without frames, and where Jinja2 or Plotly is missing.
    """

    def __init__(self, paths, studies=()):
        require_libraries()
        self._studies = studies
        self.runs = [Run(path) for path in paths]
        for run in self.runs:
            if len(run.times) == 0:
                raise ValueError(f"{run.path}: holds no particle frame yet")
        self._titles = _titles(self.runs)
        self._player = frames.Player(self.runs, self._titles)
        self._sections = _charts(self.runs, self._titles)

    @functools.cached_property
    def content(self):
        """JSON of what the page's script draws."""
        figures, ratios = _figures(self._sections) | _charts_of(self._studies), self._sections["ratios"]
        return _json(_finite({"player": self._player.content(), "charts": figures, "ratios": ratios}))

    def html(self, live=None):
        """The page. live: of a run that goes on, what the page needs to follow it (watch.py)."""
        runs, titles = self.runs, self._titles
        return _rendered(
            "run.html.jinja",
            self.content,
            title=runs[0].title if len(runs) == 1 else " | ".join(titles),
            runs=[
                {
                    "title": title, "name": run.title, "status": run.status, "case": run.case, "model": facts.model(run),
                    "picture": _drawn(run, preview.preview), "stages": _drawn(run, stages.picture), "plan": facts.plan(run),
                    "contacts": [drawn for name in run.bodies
                                 if (drawn := _drawn(run, functools.partial(contact.picture, name=name)))],
                    "linings": [drawn for name in run.linings for on_face in (False, True)
                                if (drawn := _drawn(run, functools.partial(linings.picture, name=name, contact=on_face)))],
                    "rings": [drawn for name in run.sections if run.section(name).centre is not None
                              if (drawn := _drawn(run, functools.partial(sections.ring, name=name)))],
                    "measures": facts.measures(run), "stage_measures": facts.stage_measures(run), "waits": facts.waits(run),
                    "processes": facts.processes(run), "origin": facts.origin(run), "warnings": facts.warnings(run),
                    "checklist": None if live else checklist.checklist(run),
                }
                for run, title in zip(runs, titles)
            ],
            differences=[facts.differences(runs[0], run, [titles[0], title]) for run, title in zip(runs[1:], titles[1:])],
            sections=self._sections,
            studies=self._studies,
            player={"fields": [field.label for field, _ in self._player.fields], "frames": len(self._player.times),
                    "of": len(runs[0].times)},
            live=_json(live) if live else None,
        )


def _studies(paths):
    require_libraries()
    from tremolo.report import studies  # needs Plotly

    return [studies.read(path, number) for number, path in enumerate(paths)]


def _charts_of(studies):
    return {chart.key: _plain(chart.figure) for study in studies for chart in study.charts}


def _of_runs(runs, studies):
    report = Report(runs, _studies(studies))
    folder = report.runs[0].path.parent
    return report.html(), folder / ("report.html" if len(runs) == 1 else "comparison.html")


def _of_studies(paths):
    found = _studies(paths)
    page = _rendered(
        "study.html.jinja", _json(_finite({"player": {"fields": []}, "charts": _charts_of(found), "ratios": []})),
        title=" | ".join(dict.fromkeys(study.title for study in found)), studies=found,
    )
    first = Path(paths[0])
    return page, first / "report.html" if first.is_dir() else first.with_suffix(".html")


def write(paths, out=None):
    """Writes the report of one run, of several side by side, with studies one below the other, or of these alone; returns its path.

    paths: folders of runs, or their run.h5; or what `tremolo soiltest`, `column`, `swap`, `cost` and `sweep` wrote.
    out: the file (default: report.html beside the only run, comparison.html beside the first of several; report.html in the folder
    of a swap, a ladder or a sweep, OUT.html beside OUT.h5).
    Raises OSError and ValueError for what cannot be read, for a run without frames, and where Jinja2 or Plotly is missing.
    """
    if out:  # before the work
        outputs.made_folder(Path(out).parent)
        outputs.writable(out, inputs=paths)
    runs = [path for path in paths if kinds.kind_of(path) == "run"]
    studies = [path for path in paths if path not in runs]
    page, beside = _of_runs(runs, studies) if runs else _of_studies(studies)
    out = outputs.writable(out or beside, inputs=paths)
    out.write_text(page, encoding="utf-8")
    return out
