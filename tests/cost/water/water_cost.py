#!/usr/bin/python3
"""What accuracy costs under a water table: cells, stiffness of the water, drainage, free field, scaled permeability.

    tests/cost/water/water_cost.py [BUILD [FOLDER [PNG]]]   default: build/release, runs/water_cost, docs/pictures/cost_water.png

Runs columns of cases/level_ground and BUILD/bin/cost/cost_scaled_permeability where their results are not in FOLDER yet,
prints tables and draws the picture.
"""

import csv
import re
import subprocess
import sys
from collections import defaultdict
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "python"))

import numpy as np
from tremolo import pore_pressure, style

CASE = ROOT / "cases" / "level_ground"
DEPTHS = [3.0, 5.0, 7.0]  # m
BULK = "[water]\nbulk_modulus = "
RUNS = {  # name: (model, what is replaced in the case, by what)
    "mpm, h = 2 m": ("mpm", "size = 0.5", "size = 2.0"),
    "mpm, h = 1 m": ("mpm", "size = 0.5", "size = 1.0"),
    "mpm, h = 0.5 m": ("mpm", "", ""),
    "mpm, h = 0.25 m": ("mpm", "size = 0.5", "size = 0.25"),
    "fe": ("fe", "", ""),
    "mpm, undrained": ("mpm", "permeability = 1e-4", 'permeability = 1e-4\ndrainage = "undrained"'),
    "fe, undrained": ("fe", "permeability = 1e-4", 'permeability = 1e-4\ndrainage = "undrained"'),
    "mpm, K_f = 1 GPa": ("mpm", "[water]\n", BULK + "1e9\n"),
    "mpm, K_f = 0.5 GPa": ("mpm", "[water]\n", BULK + "5e8\n"),
    "mpm, K_f = 0.2 GPa": ("mpm", "[water]\n", BULK + "2e8\n"),
    "mpm, K_f = 0.1 GPa": ("mpm", "[water]\n", BULK + "1e8\n"),
}
CELLS = ["mpm, h = 2 m", "mpm, h = 1 m", "mpm, h = 0.5 m", "fe"]
WATERS = ["mpm, K_f = 1 GPa", "mpm, K_f = 0.5 GPa", "mpm, K_f = 0.2 GPa", "mpm, K_f = 0.1 GPa"]


class Column:
    """A run of `tremolo column`: times, r_u [depth, time], settlement, CPU time and steps."""

    def __init__(self, path, told):
        levels, histories, _, settlement, _ = pore_pressure.read(path)
        rows = [histories[int(np.argmin(np.abs(levels + depth)))] for depth in DEPTHS]
        self.time = rows[0]["time"]
        self.ratio = np.array([row["pore_pressure_ratio"] for row in rows])
        self.settlement = 1e3 * settlement["settlement"][-1]
        self.cpu = float(re.search(r"([\d.]+) s CPU", told)[1])
        steps = re.search(r"(\d+) steps of ([-\d.e]+) s", told)
        self.step = float(steps[2]) if steps else None

    def at(self, times):
        return np.array([np.interp(times, self.time, row) for row in self.ratio])

    def time_of(self, level):
        """First time at each depth at which the 1-s mean of r_u reaches a level, s."""
        width = int(round(1.0 / (self.time[1] - self.time[0])))
        mean = np.array([np.convolve(row, np.full(width, 1.0 / width), mode="same") for row in self.ratio])
        return np.array([self.time[np.argmax(row >= level)] if (row >= level).any() else np.inf for row in mean])

    def differences(self, other):
        """Largest |difference of r_u| to 3 s, of the times to r_u = 0.7, and of mean r_u from 5 to 15 s."""
        early, late = np.arange(0.0, 3.0, 0.01), np.arange(5.0, 15.0, 0.01)
        return (
            np.abs(self.at(early) - other.at(early)).max(),
            np.abs(self.time_of(0.7) - other.time_of(0.7)).max(),
            np.abs(self.at(late).mean(axis=1) - other.at(late).mean(axis=1)).max(),
        )


def column(tremolo, folder, name):
    model, old, new = RUNS[name]
    place = folder / re.sub(r"\W+", "_", name)
    if not (place / "told.txt").exists():
        place.mkdir(parents=True, exist_ok=True)
        text = (CASE / "case.toml").read_text()
        if old not in text:
            sys.exit(f"cases/level_ground/case.toml no longer has {old!r}")
        (place / "case.toml").write_text(text.replace(old, new, 1) if old else text)
        (place / "motion.csv").write_bytes((CASE / "motion.csv").read_bytes())
        depths = ",".join(str(depth) for depth in DEPTHS)
        told = subprocess.run(
            [tremolo, "column", place / "case.toml", "--model", model, "--depths", depths, "--duration", "25",
             "--every", "0.01", "--out", place / "out.h5"],
            check=True, capture_output=True, text=True,
        )
        (place / "told.txt").write_text(told.stdout)
    return Column(place / "out.h5", (place / "told.txt").read_text())


def scaled(build, folder):
    """Rows of cost_scaled_permeability by factor."""
    path = folder / "scaled.csv"
    if not path.exists():
        told = subprocess.run([build / "bin" / "cost" / "cost_scaled_permeability"], check=True, capture_output=True)
        path.write_bytes(told.stdout)
    rows = defaultdict(list)
    with open(path) as file:
        for row in csv.DictReader(file):
            rows[float(row["factor"])].append({key: float(value) for key, value in row.items()})
    return rows


def report(columns, rows):
    def table(names, reference):
        yield f"| column, against {reference} | r_u to 3 s | time to r_u = 0.7 | mean r_u, 5 to 15 s | settlement at 25 s | step | CPU time |"
        yield "| --- | --- | --- | --- | --- | --- | --- |"
        for name in names:
            one = columns[name]
            early, time, late = one.differences(columns[reference])
            step = f"{1e3 * one.step:.3g} ms" if one.step else "-"
            yield f"| {name} | {early:.4f} | {time:.2f} s | {late:.3f} | {one.settlement:.2f} mm | {step} | {one.cpu:.3g} s |"

    yield from table([*CELLS, "mpm, h = 0.25 m"], "mpm, h = 0.25 m")
    yield from table([*WATERS, "mpm, undrained", "fe", "mpm, h = 0.5 m"], "mpm, h = 0.5 m")
    yield from table(["fe, undrained"], "fe")
    yield "| factor on k | settlement | excess pressure | CPU time |\n| --- | --- | --- | --- |"
    base = rows[1.0]
    for factor, of_factor in rows.items():
        settled = max(abs(a["settlement"] - b["settlement"]) for a, b in zip(of_factor, base)) / base[-1]["settlement"]
        pressed = max(abs(a["pressure"] - b["pressure"]) for a, b in zip(of_factor, base))
        yield f"| {factor:g} | {100 * settled:.2g} % | {pressed:.2g} | {of_factor[0]['cpu']:.3g} s |"


def short(name):
    return name.removeprefix("mpm, ").replace("K_f", "$K_f$")


def picture(columns, rows, path):
    figure, axes = style.plt.subplots(2, 2, figsize=(9.0, 7.0), layout="constrained")
    for name in ["mpm, h = 2 m", "mpm, h = 1 m", "mpm, h = 0.5 m", "mpm, h = 0.25 m", "fe", "mpm, undrained"]:
        axes[0, 0].plot(columns[name].time, columns[name].ratio[1], linewidth=0.7, label=name)
    axes[0, 0].set(xlabel="t (s)", ylabel="$r_u$, 5 m deep", xlim=(0.0, 8.0))
    axes[0, 0].legend(fontsize=7)
    for name in ["mpm, h = 0.5 m", *WATERS]:
        label = "$K_f$ = 2.2 GPa" if name not in WATERS else short(name)
        axes[0, 1].plot(columns[name].time, columns[name].ratio[1], linewidth=0.7, label=label)
    axes[0, 1].set(xlabel="t (s)", ylabel="$r_u$, 5 m deep", xlim=(0.0, 8.0))
    axes[0, 1].legend(fontsize=7)
    for name in [*CELLS, *WATERS, "mpm, undrained"]:
        reference = columns["mpm, h = 0.25 m" if name in CELLS else "mpm, h = 0.5 m"]
        error = columns[name].differences(reference)[0]
        axes[1, 0].plot(columns[name].cpu, error, "o", markersize=4)
        axes[1, 0].annotate(short(name), (columns[name].cpu, error), fontsize=7, xytext=(3, 3),
                            textcoords="offset points")
    axes[1, 0].set(xscale="log", yscale="log", xlim=(2.0, 40.0), xlabel="CPU time (s)",
                   ylabel="largest difference of $r_u$ to 3 s")
    axes[1, 0].set_xticks([2, 5, 10, 20, 40], ["2", "5", "10", "20", "40"])
    axes[1, 0].minorticks_off()
    for factor, of_factor in rows.items():
        axes[1, 1].plot([row["time"] for row in of_factor], [1e3 * row["settlement"] for row in of_factor],
                        "k" if factor == 1.0 else "--", label=f"k times {factor:g}, {of_factor[0]['cpu']:.2g} s CPU")
    axes[1, 1].set(xlabel="t times the factor (s)", ylabel="settlement of 5 m (mm)")
    axes[1, 1].legend(fontsize=7)
    for ax in axes.flat:
        ax.grid(alpha=0.3)
    return style.save(figure, path.parent, path.name)


def main():
    build = Path(sys.argv[1] if len(sys.argv) > 1 else "build/release")
    folder = Path(sys.argv[2] if len(sys.argv) > 2 else "runs/water_cost")
    path = Path(sys.argv[3] if len(sys.argv) > 3 else ROOT / "docs/pictures/cost_water.png")
    folder.mkdir(parents=True, exist_ok=True)
    columns = {name: column(build / "bin" / "tremolo", folder, name) for name in RUNS}
    rows = scaled(build, folder)
    for line in report(columns, rows):
        print(line)
    print(picture(columns, rows, path))


if __name__ == "__main__":
    main()
