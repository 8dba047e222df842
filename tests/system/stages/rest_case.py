"""Sand that is shaken until it liquefies, and rests: 2 m wide, 6 m deep, in cells of 1 m."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "runs"))

import small_case

CASE = """
title = "sand that rests"

[motion]
pulse = {{ shape = "ricker", frequency = 1.5, time = 1.0, velocity = 0.35 }}
wave = "SV"
angle_deg = 0.0
reference = [0.0, -6.0]
""" + small_case.SAND_ON_ROCK + """
[water]
level = 0.0

[soil.sand]
library = "pm4sand_dr55"
permeability = {permeability}
rest_coefficient = 0.5
damping = 0.005
{soil}
[damping]
model = "kelvin_voigt"
reference_hz = 5.0

[[region]]
soil = "sand"
polygon = [[0.0, -6.0], [2.0, -6.0], [2.0, 0.0], [0.0, 0.0]]

[mesh]
size = 1.0
box = [0.0, -6.0, 2.0, 0.0]

[time]
fraction = 0.8

[fe]
element_size = 0.5

[boundary]
{boundary}
base = {{ model = "mpm", form = "total" }}

[[stage]]
kind = "gravity"
{load}
[[stage]]
kind = "shaking"
duration_s = {shaking}
{rest}
[[monitor]]
name = "surface"
point = [1.0, 0.0]

[[monitor]]
name = "2.5 m"
point = [1.25, -2.5]

[output]
every_s = 0.5
history_every_s = 0.05
"""

BESIDE_COLUMNS = 'left = { model = "mpm" }\nright = { model = "mpm" }'


def rest(duration, **keys):
    """A stage of rest; a key's value is as TOML has it."""
    lines = "".join(f"{key} = {value}\n" for key, value in keys.items())
    return f'\n[[stage]]\nkind = "rest"\nduration_s = {duration}\n{lines}'


def replayed(text):
    """The case whose free fields are replayed from the exchange that its own run has recorded."""
    for side in ("left", "right", "base"):
        text = text.replace(f'{side} = {{ model = "mpm"', f'{side} = {{ model = "recording", file = "run/exchange.h5", side = "{side}"')
    return text


class RestWorkspace(small_case.Workspace):
    template = CASE
    defaults = {"permeability": 1e-3, "soil": "", "boundary": BESIDE_COLUMNS, "load": "", "shaking": 3.0, "rest": ""}
