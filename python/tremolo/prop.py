"""Props: springs between structures and ground."""

import numpy as np

from tremolo.series import Series, text


class Prop(Series):
    """The force in a [[prop]] over time, and where its ends are.

        strut = run.prop("strut")
        strut.force                        # N/m, tension positive, at strut.time
        strut.force.min()                  # the largest compression
        strut.length                       # m, between its ends
        strut.places                       # [times, 2, 2], m: x and y of the first end and of the second

    The attribute `ends` has the names of the two structures that it is fastened to; "ground" is the ground.
    """

    def __init__(self, dataset):
        super().__init__(dataset)
        self.ends = text(dataset.attrs["from"]), text(dataset.attrs["to"])

    def __repr__(self):
        span = f", {self.time[0]:g} to {self.time[-1]:g} s" if len(self) else ""
        return f"<Prop: {len(self)} rows{span}; from {self.ends[0]} to {self.ends[1]}>"

    @property
    def force(self):
        """N/m, tension positive."""
        return self["n"]

    @property
    def length(self):
        """m, between its ends."""
        return self["length"]

    @property
    def places(self):
        """m, of both ends."""
        return np.stack([np.column_stack([self[f"{end}_x"], self[f"{end}_y"]]) for end in ("from", "to")], axis=1)

    def ends_at(self, time):
        """m, x and y of both ends at a time (s), [2, 2]."""
        return np.array([[np.interp(time, self.time, self[f"{end}_{axis}"]) for axis in "xy"] for end in ("from", "to")])
