"""Section forces of a beam or of cuts, N, Q and M, as series with numbered columns."""

import numpy as np

from tremolo.series import Series

FORCES = ("axial_force", "shear_force", "moment")


class SectionForces(Series):
    """N, Q and M at numbered places over time."""

    def _numbered(self, column):
        """The columns of a name with the numbers 0, 1, ... behind it, or the one without a number."""
        return self._rows[:, [i for i, name in enumerate(self.columns) if name.rstrip("0123456789") == column]]

    @property
    def axial_force(self):
        """N/m, tension positive."""
        return self._numbered("n")

    @property
    def shear_force(self):
        """N/m; dM/ds = -Q along the axis."""
        return self._numbered("q")

    @property
    def moment(self):
        """N m per m; positive where it stretches the outer face, which is the end `to` of a single cut."""
        return self._numbered("m")

    @property
    def places(self):
        """m, of the nodes of a lining, or of the middles of cuts."""
        return np.stack([self._numbered("x"), self._numbered("y")], axis=-1)

    def nearest(self, time):
        """The row next to a time (s)."""
        return int(np.argmin(np.abs(self.time - time)))

    def envelope(self, force):
        """The least and the greatest value at each place over all times: of "axial_force", "shear_force" or "moment"."""
        if force not in FORCES:
            raise KeyError(f"no section force '{force}'; there are {', '.join(FORCES)}")
        values = getattr(self, force)
        return values.min(axis=0), values.max(axis=0)
