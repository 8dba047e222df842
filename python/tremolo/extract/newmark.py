"""Newmark's displacement (Newmark 1965, Geotechnique 15, 139-160): a rigid mass on a slip surface.

The mass slides where the acceleration a(t) that drives it down the slope exceeds the yield acceleration k_y g, until its
velocity relative to the ground below is zero again:

    dv/dt = a(t) - k_y g    while v > 0 or a(t) > k_y g,        v >= 0,        d = integral of v dt.

It never slides up the slope. a(t) is linear between its samples, and the integral over them is exact. With the ground's
acceleration under the slip surface this is the rigid block; with the mean acceleration of the mass in a run in which it does
not slide, the horizontal equivalent acceleration, it is the decoupled analysis (Makdisi & Seed 1978, J. Geotech. Eng. Div.
ASCE 104(GT7), 849-867).
"""

import numpy as np


def _stop(v, r, slope, longest):
    """The first time > 0 at which v + r t + slope t^2 / 2 is zero; None where it is not by `longest`. v >= 0; r > 0 where v = 0."""
    square = r * r - 2.0 * slope * v
    if square < 0.0:
        return None
    root = np.sqrt(square)
    # Without cancellation: q is the larger in size of the two numerators.
    q = -(r + root) if r >= 0.0 else -(r - root)
    times = [2.0 * v / q] if q != 0.0 else []
    if slope != 0.0:
        times.append(q / slope)
    times = [t for t in times if 0.0 < t <= longest]
    return min(times, default=None)


def _interval(v, first, last, length):
    """Velocity after an interval of excess acceleration that is linear from `first` to `last`, and displacement over it."""
    slope = (last - first) / length
    t, moved = 0.0, 0.0
    while t < length:
        r = first + slope * t
        if v <= 0.0 and r <= 0.0:
            if last <= 0.0 or slope <= 0.0:
                return 0.0, moved
            t, r, v = -first / slope, 0.0, 0.0
        left = length - t
        sliding = _stop(v, r, slope, left) if v > 0.0 or r > 0.0 else None
        duration = left if sliding is None else sliding
        moved += v * duration + r * duration**2 / 2.0 + slope * duration**3 / 6.0
        v = 0.0 if sliding is not None else v + r * duration + slope * duration**2 / 2.0
        t = length if sliding is None else t + duration
        if sliding is not None and slope <= 0.0:
            return 0.0, moved
    return v, moved


def sliding_displacement(time, driving, yield_acceleration):
    """Displacement [samples] (m) down the slope relative to the ground.

    time [samples] (s), rising; driving [samples] (m/s2), positive where it drives the mass down the slope;
    yield_acceleration (m/s2), at least 0.
    """
    excess = np.asarray(driving, dtype=float) - yield_acceleration
    displacement = np.zeros(len(excess))
    v = 0.0
    for n in range(len(excess) - 1):
        displacement[n + 1] = displacement[n]
        if v > 0.0 or excess[n] > 0.0 or excess[n + 1] > 0.0:
            v, moved = _interval(v, excess[n], excess[n + 1], time[n + 1] - time[n])
            displacement[n + 1] += moved
    return displacement


def driving(ax, downslope):
    """What drives a mass down the slope where the ground has the acceleration ax (m/s2) along x; downslope: +1 or -1 along x.

    The inertia of the mass is opposite to the acceleration of the ground.
    """
    return -downslope * np.asarray(ax)
