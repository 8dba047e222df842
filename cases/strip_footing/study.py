#!/usr/bin/env python3
"""Which weight of the footing the clay carries, as a share of Prandtl's (2 + pi) c, and the pressure under it: a Markdown
table and pressure.png.

    cases/strip_footing/study.py [TREMOLO]      default: build/release/bin/tremolo; results go to runs/strip_footing
"""

import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "python"))

from tremolo import Run, style
from tremolo.variants import variant

CASE = Path(__file__).resolve().parent / "case.toml"
SHARES = [0.30, 0.60, 0.95, 1.05]
COHESION, WIDTH, HEIGHT, GRAVITY = 20e3, 2.0, 2.0, 9.81  # Pa, m, m, m/s2


def run_with(tremolo, folder, share):
    """The run with this share of Prandtl's load; None where the gravity stage finds no rest."""
    density = share * (2.0 + np.pi) * COHESION / (GRAVITY * HEIGHT)
    out = folder / f"{share:.2f}"
    if not (out / "run.h5").exists():
        case = folder / f"{share:.2f}.toml"
        case.write_text(variant(CASE, {"density = 4979.0 ": f"density = {density:.2f} "}))
        shutil.rmtree(out, ignore_errors=True)
        done = subprocess.run([tremolo, "run", case, "--out", out], capture_output=True, text=True)
        if "the gravity stage did not come to rest" in done.stderr:
            return None
        if done.returncode != 0:
            raise SystemExit(done.stderr)
    return Run(out)


def pressure(run):
    """Places (m) and pressures (Pa) of the contact nodes under the footing; nodes at its edges have half a cell or less."""
    nodes = run.contact(0)
    below = nodes["normal"][:, 1] > 0.9
    order = np.argsort(nodes["position"][below, 0])
    return nodes["position"][below, 0][order], (nodes["normal_force"][below] / nodes["area"][below])[order]


def main():
    tremolo = sys.argv[1] if len(sys.argv) > 1 else ROOT / "build/release/bin/tremolo"
    folder = Path("runs/strip_footing")
    folder.mkdir(parents=True, exist_ok=True)
    figure, ax = style.plt.subplots(figsize=(7.2, 3.4), layout="constrained")
    print("| weight over (2 + π) c B | the clay | contact force over weight |\n| --- | --- | --- |")
    for share in SHARES:
        run = run_with(tremolo, folder, share)
        if run is None:
            print(f"| {share:g} | fails: the gravity stage finds no rest | |", flush=True)
            continue
        footing = run.body("footing")
        carried = (footing["normal_y"][-1] + footing["friction_y"][-1]) / -footing["weight_y"][-1]
        print(f"| {share:g} | stands | {carried:.6f} |", flush=True)
        x, p = pressure(run)
        [line] = ax.plot(x, p / COHESION, "o-", markersize=3, label=f"{share:g}")
        ax.hlines(share * (2.0 + np.pi), -0.5 * WIDTH, 0.5 * WIDTH, color=line.get_color(), linewidth=0.7, linestyle="--")
    ax.set(xlabel="x (m)", ylabel="pressure under the footing over c", ylim=(0.0, None))
    ax.legend(title="weight over\n(2 + π) c B", loc="center left", bbox_to_anchor=(1.0, 0.5))
    print(style.save(figure, folder, "pressure.png"))


if __name__ == "__main__":
    main()
