"""Contour pictures of particle fields: acceleration, plastic strain, r_u, and two runs side by side."""

import numpy as np
from matplotlib.cm import ScalarMappable
from matplotlib.colors import Normalize

from tremolo import bodies, style


def telling_times(run, count=4):
    """Times (s) that show a run: where 10 to 90 % of the domain's squared acceleration have passed; evenly spread without accelerations."""
    if not run.has_field("acceleration"):
        return sorted({float(run.times[round(i)]) for i in np.linspace(0, len(run.times) - 1, count)})
    power = np.array([np.mean(run.field(i, "acceleration") ** 2) for i in range(len(run.times))])
    passed = np.cumsum(power)
    if passed[-1] == 0.0:
        return [float(run.times[-1])]
    levels = np.linspace(0.1, 0.9, count) * passed[-1]
    frames = sorted({int(np.searchsorted(passed, level)) for level in levels})
    return [float(run.times[i]) for i in frames]


def symmetric_limit(values):
    """A round limit of a diverging scale that cuts off no more than the highest 0.3 %."""
    limit = float(np.percentile(np.abs(np.concatenate([np.ravel(v) for v in values])), 99.7))
    if limit == 0.0:
        return 1.0
    step = 10.0 ** np.floor(np.log10(limit)) / 2.0
    return float(np.ceil(limit / step) * step)


def _angle(run):
    angle = run.attribute("angle_deg")
    return "" if angle is None else f"$\\beta$ = {angle:g}°"


def _panels(runs, frames, name, component, colouring, label, colour_extend):
    """One row a time, one column a run; times of one run of a high model side by side. frames[run][row] are frame
    indices."""
    bounds = style.extent(runs[0], [0, *frames[0]])
    side_by_side = len(runs) == 1 and style.aspect_of(bounds) > 0.6
    rows, columns = (1, len(frames[0])) if side_by_side else (len(frames[0]), len(runs))
    figure, axes = style.map_axes(bounds, rows, columns, highest=2.4)
    if side_by_side:
        axes = axes.T
        axes[0, 0].locator_params(axis="x", nbins=4)  # shared by all
    figure.colorbar(
        ScalarMappable(Normalize(colouring["vmin"], colouring["vmax"]), colouring["cmap"]), ax=axes, label=label,
        extend=colour_extend, extendfrac=0.03, shrink=1.2 / (rows + 0.5), aspect=18, pad=0.015,
    )
    for column, run in enumerate(runs):
        for ax, index in zip(axes[:, column], frames[column]):
            title = f"t = {run.times[index]:.2f} s"
            ax.set_title(f"{_angle(run)},  {title}" if len(runs) > 1 else title, loc="left")
    style.fix_layout(figure)
    for column, run in enumerate(runs):
        for ax, index in zip(axes[:, column], frames[column]):
            values = run.field(index, name)
            values = values[:, component] if values.ndim > 1 else values
            style.fill_particles(ax, run.field(index, "position"), values, style.sizes(run, index), **colouring)
            bodies.draw(ax, run, index)
    return figure


def final_map(run, values, folder, name, label, diverging=False):
    """A field of the last frame on the deformed shape, with the structures: a value a particle, from 0 up or symmetric about it.

    The scale cuts off the highest 0.5 %.
    """
    last = len(run.times) - 1
    top = float(np.percentile(np.abs(values), 99.5))
    colouring = dict(cmap=style.DIVERGING if diverging else style.SEQUENTIAL, vmin=-top if diverging else 0.0, vmax=top)
    figure, axes = style.map_axes(style.extent(run, [0, last]), 1, 1)
    ax = axes[0, 0]
    ax.set_title(f"t = {run.times[last]:.0f} s", loc="left")
    figure.colorbar(ScalarMappable(Normalize(colouring["vmin"], top), colouring["cmap"]), ax=ax, label=label,
                    extend="both" if diverging else "max", shrink=0.8)
    style.fix_layout(figure)
    style.fill_particles(ax, run.field(last, "position"), values, style.sizes(run, last), **colouring)
    bodies.draw(ax, run, last)
    return style.save(figure, folder, name)


def acceleration(runs, times, folder, name="acceleration.png"):
    """Horizontal acceleration at the given times, one column a run, all on one symmetric scale."""
    frames = [[run.nearest_frame(time) for time in times] for run in runs]
    limit = symmetric_limit(
        [run.field(i, "acceleration")[:, 0] for run, indices in zip(runs, frames) for i in indices]
    )
    figure = _panels(
        runs, frames, "acceleration", 0, dict(cmap=style.DIVERGING, vmin=-limit, vmax=limit),
        "horizontal acceleration (m/s²)", "both",
    )
    return style.save(figure, folder, name)


def _frames_and_last(runs, times):
    """Indices of the frames nearest to the times and of the last one; as many of each run."""
    frames = []
    for run in runs:
        indices = [run.nearest_frame(time) for time in times]
        last = len(run.times) - 1
        frames.append(indices if indices[-1] == last else indices + [last])
    rows = min(len(indices) for indices in frames)
    return [indices[-rows:] for indices in frames]


def shear_bands(runs, times, folder, name="shear_bands.png"):
    """Equivalent plastic strain on the deformed shape at the given times and at the end."""
    frames = _frames_and_last(runs, times)
    strains = np.concatenate([run.field(indices[-1], "equivalent_plastic_strain") for run, indices in zip(runs, frames)])
    # Soil that has strained by 1 has lost what it can lose: a longer scale would only hide the bands.
    top = min(float(np.percentile(strains, 99.5)), 1.0)
    top = top if top > 0.0 else 1.0
    figure = _panels(
        runs, frames, "equivalent_plastic_strain", 0, dict(cmap=style.SEQUENTIAL, vmin=0.0, vmax=top),
        "equivalent plastic strain (1)", "max",
    )
    return style.save(figure, folder, name)


def pore_pressure_ratio(runs, times, folder, name="pore_pressure_ratio.png"):
    """r_u on the deformed shape at the given times and at the end; soil that dilates sucks and has less than 0."""
    figure = _panels(
        runs, _frames_and_last(runs, times), "pore_pressure_ratio", 0,
        dict(cmap=style.SEQUENTIAL, vmin=0.0, vmax=1.0), "pore pressure ratio $r_u$ (1)", "both",
    )
    return style.save(figure, folder, name)
