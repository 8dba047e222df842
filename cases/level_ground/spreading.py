#!/usr/bin/python3
"""The numbers and the picture of the gentle slope in README.md.

    cases/level_ground/spreading.py [TREMOLO [FOLDER]]      default: build/release/bin/tremolo, runs/level_ground

Runs slope.toml if FOLDER/slope is not there yet.
"""

import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1] / "python"))

import numpy as np
from tremolo import Run, style

PLACES = {  # m
    "upper flat": (4.5, -0.25), "upper slope": (18.5, -0.75), "middle": (28.5, -1.25), "lower slope": (38.5, -1.75),
    "lower flat": (52.5, -2.25), "middle, 4.5 m": (28.5, -4.5), "middle, 6.5 m": (28.5, -6.5),
}
PERIOD = 1.0  # s, of the motion
TIMES = [4.0, 6.0, 8.0, 10.0, 15.0, 25.0]  # s


def downhill(run):
    """[frame, particle], m, against the lowest row of particles, which moves with the rock."""
    base = run.field(0, "position")[:, 1] < run.field(0, "position")[:, 1].min() + 0.1
    all_of_them = [run.field(frame, "displacement")[:, 0] for frame in range(len(run.times))]
    return np.array([one - one[base].mean() for one in all_of_them])


def nearest(run, place):
    return int(np.argmin(np.hypot(*(run.field(0, "position") - place).T)))


def mean_of_cycle(times, values, time):
    cycle = (times > time - PERIOD + 1e-6) & (times <= time + 1e-6)
    return values[cycle].mean()


def picture(run, moved, path):
    figure, (lines, field) = style.plt.subplots(
        2, 1, figsize=(8.0, 5.5), layout="constrained", height_ratios=[1.5, 1.0]
    )
    for name, place in PLACES.items():
        lines.plot(run.times, moved[:, nearest(run, place)], linewidth=0.8, label=name)
    lines.set(xlabel="t (s)", ylabel="downhill, against the base (m)", xlim=(0.0, run.times[-1]))
    lines.legend(ncols=3, fontsize=7)
    x, y = run.field(len(run.times) - 1, "position").T
    dots = field.scatter(x, y, c=moved[-1], s=6.0, cmap="viridis")
    field.set(xlabel="x (m)", ylabel="y (m)", aspect="equal")
    figure.colorbar(dots, ax=field, label="downhill (m)", shrink=0.9)
    return style.save(figure, path.parent, path.name)


def main():
    tremolo = sys.argv[1] if len(sys.argv) > 1 else "build/release/bin/tremolo"
    folder = Path(sys.argv[2] if len(sys.argv) > 2 else "runs/level_ground")
    if not (folder / "slope" / "run.h5").exists():
        subprocess.run([tremolo, "run", HERE / "slope.toml", "--out", folder / "slope"], check=True)
    run = Run(folder / "slope")
    moved = downhill(run)
    print("| mm downhill, mean of a cycle | " + " | ".join(f"{time:g} s" for time in TIMES) + " |")
    for name, place in PLACES.items():
        history = moved[:, nearest(run, place)]
        print(f"| {name} | " + " | ".join(f"{1e3 * mean_of_cycle(run.times, history, time):.0f}" for time in TIMES) + " |")
    print(picture(run, moved, folder / "spreading.png"))


if __name__ == "__main__":
    main()
