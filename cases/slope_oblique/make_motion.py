#!/usr/bin/env python3
"""Makes motion.AT2, the accelerogram that shakes the slope: modulated, filtered noise with the strength, duration and
mean period of the Northridge (1994) record at LA Baldwin Hills, component 90.

    a(t) = s w(t) (h * n)(t)

n  white noise of a seeded generator whose stream numpy keeps fixed (RandomState)
h  the filter of Clough & Penzien (1975), Dynamics of Structures, a soil column (FREQUENCY, DAMPING) after a high-pass
   (HIGH_PASS), and a cosine taper that ends at LAST_FREQUENCY: a mesh of 0.5 m carries 8 Hz at c_s = 96 m/s with 24
   cells a wave length
w  the gamma envelope of Saragoni & Hart (1974), Earthq. Eng. Struct. Dyn. 2, its energy spread as the record's is,
   and the record's burst of strong shaking on top of it
s  the scale that gives the Arias intensity

A correction w (p + q t) brings final velocity and displacement to zero. FREQUENCY, HIGH_PASS, ENVELOPE_TIME and
BURST_STRENGTH were found, for this SEED, by Gauss-Newton steps on mean period, PGV, duration and PGA.

    usage: make_motion.py OUT.AT2
"""

import sys

import numpy as np

GRAVITY = 9.80665  # m/s2
STEP = 0.02  # s
POINTS = 2000

# Measures of the record. PGA in g, PGV and Arias intensity in m/s, the rest in s.
TARGET = {"pga": 0.2389, "pgv": 0.1487, "arias": 0.6700, "duration": 16.56, "mean_period": 0.5176}
TOLERANCE = 0.005  # relative, of every measure

SEED = 249

FREQUENCY, DAMPING = 2.7692, 0.7  # Hz, 1
HIGH_PASS, HIGH_PASS_DAMPING = 0.3509, 0.6  # Hz, 1
TAPER_START, LAST_FREQUENCY = 6.5, 8.0  # Hz

ENVELOPE_START, ENVELOPE_SHAPE, ENVELOPE_TIME = 4.0, 1.8, 4.3077  # s, 1, s: of the energy
BURST_TIME, BURST_WIDTH, BURST_STRENGTH = 10.3, 0.4, 0.8025  # s, s, 1: of the energy


def time():
    return STEP * np.arange(POINTS)


def integral(x):
    """Trapezoidal integral from the start, same length as x."""
    return np.concatenate(([0.0], np.cumsum(0.5 * STEP * (x[1:] + x[:-1]))))


def filter_response():
    """Amplitude of h at the frequencies of a real FFT."""
    f = np.fft.rfftfreq(POINTS, STEP)
    soil = (FREQUENCY**2 + 2j * DAMPING * FREQUENCY * f) / (FREQUENCY**2 - f**2 + 2j * DAMPING * FREQUENCY * f)
    high = f**2 / (HIGH_PASS**2 - f**2 + 2j * HIGH_PASS_DAMPING * HIGH_PASS * f)
    taper = np.clip((LAST_FREQUENCY - f) / (LAST_FREQUENCY - TAPER_START), 0.0, 1.0)
    return np.abs(soil * high) * 0.5 * (1.0 - np.cos(np.pi * taper))


def envelope():
    """w(t): the square root of the mean energy."""
    x = np.maximum(time() - ENVELOPE_START, 0.0) / ENVELOPE_TIME
    burst = BURST_STRENGTH * np.exp(-(((time() - BURST_TIME) / BURST_WIDTH) ** 2))
    return np.sqrt(x ** (ENVELOPE_SHAPE - 1.0) * np.exp(-x) + burst)


def without_drift(acceleration, w):
    """Subtracts w (p + q t) so that velocity and displacement end at zero."""

    def ends(a):
        velocity = integral(a)
        return np.array([velocity[-1], integral(velocity)[-1]])

    shapes = [w, w * time()]
    p, q = np.linalg.solve(np.column_stack([ends(shape) for shape in shapes]), ends(acceleration))
    return acceleration - p * shapes[0] - q * shapes[1]


def motion():
    """Acceleration in g, scaled to the Arias intensity."""
    noise = np.random.RandomState(SEED).standard_normal(POINTS)
    w = envelope()
    a = w * np.fft.irfft(filter_response() * np.fft.rfft(noise), POINTS)
    a = without_drift(a, w)
    scaled = a * np.sqrt(TARGET["arias"] / arias(a)[-1])
    return np.round(scaled, 10) + 0.0  # neither -0 nor 1e-140


def arias(acceleration):
    """Husid curve pi/(2 g) int a^2 dt in m/s, acceleration in g."""
    return 0.5 * np.pi * GRAVITY * np.cumsum(acceleration**2) * STEP


def measures(acceleration):
    """The five measures of an acceleration in g; mean period after Rathje, Abrahamson & Bray (1998), 0.25 to 20 Hz."""
    husid = arias(acceleration)
    start, end = np.searchsorted(husid, [0.05 * husid[-1], 0.95 * husid[-1]])
    f = np.fft.rfftfreq(len(acceleration), STEP)
    power = np.abs(np.fft.rfft(acceleration)) ** 2
    band = (f >= 0.25) & (f <= 20.0)
    return {
        "pga": np.abs(acceleration).max(),
        "pgv": np.abs(integral(GRAVITY * acceleration)).max(),
        "arias": husid[-1],
        "duration": STEP * (end - start),
        "mean_period": np.sum(power[band] / f[band]) / np.sum(power[band]),
    }


def misfit(acceleration):
    """Largest relative difference from the target."""
    found = measures(acceleration)
    return max(abs(found[name] / value - 1.0) for name, value in TARGET.items())


def peer_at2(acceleration):
    """The text of a PEER AT2 file."""
    m = measures(acceleration)
    header = [
        "TREMOLO SYNTHETIC MOTION, MODULATED AND FILTERED NOISE",
        f"Seed {SEED}: PGA {m['pga']:.4f} g, PGV {m['pgv']:.4f} m/s, Arias {m['arias']:.4f} m/s, "
        f"D5-95 {m['duration']:.2f} s, Tm {m['mean_period']:.4f} s",
        "ACCELERATION TIME SERIES IN UNITS OF G",
        f"NPTS= {POINTS:6d}, DT= {STEP:7.4f} SEC",
    ]
    rows = acceleration.reshape(-1, 5)
    return "\n".join(header + ["".join(f"{a:15.7E}" for a in row) for row in rows]) + "\n"


def main():
    if len(sys.argv) != 2:
        sys.exit("usage: make_motion.py OUT.AT2")
    acceleration = motion()
    if misfit(acceleration) > TOLERANCE:
        sys.exit(f"make_motion.py: a measure misses its target by {misfit(acceleration):.2%}")
    with open(sys.argv[1], "w", encoding="ascii", newline="\n") as out:
        out.write(peer_at2(acceleration))


if __name__ == "__main__":
    main()
