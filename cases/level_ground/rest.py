#!/usr/bin/python3
"""The ten minutes in which the water leaves: the case in cells of 1 m, as a column of finite elements half as high,
as the domain's own column, and as the domain, whose rest passes 25 times as fast as it is simulated.

    cases/level_ground/rest.py [TREMOLO [FOLDER]]      default: build/release/bin/tremolo, runs/level_ground

Runs what is not in FOLDER yet; prints a table and draws rest.png.
"""

import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1] / "python"))

import numpy as np
from study import GRADIENT, PERMEABILITY, Level
from tremolo import pore_pressure, style
from tremolo.variants import cpu_time, run_column, run_variant

DURATION = 625.0  # s
DEPTHS = [2.5, 5.5, 8.5]  # m, centres of cells of 1 m
TIMES = [15.0, 25.0, 50.0, 100.0, 200.0, 300.0, 625.0]  # s
MODELS = {"fe": "column fe, elements of 0.5 m", "mpm": "column mpm, cells of 1 m"}
COARSE = {"size = 0.5\n": "size = 1.0\n"}
LONG = {"duration_s = 11.0\n": f"duration_s = {DURATION - 14.0}\n"}
FAST = {"duration_s = 11.0\n": f"duration_s = {DURATION - 14.0}\ntime_factor = 25.0\nevery_s = 0.5\n"}


def column(tremolo, folder, model):
    """Time (s), r_u [depth, time] and settlement (m) of a column, and its CPU time (s)."""
    depths = ",".join(str(depth) for depth in DEPTHS)
    out, cpu = run_column(tremolo, HERE / "case.toml", COARSE | LONG, folder, f"rest_{model}", model, "--depths", depths,
                          "--duration", f"{DURATION:g}", "--every", "0.1")
    levels, histories, _, settlement, _ = pore_pressure.read(out)
    ratios = [histories[int(np.argmin(np.abs(levels + depth)))]["pore_pressure_ratio"] for depth in DEPTHS]
    return settlement["time"], np.array(ratios), settlement["settlement"], cpu


def domain(tremolo, folder):
    """The same of the domain, in the mean over x."""
    with run_variant(tremolo, HERE / "case.toml", COARSE | FAST, folder, "rest_domain") as run:
        level = Level(run)
        time = np.arange(0.0, run.times[-1], 0.1)
        even = lambda values: np.interp(time, run.times, values.mean(axis=1))
        return time, np.array([even(level.ratio(depth)) for depth in DEPTHS]), even(level.settlement()), cpu_time(run)


def picture(results, path):
    """r_u at depths and settlement, over the logarithm of time."""
    figure, axes = style.plt.subplots(2, 1, figsize=(7.6, 5.2), sharex=True, layout="constrained")
    for number, (name, (time, ratios, settlement, _)) in enumerate(results.items()):
        look = dict(color=style.COLOURS[number], linewidth=0.9)
        width = max(1, round(1.0 / (time[1] - time[0])))  # means of a second
        for ratio in ratios:
            mean = np.convolve(ratio, np.full(width, 1.0 / width), mode="same")
            axes[0].plot(time[width:-width], mean[width:-width], **look)
        axes[1].plot(time, 1e3 * settlement, label=name, **look)
    time = np.geomspace(15.0, 60.0)
    axes[1].plot(time, 0.9 + 1e3 * PERMEABILITY * GRADIENT * (time - time[0]), "k:", label="slope $k\\gamma'/\\gamma_w$")
    axes[0].set(ylabel="$r_u$", title=", ".join(f"{depth:g}" for depth in DEPTHS) + " m deep (the deeper the later), means of a second")
    axes[1].set(xlabel="t (s)", ylabel="settlement (mm)", xscale="log", xlim=(3.0, DURATION), ylim=(0.0, None))
    axes[1].legend(loc="upper left")
    return style.save(figure, path.parent, path.name)


def main():
    tremolo = sys.argv[1] if len(sys.argv) > 1 else "build/release/bin/tremolo"
    folder = Path(sys.argv[2] if len(sys.argv) > 2 else "runs/level_ground")
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "motion.csv").write_bytes((HERE / "motion.csv").read_bytes())
    results = {name: column(tremolo, folder, model) for model, name in MODELS.items()}
    results["domain, cells of 1 m"] = domain(tremolo, folder)
    print("| | " + " | ".join(f"{time:g} s" for time in TIMES) + " | CPU time |")
    for name, (time, ratios, settlement, cpu) in results.items():
        row = " | ".join(f"{1e3 * np.interp(at, time, settlement):.2f}" for at in TIMES)
        print(f"| settlement, mm: {name} | {row} | {cpu / 60.0:.1f} min |")
        row = " | ".join(f"{np.interp(at, time, ratios[1]):.3f}" for at in TIMES)
        print(f"| r_u, {DEPTHS[1]:g} m deep: {name} | {row} | |")
    print(picture(results, folder / "rest.png"))


if __name__ == "__main__":
    main()
