#!/usr/bin/env python3
"""Acceleration of the block for frictions below and above tan(20 degrees), against g (sin - mu cos): a Markdown table and
slide.png.

    cases/block_on_slope/study.py [TREMOLO]      default: build/release/bin/tremolo; results go to runs/block_on_slope
"""

import sys
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "python"))

from tremolo import style
from tremolo.variants import run_variant

CASE = Path(__file__).resolve().parent / "case.toml"
ANGLE = np.radians(20.0)
SHARES = [0.0, 0.25, 0.5, 0.75, 0.95, 1.05, 1.25]  # of tan(20 degrees)
GRAVITY = 9.81  # m/s2


def slide(run):
    """Time (s) and speed of the block down the slope (m/s)."""
    block = run.body("block")
    return block["time"], -(block["vx"] * np.cos(ANGLE) + block["vy"] * np.sin(ANGLE))


def acceleration(run):
    """Slope of the speed after 0.1 s, in which the rock springs back from the bonds, m/s2."""
    time, speed = slide(run)
    return float(np.polyfit(time[time > 0.1], speed[time > 0.1], 1)[0])


def main():
    tremolo = sys.argv[1] if len(sys.argv) > 1 else ROOT / "build/release/bin/tremolo"
    folder = Path("runs/block_on_slope")
    folder.mkdir(parents=True, exist_ok=True)
    figure, (speeds, accelerations) = style.plt.subplots(1, 2, figsize=(9.0, 3.4), layout="constrained")
    print("| friction over tan 20° | a, m/s² | g (sin − μ cos) | slid in 0.8 s, m |\n| --- | --- | --- | --- |")
    for share in SHARES:
        friction = share * float(np.tan(ANGLE))
        changes = {"friction = 0.3\n": f"friction = {friction!r}\n"}
        with run_variant(tremolo, CASE, changes, folder, f"{friction:.4f}") as run:
            a = acceleration(run)
            exact = GRAVITY * max(0.0, np.sin(ANGLE) - friction * np.cos(ANGLE))
            block = run.body("block")
            way = np.hypot(block["x"][-1] - block["x"][0], block["y"][-1] - block["y"][0])
            print(f"| {share:g} | {a:.4f} | {exact:.4f} | {way:.2g} |", flush=True)
            [line] = speeds.plot(*slide(run), label=f"{share:g}")
            accelerations.plot(share, a, "o", color=line.get_color(), markersize=5)
    shares = np.linspace(0.0, 1.4, 141)
    exact = GRAVITY * np.sin(ANGLE) * np.maximum(0.0, 1.0 - shares)
    accelerations.plot(shares, exact, color="0.4", linewidth=0.8, zorder=0, label="g (sin − μ cos)")
    accelerations.set(xlabel="friction over tan 20°", ylabel="acceleration (m/s²)")
    accelerations.legend()
    speeds.set(xlabel="t (s)", ylabel="speed down the slope (m/s)")
    speeds.legend(title="friction over tan 20°", ncols=2)
    print(style.save(figure, folder, "slide.png"))


if __name__ == "__main__":
    main()
