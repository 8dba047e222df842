"""The model at the end of each static stage: how far soil has moved since gravity, its vertical stress, and
where the water stands."""

import numpy as np
from matplotlib.cm import ScalarMappable
from matplotlib.colors import Normalize

from tremolo import bodies, style
from tremolo.pictures import water
from tremolo.run import Run


def frames(run):
    """(name, Run) of the static stages of a run in their order; none where gravity is the only one."""
    folder = run.path.parent / "stages"
    if not folder.is_dir():
        return []
    numbered = [(path.parent.name.split(" ", 1), path) for path in folder.glob("*/run.h5")]
    ordered = sorted((int(parts[0]), parts[1], path) for parts, path in numbered if parts[0].isdecimal() and len(parts) == 2)
    return [(name, Run(path)) for _, name, path in ordered]


def _quantities(run):
    """(values, label) of the two columns."""
    moved = 1e3 * np.hypot(*run.field(0, "displacement").T)
    return (moved, "displacement since gravity (mm)"), (-1e-3 * run.field(0, "stress")[:, 1], "vertical stress of the grains (kPa)")


def figure_of(run):
    """A row a stage; None where the run has no such frames. Each column has one scale, which cuts off the highest 0.5 %."""
    found = frames(run)
    if not found:
        return None
    columns = list(zip(*(_quantities(stage) for _, stage in found)))
    bounds = np.array([style.extent(stage, [0]) for _, stage in found])
    bounds = (*bounds[:, :2].min(axis=0), *bounds[:, 2:].max(axis=0))
    figure, axes = style.map_axes(bounds, len(found), 2)
    scales = []
    for column, drawn in enumerate(columns):
        top = max(float(np.percentile(values, 99.5)) for values, _ in drawn) or 1.0
        scales.append(dict(cmap=style.SEQUENTIAL, vmin=0.0, vmax=top))
        figure.colorbar(ScalarMappable(Normalize(0.0, top), style.SEQUENTIAL), ax=axes[:, column], label=drawn[0][1], extend="max",
                        location="top", aspect=40, pad=0.02)
    for row, (name, _) in enumerate(found):
        axes[row, 0].set_title(name, loc="left")
    style.fix_layout(figure)
    for row, (_, stage) in enumerate(found):
        for column in range(2):
            style.fill_particles(axes[row, column], stage.field(0, "position"), columns[column][row][0], style.sizes(stage, 0),
                                 **scales[column])
            bodies.draw(axes[row, column], stage, 0)
            if (surface := water.line(stage, bounds[0], bounds[2])) is not None:
                water.draw(axes[row, column], surface)
    return figure


def picture(run, folder):
    """Writes stages.png; returns its path, or None."""
    figure = figure_of(run)
    return None if figure is None else style.save(figure, folder, "stages.png")
