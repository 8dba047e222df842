"""What the processes of a run did when: drawn, and in words who waited for whom."""

import numpy as np

from tremolo import style

WAITING = "waiting for "
# Of the time of the run: what is less is not worth a name.
NEGLIGIBLE = 0.01


class Timeline:
    """Seconds of each activity in the slices of wall time of one process."""

    def __init__(self, slice_length, activities):
        self.slice = slice_length  # s
        self.activities = activities  # name -> [slices], s

    @property
    def end(self):
        """From the common start until the process said that it was done, s."""
        return self.total()

    def total(self, prefix=""):
        """Of all activities whose name begins so, s."""
        return sum(seconds.sum() for name, seconds in self.activities.items() if name.startswith(prefix))

    def waits(self):
        """For whom it waited and how long, the longest wait first."""
        waits = {name[len(WAITING) :]: seconds.sum() for name, seconds in self.activities.items() if name.startswith(WAITING)}
        return dict(sorted(waits.items(), key=lambda wait: -wait[1]))

    def done(self):
        """When all but a thousandth of its computing was done, s."""
        computed = np.cumsum(self.activities.get("computing", np.zeros(1)))
        return self.slice * (1 + int(np.searchsorted(computed, 0.999 * computed[-1])))


def timelines(run):
    """Process -> Timeline, in the order of the run's processes.

    Raises ValueError for a run without: one that has failed, or of an older version.
    """
    table = run.table("timeline")
    if table is None:
        raise ValueError(f"{run.path}: holds no timeline; it is written when a run has ended well")
    process, activity = np.array(table["process"]), np.array(table["activity"])
    found = {}
    for name in dict.fromkeys(table["process"]):
        own = process == name
        activities = {what: table["duration"][own & (activity == what)] for what in dict.fromkeys(activity[own])}
        found[name] = Timeline(float(table["slice"][own][0]), activities)
    return found


def _percent(seconds, whole):
    share = 100.0 * seconds / whole
    return f"{share:.0f} %" if share >= 1.0 else "less than 1 %"


def _deeds(name, line):
    """'domain: computed 95 %, mapped 2 % and waited 3 % of 12.1 s, mostly for right'"""
    whole = line.end
    waited = line.total(WAITING)
    text = f"{name}: of {whole:.2f} s it computed {_percent(line.total('computing'), whole)}"
    text += f", mapped {_percent(line.total('mapping'), whole)} and waited {_percent(waited, whole)}"
    if waited > NEGLIGIBLE * whole:
        whom, longest = next(iter(line.waits().items()))
        text += f", {'mostly' if longest < 0.999 * waited else 'all of it'} for {whom}"
    return text


def sentences(lines, domain="domain"):
    """Yields who did what, when the sources were done, and who sets the pace."""
    for name, line in lines.items():
        yield _deeds(name, line)
    sources = {name: line for name, line in lines.items() if name != domain}
    if domain not in lines or not sources:
        return
    last = max(sources, key=lambda name: sources[name].done())
    yield f"the free fields were done after {sources[last].done():.2f} s, {last} last"
    whole, waits = lines[domain].end, lines[domain].waits()
    whom, longest = next(iter(waits.items()), ("nobody", 0.0))
    if longest > 0.1 * whole:
        yield f"{domain} waited {longest:.2f} s for {whom}: a faster {whom} would shorten the run by at most that"
    else:
        yield f"{domain} sets the pace: faster free fields would shorten the run by {sum(waits.values()):.2f} s at most"


def activity_colours(lines):
    """Activity -> colour, the same in all rows."""
    awaited = dict.fromkeys(whom for line in lines.values() for whom in line.waits())
    colours = {"computing": style.COLOURS[0], "mapping": style.COLOURS[2]}
    waiting = ["#D9D9D9", style.COLOURS[1], style.COLOURS[4], style.COLOURS[3], style.COLOURS[6], style.COLOURS[5]]
    # Grey is the harmless wait: a source that is ahead of the domain.
    order = sorted(awaited, key=lambda whom: whom != "domain")
    if "domain" not in awaited:
        waiting = waiting[1:]
    for i, whom in enumerate(order):
        colours[WAITING + whom] = waiting[i % len(waiting)]
    return colours


def picture(run, folder):
    """A row a process: the share of each activity in each slice of wall time."""
    lines = timelines(run)
    colours = activity_colours(lines)
    figure, axes = style.plt.subplots(
        len(lines), 1, figsize=(7.2, 0.8 + 0.75 * len(lines)), squeeze=False, sharex=True, layout="constrained"
    )
    used = {}
    for ax, (name, line) in zip(axes[:, 0], lines.items()):
        slices = max(len(seconds) for seconds in line.activities.values())
        begin = line.slice * np.arange(slices)
        below = np.zeros(slices)
        for activity, colour in colours.items():
            seconds = line.activities.get(activity)
            if seconds is None:
                continue
            share = 100.0 * np.pad(seconds, (0, slices - len(seconds))) / line.slice
            used[activity] = ax.bar(begin, share, line.slice, below, align="edge", color=colour, linewidth=0)
            below += share
        ax.set_ylim(0, 100)
        ax.set_yticks([0, 50, 100], ["", "50 %", ""])
        ax.set_ylabel(name, rotation=0, ha="right", va="center")
    axes[-1, 0].set_xlim(0, max(line.end for line in lines.values()))
    axes[-1, 0].set_xlabel("wall time since all processes are connected (s)")
    shown = [activity for activity in colours if activity in used]
    axes[0, 0].legend([used[activity] for activity in shown], shown, loc="lower left", bbox_to_anchor=(0.0, 1.0), ncols=min(len(shown), 4))
    return style.save(figure, folder, "timeline.png")
