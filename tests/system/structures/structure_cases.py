"""Small cases with a structure: a block on flat ground, a frame that is cut, a light tunnel below a water table, its lining,
and a lining with hinges in dry ground."""

import sys
from pathlib import Path

sys.path[:0] = [str(Path(__file__).parents[1] / "resume")]

from broken_run import checkpoints, differences, resumes_with_the_same_bits, whole_run, with_checkpoints
from small_case import Workspace

__all__ = ["AnchoredWorkspace", "BlockWorkspace", "FrameWorkspace", "LinedWorkspace", "TunnelWorkspace", "WetLinedWorkspace", "checkpoints",
           "differences", "resumes_with_the_same_bits", "whole_run", "with_checkpoints"]

STAGES = """
[[stage]]
kind = "gravity"

[[stage]]
kind = "shaking"
duration_s = {duration}
"""

BLOCK = """
title = "block"

[motion]
pulse = {{ shape = "ricker", frequency = 3.0, time = 0.5, velocity = {velocity} }}
wave = "SV"
angle_deg = {angle}
reference = [0.0, -4.0]

[surface]
level = 0.0

[halfspace]
density = 1900.0
young = 200e6
poisson = 0.3

[soil.ground]
model = "linear_elastic"
density = 1900.0
young = 200e6
poisson = 0.3

[[region]]
soil = "ground"
polygon = [[-8.0, -4.0], [8.0, -4.0], [8.0, 0.0], [-8.0, 0.0]]

[[structure]]
name = "block"
polygon = [[-2.0, 0.0], [2.0, 0.0], [2.0, 1.0], [-2.0, 1.0]]
density = 2000.0
{kind}
friction = {friction}

[mesh]
size = 0.5
box = [-8.0, -4.0, 8.0, 0.0]

[boundary]
left = {{ model = "wave" }}
right = {{ model = "wave" }}
base = {{ model = "wave" }}
""" + STAGES + """
[[monitor]]
name = "ground"
point = [5.75, -0.25]

[[monitor]]
name = "roof"
point = [2.0, 1.0]
structure = "block"

[[monitor]]
name = "centre"
point = [0.0, 0.5]
structure = "block"

[output]
every_s = 0.1
history_every_s = 0.005
"""


class BlockWorkspace(Workspace):
    """4 m by 1 m of concrete on flat elastic ground: 78.48 kN/m."""

    template, defaults = BLOCK, {"velocity": 0.2, "angle": 15.0, "duration": 1.0, "kind": "rigid = true", "friction": 0.5}
    weight = 8000.0 * 9.81  # N/m


FRAME = BLOCK.replace("polygon = [[-2.0, 0.0], [2.0, 0.0], [2.0, 1.0], [-2.0, 1.0]]", """polygon = [[-2.0, 0.0], [2.0, 0.0], [2.0, 4.0], [-2.0, 4.0]]
hole = [[-1.0, 1.0], [1.0, 1.0], [1.0, 3.0], [-1.0, 3.0]]""").replace("[mesh]", """[[section]]
name = "left"
structure = "block"
from = [-2.5, 2.0]
to = [-0.5, 2.0]

[[section]]
name = "right"
structure = "block"
from = [0.5, 2.0]
to = [2.5, 2.0]

[[section]]
name = "sill"
structure = "block"
from = [-2.0, 0.75]
to = [2.0, 0.75]

[[section]]
name = "around"
structure = "block"
ring = {{ centre = [0.0, 2.0], inner = 1.0, outer = 3.0, count = 8 }}

[mesh]""")


class FrameWorkspace(Workspace):
    """An elastic frame of 4 m by 4 m with walls of 1 m on flat ground, 235.44 kN/m, and cuts through it."""

    template = FRAME
    defaults = BlockWorkspace.defaults | {"kind": "young = 500e6\npoisson = 0.2", "velocity": 0.1}
    weight = 24000.0 * 9.81  # N/m


ANCHORED = BLOCK.replace("[mesh]", """[[prop]]
name = "anchor"
from = {{ structure = "block", at = [0.0, 0.5] }}
to = {{ at = [0.0, -2.5] }}
stiffness = 2e7
prestress = 60e3
bears = "tension"

[mesh]""", 1).replace("[[stage]]\nkind = \"shaking\"", "[[stage]]\nkind = \"construction\"\nname = \"tie\"\nplace = [\"anchor\"]\n\n"
                      "[[stage]]\nkind = \"shaking\"")


class AnchoredWorkspace(BlockWorkspace):
    """The block, tied to the ground below it by a prestress of 60 kN/m in a stage of its own."""

    template = ANCHORED
    prestress = 60e3  # N/m


TUNNEL = """
title = "tunnel"

[motion]
pulse = {{ shape = "ricker", frequency = 2.0, time = 0.7, velocity = 0.1 }}
wave = "SV"
angle_deg = 0.0
reference = [0.0, -12.0]

[surface]
level = 0.0

[water]
level = 0.0

[halfspace]
density = 2000.0
young = 100e6
poisson = 0.45

[soil.sand]
model = "linear_elastic"
porosity = 0.4
permeability = 1e-3
drainage = "{drainage}"
young = 60e6
poisson = 0.3

[[region]]
soil = "sand"
polygon = [[-10.0, -12.0], [10.0, -12.0], [10.0, 0.0], [-10.0, 0.0]]

[[structure]]
name = "tunnel"
circle = {{ centre = [0.0, -6.0], radius = 2.5 }}
hole_circle = {{ centre = [0.0, -6.0], radius = 2.2 }}
density = 1800.0
rigid = true
friction = 0.4

[mesh]
size = 1.0
box = [-10.0, -12.0, 10.0, 0.0]

[boundary]
sides = "periodic"
base = {{ model = "wave" }}
""" + STAGES + """
[[monitor]]
name = "crown"
point = [0.0, -3.6]
structure = "tunnel"

[output]
every_s = 0.2
history_every_s = 0.01
"""


class TunnelWorkspace(Workspace):
    """A tunnel of 5 m across that weighs less than the water that it displaces."""

    template, defaults = TUNNEL, {"drainage": "undrained", "duration": 2.0}


class WetLinedWorkspace(Workspace):
    """Its lining, a beam, in its place."""

    template = TUNNEL.replace(TUNNEL[TUNNEL.index("[[structure]]"):TUNNEL.index("[mesh]")], """[[lining]]
name = "ring"
circle = {{ centre = [0.0, -6.0], radius = 2.5 }}
thickness = 0.3
young = 30e9
poisson = 0.2
density = 1800.0
friction = 0.4

""").replace(TUNNEL[TUNNEL.index("[[monitor]]"):TUNNEL.index("[output]")], """[[monitor]]
name = "beside"
point = [4.25, -6.25]

""")
    defaults = TunnelWorkspace.defaults


LINED = """
title = "lined"

[motion]
pulse = {{ shape = "ricker", frequency = 3.0, time = 0.5, velocity = 0.05 }}
wave = "SV"
angle_deg = 0.0
reference = [0.0, -12.0]

[surface]
level = 0.0

[halfspace]
density = 1900.0
vs = 250.0
vp = 467.7

[soil.ground]
model = "linear_elastic"
density = 1900.0
vs = 250.0
poisson = 0.3

[[region]]
soil = "ground"
polygon = [[-9.0, -12.0], [9.0, -12.0], [9.0, 0.0], [-9.0, 0.0]]

[[lining]]
name = "ring"
circle = {{ centre = [0.3, -6.1], radius = 2.6 }}
thickness = 0.25
young = 30e9
poisson = 0.2
density = 2500.0
friction = 0.6
hinges = [[0.3, -3.5], [2.9, -6.1], [-2.3, -6.1]]

[mesh]
size = 1.0
box = [-9.0, -12.0, 9.0, 0.0]

[boundary]
sides = "periodic"
base = {{ model = "wave" }}
""" + STAGES + """
[[monitor]]
name = "surface"
point = [0.0, 0.0]

[output]
every_s = 0.2
history_every_s = 0.005
"""


class LinedWorkspace(Workspace):
    """A ring of 2.6 m with three hinges, its axis 6.1 m deep."""

    template, defaults = LINED, {"duration": 1.0}
