"""Spectral ratios of the accelerations of two points.

    Fourier:   |A(f)| / |A_b(f)|, both smoothed (report/spectra.py)
    response:  S_a(T) / S_a,b(T), pseudo-acceleration, 5 % damping

A ratio is NaN where the base's spectrum is below a fiftieth of its peak, and in a direction in which the base moves by less
than a hundredth of what it does in the other: it would compare errors.
"""

import numpy as np

from tremolo.histories import PERIODS, even_steps
from tremolo.report import spectra
from tremolo.response_spectrum import response_spectrum

STILL = 1e-2


def _records(series, base):
    """Even records of both over their common time: direction -> (a, a_b), and the step (s). Without directions at rest."""
    rows = min(len(series), len(base))
    if rows < 16:
        raise ValueError(f"{rows} rows of history are too few for a spectrum")
    records = {}
    for direction in ("x", "y"):
        (one, dt), (other, _) = (even_steps(of["time"][:rows], of["a" + direction][:rows]) for of in (series, base))
        records[direction] = (one, other)
    strongest = max(np.abs(other).max() for _, other in records.values())
    if strongest == 0.0:
        raise ValueError("the base does not move: there is no spectral ratio over it")
    return {direction: pair for direction, pair in records.items() if np.abs(pair[1]).max() > STILL * strongest}, dt


def _table(axis, over, records, spectrum):
    """A column a direction of the ratio of spectra."""
    table = {}
    for direction in ("x", "y"):
        known = direction in records
        table[f"{axis}_{direction}"] = spectra.ratio(*map(spectrum, records[direction])) if known else np.full(len(over), np.nan)
    return table


def fourier(series, base):
    """Columns frequency_Hz, fourier_ratio_x, fourier_ratio_y."""
    records, dt = _records(series, base)
    samples = len(next(iter(records.values()))[0])
    frequencies = spectra.frequencies(dt * samples, dt)
    return {"frequency_Hz": frequencies} | _table(
        "fourier_ratio", frequencies, records, lambda record: spectra.fourier_amplitude(record, dt, frequencies))


def response(series, base):
    """Columns period_s, response_ratio_x, response_ratio_y."""
    records, dt = _records(series, base)
    periods = PERIODS[PERIODS >= 2.0 * dt]
    return {"period_s": periods} | _table(
        "response_ratio", periods, records, lambda record: response_spectrum(record, dt, periods))
