"""The charts of a report, as Plotly figures: histories, spectra, structures, pore water, energy, and where the time went.

Several runs share a chart: a run has its line style, a direction or an entry its colour.
"""

import numpy as np
from plotly import graph_objects as go
from plotly.subplots import make_subplots

from tremolo import pore_pressure, style, timeline
from tremolo.histories import PERIODS, even_steps
from tremolo.report import spectra
from tremolo.response_spectrum import response_spectrum

MOST_POINTS = 1500
TICKS = [0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 20]  # s or Hz
DASHES = ["solid", "dash", "dot", "dashdot", "longdash", "longdashdot"]
DIRECTIONS = (("x", "horizontal"), ("y", "vertical"))
QUANTITIES = (("a", "acceleration (m/s²)"), ("v", "velocity (m/s)"), ("u", "displacement (m)"))


class Chart:
    """A figure with its heading, and in words what it shows, for those who cannot see it."""

    def __init__(self, key, heading, words, figure):
        self.key, self.heading, self.words, self.figure = key, heading, words, figure


def kept(values):
    """Indices of at most MOST_POINTS samples: the lowest and the highest of each stretch, so that no peak is lost."""
    if len(values) <= MOST_POINTS:
        return np.arange(len(values))
    edges = np.linspace(0, len(values), MOST_POINTS // 2 + 1).astype(int)
    found = {0, len(values) - 1}
    for begin, end in zip(edges[:-1], edges[1:]):
        found.update((begin + int(np.argmin(values[begin:end])), begin + int(np.argmax(values[begin:end]))))
    return np.array(sorted(found))


def numbers(values):
    """Five digits are more than a screen shows, and a third of the bytes."""
    return [float(f"{value:.5g}") for value in np.asarray(values, dtype=float)]


def _add(figure, x, y, name, colour, dash="solid", row=1, group=None, shown=True, thin=True):
    chosen = kept(y) if thin else np.arange(len(y))
    figure.add_trace(
        go.Scatter(
            x=numbers(x[chosen]), y=numbers(y[chosen]), name=name, legendgroup=group or name, showlegend=shown, mode="lines",
            line={"color": colour, "dash": dash, "width": 1.3},
        ),
        row=row, col=1,
    )


def _stacked(labels, height, **options):
    """Charts above each other with one axis of time."""
    figure = make_subplots(len(labels), 1, shared_xaxes=True, vertical_spacing=0.06, **options)
    for row, label in enumerate(labels, 1):
        figure.update_yaxes(title_text=label, row=row)
    figure.update_xaxes(title_text="time t (s)", row=len(labels))
    figure.update_layout(height=height)
    return figure


def _label(text, title, runs):
    return f"{text}, {title}" if len(runs) > 1 else text


def _of_all(runs, titles):
    """Run, title and dash of each."""
    return [(run, title, DASHES[i % len(DASHES)]) for i, (run, title) in enumerate(zip(runs, titles))]


def monitors(runs):
    """Names of the monitors that have a history, those of the first run first."""
    names = dict.fromkeys(name for run in runs for name in run.monitors)
    return [name for name in names if any(name in run.monitors and len(run.monitor(name)) > 1 for run in runs)]


def _series(runs, titles, name):
    for run, title, dash in _of_all(runs, titles):
        if name in run.monitors and len(run.monitor(name)) > 1:
            yield run.monitor(name), title, dash


def history(runs, titles, name):
    figure = _stacked([label for _, label in QUANTITIES], 620)
    place = ""
    for series, title, dash in _series(runs, titles, name):
        place = place or f", which starts at x = {series['x'][0]:.2f} m, y = {series['y'][0]:.2f} m"
        for row, (quantity, _) in enumerate(QUANTITIES, 1):
            for number, (direction, text) in enumerate(DIRECTIONS):
                _add(figure, series["time"], series[quantity + direction], _label(text, title, runs), style.COLOURS[number], dash,
                     row, shown=row == 1)
    words = f"Acceleration, velocity and displacement over time at the monitor {name}{place}"
    return Chart(f"history-{name}", f"{name}: histories", words, figure)


def _logarithmic(figure, x, y, values):
    figure.update_xaxes(type="log", title_text=x, range=[float(np.log10(values[0])), float(np.log10(values[-1]))], tickvals=TICKS)
    figure.update_yaxes(title_text=y, rangemode="tozero")
    figure.update_layout(height=400)


def response(runs, titles, name):
    figure = make_subplots(1, 1)
    for series, title, dash in _series(runs, titles, name):
        for number, (direction, text) in enumerate(DIRECTIONS):
            acceleration, dt = even_steps(series["time"], series["a" + direction])
            periods = PERIODS[PERIODS >= 2.0 * dt]
            _add(figure, periods, response_spectrum(acceleration, dt, periods), _label(text, title, runs), style.COLOURS[number], dash,
                 thin=False)
    _logarithmic(figure, "period (s)", "spectral acceleration (m/s²)", PERIODS)
    words = f"Pseudo-acceleration response spectra with 5 % damping at the monitor {name}"
    return Chart(f"response-{name}", f"{name}: response spectra, 5 % damping", words, figure)


def fourier(runs, titles, name):
    figure = make_subplots(1, 1)
    centres = np.array([spectra.LOWEST, spectra.HIGHEST])
    for series, title, dash in _series(runs, titles, name):
        for number, (direction, text) in enumerate(DIRECTIONS):
            acceleration, dt = even_steps(series["time"], series["a" + direction])
            centres = spectra.frequencies(series["time"][-1] - series["time"][0], dt)
            _add(figure, centres, spectra.fourier_amplitude(acceleration, dt, centres), _label(text, title, runs), style.COLOURS[number],
                 dash, thin=False)
    _logarithmic(figure, "frequency (Hz)", "Fourier amplitude of acceleration (m/s)", centres)
    words = f"Smoothed Fourier amplitude spectra of the acceleration at the monitor {name}"
    return Chart(f"fourier-{name}", f"{name}: Fourier spectra", words, figure)


def ratios(runs, titles):
    """What the page divides: frequencies (Hz) and smoothed amplitudes (m/s) of each run, direction and monitor, the lowest first:
    what lies deepest is mostly what one divides by."""
    spectra_of = []
    for run, title, dash in _of_all(runs, titles):
        series = {name: run.monitor(name) for name in run.monitors if len(run.monitor(name)) > 1}
        if len(series) < 2:
            continue
        series = dict(sorted(series.items(), key=lambda item: item[1]["y"][0]))
        first = next(iter(series.values()))
        _, dt = even_steps(first["time"], first["ax"])
        centres = spectra.frequencies(first["time"][-1] - first["time"][0], dt)
        amplitudes = {
            text: {
                name: numbers(spectra.fourier_amplitude(even_steps(one["time"], one["a" + direction])[0], dt, centres))
                for name, one in series.items()
            }
            for direction, text in DIRECTIONS
        }
        spectra_of.append({"title": title, "dash": dash, "frequency": numbers(centres), "amplitude": amplitudes})
    return spectra_of


def structure(runs, titles, name):
    """Motion of a structure and the forces on it."""
    labels = ["displacement (m)", "tilt (°)", "vertical force (kN/m)", "horizontal force (kN/m)"]
    figure = _stacked(labels, 760)
    for run, title, dash in _of_all(runs, titles):
        if name not in run.bodies or len(run.body(name)) < 2:
            continue
        body = run.body(name)
        for number, (direction, text) in enumerate((("x", "horizontal"), ("y", "vertical"))):
            _add(figure, body["time"], body[direction] - body[direction][0], _label(text, title, runs), style.COLOURS[number], dash, 1)
        _add(figure, body["time"], np.degrees(body["tilt"]), _label("tilt", title, runs), style.COLOURS[2], dash, 2)
        for number, (force, text) in enumerate((("normal", "normal force"), ("friction", "friction"), ("water", "excess pore pressure"))):
            for row, direction in ((3, "y"), (4, "x")):
                _add(figure, body["time"], body[f"{force}_{direction}"] / 1e3, _label(text, title, runs), style.COLOURS[3 + number], dash,
                     row, shown=row == 3)
    words = f"Displacement, tilt (counter-clockwise) and forces of the structure {name} over time"
    return Chart(f"structure-{name}", f"{name}: motion and forces", words, figure)


def lining(runs, titles, name):
    """The least and the greatest section forces of a lining over time."""
    figure = _stacked(["M (kNm/m)", "N (kN/m)", "Q (kN/m)"], 620)
    for run, title, dash in _of_all(runs, titles):
        if name not in run.linings or not len(run.lining(name)):
            continue
        own = run.lining(name)
        for row, force in enumerate(("moment", "axial_force", "shear_force"), 1):
            values = getattr(own, force) / 1e3
            for text, extreme, colour in (("greatest", values.max(axis=1), 1), ("least", values.min(axis=1), 0)):
                _add(figure, own.time, extreme, _label(text, title, runs), style.COLOURS[colour], dash, row, shown=row == 1)
    words = f"The least and the greatest moment, axial and shear force around the lining {name} over time"
    return Chart(f"lining-{name}", f"{name}: extremes around it", words, figure)


def props(runs, titles):
    """The force in each prop over time; None where there is none."""
    figure = _stacked(["N (kN/m), tension positive"], 360)
    names = {}
    for run, title, dash in _of_all(runs, titles):
        for name in run.props:
            own = run.prop(name)
            colour = style.COLOURS[names.setdefault(name, len(names)) % len(style.COLOURS)]
            _add(figure, own.time, own.force / 1e3, _label(name, title, runs), colour, dash, 1)
    return Chart("props", "Forces in props", "The force in each prop over time", figure) if names else None


def section(runs, titles, name):
    """The section forces of a cut, or the least and the greatest of a ring of cuts, over time."""
    figure = _stacked(["M (kNm/m)", "N (kN/m)", "Q (kN/m)"], 620)
    ring = False
    for run, title, dash in _of_all(runs, titles):
        if name not in run.sections or not len(run.section(name)):
            continue
        own = run.section(name)
        ring = own.centre is not None
        for row, force in enumerate(("moment", "axial_force", "shear_force"), 1):
            values = getattr(own, force) / 1e3
            lines = (("greatest", values.max(axis=1), 1), ("least", values.min(axis=1), 0)) if ring else ((own.structure, values[:, 0], 0),)
            for text, line, colour in lines:
                _add(figure, own.time, line, _label(text, title, runs), style.COLOURS[colour], dash, row, shown=row == 1)
    what = "The least and the greatest moment, axial and shear force around" if ring else "Moment, axial and shear force of"
    return Chart(f"section-{name}", f"{name}: {'extremes around it' if ring else 'section forces'}", f"{what} the section {name} over time",
                 figure)


def water(runs, titles):
    """r_u and pore pressure at the monitors below the water table; None where there are none."""
    figure = _stacked(["pore pressure ratio r_u (1)", "pore pressure (kPa)"], 520)
    names = {}
    for run, title, dash in _of_all(runs, titles):
        for name, series in pore_pressure.wet_monitors(run).items():
            colour = style.COLOURS[names.setdefault(name, len(names)) % len(style.COLOURS)]
            _add(figure, series["time"], series["pore_pressure_ratio"], _label(name, title, runs), colour, dash, 1)
            _add(figure, series["time"], series["pore_pressure"] / 1e3, _label(name, title, runs), colour, dash, 2, shown=False)
    if not names:
        return None
    return Chart("water", "Pore water", "Pore pressure ratio and pore pressure at the monitors over time", figure)


def energy(runs, titles):
    """Every entry of the ledger, and below the absolute values on a logarithmic axis; None where no run has a ledger."""
    ledgers = [(run.energy, title, dash) for run, title, dash in _of_all(runs, titles) if run.energy is not None and len(run.energy) > 1]
    entries = list(dict.fromkeys(c for ledger, _, _ in ledgers for c in ledger.columns[1:] if np.any(ledger[c])))
    if not entries:
        return None
    figure = _stacked(["energy (kJ per m)", "absolute value (kJ per m)"], 620)
    top = max(np.abs(ledger[c]).max() for ledger, _, _ in ledgers for c in entries if c in ledger.columns) / 1e3
    for ledger, title, dash in ledgers:
        for number, entry in enumerate(entries):
            if entry not in ledger.columns:
                continue
            name, colour = _label(entry, title, runs), style.COLOURS[number % (len(style.COLOURS) - 1)]
            line = dash if number < len(style.COLOURS) - 1 else "dot"
            values = ledger[entry] / 1e3
            _add(figure, ledger["time"], values, name, colour, line, 1)
            _add(figure, ledger["time"], np.where(values == 0.0, np.nan, np.abs(values)), name, colour, line, 2, shown=False, thin=False)
    figure.update_yaxes(type="log", range=[float(np.log10(1e-7 * top)), float(np.log10(2.0 * top))], exponentformat="power", row=2)
    words = "Entries of the energy ledger per metre of thickness over time, and their absolute values"
    return Chart("energy", "Energy ledger", words, figure)


def exact(tables, point):
    """Velocity at a point beside the exact field."""
    figure = make_subplots(1, 1)
    table = tables[f"histories/{point}"]
    for number, (direction, text) in enumerate(DIRECTIONS):
        _add(figure, table["time"], table[f"exact_v{direction}"], f"exact, {text}", style.COLOURS[number], "dot")
        _add(figure, table["time"], table[f"v{direction}"], f"computed, {text}", style.COLOURS[number])
    figure.update_xaxes(title_text="time t (s)")
    figure.update_yaxes(title_text="particle velocity (m/s)")
    figure.update_layout(height=360)
    return Chart(f"exact-{point}", f"{point}: computed and exact velocity", f"Computed and exact velocity at {point} over time", figure)


def activities(run, key):
    """A row a process: the share of each activity in each slice of wall time; None where the run has no timeline."""
    if run.table("timeline") is None:
        return None
    lines = timeline.timelines(run)
    colours = timeline.activity_colours(lines)
    figure = make_subplots(len(lines), 1, shared_xaxes=True, vertical_spacing=0.06)
    shown = set()
    for row, (name, line) in enumerate(lines.items(), 1):
        figure.update_yaxes(range=[0, 100], title_text=f"{name} (%)", row=row)
        for activity, colour in colours.items():
            seconds = line.activities.get(activity)
            if seconds is None:
                continue
            middle = line.slice * (np.arange(len(seconds)) + 0.5)
            figure.add_trace(
                go.Bar(x=numbers(middle), y=numbers(100.0 * seconds / line.slice), width=line.slice, name=activity,
                       legendgroup=activity, showlegend=activity not in shown, marker={"color": colour, "line": {"width": 0}}),
                row=row, col=1,
            )
            shown.add(activity)
    figure.update_xaxes(title_text="wall time (s)", row=len(lines))
    figure.update_layout(barmode="stack", bargap=0, height=120 + 130 * len(lines))
    return Chart(f"activities-{key}", "Who did what when", "Share of computing, mapping and waiting of each process over wall time", figure)


def passes(runs, titles):
    """Seconds of each pass of the domain; None where no run has ended."""
    tables = [(run.table("timings"), title) for run, title in zip(runs, titles) if run.table("timings")]
    if not tables:
        return None
    figure = make_subplots(1, 1)
    for number, (table, title) in enumerate(tables):
        names, seconds = list(table["pass"])[::-1], np.asarray(table["seconds"])[::-1]
        figure.add_trace(go.Bar(y=names, x=numbers(seconds), name=title, orientation="h", showlegend=len(tables) > 1,
                                marker={"color": style.COLOURS[number % len(style.COLOURS)]}))
    figure.update_xaxes(title_text="time of the domain (s)")
    figure.update_layout(height=160 + 22 * max(len(table["pass"]) for table, _ in tables) * len(tables), barmode="group")
    return Chart("passes", "Passes of the domain", "Seconds that the domain spent in each of its passes", figure)
