"""Picture of a motion from the tables that `tremolo motion` writes: histories, response and Fourier spectra."""

from pathlib import Path

import numpy as np

from tremolo import style

HISTORIES = {"a": "acceleration (m/s²)", "v": "velocity (m/s)", "d": "displacement (m)"}


def _table(path):
    return np.genfromtxt(path, delimiter=",", names=True)


def _draw_histories(axes, series):
    for quantity, label in HISTORIES.items():
        ax = axes[quantity]
        ax.plot(series["t"], series[quantity], linewidth=0.7)
        peak = np.argmax(np.abs(series[quantity]))
        ax.plot(series["t"][peak], series[quantity][peak], "o", markersize=4, color=style.COLOURS[1])
        ax.annotate(
            f"{abs(series[quantity][peak]):.3g}", (series["t"][peak], series[quantity][peak]),
            xytext=(5, -2), textcoords="offset points", fontsize=8, color=style.COLOURS[1],
        )
        ax.axhline(0.0, color="0.6", linewidth=0.5, zorder=0)
        ax.set_ylabel(label)
        ax.set_xlim(series["t"][0], series["t"][-1])
    axes["d"].set_xlabel("t (s)")


def _draw_response(ax, spectrum, damping, target):
    ax.semilogx(spectrum["period"], spectrum["acceleration"], label="motion")
    if target is not None:
        ax.semilogx(target["period"], target["acceleration"], "--", color=style.COLOURS[1], label="target")
        ax.legend(fontsize=8)
    ax.set(xlabel="period (s)", ylabel=f"spectral acceleration,\n{100.0 * damping:g} % damping (m/s²)", ylim=(0, None))
    ax.set_xlim(spectrum["period"][0], spectrum["period"][-1])
    ax.set_xticks([0.01, 0.1, 1, 10], ["0.01", "0.1", "1", "10"])


def _draw_fourier(ax, spectrum):
    shown = (spectrum["frequency"] >= 0.05) & (spectrum["amplitude"] > 0.0)
    ax.loglog(spectrum["frequency"][shown], spectrum["amplitude"][shown], linewidth=0.5)
    top = spectrum["amplitude"][shown].max()
    ax.set(xlabel="frequency (Hz)", ylabel="Fourier amplitude\nof the acceleration (m/s)", ylim=(1e-4 * top, 2.0 * top))


def picture(folder, path, title, damping):
    """Draws histories.csv, response.csv and fourier.csv of the folder, and target.csv where the motion was matched to one;
    returns the path of the picture."""
    folder = Path(folder)
    figure = style.plt.figure(figsize=(9.0, 5.0), layout="constrained")
    left, right = figure.subfigures(1, 2, width_ratios=[1.6, 1.0])
    axes = dict(zip(HISTORIES, left.subplots(len(HISTORIES), 1, sharex=True)))
    response, fourier = right.subplots(2, 1)
    _draw_histories(axes, _table(folder / "histories.csv"))
    _draw_response(response, _table(folder / "response.csv"), damping,
                   _table(folder / "target.csv") if (folder / "target.csv").exists() else None)
    _draw_fourier(fourier, _table(folder / "fourier.csv"))
    figure.suptitle(title, fontsize=10)
    path = Path(path)
    return style.save(figure, path.parent, path.name)
