"""Small cases for the tests of free fields, and the `tremolo` command on them."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1] / "runs"))

import numpy as np
import small_case
from tremolo import column

HALFSPACE = "density = 1700.0\nyoung = 40e6\npoisson = 0.28"  # c_s 95.9 m/s, c_p 173 m/s

FLAT = """
[soil.box]
model = "linear_elastic"
density = 1700.0
young = 40e6
poisson = 0.28

[[region]]
soil = "box"
polygon = [[0.0, -10.0], [20.0, -10.0], [20.0, 0.0], [0.0, 0.0]]
"""

STIFF = "density = 1900.0\nvs = 200.0\nvp = 400.0"

LAYERED = """
[[profile]]
thickness = 4.0
soil = "soft"

[[profile]]
thickness = 8.0
soil = "firm"

[soil.soft]
model = "linear_elastic"
density = 1600.0
vs = 80.0
vp = 160.0

[soil.firm]
model = "linear_elastic"
density = 1700.0
vs = 120.0
vp = 240.0

[[region]]
soil = "soft"
polygon = [[0.0, -4.0], [20.0, -4.0], [20.0, 0.0], [0.0, 0.0]]

[[region]]
soil = "firm"
polygon = [[0.0, -10.0], [20.0, -10.0], [20.0, -4.0], [0.0, -4.0]]
"""

BOX = """
title = "free fields at a small box"

[motion]
pulse = {{ shape = "ricker", frequency = {frequency}, time = {peak_time}, velocity = 0.1 }}
wave = "SV"
angle_deg = {angle}
reference = [0.0, {reference}]

[surface]
level = 0.0

[halfspace]
{halfspace}
{ground}
[mesh]
size = 0.5
box = [0.0, -10.0, {width}, {top}]

[boundary]
left = {{ {left} }}
right = {{ {right} }}
base = {{ {base} }}

[[stage]]
kind = "shaking"
duration_s = {duration}

[[monitor]]
name = "surface"
point = [{middle}, {monitor}]

[[monitor]]
name = "inside"
point = [5.0, -7.0]

[output]
every_s = 1.0
history_every_s = 0.005
"""


def model(name, **others):
    """Keys of a side or the base."""
    return ", ".join([f'model = "{name}"', *(f'{key} = {value!r}'.replace("'", '"') for key, value in others.items())])


class BoxWorkspace(small_case.Workspace):
    """A box of 20 m x 10 m with cells of 0.5 m; 30 cells to the shear wavelength at 6 Hz."""

    template = BOX
    defaults = {"frequency": 3.0, "peak_time": 0.5, "angle": 0.0, "reference": -12.0, "halfspace": HALFSPACE, "ground": FLAT,
                "top": 0.0, "width": 20.0, "middle": 10.0, "monitor": 0.0, "left": model("wave"), "right": model("wave"), "base": model("wave"),
                "duration": 1.2}


COLUMN = """
title = "a column"

[motion]
{motion}
wave = "SV"
angle_deg = 0.0
reference = [0.0, -20.0]

[surface]
level = 0.0

[halfspace]
density = 2000.0
vs = 400.0
vp = 800.0
{ground}
[fe]
element_size = {size}

[ode]
cell_size = {size}
relative_tolerance = 1e-7
absolute_tolerance = 1e-10
"""


class ColumnWorkspace(small_case.Workspace):
    """A free field of 20 m over rock, without a domain; what `ode` errs by is that of its cells."""

    template = COLUMN

    def histories(self, name, *arguments):
        """Runs `tremolo column` with a model; the histories from the surface down, arrays by column."""
        out = self.path / f"{name}.h5"
        result = self.command("column", self.case, "--model", name, "--out", out, *arguments)
        assert result.returncode == 0, result.stdout + result.stderr
        return column.read(out)[1]


def with_frames(work):
    """The workspace, with 20 frames of particles a second."""
    work.case.write_text(work.case.read_text().replace("every_s = 1.0", "every_s = 0.05"))
    return work


def unevenness(run):
    """Largest difference of velocities at one level, over all frames, relative to the largest velocity."""
    level = np.round(run.field(0, "position")[:, 1] - run.field(0, "displacement")[:, 1], 6)
    largest = difference = 0.0
    for index in range(len(run.times)):
        velocity = run.field(index, "velocity")
        largest = max(largest, abs(velocity).max())
        for y in np.unique(level):
            row = velocity[level == y]
            difference = max(difference, (row.max(axis=0) - row.min(axis=0)).max())
    return difference / largest


def stages(duration):
    """Gravity, then so many seconds of shaking."""
    return f'\n[[stage]]\nkind = "gravity"\n\n[[stage]]\nkind = "shaking"\nduration_s = {duration}\n'


# 20 m of loose sand with its water table at 2 m.
LIQUEFYING = """
[water]
level = -2.0

[[profile]]
thickness = 20.0
soil = "sand"

[soil.sand]
library = "pm4sand_dr35"
permeability = 1e-4
rest_coefficient = 0.5
"""
