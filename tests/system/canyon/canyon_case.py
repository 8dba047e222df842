"""A canyon, 16 m deep, under an SV pulse, as a case."""

import numpy as np
from half_space_uneven import Medium

DEPTH, SIGMA = 16.0, 10.0  # m
GROUND = Medium(density=1800.0, vs=200.0, vp=370.0)
VELOCITY, FREQUENCY, ARRIVAL = 0.01, 2.5, 1.0  # m/s, Hz, s: of the incident wave at (0, 0)

CASE = """
title = "canyon"

[motion]
pulse = {{ shape = "ricker", frequency = {frequency}, time = {arrival}, velocity = {velocity} }}
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

[[region]]
soil = "ground"
polygon = [[-80.0, -64.0], [80.0, -64.0], [80.0, 0.0], {surface}, [-80.0, 0.0]]

[mesh]
size = {size}
box = [-80.0, -64.0, 80.0, 0.0]

[boundary]
left = {{ model = "wave", absorber = "{absorber}" }}
right = {{ model = "wave", absorber = "{absorber}" }}
base = {{ model = "wave", form = "total", absorber = "{absorber}" }}

[[stage]]
kind = "shaking"
duration_s = 2.6

[output]
every_s = 0.02
fields = ["velocity"]
"""


def write(file, angle_deg, size, absorber):
    x = np.linspace(5.0 * SIGMA, -5.0 * SIGMA, 401)
    surface = ", ".join(f"[{a:.6f}, {b:.6f}]" for a, b in zip(x, -DEPTH * np.exp(-0.5 * (x / SIGMA) ** 2)))
    file.write_text(CASE.format(frequency=FREQUENCY, arrival=ARRIVAL, velocity=VELOCITY, angle=angle_deg, size=size, absorber=absorber,
                                ground=GROUND, surface=surface))
    return file


def pulse(t):
    """Velocity of the incident wave at (0, 0), m/s."""
    a = (np.pi * FREQUENCY * (t - ARRIVAL)) ** 2
    return VELOCITY * (1.0 - 2.0 * a) * np.exp(-a)
