"""Linings: closed beams with their section forces."""

import numpy as np

from tremolo.section_forces import SectionForces


class Lining(SectionForces):
    """What became of a [[lining]]: section forces in the middle of each element, places of the nodes, stresses on its outer face.

        ring = run.lining("ring")
        ring.moment                        # [times, elements], N m per m of tunnel, at ring.time; positive: stretches the outer face
        ring.axial_force                   # N/m, tension positive
        ring.shear_force                   # N/m
        ring.places                        # [times, nodes, 2], m, of its axis; element k begins at node k
        ring.pressure, ring.shear          # [times, segments], Pa, of soil and water on its outer face, in front of ring.segments
        ring.water_pressure                # Pa, the water's part; ring.pressure - ring.water_pressure is effective
        ring.envelope("moment")            # the least and the greatest moment of each element over all times
        ring.moment[ring.nearest(4.2)]     # those next to 4.2 s

    Nodes, elements and segments run counter-clockwise. The attributes: `nodes` [nodes, 2] and `segments` [segments, 2], middles of the
    segments, at the start (m); `thickness` (m), `axial_stiffness`, `shear_stiffness` (N/m), `bending_stiffness` (N m), `mass` (kg/m2);
    `hinges`, numbers of nodes.
    """

    def __init__(self, dataset):
        super().__init__(dataset)
        self.nodes = np.reshape(dataset.attrs["nodes"], (-1, 2))
        self.segments = np.reshape(dataset.attrs["segments"], (-1, 2))
        for name in ("thickness", "axial_stiffness", "shear_stiffness", "bending_stiffness", "mass"):
            setattr(self, name, float(dataset.attrs[name]))
        self.hinges = [int(node) for node in dataset.attrs["hinges"]] if "hinges" in dataset.attrs else []

    def __repr__(self):
        span = f", {self.time[0]:g} to {self.time[-1]:g} s" if len(self) else ""
        return f"<Lining: {len(self)} rows{span}; {len(self.nodes)} elements, {len(self.segments)} segments>"

    @property
    def pressure(self):
        """Pa, of soil and water on the outer face."""
        return self._numbered("pressure")

    @property
    def water_pressure(self):
        """Pa, the part of the pressure that pore water bears: at rest and in excess of that."""
        return self._numbered("water_pressure")

    @property
    def shear(self):
        """Pa, of the soil along the outer face, counter-clockwise on the lining."""
        return self._numbered("shear")

    def axis(self, time):
        """Places of the nodes at a time (s), m."""
        if len(self) == 0:
            return self.nodes
        places = self.places
        return np.stack([[np.interp(time, self.time, places[:, k, c]) for c in (0, 1)] for k in range(places.shape[1])])

    def faces(self, time):
        """Outer and inner face at a time (s), m: corners in front of and behind the nodes."""
        axis = self.axis(time)
        before, behind = axis - np.roll(axis, 1, axis=0), np.roll(axis, -1, axis=0) - axis
        outward = [np.column_stack([along[:, 1], -along[:, 0]]) / np.linalg.norm(along, axis=1)[:, None] for along in (before, behind)]
        # The lines of both faces at half the thickness meet there.
        away = (outward[0] + outward[1]) / (1.0 + np.sum(outward[0] * outward[1], axis=1))[:, None]
        return axis + 0.5 * self.thickness * away, axis - 0.5 * self.thickness * away
