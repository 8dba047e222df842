"""The cost of a domain on P ranks, one a node, with N particles in a flat box (docs/ranks.md).

    T(N, P) = C + H + B + S + R

    C  compute       u N/(P r)                                        u: fullest rank over the mean
    H  halo          3 (alpha + (m - 1) o) + b/beta                   m neighbours, b bytes in the two scatters of a step;
                                                                      the third message has what faces near the rank ask for
    B  boundary      n t_f + F t_e                                    n faces near the rank's tiles; all F, Eq. (6) alone
    S  collect,      2 ((P - 1) o + alpha) + b_f/beta                 velocities of faces to the first rank, and the free
       deal_out                                                       field from it to each that of its near faces
    R  totals        q 2 ceil(log2 P) (alpha + b_q/beta)              q sums or extremes, up a tree and down

alpha: latency, o: time of the processor for a message, beta: bandwidth. How often a step calls each comes from what
cost_ranks has counted; b from the perimeter of a piece of tiles (rank_tiles.py); F and b_f grow with the length of the
boundary, sqrt(N).

    usage: ranks_model.py STEPS.csv MESSAGES.csv [PNG]    files of `cost_ranks steps` and `cost_ranks messages` for 2 ranks

Prints the tables of the page as Markdown.
"""

import csv
import math
import sys
from dataclasses import dataclass, replace

import rank_tiles

FIELDS = 5 + 2  # mass, momentum and force; then momentum again (musl)
NUMBER = rank_tiles.NUMBER
SCATTERS = 2
ROUNDS = SCATTERS + 1  # and one for the boundary
MEAN_SHAPE = 1.4  # c of rank_tiles.py
NEIGHBOURS = 6  # of a piece in the mean: 6.1 of 1,000 pieces of a box
UNEVEN = 1.15  # beyond it tiles are dealt anew
ASPECT = 2.5  # width of the box over its depth


@dataclass
class Machine:
    name: str
    rate: float  # particle updates a second of a node
    face: float  # time of a face in a step, s
    eq6: float  # time of the part of it that every rank spends on every face, s
    alpha: float  # s
    overhead: float  # o, s
    beta: float  # bytes/s
    memory: float  # of a node, bytes


@dataclass
class Calls:
    """Collective exchanges of a step, and the bytes of each kind."""

    totals: float  # add, largest, and both together
    of_first: float  # collect and deal_out
    totals_bytes: float  # all calls together


# One rank of 64 cores on InfiniBand. Rate: 25 million updates a core are 1.6e9; memory of 300 GB/s, 600 bytes a particle,
# allows 0.5e9. alpha, o, beta: OSU benchmarks on a cluster with EDR InfiniBand (see the page) give 1.1 us, 0.27 us, 13.6 GB/s.
CLUSTER = Machine("cluster (assumed)", 0.5e9, math.nan, math.nan, 1.5e-6, 0.3e-6, 12e9, 256e9)


def box(particles):
    """Columns and rows of cells of a box with about so many particles."""
    rows = max(1, round(math.sqrt(particles / rank_tiles.PARTICLES_PER_CELL / ASPECT)))
    return round(ASPECT * rows), rows


def halo_bytes(particles, ranks):
    """Sent by a rank in a step, by the perimeter of its piece; 0 for one rank."""
    if ranks == 1:
        return 0.0
    tiles = particles / ranks / (rank_tiles.PARTICLES_PER_CELL * rank_tiles.TILE[0] * rank_tiles.TILE[1])
    return 2 * (rank_tiles.BESIDE + rank_tiles.ABOVE) * math.sqrt(tiles) * MEAN_SHAPE * FIELDS * NUMBER


def near_faces(particles, ranks):
    """Of a rank in a corner of the box, whose piece has a side along the base and one along a side of the box."""
    columns, rows = box(particles)
    if ranks == 1:
        return rank_tiles.faces(columns, rows)
    tiles = particles / ranks / (rank_tiles.PARTICLES_PER_CELL * rank_tiles.TILE[0] * rank_tiles.TILE[1])
    cells = sum(rank_tiles.TILE) * math.sqrt(tiles) * MEAN_SHAPE + 2 * rank_tiles.REACH
    return min(rank_tiles.faces(columns, rows), 2 * cells)


def passed_faces(particles, ranks):
    """Near faces of all ranks together: those within REACH of two pieces along the boundary count for both."""
    columns, rows = box(particles)
    if ranks == 1:
        return rank_tiles.faces(columns, rows)
    side = math.sqrt(particles / ranks / (rank_tiles.PARTICLES_PER_CELL * rank_tiles.TILE[0] * rank_tiles.TILE[1]))
    pieces = columns / (rank_tiles.TILE[0] * side) + 2 * rows / (rank_tiles.TILE[1] * side)
    return rank_tiles.faces(columns, rows) + pieces * 2 * (2 * rank_tiles.REACH)


def velocity_bytes(columns, rows):
    """Bytes that the first rank takes: the velocities of all faces."""
    return NUMBER * 2 * rank_tiles.faces(columns, rows)


def field_bytes(near_faces_of_all):
    """Bytes of the free field that the first rank gives away."""
    return NUMBER * 5 * near_faces_of_all


def step(machine, calls, particles, ranks, uneven=UNEVEN, cells=None, halo=None, neighbours=None, near=None, passed=None):
    """The terms of a step, s, by name.
    cells, halo, neighbours, near, passed: columns and rows, bytes, neighbours and near faces of a rank, near faces of all;
    those of the typical box if left out."""
    columns, rows = cells or box(particles)
    neighbours = min(NEIGHBOURS, ranks - 1) if neighbours is None else neighbours
    halo = halo_bytes(particles, ranks) if halo is None else halo
    near = near_faces(particles, ranks) if near is None else near
    passed = passed_faces(particles, ranks) if passed is None else passed
    depth = math.ceil(math.log2(ranks))
    alpha, o, beta = machine.alpha, machine.overhead, machine.beta
    terms = {
        "compute": (uneven if ranks > 1 else 1.0) * particles / ranks / machine.rate,
        "halo": 0.0,
        "boundary": near * (machine.face - machine.eq6) + rank_tiles.faces(columns, rows) * machine.eq6,
        "free field": 0.0,
        "totals": 0.0,
    }
    if ranks > 1:
        terms["halo"] = ROUNDS * (alpha + (neighbours - 1) * o) + halo / beta
        terms["free field"] = calls.of_first * ((ranks - 1) * o + alpha) + (velocity_bytes(columns, rows) + field_bytes(passed)) / beta
        terms["totals"] = 2 * depth * (calls.totals * alpha + calls.totals_bytes / beta)
    return terms


class Measured:
    """What cost_ranks has printed."""

    def __init__(self, steps, messages):
        self.values = {}
        with open(steps, newline="") as file:
            for row in csv.DictReader(file):
                key = (int(row["ranks"]), int(row["threads"]), row["name"])
                self.values.setdefault(key, []).append(float(row["value"]))
                self.cells = int(row["columns"]), int(row["rows"])
                self.ranks = int(row["ranks"])
        with open(messages, newline="") as file:
            self.messages = [(row["exchange"], int(row["bytes"]), float(row["seconds"])) for row in csv.DictReader(file)]

    def of(self, name, ranks=1, threads=1):
        """The largest of all ranks."""
        return max(self.values[ranks, threads, name])

    def shared(self, name):
        return self.of(name, self.ranks)

    def calls(self):
        kinds = ("add", "largest", "totals")
        return Calls(
            sum(self.shared(f"{kind} calls") for kind in kinds),
            self.shared("collect calls") + self.shared("deal_out calls"),
            sum(self.shared(f"{kind} bytes") for kind in kinds),
        )

    def messages_of(self, exchange):
        return {size: seconds for kind, size, seconds in self.messages if kind == exchange}

    def machine(self, threads):
        """This machine, a node being `threads` of its cores."""
        particles, faces = self.of("particles", threads=threads), self.of("faces", threads=threads)
        without = self.of("seconds without faces", threads=threads)
        there = self.messages_of("message")
        large = max(there)
        return Machine(
            f"measured, {threads} core{'s' if threads > 1 else ''} a node",
            particles / without,
            sum(self.of(f"pass: boundary {part}", threads=threads) for part in ("exchange", "tractions")) / faces,
            self.of("seconds of Eq. (6)", threads=threads) / faces,
            min(there.values()),
            min(there.values()) / 2,  # both ends of a message share memory: half the latency is each one's work
            large / there[large],
            24e9,
        )


def cluster(measured):
    """Its faces cost what they cost here on two cores: the work of a rank on them is mostly one thread's."""
    return replace(CLUSTER, face=measured.machine(2).face, eq6=measured.machine(2).eq6)


def table(head, rows):
    print("| " + " | ".join(head) + " |")
    print("|" + "|".join("---:" if n else "---" for n in range(len(head))) + "|")
    for row in rows:
        print("| " + " | ".join(row) + " |")
    print()


def print_machines(machines):
    table(
        ["parameter"] + [m.name for m in machines],
        [
            ["r, million updates a second of a node"] + [f"{m.rate / 1e6:.3g}" for m in machines],
            ["t_f, ns a face and step"] + [f"{m.face * 1e9:.3g}" for m in machines],
            ["t_e, ns a face and step"] + [f"{m.eq6 * 1e9:.3g}" for m in machines],
            ["alpha, us"] + [f"{m.alpha * 1e6:.2g}" for m in machines],
            ["o, us"] + [f"{m.overhead * 1e6:.2g}" for m in machines],
            ["beta, GB/s"] + [f"{m.beta / 1e9:.2g}" for m in machines],
        ],
    )


def print_check(measured):
    """Two ranks with a core each against the model of one core's measurements."""
    machine, calls, ranks = measured.machine(1), measured.calls(), measured.ranks
    columns, rows = measured.cells
    tiles = rank_tiles.Tiles(columns, rows, ranks)
    nodes, neighbours = tiles.sent()
    of_boundary = tiles.boundary(columns, rows)[1]
    terms = step(machine, calls, measured.of("particles"), ranks, tiles.unevenness(), (columns, rows),
                 nodes.max() * FIELDS * NUMBER + of_boundary.max(), neighbours.max(), tiles.near_faces(columns, rows).max(),
                 tiles.near_faces(columns, rows).sum())  # fmt: skip
    rows_of_table = [[name, f"{1e3 * value:.3f}"] for name, value in terms.items()]
    total, time = sum(terms.values()), measured.shared("seconds")
    rows_of_table.append(["sum", f"{1e3 * total:.3f}"])
    rows_of_table.append(["measured", f"{1e3 * time:.3f}"])
    rows_of_table.append(["predicted over measured", f"{total / time:.3f}"])
    table([f"{columns} x {rows} cells, {ranks} ranks", "ms"], rows_of_table)
    waits = {kind: measured.shared(f"{kind} seconds") for kind in ("wait", "collect", "deal_out", "add", "largest", "totals")}
    table(["in exchanges, fullest rank", "ms"], [[kind, f"{1e3 * seconds:.3f}"] for kind, seconds in waits.items()])
    one, two = measured.of("seconds"), measured.of("seconds", threads=2)
    print(f"updates a second, million: one thread {measured.of('particles') / one / 1e6:.2f}, two threads "
          f"{measured.of('particles') / two / 1e6:.2f}, {ranks} ranks {measured.of('particles') / time / 1e6:.2f}; ranks over "
          f"two threads {two / time:.3f}\n")  # fmt: skip


NODES = (1, 2, 4, 8, 16, 32, 64, 128, 256, 512, 1000)
SIZES = (1e6, 1e7, 1e8, 1e9)


def efficiency(machine, calls, particles, ranks, of_one):
    """Of `ranks` nodes against `of_one` times as many particles on one."""
    one = sum(step(machine, calls, particles * of_one, 1).values())
    return one / sum(step(machine, calls, particles, ranks).values()) / (ranks * of_one)


def print_scaling(machine, calls):
    def one(particles, ranks):
        terms = step(machine, calls, particles, ranks)
        rest = max((value, name) for name, value in terms.items() if name != "compute")[1]
        return f"{1e3 * sum(terms.values()):.3g} ms, {rest}"

    table([f"strong, {machine.name}"] + [f"N = {n:.0e}" for n in SIZES],
          [[str(p)] + [f"{one(n, p)}, {100 * efficiency(machine, calls, n, p, 1.0):.0f} %" for n in SIZES] for p in NODES])  # fmt: skip
    per_node = (1e6, 1e7)
    table([f"weak, {machine.name}"] + [f"{n:.0e} a node" for n in per_node],
          [[str(p)] + [f"{one(n * p, p)}, {100 * efficiency(machine, calls, n * p, p, 1 / p):.0f} %" for n in per_node]
           for p in NODES])  # fmt: skip
    table([f"half efficiency, {machine.name}"] + [f"N = {n:.0e}" for n in SIZES],
          [["nodes"] + [str(half(machine, calls, n)) for n in SIZES]])  # fmt: skip


def half(machine, calls, particles):
    """The largest number of nodes with at least half the efficiency."""
    ranks = 1
    while ranks < 100000 and efficiency(machine, calls, particles, ranks + 1, 1.0) >= 0.5:
        ranks += 1
    return ranks


def draw(machine, calls, picture):
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    figure, (strong, weak, terms) = plt.subplots(1, 3, figsize=(13.0, 4.0), layout="constrained")
    for particles in SIZES:
        strong.plot(NODES, [sum(step(machine, calls, particles, p).values()) for p in NODES], "o-", ms=3, label=f"{particles:.0e} particles")
        strong.plot(NODES, [particles / machine.rate / p for p in NODES], "k:", linewidth=0.7)
    strong.set(xscale="log", yscale="log", xlabel="nodes", ylabel="time of a step (s)", title="strong scaling; dotted: ideal")
    for particles in (1e5, 1e6, 1e7):
        weak.plot(NODES, [efficiency(machine, calls, particles * p, p, 1 / p) for p in NODES], "o-", ms=3, label=f"{particles:.0e} a node")
    weak.set(xscale="log", ylim=(0.0, 1.0), xlabel="nodes", ylabel="efficiency", title="weak scaling")
    parts = {p: step(machine, calls, 1e8, p) for p in NODES}
    for name in parts[1]:
        values = [parts[p][name] or math.nan for p in NODES]
        terms.plot(NODES, values, "o-", ms=3, label=name)
    terms.set(xscale="log", yscale="log", xlabel="nodes", ylabel="time in a step (s)", title="parts, 1e8 particles")
    for axes in (strong, weak, terms):
        axes.grid(alpha=0.3)
        axes.legend(fontsize=8)
    figure.savefig(picture, dpi=110)


def main(steps, messages, picture=None):
    measured = Measured(steps, messages)
    calls = measured.calls()
    machines = [measured.machine(1), measured.machine(2), cluster(measured)]
    print_machines(machines)
    print(f"calls a step: totals {calls.totals:g} with {calls.totals_bytes:g} bytes, collect and deal_out "
          f"{calls.of_first:g}\n")  # fmt: skip
    print_check(measured)
    print_scaling(machines[2], calls)
    if picture:
        draw(machines[2], calls, picture)


if __name__ == "__main__":
    main(*sys.argv[1:])
