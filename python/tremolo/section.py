"""Sections: cuts through elastic structures, with the forces that pass through them."""

import numpy as np

from tremolo.section_forces import SectionForces
from tremolo.series import text


class Section(SectionForces):
    """What passes through a [[section]]: N, Q and M of a cut, or of each cut of a ring, in the signs of linings.

        foot = run.section("foot")
        foot["n"], foot["q"], foot["m"]    # N/m, N/m, N m per m of a single cut, at foot.time
        ring = run.section("ring")
        ring.moment                        # [times, cuts], N m per m; positive: stretches the end `to`, of a ring its outer face
        ring.axial_force                   # N/m, tension positive
        ring.shear_force                   # N/m
        ring.places                        # [times, cuts, 2], m, of the middles of the cuts
        ring.angles                        # [cuts], degrees from the direction of x, counter-clockwise
        ring.envelope("moment")            # the least and the greatest moment of each cut over all times
        ring.moment[ring.nearest(4.2)]     # those next to 4.2 s

    The attributes: `structure`, its name; `cuts` [cuts, 2, 2], both ends of each at the start (m); `centre` of a ring (m), None of a
    single cut.
    """

    def __init__(self, dataset):
        super().__init__(dataset)
        self.structure = text(dataset.attrs["structure"])
        self.cuts = np.reshape(dataset.attrs["cuts"], (-1, 2, 2))
        self.centre = np.array(dataset.attrs["centre"]) if "centre" in dataset.attrs else None

    def __repr__(self):
        span = f", {self.time[0]:g} to {self.time[-1]:g} s" if len(self) else ""
        cuts = "a cut" if self.centre is None else f"a ring of {len(self.cuts)} cuts"
        return f"<Section: {len(self)} rows{span}; {cuts} through '{self.structure}'>"

    @property
    def angles(self):
        """Degrees, in [0, 360), in which the cuts of a ring stand at the start."""
        if self.centre is None:
            raise ValueError("a single cut has no angle around a centre")
        out = self.cuts.mean(axis=1) - self.centre
        return np.degrees(np.arctan2(out[:, 1], out[:, 0])) % 360.0

    @property
    def thickness(self):
        """m, of the structure at each cut at the start."""
        return np.linalg.norm(self.cuts[:, 1] - self.cuts[:, 0], axis=1)
