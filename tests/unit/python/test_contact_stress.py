"""Pressure and shear on structures from the forces at contact nodes, and their picture."""

import tempfile
import unittest
from pathlib import Path

import h5py
import numpy as np

import synthetic_run
from test_pictures import run_command
from tremolo import Run
from with_run import WithRun

SIDE, PRESSURE, SHEAR = 8.0, 5e4, 2e3  # m, Pa
NODES = 16  # a side


def _square_of_nodes(centre, tilt):
    """Nodes around a square that has turned: uniform pressure, and shear that pushes it counter-clockwise."""
    position, normal = [], []
    for side in range(4):
        angle = tilt + side * np.pi / 2.0
        out, along = np.array([np.cos(angle), np.sin(angle)]), np.array([-np.sin(angle), np.cos(angle)])
        for k in range(NODES):
            position.append(centre + 0.5 * SIDE * out + ((k + 0.5) / NODES - 0.5) * SIDE * along)
            normal.append(-out)
    count, area = len(position), SIDE / NODES
    return {"position": np.array(position), "normal": np.array(normal), "body": np.zeros(count, dtype=np.int32),
            "area": np.full(count, area), "normal_force": np.full(count, PRESSURE * area),
            "friction_force": np.full(count, -SHEAR * area), "water_force": np.full(count, 0.5 * PRESSURE * area)}


class ContactStress(WithRun):
    @classmethod
    def write(cls):
        synthetic_run.write(cls.path, frames=3, size=4.0, structures=True)
        corners = 0.5 * SIDE * np.array([[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]])
        with Run(cls.path) as run:
            cls.name = run.bodies[0]
            places = [run.body(cls.name).place(time) for time in run.times]
        with h5py.File(cls.path, "a") as file:
            file["bodies"][cls.name].attrs["outline"] = (corners + places[0][:2])[::-1].ravel()  # clockwise
            for number, (x, y, tilt) in enumerate(places):
                frame = file["contact"][f"{number:04}"]
                nodes = _square_of_nodes(np.array([x, y]), tilt)
                if number == 2:  # its first node, at a corner, looks askew
                    nodes["normal"][0] = -np.array([np.cos(tilt - np.pi / 4.0), np.sin(tilt - np.pi / 4.0)])
                for field, values in nodes.items():
                    del frame[field]
                    frame[field] = values

    def test_uniform_stress_stays_uniform_while_the_structure_turns(self):
        stress = self.run.contact_stress(self.name)
        self.assertEqual((3, 4 * NODES // 2), stress.pressure.shape)
        np.testing.assert_allclose(stress.pressure[:2], PRESSURE, rtol=1e-12)
        np.testing.assert_allclose(stress.shear[:2], SHEAR, rtol=1e-9)
        np.testing.assert_allclose(stress.water_pressure[:2], 0.5 * PRESSURE, rtol=1e-12)
        np.testing.assert_allclose(stress.lengths.sum(), 4.0 * SIDE)
        least, greatest = stress.envelope("pressure")
        self.assertLess(least.min(), PRESSURE)
        np.testing.assert_allclose(greatest, PRESSURE, rtol=1e-9)
        self.assertEqual(1, stress.nearest(stress.time[1] + 1e-3))

    def test_forces_at_corners_are_kept(self):
        stress = self.run.contact_stress(self.name)
        tangents = np.column_stack([-stress.outwards[:, 1], stress.outwards[:, 0]])
        total = stress.lengths @ (stress.shear[2][:, None] * tangents - stress.pressure[2][:, None] * stress.outwards)
        # What its first node has more than one of the face: all others are in balance.
        oblique, straight = np.array([1.0, -1.0]) / np.sqrt(2.0), np.array([1.0, 0.0])
        turned = [np.array([-n[1], n[0]]) for n in (oblique, straight)]
        area = SIDE / NODES
        np.testing.assert_allclose(total, area * (PRESSURE * (straight - oblique) + SHEAR * (turned[0] - turned[1])), atol=1e-6)

    def test_refuses_what_is_not_there(self):
        with self.assertRaisesRegex(KeyError, "no body 'wall'"):
            self.run.contact_stress("wall")
        with self.assertRaisesRegex(KeyError, "no component 'suction'; there are pressure, shear, water_pressure"):
            self.run.contact_stress(self.name).envelope("suction")

    def test_is_drawn(self):
        with tempfile.TemporaryDirectory() as out:
            status, printed, _ = run_command("plot", self.path, "--out", out)
            self.assertEqual(0, status)
            self.assertIn(str(Path(out) / f"contact_{self.name}.png"), printed)


if __name__ == "__main__":
    unittest.main()
