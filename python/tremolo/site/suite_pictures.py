"""Pictures of many responses of one site: each a faint curve, their median and one standard deviation of the logarithm to each side, and
that deviation in a panel below."""

from typing import NamedTuple

import numpy as np

from tremolo import style
from tremolo.intensity import GRAVITY
from tremolo.site import suite
from tremolo.site.pictures import FREQUENCIES, OUTCROP, PERIODS, logarithmic


class Family(NamedTuple):
    """Responses that belong together, with a name ("" of the only family)."""

    name: str
    responses: list


def _colour(number):
    return style.COLOURS[number % len(style.COLOURS)]


def _draw(ax, curves, family, number, upright=False):
    """The curves over their places; upright: the places are depths."""
    colour = _colour(number)

    def line(values, **look):
        ax.plot(*((values, curves.places) if upright else (curves.places, values)), color=colour, **look)

    for values in curves.values:
        line(values, linewidth=0.5, alpha=min(0.5, max(0.12, 9.0 / len(curves.values))))
    median, sigma = curves.statistics()
    line(median, linewidth=1.8, label=f"{family.name + ', ' if family.name else ''}median of {len(curves.values)}")
    for sign, label in ((-1.0, "± σ of ln"), (1.0, None)):
        line(median * np.exp(sign * sigma), linewidth=0.9, linestyle="--", label=label if number == 0 else None)


def _draw_sigma(ax, curves, number, upright=False):
    sigma = curves.statistics()[1]
    ax.plot(*((sigma, curves.places) if upright else (curves.places, sigma)), color=_colour(number), linewidth=1.2)


def _over(axes, ticks, label, places):
    """What the two panels above each other share: the logarithmic axis of periods or frequencies."""
    for ax in axes:
        logarithmic(ax, [tick for tick in ticks if places[0] <= tick <= places[-1]], (places[0], places[-1]))
        ax.grid(color="0.92", linewidth=0.6)
        ax.set_ylim(0, None)
    axes[0].legend()
    axes[1].set(xlabel=label, ylabel="σ of ln")


def spectra(families):
    """Response spectra of the surface; the outcrop's median beside them."""
    figure, axes = style.plt.subplots(2, 1, figsize=(7.6, 6.0), layout="constrained", sharex=True, height_ratios=(2.2, 1.0))
    for number, family in enumerate(families):
        curves = suite.spectra(family.responses)
        _draw(axes[0], curves, family, number)
        _draw_sigma(axes[1], curves, number)
    outcrop = suite.spectra(families[0].responses, "outcrop")
    if outcrop:
        axes[0].plot(outcrop.places, outcrop.statistics()[0], label="outcrop, median", **OUTCROP)
    axes[0].set(ylabel="spectral acceleration, 5 % (g)")
    _over(axes, PERIODS, "period (s)", curves.places)
    return figure


def amplification(families):
    """Ratios of response spectra over the period, and of smoothed Fourier spectra over the frequency."""
    columns = [(suite.fourier_amplification, f"smoothed Fourier amplitudes, surface over {suite.below(families[0].responses)}",
                FREQUENCIES, "frequency (Hz)")]
    if suite.below(families[0].responses) == "outcrop":
        columns.insert(0, (suite.spectral_amplification, "5 % spectra, surface over outcrop", PERIODS, "period (s)"))
    figure, axes = style.plt.subplots(2, len(columns), figsize=(1.0 + 5.0 * len(columns), 6.0), layout="constrained", squeeze=False,
                                      sharex="col", height_ratios=(2.2, 1.0))
    for column, (of, label, ticks, places) in zip(axes.T, columns):
        for number, family in enumerate(families):
            curves = of(family.responses)
            _draw(column[0], curves, family, number)
            _draw_sigma(column[1], curves, number)
        column[0].axhline(1.0, color="0.6", linewidth=0.6, zorder=0)
        column[0].set(ylabel=label)
        _over(column, ticks, places, curves.places)
    return figure


def profiles(families):
    """Vs at small strain, peak acceleration and peak strain over depth; strain on a logarithmic axis."""
    first = families[0].responses[0]
    panels = [(suite.speeds, 1.0, "Vs at small strain (m/s)"),
              (lambda responses: suite.peaks(responses, f"peak_{first.acceleration}"), 1.0 / GRAVITY, "peak acceleration (g)"),
              (lambda responses: suite.peaks(responses, f"peak_{first.strain}"), 100.0, "peak strain (%)")]
    figure, axes = style.plt.subplots(2, len(panels), figsize=(9.6, 8.4), layout="constrained", sharey=True, height_ratios=(1.6, 1.0))
    for column, (of, scale, label) in zip(axes.T, panels):
        for number, family in enumerate(families):
            found = of(family.responses)
            curves = suite.Curves(found.places, scale * np.where(found.values > 0.0, found.values, np.nan))
            _draw(column[0], curves, family, number, upright=True)
            _draw_sigma(column[1], curves, number, upright=True)
        if label.startswith("peak strain"):
            most = np.nanmax(curves.values)
            column[0].set(xscale="log", xlim=(1e-3 * most, 2.0 * most))
        else:
            column[0].set_xlim(0, None)
        column[0].set(xlabel=label)
        column[1].set(xlabel=f"σ of ln {label.rpartition(' (')[0]}", xlim=(0, None))
        for ax in column:
            ax.grid(color="0.92", linewidth=0.6)
    for row in axes:
        row[0].set(ylabel="depth (m)", ylim=(first.depth().max(), 0.0))
    axes[0][0].legend()
    return figure


def of_suite(families):
    """Figures by name, in the order in which one reads them."""
    return {"spectra": spectra(families), "amplification": amplification(families), "profiles": profiles(families)}
