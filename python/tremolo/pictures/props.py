"""Props: drawn into maps, and their forces over time."""

from tremolo import style

LINE = dict(color="#222222", linewidth=1.6, solid_capstyle="butt", marker="o", markersize=2.5)


def draw(ax, run, time):
    """A line between the ends of every prop where they are at a time (s)."""
    for name in run.props:
        prop = run.prop(name)
        if len(prop):
            ends = prop.ends_at(time)
            ax.plot(ends[:, 0], ends[:, 1], **LINE)


def picture(run, folder):
    """props.png: the force in each prop over time, tension upwards. None where there is none with a history."""
    own = {name: run.prop(name) for name in run.props}
    own = {name: prop for name, prop in own.items() if len(prop) > 1}
    if not own:
        return None
    figure, ax = style.plt.subplots(figsize=(7.0, 3.6), layout="constrained")
    for number, (name, prop) in enumerate(own.items()):
        ax.plot(prop.time, prop.force / 1e3, color=style.COLOURS[number % len(style.COLOURS)], linewidth=0.9, label=name)
    ax.axhline(0.0, color="0.6", linewidth=0.5, zorder=0)
    ax.set_ylabel("N (kN/m), tension positive")
    ax.set_xlabel("t (s)")
    ax.set_xlim(min(prop.time[0] for prop in own.values()), max(prop.time[-1] for prop in own.values()))
    ax.legend(loc="best", frameon=False)
    return style.save(figure, folder, "props.png")
