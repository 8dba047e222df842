"""The faults that a run must survive or end well: how they are listed, and what their checks share."""

import dataclasses
import random
import time
from collections.abc import Callable

from fault_lab import Attack

GONE = 2.0  # s, from a death to the end of the last process
DEADLINE = 2.0  # s, the step deadline where it is to pass
PROMPT = 5.0  # s, from a signal to the end of the last process: less than the grace of 10 s that the domain has
# Survivors have 1 s to close their files; a loaded machine takes some seconds more.
VERDICT = DEADLINE + 6.0
# A wait begins when the domain has used up what it holds: little, with this window.
BRIEF = {"duration": 60.0, "step": DEADLINE, "window": 2}
SLOPE_SOURCES = ("left-base", "right")


@dataclasses.dataclass
class Fault:
    name: str
    injected: str
    promised: str
    check: Callable
    in_suite: bool


FAULTS: list[Fault] = []


def fault(injected, promised, in_suite=False):
    """@param in_suite: one of each kind is in the suite, the others are tests of acceptance."""

    def register(check):
        FAULTS.append(Fault(check.__name__.replace("_", " "), injected, promised, check, in_suite))
        return check
    return register


class Faults:
    """What the checks share: the program, the chance, the results of undisturbed runs."""

    def __init__(self, tremolo, clock, seed):
        self.tremolo, self.clock, self.random = tremolo, clock, random.Random(seed)
        self._reference = {}

    def attack(self, **options):
        return Attack(self.tremolo, **options)

    def rogue(self, misdeed, step=None, **options):
        """The small box with the rogue source on its left, at a random step of its 500."""
        step = self.random.randrange(500) if step is None else step
        return self.attack(template="box", rogue=f"{misdeed} {step}", step=options.pop("step_deadline", 20.0),
                           **{"angle": 0.0, **options})

    def undisturbed(self, start, key):
        """Results and wall time of the same run left alone."""
        if key not in self._reference:
            with start() as run:
                run.must_succeed()
                self._reference[key] = (run.numbers(), time.monotonic() - run.started)
        return self._reference[key]

    def slope(self):
        return self.undisturbed(self.attack, "slope")

    def box(self):
        return self.undisturbed(lambda: self.rogue("none"), "box")[0]
