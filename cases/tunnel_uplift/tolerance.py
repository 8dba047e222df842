#!/usr/bin/env python3
"""What accuracy of the sand's law costs: rise of the tunnel in 8 s (the coarse case) and settlement of level ground at 25 s (the
column of cases/level_ground) against CPU time, over the tolerance of PM4Sand's integration: the table of README.md and tolerance.png.

    cases/tunnel_uplift/tolerance.py [TREMOLO [FOLDER]]      default: build/release/bin/tremolo, runs/tunnel_uplift

Runs what is not in FOLDER yet.
"""

import sys
from pathlib import Path

import numpy as np
from study import CASE, COARSE, COMPARED, run_variant, style, synthesise, uplift
from tremolo import pore_pressure
from tremolo.variants import cpu_time, run_column

TOLERANCES = ("1e-2", "3e-3", "1e-3", "3e-4", "1e-4", "1e-5")
LEVEL = CASE.parents[1] / "level_ground" / "case.toml"
END = 25.0  # s


def rise(tremolo, folder, tolerance):
    """Rise at 8 s (m) and CPU time (s)."""
    given = {'library = "hostun_dr45"\n': f'library = "hostun_dr45"\ntolerance = {tolerance}\n'}
    with run_variant(tremolo, CASE, COARSE | given, folder, f"tolerance_{tolerance}") as run:
        time, risen = uplift(run)
        return float(np.interp(COMPARED, time, risen)), cpu_time(run)


def settlement(tremolo, folder, tolerance):
    """Settlement at 25 s (mm) and CPU time (s)."""
    (folder / "level_motion.csv").write_bytes(LEVEL.with_name("motion.csv").read_bytes())
    given = {'file = "motion.csv"': 'file = "level_motion.csv"',
             'library = "pm4sand_dr55"\n': f'library = "pm4sand_dr55"\ntolerance = {tolerance}\n'}
    out, cpu = run_column(tremolo, LEVEL, given, folder, f"level_{tolerance}", "fe", "--depths", "0", "--duration", f"{END:g}")
    return 1e3 * float(pore_pressure.read(out)[3]["settlement"][-1]), cpu


def picture(rows, folder):
    risen, cpu = np.array([row[:2] for row in rows]).T
    figure, ax = style.plt.subplots(figsize=(6.0, 3.2), layout="constrained")
    ax.plot(cpu, risen, "o", color=style.COLOURS[0])
    for tolerance, x, y, below in zip(TOLERANCES, cpu, risen, (False, True, False, False, False, False)):
        ax.annotate(tolerance, (x, y), xytext=(0, -14 if below else 6), textcoords="offset points", fontsize=8, ha="center")
    ax.set(xlabel="CPU time (s)", ylabel="rise of the tunnel in 8 s (m)", xlim=(0.0, None), ylim=(0.9 * risen.mean(), 1.1 * risen.mean()))
    return style.save(figure, folder, "tolerance.png")


def main():
    tremolo = sys.argv[1] if len(sys.argv) > 1 else "build/release/bin/tremolo"
    folder = Path(sys.argv[2] if len(sys.argv) > 2 else "runs/tunnel_uplift")
    folder.mkdir(parents=True, exist_ok=True)
    synthesise(tremolo, folder)
    print("| tolerance | rise of the tunnel in 8 s, m | CPU time, s | settlement of level ground at 25 s, mm | CPU time, s |\n" + "| --- " * 5 + "|")
    rows = []
    for tolerance in TOLERANCES:
        rows.append((*rise(tremolo, folder, tolerance), *settlement(tremolo, folder, tolerance)))
        print(f"| {tolerance} | {rows[-1][0]:.3f} | {rows[-1][1]:.0f} | {rows[-1][2]:.2f} | {rows[-1][3]:.1f} |", flush=True)
    print(picture(rows, folder))


if __name__ == "__main__":
    main()
