"""Sections: histories of N, Q and M of single cuts, and diagrams of rings of cuts, with the signs and on the sides of linings."""

from matplotlib.patches import PathPatch

from tremolo import bodies, style
from tremolo.pictures import diagrams, linings

BODY = dict(facecolor="#E4E4E4", edgecolor="#888888", linewidth=0.8)


def _draw_on_structure(ax, run, section, force, sign, rows):
    """A diagram of a ring on the outline of its structure at the start."""
    body = run.body(section.structure)
    ax.add_patch(PathPatch(bodies.shape(body.outline, body.hole), **BODY))
    middles = section.cuts.mean(axis=1)
    outwards = (section.cuts[:, 1] - section.cuts[:, 0]) / section.thickness[:, None]
    diagrams.draw(ax, middles, middles, outwards, getattr(section, force), section.time, rows, sign)


def ring(run, folder, name, times=None):
    """section_NAME.png of a ring of cuts; None where it has no history yet."""
    section = run.section(name)
    if not len(section):
        return None
    rows = [section.nearest(time) for time in times] if times else diagrams.telling_rows(section.moment)
    figure = diagrams.sheet(linings.DIAGRAMS, lambda ax, force, sign: _draw_on_structure(ax, run, section, force, sign, rows),
                            lambda force: getattr(section, force), section.time)
    figure.suptitle(f"{name}: section forces in {section.structure}", fontsize=10)
    return style.save(figure, folder, f"section_{name}.png")


def histories(run, folder):
    """sections.png, a column a single cut: M, N and Q over time. None where there is none with a history."""
    cuts = {name: run.section(name) for name in run.sections}
    cuts = {name: cut for name, cut in cuts.items() if cut.centre is None and len(cut) > 1}
    if not cuts:
        return None
    figure, axes = style.plt.subplots(len(linings.DIAGRAMS), len(cuts), figsize=(2.0 + 5.0 * len(cuts), 6.5), squeeze=False, sharex=True,
                                      layout="constrained")
    for column, (name, cut) in enumerate(cuts.items()):
        for row, (force, text, _, unit) in enumerate(linings.DIAGRAMS):
            ax = axes[row, column]
            ax.plot(cut.time, getattr(cut, force)[:, 0] / 1e3, color=style.COLOURS[row], linewidth=0.8)
            ax.axhline(0.0, color="0.6", linewidth=0.5, zorder=0)
            ax.set_ylabel(f"{text.split(',')[0]} ({unit})")
        axes[0, column].set_title(f"{name}: {cut.thickness[0]:.3g} m of {cut.structure}", loc="left")
        axes[-1, column].set_xlabel("t (s)")
        axes[-1, column].set_xlim(cut.time[0], cut.time[-1])
    return style.save(figure, folder, "sections.png")


def pictures(run, folder, times=None):
    """Yields the path of every picture of sections."""
    if drawn := histories(run, folder):
        yield drawn
    for name in run.sections:
        if run.section(name).centre is not None and (drawn := ring(run, folder, name, times)):
            yield drawn
