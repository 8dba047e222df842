"""Intensity of an acceleration: how it grows (Arias 1970), in terms of the standard gravity that motions in g are given in."""

import numpy as np

GRAVITY = 9.80665  # m/s2, standard gravity


def arias(acceleration, dt):
    """Arias intensity (m/s) up to each sample: pi/(2 g) times the integral of the squared acceleration (m/s2), dt in s."""
    return np.pi / (2.0 * GRAVITY) * np.cumsum(np.square(acceleration)) * dt
