"""A canyon, 16 m deep, under an SV pulse, as a case."""

import numpy as np
from elastic_ground import Pulse, head

DEPTH, SIGMA = 16.0, 10.0  # m
pulse = Pulse(velocity=0.01, frequency=2.5, arrival=1.0)

CASE = """
[[region]]
soil = "ground"
polygon = [[-80.0, -64.0], [80.0, -64.0], [80.0, 0.0], {surface}, [-80.0, 0.0]]

[mesh]
size = {size}
box = [-80.0, -64.0, 80.0, 0.0]

[boundary]
left = {{ model = "wave", {absorber} }}
right = {{ model = "wave", {absorber} }}
base = {{ model = "wave", form = "total", {absorber} }}

[[stage]]
kind = "shaking"
duration_s = 2.6

[output]
every_s = 0.02
fields = ["velocity"]
"""


ABSORBERS = {"matched_layer": 'absorber = "matched_layer"', "dashpots": "spring = false", "springs": "spring = [1.0, 0.5]"}


def write(file, angle_deg, size, absorber):
    x = np.linspace(5.0 * SIGMA, -5.0 * SIGMA, 401)
    surface = ", ".join(f"[{a:.6f}, {b:.6f}]" for a, b in zip(x, -DEPTH * np.exp(-0.5 * (x / SIGMA) ** 2)))
    file.write_text(head("canyon", pulse, angle_deg) + CASE.format(size=size, absorber=ABSORBERS[absorber], surface=surface))
    return file
