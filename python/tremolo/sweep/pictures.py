"""Pictures of a sweep: sweep.png, every response by colour, over the intensity, and over what was sampled; histories.png, the
median displacement of each monitor over time and its spread."""

import json

import numpy as np
from matplotlib import ticker

from tremolo import style
from tremolo.run import Run
from tremolo.sweep import site_responses, statistics
from tremolo.sweep.plan import in_words

MOST_COLUMNS = 4  # of groups, and of sampled keys
MOST_MONITORS = 4
INTENSITIES = {"pga_m_s2": "PGA of the incident wave (m/s²)", "pgv_m_s": "PGV of the incident wave (m/s)",
               "arias_m_s": "Arias intensity of the incident wave (m/s)"}
UNITS = {"m/s2": "m/s²", "1": ""}


def label(name, unit):
    """"final displacement, crest (m)" of "crest.final_displacement_m"."""
    if name.startswith("spectral_ratio_"):
        return f"spectral ratio at {name.removeprefix('spectral_ratio_').removesuffix('s')} s"
    place, _, measure = name.rpartition(".")
    for end in ("_m_s2", "_m_s", "_rad", "_m", "_s"):
        if measure.endswith(end) and unit != "1":
            measure = measure.removesuffix(end)
            break
    words = measure.replace("_", " ").replace(" ax", " $a_x$").replace("r u", "$r_u$").replace("run out", "run-out")
    shown_unit = UNITS.get(unit, unit)
    return words + (f", {place}" if place else "") + (f" ({shown_unit})" if shown_unit else "")


def axis_label(sweep, key):
    unit = sweep.columns[key].unit
    return key + (f" ({unit})" if unit not in ("", "1") else "")


def _colour(sweep, colour):
    return style.COLOURS[sweep.colours.index(colour) % len(style.COLOURS)]


def _name(sweep, colour):
    return "" if colour is None else f"{sweep.colour_key} = {in_words(colour)}"


def _places(sweep):
    """Where each colour stands on an axis: its number, or its rank where it is none."""
    colours = sweep.colours
    if all(isinstance(colour, (int, float)) and not isinstance(colour, bool) for colour in colours):
        return dict(zip(map(json.dumps, colours), map(float, colours)))
    return {json.dumps(colour): float(rank) for rank, colour in enumerate(colours)}


def _group_columns(sweep):
    """Values of the axes that have neither colour nor motions -> groups; all in one where they are too many."""
    found = {}
    for group in sweep.groups():
        found.setdefault(group.rest, []).append(group)
    if len(found) <= MOST_COLUMNS:
        return found
    together = {}
    for group in sweep.groups():
        merged = together.setdefault(json.dumps(group.colour), statistics.Group(group.colour, (), []))
        merged.runs.extend(group.runs)
    return {(("all", "together"),): list(together.values())}


def _head(axes, columns):
    """What the panels of a column have in common above it; the panels below know it too, for reports that show them alone."""
    for number, row in enumerate(axes):
        for ax, rest in zip(row, columns):
            ax.set_title(", ".join(f"{key} = {in_words(value)}" for key, value in rest), visible=number == 0)


def _draw_groups(ax, sweep, name, groups):
    """Dots of the runs, and the median of each colour with its spread."""
    places = _places(sweep)
    values = sweep.numbers(name)
    for group in groups:
        x, look = places[json.dumps(group.colour)], _colour(sweep, group.colour)
        runs = values[group.runs]
        ax.plot(np.full(len(runs), x), runs, "o", color=look, markersize=3.5, alpha=0.45, markeredgewidth=0)
        count, median, low, high = sweep.spread(name, group)
        if count:
            ax.plot([x, x], [low, high], color=look, linewidth=2.2)
            ax.plot([x], [median], "D", color=look, markersize=6.5, markeredgecolor="white")
        if name == "failure_time_s":
            ax.annotate(f"{count}/{len(runs)}", (x, 0.0), (0, 3), xycoords=("data", "axes fraction"), textcoords="offset points",
                        ha="center", fontsize=7, color="0.35")
    ends = sorted(places.values())
    margin = 0.25 * (ends[-1] - ends[0]) or 0.5
    ax.set_xlim(ends[0] - margin, ends[-1] + margin)
    names = {places[json.dumps(colour)]: in_words(colour) if colour is not None else "" for colour in sweep.colours}
    ax.set_xticks(list(names), list(names.values()))


def _draw_over(ax, sweep, name, over, lines):
    """Runs over another column in their colours; lines: through each colour, on logarithmic axes."""
    x, y = sweep.numbers(over), sweep.numbers(name)
    for colour in sweep.colours:
        runs = [number for number in sweep.complete if sweep.has_colour(number, colour)]
        look = {"color": _colour(sweep, colour)}
        ax.plot(x[runs], y[runs], "o", markersize=3.5, alpha=0.6, markeredgewidth=0, **look)
        line = statistics.fitted(x[runs], y[runs]) if lines else None
        if line:
            between = np.geomspace(np.nanmin(x[runs]), np.nanmax(x[runs]), 30)
            ax.plot(between, line.factor * between**line.power, linewidth=1.4, **look)
    positive = y[sweep.complete][np.isfinite(y[sweep.complete])]
    if lines and len(positive) and positive.min() > 0.0:
        ax.set(xscale="log", yscale="log")
        for axis in (ax.xaxis, ax.yaxis):
            _plain_numbers(axis)


def _plain_numbers(axis):
    """Where a logarithmic axis covers less than a decade, round numbers instead of powers of ten."""
    low, high = axis.get_view_interval()
    if high < 10.0 * low:
        axis.set_major_locator(ticker.MaxNLocator(4, steps=[1, 2, 2.5, 5, 10]))
        axis.set_major_formatter(ticker.FormatStrFormatter("%g"))
        axis.set_minor_locator(ticker.NullLocator())


def draw(sweep):
    """The figure of all responses. Raises ValueError where no run has ended well."""
    if not sweep.complete:
        raise ValueError(f"{sweep.plan.folder}: no run of the sweep has ended well")
    names = statistics.responses(sweep)
    if not names:
        raise ValueError(f"{sweep.plan.folder}: the runs hold nothing to measure: the case needs a [[monitor]]")
    columns, over = _group_columns(sweep), []
    if sweep.intensity:
        over.append((sweep.intensity, True))
    over += [(key, False) for key in sweep.sampled_keys[:MOST_COLUMNS]]
    count = len(columns) + len(over)
    figure, axes = style.plt.subplots(
        len(names), count, figsize=(1.2 + 2.6 * count, 0.9 + 2.0 * len(names)), squeeze=False, layout="constrained"
    )
    for row, name in zip(axes, names):
        row[0].set_ylabel(label(name, sweep.columns[name].unit).replace(", ", ",\n"))
        for ax, groups in zip(row, columns.values()):
            _draw_groups(ax, sweep, name, groups)
        low = min(ax.get_ylim()[0] for ax in row[: len(columns)])
        high = max(ax.get_ylim()[1] for ax in row[: len(columns)])
        low -= 0.15 * (high - low) if name == "failure_time_s" else 0.0  # below: how many runs fail
        for ax in row[: len(columns)]:
            ax.set_ylim(low, high)
        for ax, (other, lines) in zip(row[len(columns):], over):
            _draw_over(ax, sweep, name, other, lines)
    _head(axes, columns)
    for ax in axes[-1][: len(columns)]:
        ax.set_xlabel(axis_label(sweep, sweep.colour_key) if sweep.colour_key else "")
    for ax, (other, _) in zip(axes[-1][len(columns):], over):
        ax.set_xlabel(INTENSITIES.get(other) or axis_label(sweep, other))
    counted_runs = f"{len(sweep.complete)} of {len(sweep.plan.runs)} runs"
    figure.suptitle(f"{sweep.plan.title}\n{counted_runs}; diamonds and bars: median, 16 to 84 %", fontsize=9)
    return figure


def _histories(sweep, runs, monitor):
    """Times (s) and |u| (m) of each run at them, [runs, times]."""
    series = []
    for number in runs:
        with Run(sweep.plan.runs[number].folder) as run:
            found = run.monitor(monitor)
            series.append((found["time"], np.hypot(found["ux"], found["uy"])))
    end = min(time[-1] for time, _ in series)
    times = np.linspace(0.0, end, 400)
    return times, np.array([np.interp(times, time, values) for time, values in series])


def draw_histories(sweep):
    """The figure of displacement over time; None without a monitor."""
    if not sweep.complete:
        return None
    with Run(sweep.plan.runs[sweep.complete[0]].folder) as run:
        monitors = run.monitors[:MOST_MONITORS]
    columns = _group_columns(sweep)
    if not monitors:
        return None
    figure, axes = style.plt.subplots(
        len(monitors), len(columns), figsize=(1.2 + 3.6 * len(columns), 0.9 + 1.9 * len(monitors)), squeeze=False, sharex=True,
        sharey="row", layout="constrained",
    )
    for row, monitor in zip(axes, monitors):
        row[0].set_ylabel(f"|u|, {monitor} (m)")
        for ax, groups in zip(row, columns.values()):
            for group in groups:
                times, moved = _histories(sweep, group.runs, monitor)
                low, median, high = np.percentile(moved, [statistics.SPREAD[0], 50.0, statistics.SPREAD[1]], axis=0)
                look = {"color": _colour(sweep, group.colour)}
                ax.fill_between(times, low, high, alpha=0.15, linewidth=0, **look)
                for edge in (low, high):
                    ax.plot(times, edge, linewidth=0.5, linestyle=":", **look)
                ax.plot(times, median, linewidth=1.4, label=_name(sweep, group.colour), **look)
            ax.set_xlim(0.0, times[-1])
    _head(axes, columns)
    for ax in axes[-1]:
        ax.set_xlabel("t (s)")
    if sweep.colour_key:
        axes[0][0].legend(loc="upper left")
    figure.suptitle(f"{sweep.plan.title}\nmedian of the runs, and 16 to 84 %", fontsize=9)
    return figure


def write(sweep):
    """Writes sweep.png and histories.png, of site responses what site_responses.py makes; yields their paths."""
    yield style.save(draw(sweep), sweep.plan.folder, "sweep.png")
    if sweep.plan.has_site_responses:
        yield from site_responses.write(sweep)
        return
    figure = draw_histories(sweep)
    if figure is not None:
        yield style.save(figure, sweep.plan.folder, "histories.png")
