#!/usr/bin/python3
"""The numbers and the picture of README.md: the domain, its own column, and the column of finite elements.

    cases/level_ground/study.py [TREMOLO [FOLDER]]      default: build/release/bin/tremolo, runs/level_ground

Runs what is not in the folder yet.
"""

import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1] / "python"))

import numpy as np
from tremolo import Run, pore_pressure, style

DEPTHS = [2.75, 5.25, 7.75]  # m, centres of cells
BUOYANT = 1009.2 * 9.81  # N/m3, of the sand
GRADIENT = 1009.2 / 1000.0  # of water that carries the sand
PERMEABILITY = 1e-4  # m/s
SPANS = [("before, to 3 s", 0.0, 3.0), ("liquefying, 3 to 6 s", 3.0, 6.0), ("liquefied, 6 to 15 s", 6.0, 15.0)]


class Level:
    """Fields of a frame by rows from the base up and columns from the left, as the particles lay at the start."""

    def __init__(self, run):
        self.run = run
        start = run.field(0, "position") - run.field(0, "displacement")
        x, y = np.round(start, 4).T
        self.order = np.lexsort((x, y))
        self.x, self.y = np.unique(x), np.unique(y)

    def field(self, index, name):
        return self.run.field(index, name)[self.order].reshape(len(self.y), len(self.x), -1)

    def history(self, act):
        return np.array([act(index) for index in range(len(self.run.times))])

    def ratio(self, depth):
        """r_u [time, x] of the cells at a depth: their pressure over the effective stress at their centre."""
        rows = np.flatnonzero(np.abs(self.y + depth) < 0.5 * self.run.attribute("mesh_size"))
        weight = (-self.y[rows] / depth)[:, None]
        return self.history(lambda i: (self.field(i, "pore_pressure_ratio")[rows, :, 0] * weight).mean(axis=0))

    def settlement(self):
        """[time, x], m, of the surface relative to the base."""
        return self.history(lambda i: self.field(i, "displacement")[0, :, 1] - self.field(i, "displacement")[-1, :, 1])

    def outflow(self):
        """[time, x], m/s, through the upper row."""
        return self.history(lambda i: self.field(i, "darcy_velocity")[-1, :, 1])

    def lost(self):
        """[time, x], m: volume that the ground below has lost, of its width."""
        first = self.field(0, "volume")
        width = self.x[1] - self.x[0]
        return self.history(lambda i: (first - self.field(i, "volume"))[:, :, 0].sum(axis=0) / width)


def outputs(tremolo, folder):
    """The run and the two columns, computed where they are missing."""
    folder.mkdir(parents=True, exist_ok=True)
    case = HERE / "case.toml"
    if not (folder / "run" / "run.h5").exists():
        subprocess.run([tremolo, "run", case, "--out", folder / "run"], check=True)
    for model in ("fe", "mpm"):
        if not (folder / f"{model}.h5").exists():
            depths = ",".join(str(depth) for depth in DEPTHS)
            subprocess.run(
                [tremolo, "column", case, "--model", model, "--depths", depths, "--duration", "25", "--out",
                 folder / f"{model}.h5"], check=True,
            )
    return Run(folder / "run"), {model: pore_pressure.read(folder / f"{model}.h5") for model in ("fe", "mpm")}


def unevenness(level, run):
    """Lines: differences of velocity at one level over the largest velocity of the run, the largest and the rms."""
    largest = max(np.abs(run.field(i, "velocity")).max() for i in range(len(run.times)))
    for name, start, end in SPANS:
        spread, apart, size = 0.0, 0.0, 0.0
        for index in np.flatnonzero((run.times >= start) & (run.times < end)):
            velocity = level.field(index, "velocity")
            spread = max(spread, np.ptp(velocity, axis=1).max())
            apart += ((velocity - velocity.mean(axis=1, keepdims=True)) ** 2).sum()
            size += (velocity**2).sum()
        yield f"| {name} | {100 * spread / largest:.2f} % | {100 * np.sqrt(apart / size):.2f} % |"


def integral(times, values, start, end):
    inside = (times >= start - 1e-6) & (times <= end + 1e-6)
    times, values = times[inside], values[inside]
    return (0.5 * (values[1:] + values[:-1]).T * np.diff(times)).sum(axis=-1)


def report(level, run):
    yield "| unevenness of velocity | largest | rms |\n| --- | --- | --- |"
    yield from unevenness(level, run)
    start, end = 16.0, 25.0
    first, last = run.nearest_frame(start), run.nearest_frame(end)
    left = level.x < 5.0
    flow = integral(run.times, level.outflow(), start, end)
    lost, settlement = level.lost(), level.settlement()
    lost = lost[last] - lost[first]
    yield f"from {start:g} to {end:g} s, mm: outflow {1e3 * flow[left].mean():.3f} left half, {1e3 * flow.mean():.3f} all"
    yield f"    volume lost {1e3 * lost[left].mean():.3f} left half, {1e3 * lost.mean():.3f} all"
    yield f"    closed form k (rho - rho_f)/rho_f {1e3 * PERMEABILITY * GRADIENT * (end - start):.3f}"
    final = 1e3 * settlement[-1]
    yield f"settlement at 25 s, mm: mean {final.mean():.2f}, over x {final.min():.2f} to {final.max():.2f}"
    energy = run.energy
    yield "energy at 25 s, kJ/m: " + ", ".join(f"{name} {energy[name][-1] / 1e3:.3f}" for name in energy.columns[1:])


def apart(level, run, columns):
    """Lines: how far r_u of a column is from the domain's mean over x, over the depths."""
    means = [level.ratio(depth).mean(axis=1) for depth in DEPTHS]
    for model, (levels, histories, *_) in columns.items():
        differences = []
        for depth, mean in zip(DEPTHS, means):
            history = histories[int(np.argmin(np.abs(levels + depth)))]
            differences.append(mean - np.interp(run.times, history["time"], history["pore_pressure_ratio"]))
        differences = np.array(differences)
        before, after = run.times <= 3.0, (run.times >= 5.0) & (run.times <= 15.0)
        rms = np.sqrt((differences[:, after] ** 2).mean(axis=1))
        yield (f"r_u of the domain and of {model}: {np.abs(differences[:, before]).max():.4f} apart at most until 3 s, "
               f"{rms.min():.3f} to {rms.max():.3f} from 5 to 15 s (rms)")


def picture(level, run, columns, path):
    """r_u over time at depths, and settlement: lines of the columns, the domain's mean with its range over x."""
    figure, axes = style.plt.subplots(
        len(DEPTHS) + 1, figsize=(8.0, 8.0), sharex=True, layout="constrained", height_ratios=[1.0] * len(DEPTHS) + [1.2]
    )
    domain = style.COLOURS[2]

    def draw_domain(ax, values):
        ax.fill_between(run.times, values.min(axis=1), values.max(axis=1), color=domain, alpha=0.25, linewidth=0)
        ax.plot(run.times, values.mean(axis=1), color=domain, label="domain, mean and range over x")

    for ax, depth in zip(axes, DEPTHS):
        draw_domain(ax, level.ratio(depth))
        for colour, (model, (levels, histories, *_)) in zip(style.COLOURS, columns.items()):
            history = histories[int(np.argmin(np.abs(levels + depth)))]
            ax.plot(history["time"], history["pore_pressure_ratio"], color=colour, linewidth=0.8, label=f"column {model}")
        ax.set(ylabel="$r_u$", title=f"{depth:g} m deep", ylim=(-0.1, 1.15))
    axes[0].legend(loc="lower right", ncols=3)
    draw_domain(axes[-1], 1e3 * level.settlement())
    for colour, (model, (*_, settlement, _)) in zip(style.COLOURS, columns.items()):
        axes[-1].plot(settlement["time"], 1e3 * settlement["settlement"], color=colour, linewidth=0.8)
    time = np.array([15.0, 25.0])
    slope = columns["mpm"][3]["settlement"][-1] + PERMEABILITY * GRADIENT * (time - time[-1])
    axes[-1].plot(time, 1e3 * slope, "k:", label="slope $k\\gamma'/\\gamma_w$")
    axes[-1].legend(loc="upper left")
    axes[-1].set(xlabel="t (s)", ylabel="settlement (mm)", xlim=(0.0, run.times[-1]))
    return style.save(figure, path.parent, path.name)


def main():
    tremolo = sys.argv[1] if len(sys.argv) > 1 else "build/release/bin/tremolo"
    folder = Path(sys.argv[2] if len(sys.argv) > 2 else "runs/level_ground")
    run, columns = outputs(tremolo, folder)
    level = Level(run)
    for line in report(level, run):
        print(line)
    for line in apart(level, run, columns):
        print(line)
    for model, (_, histories, _, settlement, _) in columns.items():
        print(f"column {model}: settlement {1e3 * settlement['settlement'][-1]:.2f} mm")
    print(picture(level, run, columns, folder / "columns.png"))


if __name__ == "__main__":
    main()
