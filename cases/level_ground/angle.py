#!/usr/bin/python3
"""The case under the wave at 15 degrees beside the vertical one, as columns of finite elements and as domains in cells of
1 m between them: the table of README.md and angle.png.

    cases/level_ground/angle.py [TREMOLO [FOLDER]]      default: build/release/bin/tremolo, runs/level_ground

Runs what is not in FOLDER yet.
"""

import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1] / "python"))

import numpy as np
from study import Level
from tremolo import pore_pressure, style
from tremolo.variants import run_column, run_variant

ANGLES = (0, 15)  # degrees
DEPTHS = (2.75, 5.25, 7.75)  # m
END = 25.0  # s
MODELS = {'left = { model = "mpm" }': 'left = { model = "fe" }', 'right = { model = "mpm" }': 'right = { model = "fe" }',
          'base = { model = "mpm"': 'base = { model = "fe"'}


def changes(angle):
    return MODELS | {"angle_deg = 0.0": f"angle_deg = {angle}.0"}


def column(tremolo, folder, angle):
    """Histories at the surface and the depths, and the settlement over time."""
    depths = ",".join(map(str, (0, *DEPTHS)))
    out, _ = run_column(tremolo, HERE / "case.toml", changes(angle), folder, f"angle_{angle}", "fe", "--depths", depths,
                        "--duration", f"{END:g}")
    levels, histories, _, settlement, _ = pore_pressure.read(out)
    at = {depth: histories[int(np.argmin(np.abs(levels + depth)))] for depth in (0.0, *DEPTHS)}
    return at, settlement


def swing(history, before):
    """The largest departure of pore pressure from its mean of a second, Pa."""
    time, pressure = history["time"], history["pore_pressure"]
    width = round(1.0 / (time[1] - time[0])) // 2 * 2 + 1
    mean = np.convolve(pressure, np.full(width, 1.0 / width), mode="same")
    chosen = (time > 0.5) & (time < before)
    return np.abs(pressure - mean)[chosen].max()


def liquefied(time, ratio):
    """Mean of r_u from 6 to 15 s."""
    return ratio[(time > 6.0) & (time < 15.0)].mean()


def column_cells(tremolo, folder, angle):
    at, settlement = column(tremolo, folder, angle)
    middle = at[5.25]
    return [f"{np.abs(at[0.0][name]).max():.3g}" for name in ("vx", "vy")] + \
        [f"{1e-3 * swing(at[depth], 3.0):.2f}" for depth in DEPTHS] + \
        [f"{liquefied(middle['time'], middle['pore_pressure_ratio']):.3f}", f"{1e3 * settlement['settlement'][-1]:.2f}"]


def domain_cells(tremolo, folder, angle):
    with run_variant(tremolo, HERE / "case.toml", changes(angle) | {"size = 0.5\n": "size = 1.0\n"}, folder, f"angle_{angle}") as run:
        level, surface = Level(run), run.monitor("surface")
        return [f"{np.abs(surface[name]).max():.3g}" for name in ("vx", "vy")] + [""] * len(DEPTHS) + \
            [f"{liquefied(run.times, level.ratio(5.5).mean(axis=1)):.3f}", f"{1e3 * level.settlement().mean(axis=1)[-1]:.2f}"]


def picture(tremolo, folder):
    """Pore pressure at the depths and vertical velocity of the surface until the sand has liquefied."""
    figure, axes = style.plt.subplots(len(DEPTHS) + 1, 1, figsize=(7.6, 7.2), sharex=True, layout="constrained")
    for angle in reversed(ANGLES):
        at, _ = column(tremolo, folder, angle)
        look = dict(color=style.COLOURS[ANGLES.index(angle)], linewidth=0.8, label=f"{angle}°")
        for ax, depth in zip(axes, DEPTHS):
            ax.plot(at[depth]["time"], 1e-3 * at[depth]["pore_pressure"], **look)
            ax.set_title(f"{depth:g} m deep", loc="left")
        axes[-1].plot(at[0.0]["time"], at[0.0]["vy"], **look)
    for ax in axes[:-1]:
        ax.set_ylabel("excess p (kPa)")
    axes[0].legend()
    axes[-1].set(xlabel="t (s)", ylabel="$v_y$, surface (m/s)", xlim=(0.0, 6.0))
    return style.save(figure, folder, "angle.png")


def main():
    tremolo = sys.argv[1] if len(sys.argv) > 1 else "build/release/bin/tremolo"
    folder = Path(sys.argv[2] if len(sys.argv) > 2 else "runs/level_ground")
    folder.mkdir(parents=True, exist_ok=True)
    if not (folder / "motion.csv").exists():
        (folder / "motion.csv").write_bytes((HERE / "motion.csv").read_bytes())
    print("| | column, 0 degrees | 15 degrees | domain, 0 degrees | 15 degrees |\n| --- | --- | --- | --- | --- |")
    names = ["largest velocity of the surface, x, m/s", "y, m/s",
             *(f"swing of pore pressure before 3 s, {depth:g} m deep, kPa" for depth in DEPTHS),
             "r_u, mean of 6 to 15 s, 5.25 m deep (domain 5.5 m)", "settlement at 25 s, mm"]
    columns = [cells(tremolo, folder, angle) for cells in (column_cells, domain_cells) for angle in ANGLES]
    for name, *row in zip(names, *columns):
        print(f"| {name} | {' | '.join(row)} |")
    print(picture(tremolo, folder))


if __name__ == "__main__":
    main()
