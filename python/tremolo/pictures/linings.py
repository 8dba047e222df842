"""Linings: drawn into maps, and diagrams of their section forces: M on the side that it stretches, N outwards where it compresses, Q
outwards where it is positive; and of what the soil does to them: pressure outwards, shear outwards where it turns the lining
counter-clockwise."""

import numpy as np
from matplotlib.patches import PathPatch
from matplotlib.path import Path

from tremolo import style

FILL = dict(facecolor="#A9A9A9", edgecolor="#222222", linewidth=0.8)
LENGTH = 0.4  # of the longest ordinate, in half widths of the lining

# Name, what is drawn, which sign is outwards, unit.
DIAGRAMS = (
    ("moment", "M, stretched side", 1.0, "kNm/m"),
    ("axial_force", "N, compression outwards", -1.0, "kN/m"),
    ("shear_force", "Q", 1.0, "kN/m"),
)


CONTACT = (("pressure", "pressure of the soil", 1.0, "kPa"), ("shear", "shear of the soil", 1.0, "kPa"))


def wall(outer, inner):
    """A closed path along the outer face and back along the inner one."""
    rings = [np.vstack([ring, ring[:1]]) for ring in (outer, inner[::-1])]
    return Path.make_compound_path(*(Path(ring, closed=True) for ring in rings))


def draw(ax, run, time):
    """Fills all linings where they are at a time (s)."""
    for name in run.linings:
        ax.add_patch(PathPatch(wall(*run.lining(name).faces(time)), **FILL))


def telling_times(lining):
    """The first time, and that at which moments have changed most since, s."""
    changed = np.abs(lining.moment - lining.moment[0]).max(axis=1)
    rows = [0, int(np.argmax(changed))]
    return [float(lining.time[row]) for row in dict.fromkeys(rows)]


def _normals(nodes):
    """Middles of the elements and their normals, outwards."""
    along = np.roll(nodes, -1, axis=0) - nodes
    return nodes + 0.5 * along, np.column_stack([along[:, 1], -along[:, 0]]) / np.linalg.norm(along, axis=1)[:, None]


def _closed(values):
    return np.concatenate([values, values[:1]])


def _on_face(lining):
    """Middles of the segments of the outer face and its normals there, outwards: those of the nearest element."""
    middles, outwards = _normals(lining.nodes)
    distances = np.linalg.norm(lining.segments[:, None] - (middles + 0.5 * lining.thickness * outwards), axis=2)
    return lining.segments, outwards[np.argmin(distances, axis=1)]


def _extremes(lining, quantity):
    """The least and the greatest value at each place over all times."""
    values = getattr(lining, quantity)
    return values.min(axis=0), values.max(axis=0)


def _diagram(ax, lining, force, sign, rows):
    """The lining at the start, the envelope over all times as a band, and lines at some times."""
    contact = any(force == name for name, *_ in CONTACT)
    middles, outwards = _on_face(lining) if contact else _normals(lining.nodes)
    least, greatest = _extremes(lining, force)
    largest = max(np.abs(least).max(), np.abs(greatest).max())
    half = 0.5 * np.ptp(lining.nodes, axis=0).max()
    scale = sign * LENGTH * half / largest if largest > 0.0 else 0.0

    def ordinates(values):
        return _closed(middles + scale * values[:, None] * outwards)

    band = np.vstack([ordinates(greatest), ordinates(least)[::-1]])
    ax.fill(*band.T, facecolor=style.COLOURS[5], alpha=0.35, linewidth=0, label="envelope")
    ax.plot(*_closed(lining.nodes).T, color="#222222", linewidth=1.6)
    for number, row in enumerate(rows):
        ax.plot(*ordinates(getattr(lining, force)[row]).T, color=style.COLOURS[number % 4], label=f"t = {lining.time[row]:.2f} s")
    for node in lining.hinges:
        ax.plot(*lining.nodes[node], marker="o", markersize=4, markerfacecolor="white", markeredgecolor="#222222")
    centre = 0.5 * (lining.nodes.min(axis=0) + lining.nodes.max(axis=0))
    reach = (1.05 + LENGTH) * half
    ax.set(aspect="equal", xlim=(centre[0] - reach, centre[0] + reach), ylim=(centre[1] - reach, centre[1] + reach))
    ax.axis("off")


def _history(ax, lining, force):
    """The least and the greatest value around the lining over time."""
    values = getattr(lining, force) / 1e3
    for extreme, text, colour in ((values.max(axis=1), "greatest", style.COLOURS[1]), (values.min(axis=1), "least", style.COLOURS[0])):
        ax.plot(lining.time, extreme, color=colour, linewidth=0.8, label=text)
    ax.axhline(0.0, color="0.6", linewidth=0.5, zorder=0)
    ax.set_xlabel("t (s)")
    if len(lining) > 1:
        ax.set_xlim(lining.time[0], lining.time[-1])


def diagrams(lining, name, times=None, contact=False):
    """The figure of a lining: its section forces, or what the soil does to its outer face, at some times (s), by default those of
    telling_times(), and as envelopes; below them the extremes around it over time."""
    drawn = CONTACT if contact else DIAGRAMS
    rows = [lining.nearest(time) for time in times or telling_times(lining)]
    figure, axes = style.plt.subplots(2, len(drawn), figsize=(11.0 / 3.0 * len(drawn), 6.6), layout="constrained",
                                      height_ratios=[1.5, 1.0], sharex="row")
    for column, (force, text, sign, unit) in enumerate(drawn):
        least, greatest = (values / 1e3 for values in _extremes(lining, force))
        _diagram(axes[0, column], lining, force, sign, rows)
        axes[0, column].set_title(f"{text}: {least.min():.4g} to {greatest.max():.4g} {unit}", loc="left")
        _history(axes[1, column], lining, force)
        axes[1, column].set_ylabel(f"{text.split(',')[0]} ({unit})")
    axes[0, 0].legend(loc="center", frameon=False)
    axes[1, 0].legend(loc="lower right", bbox_to_anchor=(1.0, 1.0), ncols=2, borderaxespad=0.2)
    figure.suptitle(f"{name}: {'contact with the soil' if contact else 'section forces'}", fontsize=10)
    return figure


def picture(run, folder, name, times=None, contact=False):
    """lining_NAME.png, or lining_NAME_contact.png; None where the lining has no history yet."""
    lining = run.lining(name)
    file = f"lining_{name}_contact.png" if contact else f"lining_{name}.png"
    return style.save(diagrams(lining, name, times, contact), folder, file) if len(lining) else None
