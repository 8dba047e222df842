"""What `tremolo cost` has measured: its table in words and as cost.csv, and the work-precision diagram, error against CPU time and
against cell size."""

import csv
import json
import re
from pathlib import Path

import numpy as np

from tremolo import style

MARKERS = "os^Dv<>Ph*X"


def families(rungs):
    """Rungs by all but their cell size, each from coarse to fine."""
    grouped = {}
    for rung in rungs:
        grouped.setdefault(rung["family"], []).append(rung)
    return {family: sorted(members, key=lambda rung: -rung["size"]) for family, members in grouped.items()}


def short(family):
    """The setting without the tables that its keys stand in."""
    return re.sub(r"\b\w+\.(?=\w+ = )", "", family) or "all"


def draw_front(ax, rungs):
    """A step line: below and left of it no rung was measured."""
    front = sorted((rung for rung in rungs if rung["front"]), key=lambda rung: rung["cpu_s"])
    ax.step(
        [rung["cpu_s"] for rung in front], [100 * rung["error"] for rung in front], where="post", color="0.75", linewidth=4,
        zorder=0, label="Pareto front",
    )


def draw_slope(ax, sizes, errors, order):
    """A line of the order `order` below the points."""
    ends = np.array([min(sizes), max(sizes)])
    ax.plot(ends, 0.6 * min(errors) * (ends / ends[0]) ** order, ":", color="0.4", label=f"order {order}")


def read(folder):
    """What `tremolo cost` measured: cost.json."""
    return json.loads((Path(folder) / "cost.json").read_text())


def draw(folder):
    """The figure: error against CPU time, and against cell size."""
    study = read(folder)
    rungs = [rung for rung in study["rungs"] if "error" in rung]
    if not rungs:
        raise ValueError(f"{folder}: no rung has an error")
    figure, (time_axes, size_axes, names) = style.plt.subplots(
        1, 3, figsize=(11.0, 4.2), width_ratios=[1.0, 1.0, 0.55], layout="constrained"
    )
    draw_front(time_axes, rungs)
    for number, (family, members) in enumerate(families(rungs).items()):
        look = {"color": style.COLOURS[number % len(style.COLOURS)], "marker": MARKERS[number % len(MARKERS)], "markersize": 4}
        errors = [100 * rung["error"] for rung in members]
        time_axes.loglog([rung["cpu_s"] for rung in members], errors, label=short(family), **look)
        size_axes.loglog([rung["size"] for rung in members], errors, **look)
    sizes = sorted({rung["size"] for rung in rungs})
    if len(sizes) > 1:
        draw_slope(size_axes, sizes, [100 * rung["error"] for rung in rungs], 2)
        size_axes.legend(loc="lower right")
    if "target" in study:
        time_axes.axhline(100 * study["target"], color="0.4", linestyle="--", linewidth=0.8)
    if "prediction" in study:
        predicted = study["prediction"]
        time_axes.plot(predicted["cpu_s"], 100 * predicted["error"], "k*", markersize=11, markerfacecolor="none", label="predicted")
    time_axes.set(xlabel="CPU time (s)", ylabel="error, relative L2 (%)")
    size_axes.set(xlabel="cell size h (m)", xticks=sizes, xticklabels=[f"{size:.3g}" for size in sizes])
    size_axes.minorticks_off()
    names.axis("off")
    names.legend(*time_axes.get_legend_handles_labels(), loc="center left", fontsize=7)
    figure.suptitle(f"{study['title']}\n{study['error_of']}", fontsize=8)
    return figure


def _line(rung):
    """What a rung has cost, beside its knobs."""
    if "refused" in rung:
        return f"  refused: {rung['refused']}"
    error = f"{100 * rung['error']:.3g} %" if "error" in rung else "reference"
    lag = f"{1000 * rung['phase_lag_s']:.3f} ms" if rung["phase_lag_s"] else "-"
    return f"{error:>11}{lag:>11}{rung['cpu_s']:>10.2f} s{rung['updates']:>12.3g}{'  *' if rung['front'] else ''}"


def _fit(fit, rungs):
    def within(spread):
        return f"within {100 * (spread - 1):.2g} %" if fit["points"] > 2 else "two points, unchecked"

    size = min(rung["size"] for rung in rungs if rung.get("family") == fit["family"] and "error" in rung)
    error = 100 * fit["constant"] * size ** fit["order"]
    return (f"  {fit['family'] or 'all'}: error {error:.3g} % (h/{size:g} m)^{fit['order']:.2f} ({within(fit['error_spread'])}), "
            f"CPU time {fit['start_s']:.2g} s + {1e9 * fit['per_update_s']:.3g} ns an update ({within(fit['time_spread'])})")


def _answer(study):
    """What reaches the target."""
    target = f"{100 * study['target']:.3g} %"

    def costs(found):
        setting = f"{found['family']}{', ' if found['family'] else ''}mesh.size = {found['size']:g}"
        return f"{target} with {setting}: error {100 * found['error']:.3g} %, {found['cpu_s']:.3g} s of CPU time"

    good = [rung for rung in study["rungs"] if rung.get("front") and rung["error"] <= study["target"]]
    yield "measured: " + (costs(min(good, key=lambda rung: rung["cpu_s"])) if good else f"no rung reaches {target}")
    predicted = study.get("prediction")
    yield "predicted: " + (f"{costs(predicted)}; not run, by the fit" if predicted else "nothing, no fit of these rungs reaches so far")


def words(study):
    """The lines of the table, of the fits and of what reaches the target."""
    rungs = study["rungs"]
    widths = {key: 2 + max(len(key), *(len(rung["knobs"][key]) for rung in rungs)) for key in rungs[0]["knobs"]}
    yield study["title"]
    yield "".join(f"{key:<{width}}" for key, width in widths.items()) + f"{'error':>11}{'lag':>11}{'CPU time':>12}{'updates':>12}"
    for rung in rungs:
        yield "".join(f"{rung['knobs'][key]:<{width}}" for key, width in widths.items()) + _line(rung)
    yield f"error: {study['error_of']}; CPU time: user and system, of all processes; *: on the Pareto front"
    if study["fits"]:
        yield "fits along mesh.size:"
    yield from (_fit(fit, rungs) for fit in study["fits"])
    if "target" in study:
        yield from _answer(study)


def write_table(study, path):
    """cost.csv: a line a rung that was run; the error of the reference is 0."""
    with open(path, "w", newline="", encoding="utf-8") as file:
        table = csv.writer(file, lineterminator="\n")
        table.writerow([*study["rungs"][0]["knobs"], "relative_error", "phase_lag_s", "cpu_s", "particle_updates", "front"])
        table.writerows([*rung["knobs"].values(), rung.get("error", 0), *(rung[key] for key in ("phase_lag_s", "cpu_s", "updates")),
                         int(rung["front"])] for rung in study["rungs"] if "refused" not in rung)


def report(folder):
    """Says what cost.json holds, and writes cost.csv and cost.png beside it."""
    study = read(folder)
    yield from words(study)
    write_table(study, Path(folder) / "cost.csv")
    yield style.save(draw(folder), Path(folder), "cost.png")
