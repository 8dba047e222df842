"""The free field of the flat box: an SV wave in an elastic half-space and what its free surface reflects, (T1) and (T2) of
docs/theory.md (Aki and Richards 2002, Quantitative Seismology, sec. 5.2)."""

import numpy as np

DENSITY, YOUNG, POISSON = 1700.0, 40e6, 0.28  # kg/m3, Pa, 1
LOW, HIGH = np.array([0.0, -40.0]), np.array([100.0, 0.0])  # corners of the box, m
ANGLE, FREQUENCY, PEAK_TIME, PEAK = np.radians(15.0), 3.0, 1.0, 0.1  # rad, Hz, s, m/s; of the incident wave at LOW
LAME = YOUNG * POISSON / ((1.0 + POISSON) * (1.0 - 2.0 * POISSON))  # Pa
SHEAR = YOUNG / (2.0 * (1.0 + POISSON))
C_P, C_S = np.sqrt((LAME + 2.0 * SHEAR) / DENSITY), np.sqrt(SHEAR / DENSITY)  # m/s


def free_field(x, t):
    """Exact velocity (m/s) and stress (xx, yy, xy; Pa) at points x (m) and a time t (s)."""
    p = np.sin(ANGLE) / C_S  # horizontal slowness
    q_s, q_p = np.sqrt(C_S**-2 - p * p), np.sqrt(C_P**-2 - p * p)
    c2, mixed = 1.0 - 2.0 * C_S**2 * p * p, 4.0 * C_S**4 * p * p * q_p * q_s
    velocity, stress = np.zeros((len(x), 2)), np.zeros((len(x), 3))
    for amplitude, q, dx, dy in (  # q is the vertical slowness, (dx, dy) the direction of the motion
        (1.0, q_s, C_S * q_s, -C_S * p),
        ((c2 * c2 - mixed) / (c2 * c2 + mixed), -q_s, C_S * q_s, C_S * p),
        (4.0 * C_S**3 / C_P * p * q_s * c2 / (c2 * c2 + mixed), -q_p, C_P * p, -C_P * q_p),
    ):
        a = (np.pi * FREQUENCY * (t - PEAK_TIME - p * (x[:, 0] - LOW[0]) - q * x[:, 1] + q_s * LOW[1])) ** 2
        v = amplitude * PEAK * (1.0 - 2.0 * a) * np.exp(-a)
        mean = -LAME * (p * dx + q * dy)
        velocity += np.outer(v, (dx, dy))
        stress += np.outer(v, (mean - 2.0 * SHEAR * p * dx, mean - 2.0 * SHEAR * q * dy, -SHEAR * (q * dx + p * dy)))
    return velocity, stress
