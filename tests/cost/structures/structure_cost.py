#!/usr/bin/python3
"""What accuracy costs around structures: normals, gaps, stiffness of elastic structures, cells across a footing.

    tests/cost/structures/structure_cost.py [BUILD [FOLDER [PNG]]]
                            default: build/release, runs/structure_cost, docs/pictures/cost_structures.png

Runs cost_contact_normals, cost_rocking and cost_punch of BUILD/bin/cost where their tables are not in FOLDER yet, prints
tables and draws the picture.
"""

import csv
import subprocess
import sys
from collections import defaultdict
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "python"))

import numpy as np
from tremolo import style

STUDIES = ("contact_normals", "rocking", "punch")
SUNK = (0.04, 0.08)  # m, between which the punch's pressure is read
SURFACE = {"1": "rough", "0": "smooth"}


def study(build, folder, name):
    """The rows of a study's table."""
    path = folder / f"{name}.csv"
    if not path.exists():
        told = subprocess.run([build / "bin" / "cost" / f"cost_{name}"], check=True, capture_output=True)
        path.write_bytes(told.stdout)
    with open(path) as file:
        return list(csv.DictReader(file))


def curve(rows, x, y, **where):
    chosen = [row for row in rows if all(row[key] == value for key, value in where.items())]
    return np.array([[float(row[x]), float(row[y])] for row in chosen]).T


def punches(rows):
    """{(rough, cells): (sunk, pressure over Prandtl's, CPU time)}"""
    found = defaultdict(list)
    for row in rows:
        found[row["rough"], int(row["cells"])].append([float(row[key]) for key in ("sunk", "pressure", "cpu")])
    return {key: np.array(values).T for key, values in found.items()}


def limit(punch):
    """Error of the pressure at its limit, the median, and CPU time to there."""
    sunk, pressure, cpu = punch
    there = (sunk > SUNK[0]) & (sunk < SUNK[1])
    return np.median(pressure[there]) - 1.0, cpu[there][-1]


def report(normals, rocking, punch):
    yield "| normals | incline of 5, 10, 20, 30, 45 degrees | lift at h = 1, 0.5, 0.25, 0.125 m | force along the surface |"
    yield "| --- | --- | --- | --- |"
    for kind in ("polygon", "gradient"):
        slides = dict(curve(normals, "angle", "error", scene="incline", normals=kind).T)
        lift = curve(normals, "cell_size", "error", scene="tunnel", normals=kind)[1]
        along = curve(normals, "cell_size", "tangential", scene="tunnel", normals=kind)[1]
        cells = [", ".join(f"{100 * value:.2g} %" for value in values)
                 for values in ([slides[angle] for angle in (5, 10, 20, 30, 45)], lift, along)]
        yield f"| `{kind}` | " + " | ".join(cells) + " |"
    yield "| varied | value | half cycle | restitution | lift | steps | CPU time |\n| --- | --- | --- | --- | --- | --- | --- |"
    for row in rocking:
        half = float(row["half_cycle"])  # 0: it does not rock
        rocks = f"{100 * (half - 1):+.2g} % | {float(row['restitution']):+.3f}" if half else "- | -"
        yield (f"| {row['varied']} | {float(row['value']):g} | {rocks} | {float(row['lift']):.3f} | {row['steps']} | "
               f"{row['cpu']} s |")
    yield "| cells across | rough | smooth | CPU time |\n| --- | --- | --- | --- |"
    for cells in sorted({cells for _, cells in punch}):
        errors = [limit(punch[rough, cells]) for rough in SURFACE]
        yield f"| {cells} | {100 * errors[0][0]:+.1f} % | {100 * errors[1][0]:+.1f} % | {errors[0][1]:.2g} s |"


def draw_normals(incline, tunnel, rows):
    for kind in ("polygon", "gradient"):
        angle, error = curve(rows, "angle", "error", scene="incline", normals=kind)
        incline.semilogy(angle, 100 * error, "o-", markersize=3, label=kind)
        size, error = curve(rows, "cell_size", "error", scene="tunnel", normals=kind)
        _, along = curve(rows, "cell_size", "tangential", scene="tunnel", normals=kind)
        [line] = tunnel.loglog(size, 100 * error, "o-", markersize=3, label=f"lift, {kind}")
        tunnel.loglog(size, 100 * along, "s:", markersize=3, color=line.get_color(), label=f"along the surface, {kind}")
    incline.set(xlabel="incline (degrees)", ylabel="error of the acceleration (% of $g \\sin α$)",
                title="dry block that slides")
    tunnel.set(xlabel="cells (m)", ylabel="% of the force", title="tunnel of 5 m in liquefied soil")
    tunnel.set_xticks([0.125, 0.25, 0.5, 1.0], ["0.125", "0.25", "0.5", "1"])
    tunnel.minorticks_off()


def draw_gaps(ax, rows):
    for kind in ("opening", "closing"):
        gap, restitution = curve(rows, "value", "restitution", varied=kind)  # -1: it does not rock
        ax.plot(np.maximum(gap, 1e-3), np.maximum(restitution, -0.13), "o-", markersize=3, label=f"restitution, {kind}")
    gap, lift = curve(rows, "value", "lift", varied="opening")
    ax.plot(gap, lift - 1.0, "s:", markersize=3, label="lift of the tunnel, opening")
    ax.axhspan(-0.05, 0.05, color="0.92", zorder=0)
    ax.set(xscale="log", xlabel="gap (cells; 0.001: none)", ylabel="error (at -0.13: it does not rock)",
           ylim=(-0.2, 0.06), title="gaps at which contact opens and closes")


def draw_stiffness(ax, rows):
    def errors(**where):
        half, restitution, cpu = (
            np.array([float(row[key]) for row in rows if all(row[k] == v for k, v in where.items())])
            for key in ("half_cycle", "restitution", "cpu"))
        return cpu, 100 * np.hypot(half - 1.0, restitution), half

    cpu, error, half = errors(varied="young")
    values = [float(row["value"]) for row in rows if row["varied"] == "young"]
    rocks = half > 0
    ax.loglog(cpu[rocks], error[rocks], "o", markersize=4)
    for x, y, young in zip(cpu[rocks], error[rocks], np.array(values)[rocks]):
        ax.annotate(f"{young / 1e9:g} GPa", (x, y), fontsize=7, xytext=(4, 2), textcoords="offset points")
    cpu, error, _ = errors(varied="rigid")
    ax.loglog(cpu, error, "ks", markersize=5)
    ax.annotate("rigid", (cpu[0], error[0]), fontsize=7, xytext=(4, 2), textcoords="offset points")
    ax.set(xlabel="CPU time (s)", ylabel="error of half cycle and restitution (%)", xlim=(1.0, 10.0),
           title="rocking block on ground of 2 GPa")
    ax.set_xticks([1, 2, 5, 10], ["1", "2", "5", "10"])
    ax.set_yticks([2, 5, 10], ["2", "5", "10"])
    ax.minorticks_off()


def draw_punch(curves, cost, punch):
    for (rough, cells), (sunk, pressure, _) in punch.items():
        if rough == "1":
            curves.plot(1e3 * sunk, pressure, linewidth=0.8, label=f"{cells} cells")
    curves.axhline(1.0, color="k", linestyle=":")
    curves.set(xlabel="sunk (mm)", ylabel="pressure over (2 + π) c", ylim=(0.8, 1.2), xlim=(10, 80), title="rough punch")
    for rough, name in SURFACE.items():
        found = [(cells, *limit(values)) for (kind, cells), values in punch.items() if kind == rough]
        cells, error, cpu = np.array(found).T
        cost.loglog(cpu, 100 * error, "o-", markersize=3, label=name)
        if rough == "1":
            for x, y, label in zip(cpu, 100 * error, cells):
                cost.annotate(f"{label:.0f}", (x, y), fontsize=7, xytext=(3, 3), textcoords="offset points")
    cost.set(xlabel="CPU time (s)", ylabel="error of the limit load (%)", title="cells across the punch")
    cost.set_yticks([5, 10, 15], ["5", "10", "15"])
    cost.minorticks_off()


def picture(normals, rocking, punch, path):
    figure, axes = style.plt.subplots(2, 3, figsize=(11.0, 6.6), layout="constrained")
    draw_normals(axes[0, 0], axes[0, 1], normals)
    draw_gaps(axes[0, 2], rocking)
    draw_stiffness(axes[1, 0], rocking)
    draw_punch(axes[1, 1], axes[1, 2], punch)
    for ax in axes.flat:
        ax.grid(alpha=0.3)
        if ax.get_legend_handles_labels()[1]:
            ax.legend(fontsize=7)
    return style.save(figure, path.parent, path.name)


def main():
    build = Path(sys.argv[1] if len(sys.argv) > 1 else "build/release")
    folder = Path(sys.argv[2] if len(sys.argv) > 2 else "runs/structure_cost")
    path = Path(sys.argv[3] if len(sys.argv) > 3 else ROOT / "docs/pictures/cost_structures.png")
    folder.mkdir(parents=True, exist_ok=True)
    normals, rocking, punch = (study(build, folder, name) for name in STUDIES)
    punch = punches(punch)
    for line in report(normals, rocking, punch):
        print(line)
    print(picture(normals, rocking, punch, path))


if __name__ == "__main__":
    main()
