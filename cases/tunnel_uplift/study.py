#!/usr/bin/env python3
"""How far the tunnel rises, and what that depends on: a Markdown table and uplift.png.

    cases/tunnel_uplift/study.py [TREMOLO [FOLDER]]      default: build/release/bin/tremolo, runs/tunnel_uplift

Runs what is not in FOLDER yet.
"""

import sys
from pathlib import Path

import numpy as np

CASE = Path(__file__).resolve().parent / "case.toml"
sys.path.insert(0, str(CASE.parents[2] / "python"))

from tremolo import style
from tremolo.variants import run_variant

PERIOD = 1.0 / 0.75  # s, of the motion
SHAKEN = 24.7  # s
FREE_FIELD = """left = { model = "mpm" }
right = { model = "mpm" }
base = { model = "mpm", form = "total" }
"""
VARIANTS = {
    "main": ("as it is", {}),
    "smooth": ("friction 0", {"friction = 0.4": "friction = 0.0"}),
    "heavy": ("1900 kg/m³", {"density = 300.0 ": "density = 1900.0 "}),
    "fe": ("free field `fe`", {FREE_FIELD: FREE_FIELD.replace('"mpm"', '"fe"')}),
    "periodic": ("periodic sides", {FREE_FIELD: 'sides = "periodic"\nbase = { model = "mpm", form = "total" }\n'}),
}


def uplift(run):
    """Time (s) and rise of the axis (m) over the ground's rock, mean of a cycle."""
    tunnel = run.body("tunnel")
    time = tunnel["time"]
    window = max(1, round(PERIOD / np.median(np.diff(time))))
    kernel = np.ones(window) / window
    rise = np.convolve(tunnel["y"] - tunnel["y"][0], kernel, mode="valid")
    return time[window - 1 :], rise


def rate(time, rise, begin, end):
    """Mean speed between two times, m/s."""
    return float(np.interp(end, time, rise) - np.interp(begin, time, rise)) / (end - begin)


def net_lift(run, begin, end):
    """Mean force of water and gravity on the tunnel between two times, N/m."""
    tunnel = run.body("tunnel")
    chosen = (tunnel["time"] >= begin) & (tunnel["time"] < end)
    return float((tunnel["water_y"] + tunnel["weight_y"])[chosen].mean())


def liquefied(run, monitor):
    """Time at which r_u of a monitor first reaches 0.9, s; nan if it never does."""
    table = run.monitor(monitor)
    reached = np.flatnonzero(table["pore_pressure_ratio"] >= 0.9)
    return float(table["time"][reached[0]]) if len(reached) else float("nan")


def main():
    tremolo = sys.argv[1] if len(sys.argv) > 1 else "build/release/bin/tremolo"
    folder = Path(sys.argv[2] if len(sys.argv) > 2 else "runs/tunnel_uplift")
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "motion.csv").write_bytes(CASE.with_name("motion.csv").read_bytes())
    figure, (lifted, ratios) = style.plt.subplots(2, 1, figsize=(7.6, 5.2), sharex=True, layout="constrained")
    print("| variant | r_u = 0.9 in the free field, s | net lift at 8 s, kN/m | rise at 24.7 s, m | rise at 35 s, m | rate after over rate during |")
    print("| --- | --- | --- | --- | --- | --- |")
    for number, (name, (label, changes)) in enumerate(VARIANTS.items()):
        with run_variant(tremolo, CASE, changes, folder, name) as run:
            time, rise = uplift(run)
            during, after = rate(time, rise, 3.0, SHAKEN), rate(time, rise, SHAKEN + PERIOD, time[-1])
            print(
                f"| {label} | {liquefied(run, 'free field'):.1f} | {net_lift(run, 8.0, 8.0 + PERIOD) / 1e3:.0f} "
                f"| {np.interp(SHAKEN, time, rise):.3f} | {rise[-1]:.3f} | {after / during:.3f} |",
                flush=True,
            )
            lifted.plot(time, rise, color=style.COLOURS[number], label=label)
            if name == "main":
                for monitor in ("free field", "beside", "below", "above"):
                    table = run.monitor(monitor)
                    ratios.plot(table["time"], table["pore_pressure_ratio"], linewidth=0.6, label=monitor)
    lifted.set_ylabel("rise of the axis (m)")
    lifted.legend()
    ratios.set(xlabel="t (s)", ylabel="$r_u$", ylim=(-0.6, 1.2), xlim=(0.0, time[-1]))
    ratios.legend(ncols=4, loc="lower right")
    for ax in (lifted, ratios):
        ax.axvline(SHAKEN, color="0.6", linewidth=0.6, zorder=0)
    print(style.save(figure, folder, "uplift.png"))


if __name__ == "__main__":
    main()
