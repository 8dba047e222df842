"""Panels of a picture as charts that zoom: what a picture's module draws is drawn once, and read here from its axes."""

import base64
import io
import re

import numpy as np
from matplotlib import colors, ticker
from plotly import graph_objects as go

from tremolo import style
from tremolo.report.charts import Chart, kept, numbers

GREEK = {r"\sigma": "σ", r"\gamma": "γ", r"\tau": "τ", r"\beta": "β", r"\varepsilon": "ε"}
DASHES = {"-": "solid", "--": "dash", ":": "dot", "-.": "dashdot"}
SYMBOLS = {"o": "circle", "s": "square", "^": "triangle-up", "v": "triangle-down", "D": "diamond", "d": "diamond-tall", "*": "star",
           "<": "triangle-left", ">": "triangle-right", "P": "cross", "X": "x", "h": "hexagon"}


def plain(text):
    """A label of the picture without the marks of its formulas."""
    for mark, letter in GREEK.items():
        text = text.replace(mark, letter)
    text = re.sub(r"_\{([^}]*)\}|_(\w)(?=[^$]*\$)", lambda found: "<sub>" + (found[1] or found[2]) + "</sub>", text)
    return text.replace("$", "").replace("\n", "<br>")


def words(text):
    """A label in plain words."""
    return re.sub(r"<[^>]*>", " ", plain(text).replace("<sub>", "_").replace("</sub>", "")).strip()


def _line(line, ax):
    x, y = (np.asarray(values, dtype=float) for values in line.get_data())
    if line.get_transform() != ax.transData:  # a guide from edge to edge
        return None
    chosen = kept(y) if len(y) else np.arange(0)
    label = line.get_label()
    named = label and not label.startswith("_")
    marker = SYMBOLS.get(line.get_marker())
    drawn = line.get_linestyle() not in ("None", "", " ")
    return go.Scatter(
        x=numbers(x[chosen]), y=numbers(y[chosen]), name=plain(label) if named else "", showlegend=bool(named),
        mode="+".join(part for part, there in (("lines", drawn), ("markers", marker)) if there) or "lines",
        line={"color": colors.to_hex(line.get_color()), "width": 1.4, "dash": DASHES.get(line.get_linestyle(), "solid"),
              "shape": "hv" if line.get_drawstyle() == "steps-post" else "linear"},
        marker={"symbol": marker or "circle", "size": max(4.0, 7.0 / 6.0 * line.get_markersize())},
        opacity=line.get_alpha() or 1.0,
    )


def _bars(ax):
    """Horizontal bars by the names on their axis."""
    bars = [bar for container in ax.containers for bar in container]
    if not bars:
        return []
    names = [tick.get_text() for tick in ax.get_yticklabels()]
    return [go.Bar(x=numbers([bar.get_width() for bar in bars]), y=names, orientation="h", showlegend=False,
                   marker={"color": [colors.to_hex(bar.get_facecolor()) for bar in bars]})]


def _axis(label, scale, limits, ticks=()):
    """ticks: places and names, where the picture has names of its own."""
    low, high = limits
    ends = [float(np.log10(low)), float(np.log10(high))] if scale == "log" else [float(low), float(high)]
    named = {"tickvals": [place for place, _ in ticks], "ticktext": [name for _, name in ticks]} if ticks else {}
    return {"title": {"text": plain(label.replace("\n", " "))}, "type": "log" if scale == "log" else "linear", "range": ends, **named}


def _own_names(axis):
    """Places and names of the ticks of an axis that were given one by one."""
    if not isinstance(axis.get_major_locator(), ticker.FixedLocator):
        return []
    return [(float(place), plain(name.get_text())) for place, name in zip(axis.get_ticklocs(), axis.get_ticklabels())]


def _labels(ax):
    """Of x and of y. In a picture, panels above each other are labelled below, and panels side by side on the left."""
    place = ax.get_position()
    beside = [other for other in ax.figure.axes if other.axison]
    row = [one for one in beside if abs(one.get_position().y0 - place.y0) < 0.02 and one.get_position().x0 < place.x0]
    column = [one for one in beside if abs(one.get_position().x0 - place.x0) < 0.02 and one.get_position().y0 < place.y0]
    x = ax.get_xlabel() or next((one.get_xlabel() for one in reversed(column) if one.get_xlabel()), "")
    y = ax.get_ylabel() or next((one.get_ylabel() for one in reversed(row) if one.get_ylabel()), "")
    return x, y


def _chart(ax, key):
    traces = _bars(ax)
    x_label, y_label = _labels(ax)
    if traces:
        x = {"title": {"text": plain(x_label)}, "rangemode": "tozero"}
        layout = {"xaxis": x, "yaxis": {"type": "category", "autorange": "reversed"}}
    else:
        traces = [trace for line in ax.get_lines() if (trace := _line(line, ax)) is not None]
        layout = {"xaxis": _axis(x_label, ax.get_xscale(), ax.get_xlim(), _own_names(ax.xaxis)),
                  "yaxis": _axis(y_label, ax.get_yscale(), ax.get_ylim())}
    layout["height"] = 360
    layout["hovermode"] = "closest"
    title = ax.get_title() or ax.get_title(loc="left")
    heading = ", ".join(part for part in (title, x_label if ax.containers or not y_label else f"{y_label} over {x_label}") if part)
    return Chart(key, words(heading), words(heading), go.Figure(traces, layout))


def charts(figure, key):
    """A chart for each panel that holds lines or bars; panels of maps are left to the picture."""
    figure.draw_without_rendering()  # limits and ticks are known from then on
    panels = [ax for ax in figure.axes if ax.axison and ax.get_label() != "<colorbar>"]
    return [_chart(ax, f"{key}-{number}") for number, ax in enumerate(panels) if ax.get_lines() or ax.containers]


def image(figure):
    """The whole picture, for what charts do not show."""
    stream = io.BytesIO()
    figure.savefig(stream, format="png")
    return "data:image/png;base64," + base64.b64encode(stream.getvalue()).decode("ascii")


def has_map(figure):
    """Whether a panel is coloured over an area."""
    return any(ax.collections and ax.get_label() != "<colorbar>" and any(c.get_array() is not None for c in ax.collections)
               for ax in figure.axes)


def drawn(figures, key):
    """Charts and maps of figures, which are closed."""
    found, maps = [], []
    for number, figure in enumerate(figures):
        found += charts(figure, f"{key}-{number}")
        if has_map(figure):
            maps.append((image(figure), "the whole picture"))
        style.plt.close(figure)
    return found, maps
