"""The picture of a free field alone: what `tremolo column` writes."""

from pathlib import Path

import numpy as np

from tremolo import style
from tremolo.run import Run

SHEAR = {"acceleration": "ax", "strain": "gxy", "stress": "sxy"}
DILATION = {"acceleration": "ay", "strain": "eyy", "stress": "syy"}


def components(histories):
    """The names of the wave's own component: horizontal for SV, vertical for P."""
    peaks = [max(np.abs(history[name]).max() for history in histories) for name in ("ax", "ay")]
    return SHEAR if peaks[0] >= peaks[1] else DILATION


def histories(run):
    """Levels (m) of the histories, and of each its columns by name, in the order in which they were asked for."""
    levels = run.table("levels")
    return levels["y"], [dict(run.monitor(name)) for name in levels["name"]]


def read(path):
    """Levels, histories, profile, spectra and transfer functions."""
    with Run(path) as run:
        return *histories(run), *(run.table(name) for name in ("profile", "spectra", "transfer"))


def known(values):
    """With gaps where a ratio says nothing, which the file has as 0."""
    return np.where(values > 0.0, values, np.nan)


def draw_profile(ax, profile, column, label, scale=1.0):
    depth = profile["y"].max() - profile["y"]
    ax.plot(scale * (known(profile[column]) if column == "stress_ratio" else profile[column]), depth)
    ax.set(xlabel=label, xlim=(0, None))
    ax.invert_yaxis()


def draw(path):
    """The figure: histories, profiles of peak values, spectra, transfer functions and stress-strain loops."""
    levels, histories, profile, spectra, transfer = read(path)
    names = components(histories)
    surface = profile["y"].max()
    figure, axes = style.plt.subplot_mosaic(
        [
            [[["time", "time", "time", "loops"]]],
            [[["pa", "pv", "pu", "pg", "ratio"]]],
            [[["sa", "tf"]]],
        ],
        figsize=(11.0, 8.4),
        layout="constrained",
    )
    for y, history in zip(levels, histories):
        axes["time"].plot(history["time"], history[names["acceleration"]], linewidth=0.7, label=f"{surface - y:.4g} m")
    axes["time"].set(xlabel="t (s)", ylabel="acceleration (m/s²)")
    axes["time"].set_xlim(histories[0]["time"][0], histories[0]["time"][-1])
    axes["time"].legend(title="depth", loc="upper right", ncols=2)
    deformed = max(range(len(histories)), key=lambda k: np.abs(histories[k][names["strain"]]).max())
    loop = histories[deformed]
    axes["loops"].plot(100 * loop[names["strain"]], loop[names["stress"]] / 1e3, linewidth=0.6)
    axes["loops"].set(xlabel="strain (%)", ylabel="stress (kPa)", title=f"{surface - levels[deformed]:.4g} m deep")

    direction = names["acceleration"][1]
    draw_profile(axes["pa"], profile, "peak_a" + direction, "peak acceleration (m/s²)")
    draw_profile(axes["pv"], profile, "peak_v" + direction, "peak velocity (m/s)")
    draw_profile(axes["pu"], profile, "peak_u" + direction, "peak displacement (cm)", 100.0)
    draw_profile(axes["pg"], profile, "peak_" + names["strain"], "peak strain (%)", 100.0)
    draw_profile(axes["ratio"], profile, "stress_ratio", "peak shear / effective stress")
    axes["pa"].set_ylabel("depth (m)")

    for name in ("surface", "outcrop"):
        if name in spectra:
            axes["sa"].semilogx(spectra["period"], spectra[name], label=name)
    axes["sa"].set(xlabel="period (s)", ylabel="spectral acceleration, 5 % (m/s²)", ylim=(0, None))
    axes["sa"].legend()
    for name, text in (("surface_to_outcrop", "surface / outcrop"), ("surface_to_base", "surface / base")):
        if name in transfer:
            axes["tf"].plot(transfer["frequency"], known(transfer[name]), label=text, linewidth=0.8)
    axes["tf"].set(xlabel="frequency (Hz)", ylabel="Fourier amplitude ratio", ylim=(0, None))
    shown = transfer["frequency"][transfer["surface_to_base"] > 0]
    axes["tf"].set_xlim(0, min(shown.max(), 25.0) if len(shown) else 25.0)
    axes["tf"].legend()
    return figure


def picture(path):
    """OUT.png beside OUT.h5."""
    path = Path(path)
    return style.save(draw(path), path.parent, path.stem + ".png")
