"""One case under several free-field models, as `tremolo swap` compares them: its table in words, and the picture."""

import json
from pathlib import Path

import numpy as np

from tremolo import style
from tremolo.run import Run


def moving_component(run, monitors):
    """The component of velocity that is larger: horizontal under SV waves, vertical under P waves."""
    series = [run.monitor(monitor) for monitor in monitors]
    return max(("vx", "vy"), key=lambda name: max(np.abs(one[name]).max() for one in series))


def read(folder):
    """What `tremolo swap` found, an entry a model."""
    return json.loads((Path(folder) / "swap.json").read_text())


def draw(folder):
    """The figure: velocity, and r_u below a water table, at every monitor, one line a model; differences and cost beside
    them."""
    folder = Path(folder)
    entries = [entry for entry in read(folder) if not entry["refused"]]
    if not entries:
        raise ValueError(f"{folder}: no model ran")
    runs = [Run(folder / entry["model"]) for entry in entries]
    monitors = list(entries[0]["monitors"])
    moving = moving_component(runs[0], monitors)
    wet = any("pore_pressure_ratio" in entry for entry in entries)
    widths = [2.6, 1.8, 1.0] if wet else [2.6, 1.0]
    figure, axes = style.plt.subplots(
        len(monitors), len(widths), figsize=(2.7 * sum(widths), 0.6 + 2.2 * len(monitors)), squeeze=False,
        layout="constrained", width_ratios=widths,
    )
    for row, monitor in zip(axes, monitors):
        for number, (entry, run) in enumerate(zip(entries, runs)):
            series = run.monitor(monitor)
            line = "-" if number == 0 else "--"
            row[0].plot(series["time"], series[moving], line, label=entry["model"], linewidth=0.9)
            if monitor in entry.get("pore_pressure_ratio", {}):
                row[1].plot(series["time"], series["pore_pressure_ratio"], line, linewidth=0.9)
        row[0].set(ylabel=f"$v_{moving[1]}$ (m/s)", title=monitor)
        for ax in row[:-1]:
            ax.set_xlim(series["time"][0], series["time"][-1])
        if wet:
            row[1].set(ylabel="$r_u$")
        differences = [100 * entry["monitors"][monitor] for entry in entries]
        names = [entry["model"] for entry in entries]
        bars = row[-1].barh(names, differences, color=style.COLOURS[: len(names)])
        row[-1].bar_label(bars, [f"{value:.3g} %" for value in differences], padding=2, fontsize=7)
        row[-1].invert_yaxis()
        row[-1].set_xlim(0, 1.35 * max([*differences, 1e-12]))
        row[-1].set_title(f"difference to {names[0]}, relative L2")
    axes[0][0].legend(loc="upper right", ncols=len(entries))
    for ax in axes[-1][:-1]:
        ax.set_xlabel("t (s)")
    axes[-1][-1].set_xlabel("%")
    cost = ", ".join(f"{entry['model']} {entry['source_cpu_s']:.2g} s" for entry in entries)
    figure.suptitle(f"CPU time of the free fields: {cost}", fontsize=9)
    return figure


def _ratios(ran):
    """The lines of r_u at the monitors that have pore pressure; none where there is no such monitor."""
    wet = {name: max(18, len(name) + 3) for name in ran[0].get("pore_pressure_ratio", {})}
    if not wet:
        return
    yield ""
    yield f"{'r_u':<10}" + "".join(f"{name:>{width}}" for name, width in wet.items())
    for entry in ran:
        ratios = entry.get("pore_pressure_ratio", {})
        cells = {name: f"{ratio['mean']:.3f} ({ratio['rms_difference']:.3f})" for name, ratio in ratios.items()}
        yield f"{entry['model']:<10}" + "".join(f"{cells.get(name, '-'):>{width}}" for name, width in wet.items())
    yield f"Mean of the run, in brackets the root mean square of the difference to '{ran[0]['model']}'."


def words(entries):
    """The lines of the table."""
    def percent(value):
        return "-" if value is None else f"{100 * value:.3f} %"

    ran = [entry for entry in entries if not entry["refused"]]
    if not ran:
        yield "no model can compute this case"
        return
    widths = {name: max(14, len(name) + 3) for name in ran[0]["monitors"]}
    yield (f"{'model':<10}{'source CPU':>12}{'domain CPU':>12}{'wall':>12}{'free field':>14}{'to exact':>14}"
           + "".join(f"{name:>{width}}" for name, width in widths.items()))
    for entry in entries:
        if entry["refused"]:
            yield f"{entry['model']:<10}  {'failed' if entry.get('failed') else 'refused'}: {entry['refused'].splitlines()[0]}"
            continue
        costs = "".join(f"{entry[name]:>10.2f} s" for name in ("source_cpu_s", "domain_cpu_s", "wall_s"))
        fields = "".join(f"{percent(entry.get(name)):>14}" for name in ("free_field", "free_field_to_exact"))
        monitors = "".join(f"{percent(entry['monitors'][name]):>{width}}" for name, width in widths.items())
        yield f"{entry['model']:<10}{costs}{fields}{monitors}"
    yield f"Differences: relative L2 of particle velocity, to '{ran[0]['model']}' where nothing else is said."
    yield from _ratios(ran)


def report(folder):
    """Says what swap.json holds, and draws swap.png beside it."""
    yield from words(read(folder))
    yield style.save(draw(folder), Path(folder), "swap.png")
