"""Elastic ground under an SV pulse, as a case: what the cases of this folder share."""

from dataclasses import dataclass

import numpy as np
from half_space_uneven import Medium

GROUND = Medium(density=1800.0, vs=200.0, vp=370.0)


@dataclass
class Pulse:
    """The Ricker pulse of velocity (m/s) of the incident wave at (0, 0): Hz, and s of its peak."""

    velocity: float
    frequency: float
    arrival: float

    def __call__(self, t):
        a = (np.pi * self.frequency * (t - self.arrival)) ** 2
        return self.velocity * (1.0 - 2.0 * a) * np.exp(-a)


HEAD = """
title = "{title}"

[motion]
pulse = {{ shape = "ricker", frequency = {pulse.frequency}, time = {pulse.arrival}, velocity = {pulse.velocity} }}
wave = "SV"
angle_deg = {angle}
reference = [0.0, 0.0]

[surface]
level = 0.0

[halfspace]
density = {ground.density}
vs = {ground.vs}
vp = {ground.vp}

[soil.ground]
model = "linear_elastic"
density = {ground.density}
vs = {ground.vs}
vp = {ground.vp}
"""


def head(title, pulse, angle_deg):
    """Motion, ground and soil of a case, whose regions, mesh and boundary follow."""
    return HEAD.format(title=title, pulse=pulse, angle=angle_deg, ground=GROUND)
