"""Two runs in numbers: the peaks of their common monitors, and how far their histories differ."""

import numpy as np

QUANTITIES = (("a", "m/s²"), ("v", "m/s"), ("u", "m"))


def peak(series, quantity, end):
    """Largest magnitude of a vector quantity of a monitor, up to the time `end`."""
    rows = series["time"] <= end
    return float(np.max(np.hypot(series[quantity + "x"][rows], series[quantity + "y"][rows])))


def difference(one, other, quantity):
    """Norm of the difference of two histories over that of the first, over the time that both cover."""
    time = one["time"][one["time"] <= other["time"][-1]]
    ours = np.array([one[quantity + c][: len(time)] for c in "xy"])
    theirs = np.array([np.interp(time, other["time"], other[quantity + c]) for c in "xy"])
    size = float(np.linalg.norm(ours))
    return float(np.linalg.norm(theirs - ours)) / size if size > 0.0 else 0.0


def lines(first, second):
    """A line a monitor and quantity: the peak of both runs over the time that both cover, their ratio, and the difference
    of the histories. Where one run is shorter, a line before them says when it ends."""
    common = [name for name in first.monitors if name in second.monitors]
    if not common:
        yield "no monitor is common to both runs: only pictures are compared"
        return
    ends = [run.monitor(common[0])["time"][-1] for run in (first, second)]
    end = min(ends)
    if max(ends) - end > 0.01 * end:
        yield f"until {end:.4g} s, where the shorter run ends:"
    yield f"{'monitor':<16}{'peak of':<12}{first.name[-20:]:>22}{second.name[-20:]:>22}{'ratio':>9}{'difference':>12}"
    for name in common:
        one, other = first.monitor(name), second.monitor(name)
        for quantity, unit in QUANTITIES:
            a, b = (peak(series, quantity, end) for series in (one, other))
            ratio = f"{b / a:.3f}" if a > 0.0 else "-"
            yield f"{name:<16}{quantity + ', ' + unit:<12}{a:>22.4g}{b:>22.4g}{ratio:>9}{100.0 * difference(one, other, quantity):>10.2f} %"
