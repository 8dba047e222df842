"""A smooth step of the ground's surface, 10 m high and 45 degrees steep, under an SV pulse, as a case."""

import numpy as np
from elastic_ground import GROUND, Pulse, head
from half_space_uneven import Trench, flat_ground

HEIGHT = 10.0  # m
pulse = Pulse(velocity=0.01, frequency=4.0, arrival=0.9)
HALF_WIDTH, DEPTH = 160.0, 60.0  # m, of the box
OTHER = 500.0  # m, to the far edge of the trench of which this step is the near one
TRENCH_ENDS = {"right": (-300.0, OTHER + 300.0), "left": (-OTHER - 300.0, 300.0)}  # m, of points without traction
ETA = 3.0  # 1/s, of the complex frequencies at which motions are compared
PLACES = (-30.0, -20.0, -10.0, -5.0, 0.0, 10.0, 20.0)  # m, of monitors from the middle of the step; the upper ground is at the left

CASE = """
[[region]]
soil = "ground"
polygon = [[-{width}, -{depth}], [{width}, -{depth}], {surface}]

[mesh]
size = {size}
box = [-{width}, -{depth}, {width}, 0.0]

[boundary]
left = {{ model = "wave", surface = {left}, absorber = "matched_layer" }}
right = {{ model = "wave", surface = {right}, absorber = "matched_layer" }}
base = {{ model = "wave", form = "blended", absorber = "matched_layer" }}

[[stage]]
kind = "shaking"
duration_s = 2.9

[output]
every_s = 2.9
history_every_s = 0.005
"""

MONITOR = """
[[monitor]]
name = "{name}"
point = [{x}, {y:.6f}]
"""


def trench(falling):
    """The surface: a step that falls to the right or to the left, and the other edge far away."""
    return Trench(HEIGHT, 0.0, OTHER) if falling == "right" else Trench(HEIGHT, -OTHER, 0.0)


def write(file, angle_deg, falling, size):
    shape, side = trench(falling), 1.0 if falling == "right" else -1.0
    x = np.linspace(HALF_WIDTH, -HALF_WIDTH, 641)
    levels = np.where(np.abs(x) > 5.0 * HEIGHT, np.where(side * x < 0.0, 0.0, -HEIGHT), shape.level(x))
    surface = ", ".join(f"[{a:.4f}, {b:.6f}]" for a, b in zip(x, levels))
    left, right = (0.0, -HEIGHT) if falling == "right" else (-HEIGHT, 0.0)
    text = head("step", pulse, angle_deg)
    text += CASE.format(size=size, width=HALF_WIDTH, depth=DEPTH, surface=surface, left=left, right=right)
    places = side * np.array(PLACES)
    text += "".join(MONITOR.format(name=f"place {i}", x=x, y=shape.level(x) - 0.25 * size) for i, x in enumerate(places))
    file.write_text(text)
    return file


def frequency(share):
    """s = eta + i omega where H is this share of the length of shear waves: exp(-eta t) takes away what the trench's other edge sends,
    which arrives more than a second late."""
    return ETA + 2j * np.pi * share * GROUND.vs / HEIGHT


def starts(series):
    """Where the monitors of these series began, [monitors, 2], m."""
    return np.array([[s["x"][0] - s["ux"][0], s["y"][0] - s["uy"][0]] for s in series])


def response(series, share):
    """Velocities [monitors, 2] of a run for an incident wave of unit velocity, at frequency(share)."""
    s, time = frequency(share), np.linspace(0.0, 2.9, 20001)
    incident = np.trapz(pulse(time) * np.exp(-s * time), time)
    return np.array([[np.trapz(m[v] * np.exp(-s * m["time"]), m["time"]) for v in ("vx", "vy")] for m in series]) / incident


def amplification(angle_deg, share, places, velocities):
    """Horizontal velocity over that of level ground with the surface of the upper side, 0.25 m below it."""
    level = np.stack([places[:, 0], np.full(len(places), -0.25)], axis=-1)
    return np.abs(velocities[:, 0] / flat_ground(GROUND, np.radians(angle_deg), frequency(share), level)[0][:, 0])
