"""Linings: drawn into maps, and diagrams of their section forces: M on the side that it stretches, N outwards where it compresses, Q
outwards where it is positive; and of what the soil does to them: pressure outwards, shear outwards where it turns the lining
counter-clockwise."""

import numpy as np
from matplotlib.patches import PathPatch
from matplotlib.path import Path

from tremolo import style
from tremolo.pictures import diagrams as diagrams_on

FILL = dict(facecolor="#A9A9A9", edgecolor="#222222", linewidth=0.8)

# Name, what is drawn, which sign is outwards, unit.
DIAGRAMS = (
    ("moment", "M, stretched side", 1.0, "kNm/m"),
    ("axial_force", "N, compression outwards", -1.0, "kN/m"),
    ("shear_force", "Q", 1.0, "kN/m"),
)


CONTACT = (("pressure", "pressure of the soil", 1.0, "kPa"), ("shear", "shear of the soil", 1.0, "kPa"))
WET_CONTACT = (("pressure", "pressure of soil and water", 1.0, "kPa"), CONTACT[1], ("water_pressure", "pressure of the water", 1.0, "kPa"))


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
    return [float(lining.time[row]) for row in diagrams_on.telling_rows(lining.moment)]


def _normals(nodes):
    """Middles of the elements and their normals, outwards."""
    along = np.roll(nodes, -1, axis=0) - nodes
    return nodes + 0.5 * along, np.column_stack([along[:, 1], -along[:, 0]]) / np.linalg.norm(along, axis=1)[:, None]


def _on_face(lining):
    """Middles of the segments of the outer face and its normals there, outwards: those of the nearest element."""
    middles, outwards = _normals(lining.nodes)
    distances = np.linalg.norm(lining.segments[:, None] - (middles + 0.5 * lining.thickness * outwards), axis=2)
    return lining.segments, outwards[np.argmin(distances, axis=1)]


def _diagram(ax, lining, force, sign, rows):
    """One of its diagrams, with its hinges."""
    feet = _on_face(lining) if any(force == name for name, *_ in WET_CONTACT) else _normals(lining.nodes)
    diagrams_on.draw(ax, lining.nodes, *feet, getattr(lining, force), lining.time, rows, sign)
    for node in lining.hinges:
        ax.plot(*lining.nodes[node], marker="o", markersize=4, markerfacecolor="white", markeredgecolor="#222222")


def diagrams(lining, name, times=None, contact=False):
    """The figure of a lining: its section forces, or what the soil does to its outer face, at some times (s), by default those of
    telling_times(), and as envelopes; below them the extremes around it over time."""
    rows = [lining.nearest(time) for time in times or telling_times(lining)]
    of_contact = WET_CONTACT if np.any(lining.water_pressure) else CONTACT
    figure = diagrams_on.sheet(of_contact if contact else DIAGRAMS, lambda ax, force, sign: _diagram(ax, lining, force, sign, rows),
                               lambda force: getattr(lining, force), lining.time)
    figure.suptitle(f"{name}: {'contact with the ground' if contact else 'section forces'}", fontsize=10)
    return figure


def picture(run, folder, name, times=None, contact=False):
    """lining_NAME.png, or lining_NAME_contact.png; None where the lining has no history yet."""
    lining = run.lining(name)
    file = f"lining_{name}_contact.png" if contact else f"lining_{name}.png"
    return style.save(diagrams(lining, name, times, contact), folder, file) if len(lining) else None
