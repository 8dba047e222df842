"""Saturated ground on a shaking table: between periodic sides it is the column of finite elements on a rigid base, and a container of
it has the same bits however many threads and processes compute it.

    usage: test_wet_table.py TREMOLO PYTHON_PACKAGE_DIR
"""

import sys
import unittest
from pathlib import Path

TREMOLO, PACKAGE = sys.argv.pop(1), sys.argv.pop(1)
sys.path[:0] = [PACKAGE, str(Path(__file__).parent), str(Path(__file__).parents[1] / "resume")]

import numpy as np
import small_case
from broken_run import differences
from tremolo import Run, pore_pressure

GROUND = """title = "wet ground on a table"

[motion]
pulse = {{ shape = "ricker", frequency = 1.5, time = 0.8, velocity = 0.35 }}
kind = "within"
wave = "SV"
{angle}
[water]
level = 0.0

[soil.sand]
{soil}
permeability = 1e-3
rest_coefficient = 0.5
damping = 0.005

[damping]
model = "kelvin_voigt"
reference_hz = 5.0

[[stage]]
kind = "gravity"

[[stage]]
kind = "shaking"
duration_s = {duration}
"""
DOMAIN = GROUND + """
[[region]]
soil = "sand"
polygon = [[0.0, -6.0], [2.0, -6.0], [2.0, 0.0], [0.0, 0.0]]

[mesh]
size = 0.5
box = [0.0, -6.0, 2.0, 0.0]

[boundary]
sides = "{sides}"
base = {{ model = "shaking_table" }}

[[monitor]]
name = "1.25 m"
point = [1.0, -1.25]

[[monitor]]
name = "3.25 m"
point = [1.0, -3.25]

[output]
every_s = 0.5
history_every_s = 0.01
"""
COLUMN = GROUND + small_case.SAND_ON_ROCK + """
[fe]
element_size = 0.25
"""
DEPTHS = (1.25, 3.25)  # m
ELASTIC = 'model = "linear_elastic"\ngrain_density = 2650.0\nporosity = 0.4\nyoung = 80e6\npoisson = 0.3'
SAND = 'library = "pm4sand_dr55"'


class Domain(small_case.Workspace):
    template = DOMAIN
    defaults = {"angle": "", "soil": ELASTIC, "sides": "periodic", "duration": 1.5}


class Column(small_case.Workspace):
    template = COLUMN
    defaults = {"angle": "angle_deg = 0.0\nreference = [0.0, -6.0]\n", "soil": ELASTIC, "duration": 1.5}

    def histories(self):
        out = self.path / "column.h5"
        done = self.command("column", self.case, "--model", "fe", "--out", out, "--depths", ",".join(map(str, DEPTHS)), "--every", 0.01)
        assert done.returncode == 0, done.stdout + done.stderr
        levels, histories, *_ = pore_pressure.read(out)
        return [histories[int(np.argmin(np.abs(levels + depth)))] for depth in DEPTHS]


def difference(monitor, history, name, end):
    """rms of the difference of two histories, over the largest value of the second one."""
    time = np.arange(0.05, end, 0.01)
    one, other = (np.interp(time, series["time"], series[name]) for series in (monitor, history))
    return float(np.sqrt(np.mean((one - other) ** 2)) / np.abs(other).max())


class BesideTheColumn(unittest.TestCase):
    def compare(self, soil, duration, **bounds):
        with Domain(TREMOLO, soil=soil, duration=duration) as work, Column(TREMOLO, soil=soil, duration=duration) as beside:
            histories = beside.histories()
            with Run(work.run("run")) as run:
                for depth, history in zip(DEPTHS, histories):
                    for name, bound in bounds.items():
                        found = difference(run.monitor(f"{depth} m"), history, name, duration - 0.02)
                        self.assertLess(found, bound, f"{name}, {depth} m")
                energy = run.energy
                self.assertLess(np.abs(energy["residual"]).max(), 1e-3 * np.abs(energy["input"]).max())

    def test_acceptance_elastic_ground_moves_alike(self):
        self.compare(ELASTIC, 1.5, vx=5e-3)

    def test_sand_builds_up_the_same_pressure(self):
        self.compare(SAND, 1.5, vx=3e-2, pore_pressure_ratio=2e-2)


class Container(unittest.TestCase):
    def test_has_the_same_bits_for_threads_and_modes(self):
        with Domain(TREMOLO, soil=SAND, sides="container", duration=0.2) as work:
            one = work.run("one", "--threads", 1)
            for name, options in (("threads", ["--threads", 2]), ("lockstep", ["--mode", "lockstep"])):
                self.assertEqual([], differences(work.run(name, *options), one), name)

    def test_acceptance_has_the_same_bits_for_two_processes(self):
        with Domain(TREMOLO, soil=SAND, sides="container", duration=0.2) as work:
            one = work.run("one", "--threads", 1)
            ranks = work.command("run", work.case, "--out", work.path / "ranks", "--ranks", 2, "--oversubscribe", "--threads", 1)
            if "has no MPI" not in ranks.stderr:
                self.assertEqual(0, ranks.returncode, ranks.stdout + ranks.stderr)
                self.assertEqual([], differences(work.path / "ranks", one))

    def test_stands_still_on_a_table_at_rest(self):
        with Domain(TREMOLO, sides="container", duration=0.5) as work:
            work.case.write_text(work.case.read_text().replace("velocity = 0.35", "velocity = 1e-9"))
            with Run(work.run("run")) as run:
                self.assertLess(np.abs(run.field(-1, "velocity")).max(), 1e-6)


if __name__ == "__main__":
    unittest.main()
