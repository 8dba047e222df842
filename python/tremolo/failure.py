"""When a slope fails: the first time at which a shear band connects its toe with the ground behind its crest.

The band is made of the cells of the undeformed model whose mean equivalent plastic strain is at least `strain`; a cell of a
graded mesh counts as all the smallest cells that it covers. Two cells are connected where they touch, corners included. The
band connects toe and crest when one piece of it comes within a fifth of the slope's height of the monitor `toe` and within
two cells of the higher ground.
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


def connects(run, index, strain):
    """Whether the band of a frame connects toe and crest."""
    low, high = sorted(run.attribute("surface_levels"))
    toe = run.monitor("toe")
    toe = np.array([toe["x"][0], toe["y"][0]])
    cells, size = _band(run, index, strain)
    for piece in _pieces(cells):
        centres = (np.array(sorted(piece)) + 0.5) * size
        at_toe = np.min(np.hypot(*(centres - toe).T)) <= 0.2 * (high - low)
        at_crest = np.max(centres[:, 1]) >= high - 2.0 * size
        if at_toe and at_crest:
            return True
    return False


def failure_time(run, strain=0.1):
    """Time (s) of the first frame in which the band connects toe and crest; None if it never does.

    Raises ValueError for a run that has no slope with a monitor `toe`, or no plastic strain.
    """
    if not run.has_field("equivalent_plastic_strain") or not run.has_field("displacement"):
        raise ValueError(f"{run.path}: holds no plastic strain and displacement to find a shear band in")
    if "toe" not in run.monitors or len(set(run.attribute("surface_levels"))) < 2:
        raise ValueError(f"{run.path}: needs surfaces at two levels and a monitor named 'toe'")
    return next((float(run.times[i]) for i in range(len(run.times)) if connects(run, i, strain)), None)
