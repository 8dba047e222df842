"""When a slope fails: the first time at which a shear band connects its toe with the ground behind its crest.

The band is made of the cells of the undeformed model whose mean equivalent plastic strain is at least `strain`; a cell of a
graded mesh counts as all the smallest cells that it covers. Two cells are connected where they touch, corners included. The
band connects toe and crest when one piece of it comes within a fifth of the slope's height of the monitor `toe` and within
two cells of the higher ground. Two points may be given in place of both: a levee, a pit, the edge of a footing.
"""

import numpy as np

from tremolo import style


def _band(run, index, strain):
    """Cells of the band as a set of (column, row) of the smallest cells, and their size (m)."""
    material = run.field(index, "position") - run.field(index, "displacement")
    strains = run.field(index, "equivalent_plastic_strain")
    cell_per_particle = run.attribute("mesh_size") / style.spacing(run)
    sizes = np.broadcast_to(style.sizes(run, index) * cell_per_particle, len(strains))
    finest = sizes.min()
    band = set()
    for size in np.unique(sizes):
        of_size = sizes == size
        cells = np.floor(material[of_size] / size).astype(int)
        keys, inverse = np.unique(cells, axis=0, return_inverse=True)
        mean = np.bincount(inverse.ravel(), strains[of_size]) / np.bincount(inverse.ravel())
        parts = round(size / finest)
        for i, j in keys[mean >= strain]:
            band |= {(int(i) * parts + a, int(j) * parts + b) for a in range(parts) for b in range(parts)}
    return band, finest


def _pieces(cells):
    """Connected pieces of a set of cells."""
    left = set(cells)
    while left:
        piece, edge = set(), [left.pop()]
        while edge:
            i, j = edge.pop()
            piece.add((i, j))
            near = {(i + a, j + b) for a in (-1, 0, 1) for b in (-1, 0, 1)} & left
            left -= near
            edge.extend(near)
        yield piece


def _slope(run):
    """Whether a piece of the band, given by the centres of its cells and their size (m), connects toe and crest."""
    low, high = sorted(run.attribute("surface_levels"))
    toe = run.monitor("toe")
    toe = np.array([toe["x"][0], toe["y"][0]])

    def connects(centres, size):
        at_toe = np.min(np.hypot(*(centres - toe).T)) <= 0.2 * (high - low)
        return at_toe and np.max(centres[:, 1]) >= high - 2.0 * size

    return connects


def _two_points(ends):
    """Likewise whether it comes within two cells of two points (m)."""
    return lambda centres, size: all(np.min(np.hypot(*(centres - end).T)) <= 2.0 * size for end in np.asarray(ends, dtype=float))


def connects(run, index, strain, ends=None):
    """Whether the band of a frame connects toe and crest, or two points of the undeformed model (m)."""
    joined = _slope(run) if ends is None else _two_points(ends)
    cells, size = _band(run, index, strain)
    return any(joined((np.array(sorted(piece)) + 0.5) * size, size) for piece in _pieces(cells))


def _require_ends_in_soil(run, ends):
    """Raises ValueError for a point that lies in no soil."""
    material = run.field(0, "position") - run.field(0, "displacement")
    for end in ends:
        away = np.min(np.hypot(*(material - end).T))
        if not away <= run.attribute("mesh_size"):
            raise ValueError(f"{run.path}: the point {end[0]:g}, {end[1]:g} is {away:.3g} m from the nearest soil; give one in it, m")


def failure_time(run, strain=0.1, ends=None):
    """Time (s) of the first frame in which the band connects toe and crest; None if it never does.

    ends: two points (x, y), m, that the band must connect instead; it comes within two cells of both.
    Raises ValueError for a run that has no plastic strain, for a point outside the soil and, without points, for one that has no
    slope with a monitor `toe`.
    """
    if not run.has_field("equivalent_plastic_strain") or not run.has_field("displacement"):
        raise ValueError(f"{run.path}: holds no plastic strain and displacement to find a shear band in")
    if ends is not None:
        _require_ends_in_soil(run, ends)
    elif "toe" not in run.monitors or len(set(run.attribute("surface_levels"))) < 2:
        raise ValueError(f"{run.path}: needs surfaces at two levels and a monitor named 'toe', or --from X,Y --to X,Y")
    return next((float(run.times[i]) for i in range(len(run.times)) if connects(run, i, strain, ends)), None)
