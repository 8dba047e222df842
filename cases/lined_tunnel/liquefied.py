#!/usr/bin/env python3
"""What the lining bears before, while and after the sand around it liquefies, and how far it floats up: a Markdown table, liquefied.png
and liquefied_ring.png.

    cases/lined_tunnel/liquefied.py [TREMOLO [FOLDER]]      default: build/release/bin/tremolo, runs/lined_tunnel

Runs what is not in FOLDER yet.

Two closed forms bound what it bears. In sand at rest, stressed before the ring stood in it, N = (p' + p_0) R_o/(1 + 2 G R/EA) with the
mean effective stress p' and the water's pressure p_0 at the axis (Einstein and Schwartz 1979), and M goes as 2 theta with the amplitude
of study.exact(). Sand without any effective stress is a heavy fluid: N = p R_o with its total pressure p, and no moment.
"""

import sys
from pathlib import Path

import numpy as np
from study import CASE, OUTER, exact, style
from tremolo.pictures import linings
from tremolo.variants import cpu_time, run_variant

LIQUEFIED = CASE.with_name("liquefied.toml")
PERIOD = 1.0  # s, of the motion
GRAVITY = 9.81  # m/s2
DRY, WET, WATER = 1421.6, 1885.1, 1000.0  # kg/m3, of the loose sand and the water
TABLE, AXIS = 2.0, 15.0  # m, depths
REST = 0.5  # K0
MODULUS = 574.0 * 101.3e3  # Pa, G of the loose sand in the gravity stage, G_o p_A
REFINED = {"[time]\n": "[[refine]]\nbox = [-6.0, -21.0, 6.0, -9.0]\nlevel = 1\n\n[time]\n"}
# Folder: what begins its labels, changes.
VARIANTS = {
    "liquefied": ("", {}),
    "liquefied_undrained": ("undrained: ", {"rest_coefficient = 0.5\n": 'rest_coefficient = 0.5\ndrainage = "undrained"\n'}),
    "liquefied_fine": ("cells of 0.5 m around it: ", REFINED),
}


def closed_forms(lining):
    """N (N/m) and amplitude of M (N) in sand at rest; N in a heavy fluid."""
    water = WATER * GRAVITY * (AXIS - TABLE)
    total = GRAVITY * (DRY * TABLE + WET * (AXIS - TABLE))
    vertical = total - water
    radius = OUTER - 0.5 * lining.thickness
    section = lining.axial_stiffness, lining.bending_stiffness
    at_rest = (0.5 * (1.0 + REST) * vertical + water) * OUTER / (1.0 + 2.0 * MODULUS * radius / lining.axial_stiffness)
    strain = 0.5 * (1.0 - REST) * vertical / MODULUS
    return at_rest, strain * exact(section, radius, lining.thickness, True, MODULUS, stressed_before=True)[1], total * OUTER


def thrust(lining):
    """Mean compression around it over time, N/m."""
    return -lining.axial_force.mean(axis=1)


def rise(lining):
    """Rise of its axis over time, m."""
    height = lining.places[:, :, 1].mean(axis=1)
    return height - height[0]


def spans(lining):
    """Label, first and last row of what the table tells: at rest, one cycle around the largest moment, the last one before the shaking
    ends, and the end."""
    row = lambda time: int(np.argmin(np.abs(lining.time - time)))
    peak = int(np.argmax(np.abs(lining.moment).max(axis=1)))
    return [("at rest", 0, 0), (f"while it liquefies, {lining.time[peak]:.1f} s", peak, peak), ("liquefied, 4 to 5 s", row(4.0), row(4.0 + PERIOD)),
            ("liquefied, 7 to 8 s", row(7.0), row(7.0 + PERIOD)), ("at the end, 12 s", len(lining) - 1, len(lining) - 1)]


def rows(run, label):
    """Rows of the table: means over the rows of a span, and the largest and the least moment around the ring and in it."""
    lining, free, beside = run.lining("ring"), run.monitor("free field"), run.monitor("beside")
    for when, first, last in spans(lining):
        here = slice(first, last + 1)
        time = lining.time[here]
        ratios = [f"{np.interp(time, table['time'], table['pore_pressure_ratio']).mean():.2f}" for table in (free, beside)]
        moment = lining.moment[here] / 1e3
        pressures = " / ".join(f"{values[here].mean() / 1e3:.0f}" for values in (lining.pressure, lining.water_pressure))
        print(f"| {label}{when} | {' | '.join(ratios)} | {pressures} | {thrust(lining)[here].mean() / 1e3:.0f} "
              f"| {moment.max():.0f} / {moment.min():.0f} | {1e3 * rise(lining)[here].mean():.0f} |", flush=True)


def picture(run, folder):
    """r_u, N and M over time, with the closed forms, and the rise."""
    lining = run.lining("ring")
    at_rest, moment_at_rest, fluid = closed_forms(lining)
    figure, axes = style.plt.subplots(4, 1, figsize=(7.6, 7.6), sharex=True, layout="constrained")
    for colour, name in zip(style.COLOURS, ("free field", "beside", "above", "below")):
        table = run.monitor(name)
        axes[0].plot(table["time"], table["pore_pressure_ratio"], color=colour, linewidth=0.8, label=name)
    axes[0].legend(ncols=4, loc="lower right")
    axes[1].plot(lining.time, thrust(lining) / 1e3, color=style.COLOURS[0])
    for value, text in ((at_rest, "sand at rest"), (fluid, "heavy fluid")):
        axes[1].axhline(value / 1e3, color="#222222", linewidth=0.8, linestyle="--")
        axes[1].annotate(text, (lining.time[-1], value / 1e3), xytext=(0, 3), textcoords="offset points", ha="right", fontsize=8)
    for values, text, colour in ((lining.moment.max(axis=1), "largest", 0), (lining.moment.min(axis=1), "least", 1)):
        axes[2].plot(lining.time, values / 1e3, color=style.COLOURS[colour], label=text)
    for sign in (-1.0, 1.0):
        axes[2].axhline(sign * moment_at_rest / 1e3, color="#222222", linewidth=0.8, linestyle="--")
    axes[2].legend(ncols=2, loc="upper right")
    axes[3].plot(lining.time, 1e3 * rise(lining), color=style.COLOURS[0])
    for ax, text in zip(axes, ("$r_u$", "mean compression N (kN/m)", "M (kNm/m)", "rise of the axis (mm)")):
        ax.set_ylabel(text)
    figure.align_ylabels(axes)
    axes[3].set(xlabel="t (s)", xlim=(0.0, lining.time[-1]))
    return style.save(figure, folder, "liquefied.png")


def main():
    tremolo = sys.argv[1] if len(sys.argv) > 1 else "build/release/bin/tremolo"
    folder = Path(sys.argv[2] if len(sys.argv) > 2 else "runs/lined_tunnel")
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "motion.csv").write_bytes(CASE.with_name("motion.csv").read_bytes())
    print("| | r_u free field | beside | mean pressure / of water, kPa | N, kN/m | M largest / least, kNm/m | rise, mm |\n" + "| --- " * 7 + "|")
    for name, (label, changes) in VARIANTS.items():
        with run_variant(tremolo, LIQUEFIED, changes, folder, name) as run:
            lining = run.lining("ring")
            if not changes:
                at_rest, moment, fluid = (value / 1e3 for value in closed_forms(lining))
                print(f"| closed form: sand at rest | 0 | 0 | | {at_rest:.0f} | {moment:.0f} / {-moment:.0f} | |")
                print(f"| closed form: heavy fluid | 1 | 1 | | {fluid:.0f} | 0 | |")
                times = [float(lining.time[first]) for _, first, _ in spans(lining)]
                drawn = [picture(run, folder), style.save(linings.diagrams(lining, "ring", [*times[:2], times[-1]]), folder, "liquefied_ring.png")]
            rows(run, label)
            print(f"{name}: {cpu_time(run) / 60.0:.1f} min of CPU time", file=sys.stderr)
    print(*drawn, sep="\n")


if __name__ == "__main__":
    main()
