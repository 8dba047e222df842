"""Picture of a deconvolution from the tables that `tremolo deconvolve` writes: the record in the ground and the motion of
rock under it, histories, response and Fourier spectra."""

from pathlib import Path

import numpy as np

from tremolo import style

DAMPING = 0.05


def _table(folder, name, kind):
    return np.genfromtxt(Path(folder) / name / f"{kind}.csv", delimiter=",", names=True)


def _draw_history(ax, series, begin, colour, label):
    ax.plot(begin + series["t"], series["a"], linewidth=0.7, color=colour)
    peak = np.argmax(np.abs(series["a"]))
    ax.set_title(f"{label}, PGA {abs(series['a'][peak]):.3g} m/s²", loc="left", color=colour)
    ax.axhline(0.0, color="0.6", linewidth=0.5, zorder=0)
    ax.set_ylabel("acceleration (m/s²)")


def _draw_fourier(ax, folder, names, cutoff):
    tables = {name: _table(folder, name, "fourier") for name in names}
    top = max(table["amplitude"].max() for table in tables.values())
    for name, (colour, _) in names.items():
        shown = tables[name]["frequency"] >= 0.05
        ax.loglog(tables[name]["frequency"][shown], tables[name]["amplitude"][shown], linewidth=0.5, color=colour)
    ax.axvline(cutoff, color="0.4", linewidth=0.8, linestyle="--")
    ax.annotate(f"cutoff {cutoff:g} Hz", (cutoff, 6.0 * top), xytext=(-3, 0), textcoords="offset points", ha="right",
                va="top", fontsize=8, color="0.3")
    ax.set(xlabel="frequency (Hz)", ylabel="Fourier amplitude\nof the acceleration (m/s)", ylim=(1e-4 * top, 8.0 * top),
           xlim=(0.05, 2.0 * cutoff))


def picture(folder, path, kind, lead, cutoff, title):
    """Draws the tables in record/ and written/ of the folder, the latter `lead` s earlier; returns the path of the picture."""
    names = {"record": (style.COLOURS[0], "record below the cutoff"), "written": (style.COLOURS[1], f"{kind} motion of rock")}
    figure = style.plt.figure(figsize=(9.0, 5.0), layout="constrained")
    left, right = figure.subfigures(1, 2, width_ratios=[1.6, 1.0])
    histories = left.subplots(2, 1, sharex=True, sharey=True)
    response, fourier = right.subplots(2, 1)
    for ax, (name, (colour, label)) in zip(histories, names.items()):
        _draw_history(ax, _table(folder, name, "histories"), -lead if name == "written" else 0.0, colour, label)
        spectrum = _table(folder, name, "response")
        response.semilogx(spectrum["period"], spectrum["acceleration"], color=colour)
    histories[-1].set_xlabel("time of the record (s)")
    response.set(xlabel="period (s)", ylabel=f"spectral acceleration,\n{100.0 * DAMPING:g} % damping (m/s²)", ylim=(0, None),
                 xlim=(spectrum["period"][0], spectrum["period"][-1]))
    response.set_xticks([0.01, 0.1, 1, 10], ["0.01", "0.1", "1", "10"])
    _draw_fourier(fourier, folder, names, cutoff)
    figure.suptitle(title, fontsize=10)
    path = Path(path)
    return style.save(figure, path.parent, path.name)
