#!/usr/bin/env python3
"""The tunnel's lining in the place of the rigid disc, with the disc's mass: how far both rise, and axial force and moment of the lining
at rest, as it floats up and after the shaking: a Markdown table, lining.png and lining_tunnel.png.

    cases/tunnel_uplift/lining.py [TREMOLO [FOLDER]]      default: build/release/bin/tremolo, runs/tunnel_uplift

Runs what is not in FOLDER yet.
"""

import sys
from pathlib import Path

import numpy as np
from study import CASE, COMPARED, PERIOD, SHORT, coarse, run_variant, style, synthesise, uplift
from tremolo.pictures import linings
from tremolo.variants import cpu_time

TEXT = CASE.read_text()
DISC = TEXT[TEXT.index("[[structure]]"):TEXT.index("[mesh]")]
OUTER, THICKNESS = 2.5, 0.2  # m
MASS = 300.0 * np.pi * OUTER**2  # kg/m, of the disc
DENSITY = MASS / (2.0 * np.pi * (OUTER - 0.5 * THICKNESS) * THICKNESS)
RING = f"""[[lining]]
name = "tunnel"
circle = {{ centre = [22.5, -5.5], radius = {OUTER} }}
thickness = {THICKNESS}
young = 30e9
poisson = 0.2
density = {DENSITY:.1f}
friction = 0.4

"""
LINED = {DISC: RING}
# Folder: label, changes, whether the tunnel is lined.
VARIANTS = {
    "coarse": ("rigid disc, cells of 1 m", coarse(SHORT + 4.0), False),
    "coarse_lining": ("lining, cells of 1 m", coarse(SHORT + 4.0) | LINED, True),
}


def rise_of_lining(run):
    """Time (s) and rise of the axis (m), mean of a cycle."""
    ring = run.lining("tunnel")
    window = max(1, round(PERIOD / np.median(np.diff(ring.time))))
    height = ring.places[:, :, 1].mean(axis=1)
    return ring.time[window - 1 :], np.convolve(height - height[0], np.ones(window) / window, mode="valid")


def forces(ring, begin, end):
    """Mean axial force around the lining (kN/m), and the largest and the least moment (kNm/m), of the means between two times (s)."""
    chosen = (ring.time >= begin) & (ring.time < end)
    moment = ring.moment[chosen].mean(axis=0) / 1e3
    return ring.axial_force[chosen].mean() / 1e3, moment.max(), moment.min()


def main():
    tremolo = sys.argv[1] if len(sys.argv) > 1 else "build/release/bin/tremolo"
    folder = Path(sys.argv[2] if len(sys.argv) > 2 else "runs/tunnel_uplift")
    folder.mkdir(parents=True, exist_ok=True)
    synthesise(tremolo, folder)
    print("| tunnel | rise at 8 s, m | when the shaking ends | at rest: N / largest / least M | 8 to 9.3 s | at the end | CPU time, min |")
    print("| --- " * 7 + "|")
    figure, ax = style.plt.subplots(figsize=(7.6, 3.2), layout="constrained")
    for name, (label, changes, lined) in VARIANTS.items():
        with run_variant(tremolo, CASE, changes, folder, name) as run:
            time, rise = rise_of_lining(run) if lined else uplift(run)
            cells = ["–"] * 3
            if lined:
                ring = run.lining("tunnel")
                end = float(ring.time[-1])
                spans = [(0.0, 0.1), (COMPARED, COMPARED + PERIOD), (end - PERIOD, end)]
                cells = [" / ".join(f"{force:.0f}" for force in forces(ring, *span)) for span in spans]
                drawn = linings.picture(run, folder, "tunnel", [0.0, COMPARED, end])
            rises = " | ".join(f"{np.interp(at, time, rise):.3f}" for at in (COMPARED, SHORT))
            print(f"| {label} | {rises} | {' | '.join(cells)} | {cpu_time(run) / 60.0:.1f} |", flush=True)
            ax.plot(time, rise, color=style.COLOURS[lined], label=label)
    ax.set(xlabel="t (s)", ylabel="rise of the axis (m)")
    ax.legend()
    print(style.save(figure, folder, "lining.png"), drawn, sep="\n")


if __name__ == "__main__":
    main()
