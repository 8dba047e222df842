"""The bytes, messages and exchanges of the cost model (docs/ranks.md) are those that ranks of the domain count.

    usage: test_ranks_cost.py COST_RANKS MODEL_FOLDER MPIRUN
"""

import csv
import os
import subprocess
import sys
import unittest

PROGRAM, MODEL, MPIRUN = sys.argv.pop(1), sys.argv.pop(1), sys.argv.pop(1)
sys.path.insert(0, MODEL)
if not MPIRUN:
    print("this build has no MPI: nothing to count")
    sys.exit(77)

import rank_tiles
import ranks_model

# Open MPI asks for these where the user is root, as in a container.
AS_ROOT = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}


def counts(columns, rows, ranks):
    """What each rank has counted in a step, by name."""
    command = [MPIRUN, "--oversubscribe", "--bind-to", "none", "-n", str(ranks), PROGRAM, "counts", str(columns), str(rows)]
    result = subprocess.run(command, env=os.environ | AS_ROOT, capture_output=True, text=True, timeout=120)
    assert result.returncode == 0, result.stdout + result.stderr
    found = {}
    for row in csv.DictReader(result.stdout.splitlines()):
        found.setdefault(row["name"], []).append(float(row["value"]))
    return found


# Columns and rows of cells: a level rim, corners, rims along the surface, pieces of a few tiles, tiles that are not full.
BOXES = ((88, 40, 2), (200, 80, 2), (200, 80, 3), (200, 80, 4), (300, 61, 4), (200, 80, 8))


class Counts(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.counted = {box: counts(*box) for box in BOXES}

    def test_particles_and_unevenness(self):
        for box, counted in self.counted.items():
            with self.subTest(box):
                tiles = rank_tiles.Tiles(*box)
                self.assertEqual(tiles.loads().tolist(), counted["own particles"])
                self.assertAlmostEqual(tiles.unevenness(), counted["unevenness"][0], places=6)

    def test_messages_and_bytes_between_two_ranks(self):
        for box, counted in self.counted.items():
            with self.subTest(box):
                tiles = rank_tiles.Tiles(*box)
                nodes, neighbours = tiles.sent()
                near, of_boundary, partners = tiles.boundary(*box[:2])
                self.assertEqual((nodes * ranks_model.FIELDS * ranks_model.NUMBER + of_boundary).tolist(), counted["message bytes"])
                self.assertEqual((neighbours * ranks_model.SCATTERS + partners).tolist(), counted["messages"])
                self.assertEqual(near.tolist(), counted["boundary nodes"])

    def test_faces(self):
        for (columns, rows, ranks), counted in self.counted.items():
            with self.subTest((columns, rows, ranks)):
                self.assertEqual([rank_tiles.faces(columns, rows)] * ranks, counted["faces"])
                self.assertEqual(rank_tiles.Tiles(columns, rows, ranks).near_faces(columns, rows).tolist(), counted["near faces"])

    def test_the_first_rank_takes_velocities_and_gives_each_the_free_field_of_its_near_faces(self):
        for (columns, rows, ranks), counted in self.counted.items():
            with self.subTest((columns, rows, ranks)):
                near = rank_tiles.Tiles(columns, rows, ranks).near_faces(columns, rows)
                self.assertEqual([ranks_model.velocity_bytes(columns, rows)] + [0] * (ranks - 1), counted["collect bytes"])
                self.assertEqual([ranks_model.field_bytes(near.sum())] + [0] * (ranks - 1), counted["deal_out bytes"])

    def test_all_ranks_exchange_alike_and_no_more_on_a_larger_mesh(self):
        calls = {name: {value for counted in self.counted.values() for value in counted[name]} for name in self.counted[BOXES[0]] if name.endswith(" calls")}
        for name, values in calls.items():
            with self.subTest(name):
                self.assertEqual(1, len(values), values)
        self.assertEqual({0.0}, calls["swap calls"], "no particle changes ranks in these steps")
        for of_all in ("share calls", "follow_first calls"):
            self.assertEqual({0.0}, calls[of_all], "nothing goes to all but totals")


class Perimeter(unittest.TestCase):
    def test_of_squares_of_tiles_is_the_closed_form(self):
        for tiles, ranks, factor in ((4096, 64, 1.0), (4096, 256, 1.0), (4096, 128, 3 / 8**0.5)):
            mean, longest = rank_tiles.shape_factor(tiles, ranks)
            self.assertAlmostEqual(factor, mean)
            self.assertAlmostEqual(factor, longest)

    def test_gives_the_bytes_of_a_large_box(self):
        """Pieces of any number of tiles: within a quarter of those of the mean shape, since c is 1 to 1.5 and pieces at the
        edges of the box have shorter rims."""
        for particles, ranks in ((4e7, 64), (4e7, 100), (4e7, 333), (2e8, 1000)):
            with self.subTest((particles, ranks)):
                nodes, neighbours = rank_tiles.Tiles(*ranks_model.box(particles), ranks).sent()
                self.assertAlmostEqual(1.0, nodes.mean() * ranks_model.FIELDS * ranks_model.NUMBER / ranks_model.halo_bytes(particles, ranks), delta=0.25)
                self.assertAlmostEqual(ranks_model.NEIGHBOURS, neighbours.mean(), delta=1.0)


    def test_gives_the_near_faces_of_a_large_box(self):
        """The fullest rank has those of a piece in a corner, within a quarter; all together have what the model passes."""
        for particles, ranks in ((4e7, 64), (4e7, 100), (4e7, 333)):
            with self.subTest((particles, ranks)):
                columns, rows = ranks_model.box(particles)
                near = rank_tiles.Tiles(columns, rows, ranks).near_faces(columns, rows)
                self.assertAlmostEqual(1.0, near.max() / ranks_model.near_faces(particles, ranks), delta=0.25)
                self.assertAlmostEqual(1.0, near.sum() / ranks_model.passed_faces(particles, ranks), delta=0.25)


if __name__ == "__main__":
    unittest.main()
