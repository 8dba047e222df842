"""How far sides and base have moved beyond their free field by the end of a run: the table /drift."""

import numpy as np

from tremolo import style

WIDTHS = {"left": 1.0, "base": 2.0, "right": 1.0}  # of the panels
DIRECTIONS = (("x", "horizontal"), ("y", "vertical"))


def _draw(ax, name, drift, own):
    place = drift["x" if name == "base" else "y"][own]
    order = np.argsort(place)
    for number, (direction, text) in enumerate(DIRECTIONS):
        moved = 1e3 * drift["d" + direction][own]
        across, along = (place, moved) if name == "base" else (moved, place)
        ax.plot(across[order], along[order], label=text, color=style.COLOURS[number])
    if name == "base":
        ax.set(title="base", xlabel="x (m)", ylabel="beyond the free field (mm)")
        ax.axhline(0.0, color="0.6", linewidth=0.5, zorder=0)
    else:
        ax.set(title=f"{name} side", xlabel="beyond the free field (mm)", ylabel="y (m)")
        ax.axvline(0.0, color="0.6", linewidth=0.5, zorder=0)


def figure_of(run):
    """The displacement of each side over its height, and of the base over its length, where dashpots or springs hold them; None where
    the run has no such table."""
    drift = run.table("drift")
    if drift is None:
        return None
    side = np.asarray(drift["side"])
    names = [name for name in WIDTHS if np.any(side == name)]
    widths = [WIDTHS[name] for name in names]
    figure, axes = style.plt.subplots(1, len(names), figsize=(1.0 + 2.2 * sum(widths), 3.4), layout="constrained", width_ratios=widths,
                                      squeeze=False)
    for ax, name in zip(axes[0], names):
        _draw(ax, name, drift, side == name)
    axes[0][-1].legend()
    return figure


def picture(run, folder):
    """Writes drift.png; returns its path, or None."""
    figure = figure_of(run)
    return None if figure is None else style.save(figure, folder, "drift.png")
