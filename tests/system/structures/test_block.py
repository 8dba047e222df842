"""A block on flat ground from its case to its pictures: it bears on the soil with its weight, its contact nodes add up to its
forces, a monitor moves with it, and a run that is killed goes on with the same bits.

    usage: test_block.py TREMOLO SOURCE_DIR
"""

import functools
import sys
import unittest
from pathlib import Path

TREMOLO, SOURCE = sys.argv.pop(1), Path(sys.argv.pop(1))
sys.path[:0] = [str(SOURCE / "python"), str(Path(__file__).parent)]

import numpy as np
from structure_cases import BlockWorkspace, checkpoints, differences, resumes_with_the_same_bits, whole_run, with_checkpoints
from tremolo import Run


SLOPE = SOURCE / "cases" / "block_on_slope" / "case.toml"


def on_slope(along):
    """A block of 2 m by 1 m on the slope of 20 degrees, so many m up from the origin."""
    c, s = np.cos(np.radians(20.0)), np.sin(np.radians(20.0))
    return [[(along + x) * c - y * s, (along + x) * s + y * c] for x, y in ((-1, 0), (1, 0), (1, 1), (-1, 1))]


@functools.cache
def shaken(kind):
    """A block of a kind, and its run."""
    work = BlockWorkspace(TREMOLO, kind=kind)
    unittest.addModuleCleanup(work.__exit__)
    return work, work.run("run")


class EitherKind:
    """What a rigid and an elastic block have to do."""

    def test_bears_on_the_ground_with_its_weight(self):
        with BlockWorkspace(TREMOLO, velocity=1e-6, kind=self.kind) as work, Run(work.run("run")) as run:
            block = run.body("block")
            np.testing.assert_allclose(block["weight_y"], -work.weight, rtol=1e-12)
            np.testing.assert_allclose(block["normal_y"] + block["friction_y"], work.weight, rtol=5e-3)
            np.testing.assert_allclose(block["normal_x"] + block["friction_x"], 0.0, atol=5e-3 * work.weight)
            self.assertFalse(block["water_y"].any())

    def test_resumed_after_a_kill_it_gives_the_same_bits(self):
        with with_checkpoints(BlockWorkspace(TREMOLO, duration=0.8, kind=self.kind), every_steps=200) as work:
            whole = whole_run(work)
            resumes_with_the_same_bits(self, work, whole, checkpoints(whole)[-1] // 3)

    def test_a_sliding_block_has_the_same_bits_for_any_number_of_threads(self):
        with BlockWorkspace(TREMOLO, kind=self.kind, friction=0.05) as work:
            one, *others = (work.run(f"threads_{n}", "--threads", n) for n in (1, 3))
            with Run(one) as run:
                block, ground = run.body("block"), run.monitor("ground")
                slip = np.ptp(np.array(block["x"]) - block["x"][0] - np.interp(block["time"], ground["time"], ground["ux"]))
                self.assertGreater(slip, 0.01)  # m
            for other in others:
                self.assertEqual([], differences(other, one))

    def test_acceptance_pictures(self):
        work, folder = shaken(self.kind)
        done = work.command("plot", folder)
        self.assertEqual(0, done.returncode, done.stdout + done.stderr)
        names = [Path(line).name for line in done.stdout.split()]
        for name in ("model.png", "acceleration.png", "bodies.png", "monitor_roof.png"):
            self.assertIn(name, names)
            self.assertGreater((folder / "pictures" / name).stat().st_size, 10_000)


RIGID = "rigid = true"


class Rigid(EitherKind, unittest.TestCase):
    kind = RIGID


class AcceptanceElastic(EitherKind, unittest.TestCase):
    kind = "young = 500e6\npoisson = 0.2"


class Block(unittest.TestCase):
    def test_acceptance_a_stiff_block_moves_as_a_rigid_one(self):
        """Velocities within 2 % of the largest; the elastic one sways a little by itself."""
        histories = []
        for kind in ("rigid = true", "young = 5e9\npoisson = 0.2"):
            with BlockWorkspace(TREMOLO, kind=kind) as work, Run(work.run("run")) as run:
                histories.append({name: np.array(run.body("block")[name]) for name in ("time", "vx", "vy")})
        rigid, stiff = histories
        most = max(np.abs(rigid["vx"]).max(), np.abs(rigid["vy"]).max())
        for name in ("vx", "vy"):
            at_once = np.interp(rigid["time"], stiff["time"], stiff[name])
            np.testing.assert_allclose(at_once, rigid[name], rtol=0, atol=0.02 * most)

    def test_of_blocks_on_a_slope_those_that_slide_are_named(self):
        holds = f'''
[[structure]]
name = "rough"
polygon = {[[float(x), float(y)] for x, y in on_slope(2.7)]}
density = 2000.0
rigid = true
friction = 0.6
'''
        with BlockWorkspace(TREMOLO) as work:
            work.case.write_text(SLOPE.read_text().replace("duration_s = 0.8", "duration_s = 0.1") + holds)
            done = work.command("run", work.case, "--out", work.path / "run")
            self.assertEqual(0, done.returncode, done.stdout + done.stderr)
            self.assertIn("cannot hold structure 'block' under gravity: it stays in place until", done.stdout + done.stderr)
            with Run(work.path / "run") as run:
                self.assertEqual(["block", "rough"], run.bodies)
                self.assertEqual({0, 1}, set(run.contact(0)["body"]))
                block, rough = (np.ptp(run.body(name)["x"]) for name in run.bodies)
                self.assertLess(rough, 0.01 * block)  # the rock under both springs back by some micrometres

    def test_contact_nodes_add_up_to_the_forces(self):
        work, folder = shaken(RIGID)
        with Run(folder) as run:
            block = run.body("block")
            self.assertGreater(np.abs(block["friction_x"]).max(), 0.05 * work.weight)
            for index, time in enumerate(run.times):
                nodes = run.contact(index)
                self.assertEqual({0}, set(nodes["body"]))
                normal = nodes["normal"]
                tangent = np.column_stack([-normal[:, 1], normal[:, 0]])
                [row] = np.flatnonzero(np.isclose(block["time"], time, rtol=0, atol=1e-9))
                for name, direction in (("normal", normal), ("friction", tangent), ("water", normal)):
                    force = (nodes[f"{name}_force"][:, None] * direction).sum(axis=0)
                    for component, axis in zip(force, "xy"):
                        self.assertAlmostEqual(component, block[f"{name}_{axis}"][row], delta=1e-9 * work.weight)
                self.assertTrue((np.abs(nodes["friction_force"]) <= 0.5 * nodes["normal_force"] + 1e-9 * work.weight).all())

    def test_a_monitor_moves_with_the_block(self):
        work, folder = shaken(RIGID)
        with Run(folder) as run:
            block, roof = run.body("block"), run.monitor("roof")
            place = {time: block.corners(time)[0] for time in roof["time"]}
            corner = np.argmin(np.linalg.norm(block.outline - [2.0, 1.0], axis=1))
            found = np.array([place[time][corner] for time in roof["time"]])
            np.testing.assert_allclose(np.column_stack([roof["x"], roof["y"]]), found, rtol=0, atol=1e-9)
            self.assertGreater(np.abs(roof["vx"]).max(), 0.1)
            # Mass times the acceleration of the centre is the sum of all forces.
            centre = run.monitor("centre")
            for axis in "xy":
                force = sum(block[f"{name}_{axis}"] for name in ("normal", "friction", "water", "weight"))
                np.testing.assert_allclose(block.mass * centre[f"a{axis}"], force, rtol=0, atol=1e-6 * work.weight)
            self.assertGreater(np.abs(centre["ax"]).max(), 1.0)


if __name__ == "__main__":
    unittest.main()
