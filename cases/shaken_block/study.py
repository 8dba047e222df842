#!/usr/bin/env python3
"""The block's way on the ground against Newmark's (1965) integral of the free field's motion, for several frictions: a
Markdown table and slide.png.

    cases/shaken_block/study.py [TREMOLO]      default: build/release/bin/tremolo; results go to runs/shaken_block
"""

import sys
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "python"))

from tremolo import style
from tremolo.variants import run_variant

CASE = Path(__file__).resolve().parent / "case.toml"
FRICTIONS = [0.1, 0.2, 0.3, 0.8]
GRAVITY = 9.81  # m/s2


def ground_velocity(t):
    """Of the free field at the surface, where the wave of the case and its reflection add up, m/s."""
    shear_speed = np.sqrt(1e9 / (2.0 * 1.2) / 2000.0)
    a = (np.pi * 1.5 * (t - 0.8 - 6.0 / shear_speed)) ** 2
    return 2.0 * 0.35 * (1.0 - 2.0 * a) * np.exp(-a)


def newmark(time, friction):
    """Way of a rigid block on the ground at these times (m): its acceleration is that of the ground, as far as friction goes."""
    fine = np.linspace(0.0, time[-1], 200_001)
    dt = fine[1] - fine[0]
    ground = ground_velocity(fine)
    most = friction * GRAVITY * dt
    block = np.empty_like(fine)
    block[0] = ground[0]
    for k in range(1, len(fine)):
        block[k] = block[k - 1] + min(max(ground[k] - block[k - 1], -most), most)
    relative = block - ground
    way = np.concatenate([[0.0], np.cumsum(0.5 * dt * (relative[1:] + relative[:-1]))])
    return np.interp(time, fine, way)


def main():
    tremolo = sys.argv[1] if len(sys.argv) > 1 else ROOT / "build/release/bin/tremolo"
    folder = Path("runs/shaken_block")
    folder.mkdir(parents=True, exist_ok=True)
    figure, ax = style.plt.subplots(figsize=(7.2, 3.6), layout="constrained")
    print("| friction | most, Newmark, mm | most, mm | left, Newmark, mm | left, mm | largest difference, of the most |")
    print("| --- | --- | --- | --- | --- | --- |")
    for number, friction in enumerate(FRICTIONS):
        changes = {"friction = 0.3\n": f"friction = {friction!r}\n"}
        with run_variant(tremolo, CASE, changes, folder, f"{friction:g}") as run:
            block = run.monitor("foot")
            time = block["time"]
            # Displacement of the free field: the integral of its velocity.
            fine = np.linspace(0.0, time[-1], 200_001)
            ground = np.concatenate([[0.0], np.cumsum(0.5 * np.diff(fine) * (ground_velocity(fine)[1:] + ground_velocity(fine)[:-1]))])
            found = 1e3 * (block["ux"] - np.interp(time, fine, ground))
            exact = 1e3 * newmark(time, friction)
        most = np.abs(exact).max()
        share = f"{100.0 * np.abs(found - exact).max() / most:.1f} %" if most > 1e-6 else "it does not slide"
        print(f"| {friction:g} | {most:.2f} | {np.abs(found).max():.2f} | {exact[-1]:.2f} | {found[-1]:.2f} | {share} |", flush=True)
        ax.plot(time, exact, color=style.COLOURS[number], linewidth=2.4, alpha=0.35)
        ax.plot(time, found, color=style.COLOURS[number], label=f"{friction:g}")
    ax.plot([], [], color="0.4", linewidth=2.4, alpha=0.5, label="Newmark")
    ax.set(xlabel="t (s)", ylabel="way of the block on the ground (mm)", xlim=(0.0, time[-1]))
    ax.legend(title="friction")
    print(style.save(figure, folder, "slide.png"))


if __name__ == "__main__":
    main()
