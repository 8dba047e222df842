#!/usr/bin/python3
"""The SV pulse of the case, vertically up through a homogeneous half-space and reflected at its surface, in closed
form: v_x = f(t - (y - y0)/c) + f(t - (2 ys - y - y0)/c), s_xy = -rho c (first term - second term)."""

import numpy as np

from tremolo.participant import Field, Participant

participant = Participant()
case = participant.case
soil, pulse, y0 = case["halfspace"], case["motion"]["pulse"], case["motion"]["reference"][1]
rho = soil["density"]
c = np.sqrt(soil["young"] / (2.0 * (1.0 + soil["poisson"])) / rho)
surface = case["surface"]["level"]


def ricker(t):
    a = (np.pi * pulse["frequency"] * (t - pulse["time"])) ** 2
    return pulse["velocity"] * (1.0 - 2.0 * a) * np.exp(-a)


def motion(reflection, y, t):
    y, t = np.meshgrid(y, t)
    up, down = ricker(t - (y - y0) / c), reflection * ricker(t - (2.0 * surface - y - y0) / c)
    o = np.zeros_like(y)
    return np.stack([up + down, o, o, o, -rho * c * (up - down)], axis=2)  # vx vy sxx syy sxy


levels = np.arange(case["mesh"]["box"][1] - 1.0, surface + 0.1, 0.5)
dt, end = 0.005, case["stage"][-1]["duration_s"]
participant.serve([Field(name, lambda y, t, r=r: motion(r, y, t), levels, -2 * dt, dt, int(end / dt) + 6)
                   for name, r in (("total", 1.0), ("incident", 0.0))])
