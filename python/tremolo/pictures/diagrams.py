"""Diagrams on a closed axis: ordinates along its normals at chosen times, and as an envelope; below them the extremes over time."""

import numpy as np

from tremolo import style

LENGTH = 0.4  # of the longest ordinate, in half widths of the axis


def closed(values):
    """Those of a closed line, whose last point is joined to the first."""
    return np.concatenate([values, values[:1]])


def draw(ax, axis, feet, outwards, values, times, rows, sign):
    """The axis [nodes, 2] at the start, the envelope of values [times, feet] over all times as a band, and lines at some rows.

    feet, outwards: where ordinates stand and in which direction, [feet, 2]; sign: 1 where positive values are drawn outwards.
    """
    least, greatest = values.min(axis=0), values.max(axis=0)
    largest = max(np.abs(least).max(), np.abs(greatest).max())
    half = 0.5 * np.ptp(axis, axis=0).max()
    scale = sign * LENGTH * half / largest if largest > 0.0 else 0.0

    def ordinates(of):
        return closed(feet + scale * of[:, None] * outwards)

    band = np.vstack([ordinates(greatest), ordinates(least)[::-1]])
    ax.fill(*band.T, facecolor=style.COLOURS[5], alpha=0.35, linewidth=0, label="envelope")
    ax.plot(*closed(axis).T, color="#222222", linewidth=1.6)
    for number, row in enumerate(rows):
        ax.plot(*ordinates(values[row]).T, color=style.COLOURS[number % 4], label=f"t = {times[row]:.2f} s")
    centre = 0.5 * (axis.min(axis=0) + axis.max(axis=0))
    reach = (1.05 + LENGTH) * half
    ax.set(aspect="equal", xlim=(centre[0] - reach, centre[0] + reach), ylim=(centre[1] - reach, centre[1] + reach))
    ax.axis("off")


def extremes(ax, times, values):
    """The least and the greatest of values [times, feet] over time."""
    for extreme, text, colour in ((values.max(axis=1), "greatest", style.COLOURS[1]), (values.min(axis=1), "least", style.COLOURS[0])):
        ax.plot(times, extreme, color=colour, linewidth=0.8, label=text)
    ax.axhline(0.0, color="0.6", linewidth=0.5, zorder=0)
    ax.set_xlabel("t (s)")
    if len(times) > 1:
        ax.set_xlim(times[0], times[-1])


def telling_rows(moments):
    """The first row of moments [times, feet], and that at which they have changed most since."""
    return list(dict.fromkeys([0, int(np.argmax(np.abs(moments - moments[0]).max(axis=1)))]))


def sheet(drawn, draw_on, values_of, times):
    """A figure with a diagram a column, and the extremes over time below.

    drawn: name, title, sign, unit of each; draw_on(ax, name, sign) draws one, of values_of(name) [times, feet].
    """
    figure, axes = style.plt.subplots(2, len(drawn), figsize=(11.0 / 3.0 * len(drawn), 6.6), layout="constrained",
                                      height_ratios=[1.5, 1.0], sharex="row")
    for column, (name, text, sign, unit) in enumerate(drawn):
        values = values_of(name)
        draw_on(axes[0, column], name, sign)
        axes[0, column].set_title(f"{text}: {values.min() / 1e3:.4g} to {values.max() / 1e3:.4g} {unit}", loc="left")
        extremes(axes[1, column], times, values / 1e3)
        axes[1, column].set_ylabel(f"{text.split(',')[0]} ({unit})")
    axes[0, 0].legend(loc="center", frameon=False)
    axes[1, 0].legend(loc="lower right", bbox_to_anchor=(1.0, 1.0), ncols=2, borderaxespad=0.2)
    return figure
