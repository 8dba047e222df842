"""Pressure and shear on the surface of a structure, from the forces at its contact nodes."""

import numpy as np

COMPONENTS = ("pressure", "shear", "water_pressure")


def _pieces(outline, length):
    """Middles of pieces of a closed counter-clockwise line that are about as long, their normals outwards, and their lengths (m).

    No piece goes around a corner.
    """
    middles, outwards, lengths = [], [], []
    for start, end in zip(outline, np.roll(outline, -1, axis=0)):
        along = end - start
        edge = float(np.hypot(*along))
        count = max(1, round(edge / length))
        middles += [start + (k + 0.5) / count * along for k in range(count)]
        outwards += [np.array([along[1], -along[0]]) / edge] * count
        lengths += [edge / count] * count
    return np.array(middles), np.array(outwards), np.array(lengths)


def _counter_clockwise(outline):
    x, y = outline.T
    return outline if np.sum(x * np.roll(y, -1) - np.roll(x, -1) * y) > 0.0 else outline[::-1]


class ContactStress:
    """What the ground and other structures do to the surface of a structure, in each frame.

        wall = run.contact_stress("wall")
        wall.pressure                      # [times, pieces], Pa, effective, in front of wall.places at wall.time
        wall.water_pressure                # Pa, of the excess pore pressure; that at rest is not in it
        wall.shear                         # Pa, positive where it pushes the structure counter-clockwise
        wall.pressure[wall.nearest(4.2)]   # in the frame next to 4.2 s
        wall.envelope("pressure")          # the least and the greatest at each piece over all frames

    The surface is cut into pieces of about two cells, `places` [pieces, 2] and `outwards` [pieces, 2] at the start (m), counter-clockwise.
    A contact node gives its force to the nearest piece that faces it, on the structure as it has moved and turned as a whole; the
    stress is the force over the length of the piece. Pressure and shear times `lengths` add up to `normal` and `friction` of
    `Run.body`.
    """

    def __init__(self, run, name):
        body = run.body(name)
        number = run.bodies.index(name)
        self.time = run.times
        areas = [nodes["area"][nodes["body"] == number] for nodes in map(run.contact, range(len(self.time)))]
        areas = np.concatenate(areas) if areas else np.zeros(0)
        cell = float(np.median(areas[areas > 0.0])) if np.any(areas > 0.0) else float(run.attribute("mesh_size"))
        self.outline = _counter_clockwise(body.outline)
        self.places, self.outwards, self.lengths = _pieces(self.outline, 2.0 * cell)
        self.pressure, self.shear, self.water_pressure = (np.zeros((len(self.time), len(self.places))) for _ in COMPONENTS)
        self._start = np.array(body.place(self.time[0])[:2]) if len(body) else self.outline.mean(axis=0)
        for row, time in enumerate(self.time):
            nodes = run.contact(row)
            self._add(row, {field: values[nodes["body"] == number] for field, values in nodes.items()},
                      body.place(time) if len(body) else (*self._start, 0.0))

    def _add(self, row, nodes, place):
        """The nodes of a frame, in which the centre of mass is at a place x, y (m) and the structure has turned by an angle (rad)."""
        turn = np.array([[np.cos(place[2]), -np.sin(place[2])], [np.sin(place[2]), np.cos(place[2])]])
        positions = (nodes["position"] - place[:2]) @ turn + self._start
        normals = nodes["normal"] @ turn
        for n, (position, normal) in enumerate(zip(positions, normals)):
            distances = np.linalg.norm(self.places - position, axis=1)
            distances[self.outwards @ normal > -0.5] = np.inf  # of faces that look elsewhere
            piece = int(np.argmin(distances))
            if not np.isfinite(distances[piece]):
                piece = int(np.argmin(np.linalg.norm(self.places - position, axis=1)))
            # At corners the normal of a node lies between those of the faces.
            out, length = self.outwards[piece], self.lengths[piece]
            force = nodes["normal_force"][n] * normal + nodes["friction_force"][n] * np.array([-normal[1], normal[0]])
            self.pressure[row, piece] -= out @ force / length
            self.shear[row, piece] += np.array([-out[1], out[0]]) @ force / length
            self.water_pressure[row, piece] -= nodes["water_force"][n] * (out @ normal) / length

    def nearest(self, time):
        """The row next to a time (s)."""
        return int(np.argmin(np.abs(self.time - time)))

    def envelope(self, component):
        """The least and the greatest value at each piece over all frames: of "pressure", "shear" or "water_pressure"."""
        if component not in COMPONENTS:
            raise KeyError(f"no component '{component}'; there are {', '.join(COMPONENTS)}")
        values = getattr(self, component)
        return values.min(axis=0), values.max(axis=0)
