"""Tiles of a flat box, who owns them, and what ranks send: written apart from mpm_domain/tiles, which it is held against.

A box of `columns` x `rows` cells lies 6 cells inside its lattice, which is cut into tiles of 32 x 8 cells. A tile has a
window of 37 x 13 nodes; it shares 5 columns with the windows beside it and 5 rows with those above and below. So the
window falls into nine pieces, and each goes once, with the sums of a scatter, to every other rank that has a tile whose
window it lies in:

    columns  5 | 27 | 5,    rows  5 | 3 | 5.

Along a straight rim that is 5 x 13 = 65 nodes for a side of a tile with another rank beside it, and 37 x 5 = 185 for one
with another rank above or below. Tiles lie on a Hilbert curve, cut into P pieces of n = T/P tiles. A piece of n = 4^k
tiles that begins at a multiple of n is a square of tiles, with sqrt(n) sides each way:

    nodes = 2 (65 + 185) sqrt(n) c(n),    c(4^k) = 1,    c(2 4^k) = 3/sqrt(8) = 1.06,

1.3 to 1.5 in the mean in between, and up to 1.75 for the longest rim (see shape_factor).
"""

import math

import numpy as np

NUMBER = 8  # bytes
TILE = (32, 8)  # columns, rows of cells
MARGIN = 6  # cells between box and edge of the lattice
BEFORE = (1, 0)  # columns, rows between the first node that a particle belongs to and its cell
SHARED = 5  # columns, or rows, that two windows share
WINDOW = (TILE[0] + SHARED, TILE[1] + SHARED)
BESIDE = SHARED * WINDOW[1]  # nodes that go to a rank beside a tile
REACH = 24  # nodes that a face may lie away from the tiles of a rank that works it out
WAY = 0.9  # cells that a face may move until the next sort
OF_SOIL, OF_NODE = 10, 5  # numbers that go with a face, and with a node near the boundary: mass, momentum and force
ABOVE = WINDOW[0] * SHARED  # nodes that go to a rank above or below it
PARTICLES_PER_CELL = 4
NOBODY = -1


def hilbert_tiles(size):
    """Columns and rows of the cells of a square of `size` a side, a power of two, in the order of the Hilbert curve: four
    smaller curves, of which the first and the last are reflected."""
    x = y = np.zeros(1, dtype=np.int64)
    length = 1
    while length < size:
        x, y = (
            np.concatenate([y, x, x + length, 2 * length - 1 - y]),
            np.concatenate([x, y + length, y + length, length - 1 - x]),
        )
        length *= 2
    return x, y


def cells_in_tiles(cells, tile, before):
    """How many of the box's columns (or rows) of cells belong to each of the lattice's tiles."""
    nodes = cells + 1 + 2 * MARGIN
    begin = np.arange(-(-nodes // tile)) * tile
    first = MARGIN - before
    return np.clip(np.minimum(begin + tile, first + cells) - np.maximum(begin, first), 0, None)


class Tiles:
    """The tiles of a box that `ranks` ranks share. Arrays are indexed [row, column]."""

    def __init__(self, columns, rows, ranks):
        self.ranks = ranks
        self.particles = PARTICLES_PER_CELL * np.outer(
            cells_in_tiles(rows, TILE[1], BEFORE[1]), cells_in_tiles(columns, TILE[0], BEFORE[0])
        )
        self.owner = self._adopt(self._deal(columns, rows))

    def _deal(self, columns, rows):
        """A tile belongs to the rank in whose equal piece of the curve the middle of its particles lies."""
        longest = max((columns + 1 + 2 * MARGIN) // TILE[0], (rows + 1 + 2 * MARGIN) // TILE[1]) + 1
        x, y = hilbert_tiles(1 << (longest - 1).bit_length())
        inside = (y < self.particles.shape[0]) & (x < self.particles.shape[1])
        x, y = x[inside], y[inside]
        particles = self.particles[y, x]
        middle = np.cumsum(particles) - particles / 2
        owner = np.full(self.particles.shape, NOBODY)
        owner[y, x] = np.where(particles > 0, (middle * self.ranks / particles.sum()).astype(int), NOBODY)
        return owner

    def _adopt(self, owner):
        """An empty tile goes to the owner of the first tile with particles beside, above or below it, else at a corner; first
        by rows, then by columns."""
        owner = owner.copy()
        filled = self.particles > 0
        for j, i in np.argwhere(~filled):
            around = [(j + b, i + a) for b in (-1, 0, 1) for a in (-1, 0, 1)]
            near = [t for t in around if 0 <= t[0] < filled.shape[0] and 0 <= t[1] < filled.shape[1] and filled[t]]
            sides = [t for t in near if t[0] == j or t[1] == i]
            if near:
                owner[j, i] = owner[(sides or near)[0]]
        return owner

    def shifted(self, rows, columns):
        """The owner of the tile so many rows above and columns to the right."""
        padded = np.pad(self.owner, 1, constant_values=NOBODY)
        return padded[1 + rows : padded.shape[0] - 1 + rows, 1 + columns : padded.shape[1] - 1 + columns]

    def unevenness(self):
        return self.loads().max() * self.ranks / self.particles.sum()

    def loads(self):
        """Particles by rank."""
        filled = self.particles > 0
        return np.bincount(self.owner[filled], weights=self.particles[filled], minlength=self.ranks)

    def sides(self):
        """Sides that filled tiles of each rank share with filled tiles of others: (beside, above and below)."""
        filled = self.particles > 0
        counts = np.zeros((2, self.ranks))
        for direction, steps in enumerate((((0, -1), (0, 1)), ((-1, 0), (1, 0)))):
            for step in steps:
                other = self.shifted(*step)
                rim = filled & (other != NOBODY) & (other != self.owner)
                counts[direction] += np.bincount(self.owner[rim], minlength=self.ranks)
        return counts

    def _near(self, columns, rows):
        """(face, ranks) for all faces: those that work it out, from which a force may come to a node in their windows: a
        tile of theirs lies within REACH nodes. A face is (column, row, side), in nodes of its lower left end."""
        along, up = (MARGIN + np.arange(2 * cells) / 2 for cells in (columns, rows))
        sides = [(column, row, True) for column in (MARGIN, MARGIN + columns) for row in up]
        for column, row, side in sides + [(column, MARGIN, False) for column in along]:
            around = [
                slice(max(0, (int(at) - REACH) // tile), (int(at) + REACH) // tile + 1) for at, tile in ((row, TILE[1]), (column, TILE[0]))
            ]
            near = np.unique(self.owner[tuple(around)])
            yield (column, row, side), near[near != NOBODY].tolist()

    def near_faces(self, columns, rows):
        """Faces that each rank works out."""
        counts = np.zeros(self.ranks)
        for _, near in self._near(columns, rows):
            counts[near] += 1
        return counts

    def _owner_of_face(self, face, columns):
        """The rank that has its particle."""
        column, row, side = face
        cell = int(column) - (1 if side and column > MARGIN else 0)
        return self.owner[(int(row) - BEFORE[1]) // TILE[1], (cell - BEFORE[0]) // TILE[0]]

    def boundary(self, columns, rows):
        """By rank: the nodes that its faces may touch, the bytes about faces and nodes that it sends to others, and to how
        many."""
        wanted = [set() for _ in range(self.ranks)]
        numbers = np.zeros((self.ranks, self.ranks))  # from, to
        for face, near in self._near(columns, rows):
            column, row, side = face
            ends = (column, row, column + (0 if side else 0.5), row + (0.5 if side else 0))
            i, j = (range(math.floor(ends[k] - WAY), math.floor(ends[k + 2] + WAY) + 2) for k in (0, 1))
            owner = self._owner_of_face(face, columns)
            for rank in near:
                wanted[rank].update((a, b) for a in i for b in j)
                numbers[owner, rank] += OF_SOIL if rank != owner else 0
        for rank, nodes in enumerate(wanted):
            for a, b in nodes:
                owner = self.owner[b // TILE[1], a // TILE[0]]
                if owner not in (rank, NOBODY):
                    numbers[owner, rank] += OF_NODE
        return np.array([len(nodes) for nodes in wanted]), NUMBER * numbers.sum(axis=1), (numbers > 0).sum(axis=1)

    def sent(self):
        """Nodes that each rank sends in a scatter, field by field, and to how many ranks."""
        filled = self.particles > 0
        me = self.owner[filled]
        nodes = np.zeros(self.ranks)
        pairs = set()
        for b, height in ((-1, SHARED), (0, WINDOW[1] - 2 * SHARED), (1, SHARED)):
            for a, width in ((-1, SHARED), (0, WINDOW[0] - 2 * SHARED), (1, SHARED)):
                others = np.stack([self.shifted(r, c)[filled] for r in {0, b} for c in {0, a}])
                others.sort(axis=0)
                first = np.vstack([np.ones((1, me.size), bool), others[1:] != others[:-1]])
                goes = first & (others != me) & (others != NOBODY)
                nodes += width * height * np.bincount(me, weights=goes.sum(axis=0), minlength=self.ranks)
                for other, to in zip(others, goes):
                    pairs.update(zip(me[to].tolist(), other[to].tolist()))
        return nodes, np.bincount([rank for rank, _ in pairs], minlength=self.ranks)


def faces(columns, rows):
    """Boundary faces at both sides and the base, one a particle."""
    return 2 * (2 * rows + columns)


def shape_factor(tiles, ranks):
    """c of the mean and of the longest rim of the pieces of a square of 4^k = `tiles` tiles: sides over 4 sqrt(n), of pieces
    that touch no edge of the square."""
    size = round(tiles**0.5)
    x, y = hilbert_tiles(size)
    owner = np.full((size + 2, size + 2), NOBODY)
    owner[1 + y, 1 + x] = np.arange(tiles) * ranks // tiles
    inner = owner[1:-1, 1:-1]
    sides = np.zeros(ranks)
    at_edge = np.zeros(ranks, bool)
    for b, a in ((0, -1), (0, 1), (-1, 0), (1, 0)):
        other = owner[1 + b : 1 + b + size, 1 + a : 1 + a + size]
        sides += np.bincount(inner[other != inner], minlength=ranks)
        at_edge[inner[other == NOBODY]] = True
    c = sides[~at_edge] / (4 * (tiles / ranks) ** 0.5)
    return c.mean(), c.max()
