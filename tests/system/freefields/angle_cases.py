"""Flat ground of any soil under a wave at 15 degrees in the rock, and a domain in it, for the tests of free fields."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1] / "runs"))

import small_case

PLACES = (4.0, 12.0, 20.0)  # x of the monitors, m
DEPTHS = (0.25, 3.25, 8.25)

GROUND = """
[soil.soft]
{soft}
[soil.firm]
{firm}
[[profile]]
thickness = 6.0
soil = "soft"

[[profile]]
thickness = 4.0
soil = "firm"
"""

FLAT = """
title = "flat ground under a wave at an angle"

[motion]
pulse = {{ shape = "ricker", frequency = 3.0, time = 0.6, velocity = {velocity} }}
wave = "SV"
angle_deg = 15.0
reference = [0.0, -10.0]

[surface]
level = 0.0

[halfspace]
density = 2400.0
vs = 760.0
vp = 1900.0
{water}
{ground}
[[region]]
soil = "soft"
polygon = [[0.0, -6.0], [24.0, -6.0], [24.0, 0.0], [0.0, 0.0]]

[[region]]
soil = "firm"
polygon = [[0.0, -10.0], [24.0, -10.0], [24.0, -6.0], [0.0, -6.0]]

[mesh]
size = 1.0
box = [0.0, -10.0, 24.0, 0.0]

[boundary]
left = {{ model = "{model}" }}
right = {{ model = "{model}" }}
base = {{ model = "{model}", form = "{form}" }}

[[stage]]
kind = "gravity"

[[stage]]
kind = "shaking"
duration_s = {duration}
{monitors}
[output]
every_s = 1.0
history_every_s = 0.002
"""

MONITORS = "".join(f'\n[[monitor]]\nname = "{place}-{depth}"\npoint = [{place}, -{depth}]\n' for place in PLACES for depth in DEPTHS)

ELASTIC = GROUND.format(soft='model = "linear_elastic"\ndensity = 1800.0\nvs = 150.0\nvp = 300.0\n',
                        firm='model = "linear_elastic"\ndensity = 2000.0\nvs = 300.0\nvp = 600.0\n')
STRENGTH = "cohesion = {}\nfriction_deg = {}\nrest_coefficient = 0.9\n"
CONE = 'model = "drucker_prager"\n'
PLASTIC = GROUND.format(soft=CONE + "density = 1800.0\nvs = 150.0\nvp = 300.0\n" + STRENGTH.format(15e3, 22.0),
                        firm=CONE + "density = 2000.0\nvs = 300.0\nvp = 600.0\n" + STRENGTH.format(40e3, 28.0))
# c_s = 150 and 300 m/s with the saturated density.
PORES = 'porosity = {}\ndrainage = "undrained"\nyoung = {}\npoisson = 0.3\n'
UNDRAINED = GROUND.format(soft=CONE + PORES.format(0.42, 114.5e6) + STRENGTH.format(12e3, 22.0),
                          firm=CONE + PORES.format(0.35, 485e6) + STRENGTH.format(40e3, 28.0))
LIQUEFYING = 'library = "pdmy03_dr57"\npermeability = 1e-4\nrest_coefficient = 0.5\n'
SAND = GROUND.format(soft=LIQUEFYING, firm=LIQUEFYING)
WATER = "[water]\nlevel = 0.0\n"


class FlatWorkspace(small_case.Workspace):
    template = FLAT
    defaults = {"velocity": 0.2, "water": "", "ground": ELASTIC, "model": "fe", "form": "total", "duration": 1.2, "monitors": MONITORS}
