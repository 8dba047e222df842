"""What the responses of a sweep have in common: groups of runs that differ in the motion and the random profile alone, lines over the
intensity, and runs compared in pairs.

A line is that of least squares through the logarithms, ln y = a + b ln x, with the standard deviation of ln y about it
(Cornell, Jalayer, Hamburger & Foutch 2002, J. Struct. Eng. 128, 526-533, Eqs. 2 and 3): a lognormal demand with the median
e^a x^b.
"""

import json
from typing import NamedTuple

import numpy as np

from tremolo.sweep import table
from tremolo.sweep.plan import COMPLETE

MOTION_KEY = "motion.file"
REALISATION_KEY = "random_profile.realisation"
SPREAD = (16.0, 84.0)  # percentiles, one standard deviation of a normal distribution to each side
FEWEST = 3  # points of a line
ALIKE = 1e-3  # relative difference of two responses that are taken for the same
SMALLEST_RANGE = 1.05  # largest intensity over smallest: less is no axis to draw over


class Line(NamedTuple):
    """y = factor x^power; deviation: of ln y; runs: through which it goes."""

    factor: float
    power: float
    deviation: float
    runs: int


def fitted(x, y):
    """The line through the positive points; None with fewer than FEWEST, or where x is the same for all."""
    x, y = np.asarray(x, dtype=float), np.asarray(y, dtype=float)
    kept = (x > 0.0) & (y > 0.0)
    x, y = np.log(x[kept]), np.log(y[kept])
    if len(x) < FEWEST or np.ptp(x) < np.log(SMALLEST_RANGE):
        return None
    power, start = np.polyfit(x, y, 1)
    rest = y - start - power * x
    return Line(float(np.exp(start)), float(power), float(np.sqrt(np.sum(rest**2) / (len(x) - 2))), len(x))


class Group(NamedTuple):
    """Runs that differ in the motion and the random profile alone."""

    colour: object  # value of the axis that has colours; None without one
    rest: tuple  # (key, value) of the other axes that vary
    runs: list  # their numbers


class Sweep:
    """The runs of a plan by their values, and the columns of its table."""

    def __init__(self, plan):
        self.plan = plan
        self.columns = {column.name: column for column in table.columns(plan)}
        self.colour_key = plan.settings["colour"] or None
        varied = plan.varied()
        self.has_motions = MOTION_KEY in varied
        self._rest = [key for key in varied if key not in (MOTION_KEY, REALISATION_KEY, self.colour_key)]
        self.complete = [number for number, status in enumerate(self.columns["status"].values) if status == COMPLETE]

    def value(self, number, key):
        return self.plan.runs[number].values[self.plan.keys.index(key)]

    def numbers(self, name):
        """A measure of all runs; NaN where a run has none, and for a failure that did not come."""
        return self.columns[name].numbers()

    @property
    def colours(self):
        """Values of the axis that has colours, in the order of the study; [None] without one."""
        if self.colour_key is None:
            return [None]
        return _distinct(self.value(number, self.colour_key) for number in range(len(self.plan.runs)))

    def has_colour(self, number, colour):
        return self.colour_key is None or self.value(number, self.colour_key) == colour

    @property
    def sampled_keys(self):
        """Keys whose values are all different numbers: those of a Latin hypercube."""
        return [key for key in self._rest if self.columns[key].is_number and len(set(self.columns[key].values)) > 6]

    def groups(self):
        """Complete runs that differ in the motion and the random profile alone, or in what was sampled."""
        keys = [key for key in self._rest if key not in self.sampled_keys]
        found = {}
        for number in self.complete:
            rest = tuple((key, _hashable(self.value(number, key))) for key in keys)
            colour = None if self.colour_key is None else self.value(number, self.colour_key)
            found.setdefault((rest, _hashable(colour)), Group(colour, rest, [])).runs.append(number)
        return sorted(found.values(), key=lambda group: group.runs[0])

    def spread(self, name, group):
        """How many runs of a group have the measure, its median, and its 16th and 84th percentile."""
        values = self.numbers(name)[group.runs]
        values = values[np.isfinite(values)]
        if len(values) == 0:
            return 0, np.nan, np.nan, np.nan
        return len(values), float(np.median(values)), *(float(value) for value in np.percentile(values, SPREAD))

    @property
    def intensity(self):
        """Name of the column that responses are drawn over; None where it hardly differs between the runs."""
        name = table.MOTION_NAMES[self.plan.settings["intensity"]]
        if name not in self.columns or not self.complete:
            return None
        values = self.numbers(name)[self.complete]
        values = values[values > 0.0]
        return name if len(values) and values.max() >= SMALLEST_RANGE * values.min() else None

    def pairs(self, colour):
        """(first, other): complete runs that differ in nothing but the colour, the first colour and this one."""
        at = self.plan.keys.index(self.colour_key)
        alike = {}
        for number in self.complete:
            values = self.plan.runs[number].values
            if values[at] in (self.colours[0], colour):
                alike.setdefault(json.dumps(values[:at] + values[at + 1:]), {})[_hashable(values[at])] = number
        first, other = _hashable(self.colours[0]), _hashable(colour)
        return [(pair[first], pair[other]) for pair in alike.values() if len(pair) == 2]


def _hashable(value):
    return json.dumps(value) if isinstance(value, (list, dict)) else value


def _distinct(values):
    found = []
    for value in values:
        if value not in found:
            found.append(value)
    return found


class Comparison(NamedTuple):
    """A measure at one colour against the first one, in pairs of runs that differ in nothing else."""

    measure: str
    colour: object
    pairs: int
    smaller: int  # of a failure: earlier; one that comes against one that does not come is earlier
    larger: int
    alike: int
    median: float  # of the differences, where both runs have the measure


def compared(sweep, name):
    """One comparison for each colour but the first."""
    values = sweep.numbers(name)
    never = np.inf if name == "failure_time_s" else np.nan
    found = []
    for colour in sweep.colours[1:]:
        pairs = np.array(sweep.pairs(colour), dtype=int).reshape(-1, 2)
        first, other = (np.where(np.isnan(values[column]), never, values[column]) for column in pairs.T)
        known = ~(np.isnan(first) | np.isnan(other))
        finite = np.isfinite(first) & np.isfinite(other)
        alike = np.isclose(first, other, rtol=ALIKE, atol=0.0)
        found.append(Comparison(name, colour, int(known.sum()), int((~alike & (other < first)).sum()),
                                int((~alike & (other > first)).sum()), int((known & alike).sum()),
                                float(np.median(other[finite] - first[finite])) if finite.any() else np.nan))
    return found


def _varies(sweep, name):
    """Whether a measure differs between the runs that have ended well; a failure that comes in some of them does."""
    values = sweep.numbers(name)[sweep.complete]
    known = values[np.isfinite(values)]
    if len(known) == 0:
        return False
    differs = np.ptp(known) > ALIKE * np.abs(known).max()
    return bool(differs or (name == "failure_time_s" and len(known) < len(values)))


def _chosen(sweep):
    """The measures that the study asks for. Raises ValueError for one that no run has."""
    names = [name for name, column in sweep.columns.items() if column.is_number]
    for name in sweep.plan.settings["draw"]:
        if name not in names:
            raise ValueError(f"{sweep.plan.study}: [measures] draw: the runs have no measure '{name}'; they have {', '.join(names)}")
    return sweep.plan.settings["draw"]


def responses(sweep, most=6):
    """The measures that are drawn: those that the study asks for; otherwise failure, run-out, tilt, r_u, last displacements, spectral
    ratios and accelerations, of site responses peaks, Arias intensity and strain, without what is the same in all runs, unless all
    is."""
    if sweep.plan.settings["draw"]:
        return _chosen(sweep)
    names = [name for name, column in sweep.columns.items() if column.is_number]
    wanted = ["failure_time_s", "run_out_m", ".final_tilt_rad", ".settlement_m", ".peak_r_u", ".final_displacement_m",
              "spectral_ratio_", ".peak_ax_m_s2", "surface.pga_m_s2", "surface.pgv_m_s", "surface.arias_m_s", "largest_strain"]
    found = [name for want in wanted for name in names if name == want or (want[0] == "." and name.endswith(want))
             or (want[-1] == "_" and name.startswith(want))]
    found = [name for name in found if np.isfinite(sweep.numbers(name)).any()]
    return ([name for name in found if _varies(sweep, name)] or found)[:most]
