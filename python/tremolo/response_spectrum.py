"""Elastic response spectra.

An oscillator of circular frequency w and damping ratio z under the ground acceleration a(t),

    u'' + 2 z w u' + w^2 u = -a(t),        a(t) linear between its samples,

is advanced exactly from sample to sample (Nigam & Jennings 1969, Bull. Seism. Soc. Am. 59, 909-922).
"""

import numpy as np


def _transition(omega, damping, dt):
    """Matrices A, B of [u, v]_(n+1) = A [u, v]_n + B [a_n, a_(n+1)] for every frequency."""
    root = np.sqrt(1.0 - damping**2)
    decay = np.exp(-damping * omega * dt)
    damped = omega * root
    sine, cosine = np.sin(damped * dt), np.cos(damped * dt)
    a11 = decay * (damping / root * sine + cosine)
    a12 = decay / damped * sine
    a21 = -omega / root * decay * sine
    a22 = decay * (cosine - damping / root * sine)

    # Particular solution for a(t) = a_n + r t:  u_p = -(a_n + r t)/w^2 + 2 z r/w^3,  v_p = -r/w^2.
    # With q = u_p(0) the free part starts at (u_n - q, v_n + r/w^2).
    def response(first, last):
        rate = (last - first) / dt
        start_u = -first / omega**2 + 2.0 * damping * rate / omega**3
        end_u = -last / omega**2 + 2.0 * damping * rate / omega**3
        start_v = end_v = -rate / omega**2
        return (end_u - a11 * start_u - a12 * start_v, end_v - a21 * start_u - a22 * start_v)

    b11, b21 = response(1.0, 0.0)
    b12, b22 = response(0.0, 1.0)
    return (a11, a12, a21, a22), (b11, b12, b21, b22)


def oscillators(acceleration, dt, periods, damping=0.05):
    """Relative displacement and velocity of oscillators at rest at the first sample.

    acceleration: [samples], m/s2, every dt seconds; periods: s, > 0; damping: of critical, in [0, 1).
    Returns two arrays [samples, periods], m and m/s.
    """
    omega = 2.0 * np.pi / np.asarray(periods, dtype=float)
    (a11, a12, a21, a22), (b11, b12, b21, b22) = _transition(omega, damping, dt)
    u = np.zeros((len(acceleration), omega.size))
    v = np.zeros_like(u)
    for n in range(len(acceleration) - 1):
        first, last = acceleration[n], acceleration[n + 1]
        u[n + 1] = a11 * u[n] + a12 * v[n] + b11 * first + b12 * last
        v[n + 1] = a21 * u[n] + a22 * v[n] + b21 * first + b22 * last
    return u, v


def response_spectrum(acceleration, dt, periods, damping=0.05):
    """Spectral (pseudo-) acceleration w^2 max |u|, m/s2, at the periods (s); the peak is sought at the samples."""
    u, _ = oscillators(acceleration, dt, periods, damping)
    omega = 2.0 * np.pi / np.asarray(periods, dtype=float)
    return omega**2 * np.max(np.abs(u), axis=0)
