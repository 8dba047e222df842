"""Fourier amplitude spectra, smoothed so that their ratios can be read.

With acceleration a(t) sampled every dt, the amplitude is |A(f)| = |integral of a(t) exp(-2 pi i f t) dt|, in m/s. The smoothed
spectrum at f_c is the mean of |A| under the window of Konno & Ohmachi (1998, Bull. Seism. Soc. Am. 88, 228-241, Eq. 4),

    W(f, f_c) = (sin(b log10(f/f_c)) / (b log10(f/f_c)))^4,      b = 40.
"""

import numpy as np

BANDWIDTH = 40.0
LOWEST, HIGHEST = 0.1, 25.0  # Hz
LOWEST_SHARE = 1.0 / 50.0  # of the peak of a denominator, below which a ratio of spectra says nothing
PADDING = 4  # times the record, so that the window finds enough lines at low frequencies


def frequencies(duration, dt, count=160):
    """Frequencies (Hz), even on a logarithmic axis, that a record of this length and step (s) says something about."""
    return np.geomspace(max(LOWEST, 1.0 / duration), min(HIGHEST, 0.4 / dt), count)


def smoothed(lines, amplitude, centres):
    """Mean of amplitudes at `lines` (Hz, > 0) under the window around each of the centres (Hz). Amplitudes of several spectra, a
    column each, share the window, which costs most."""
    position = BANDWIDTH * np.subtract.outer(np.log10(centres), np.log10(lines))
    weight = np.square(np.square(np.sinc(position / np.pi)))
    return ((weight @ amplitude).T / weight.sum(axis=1)).T


def fourier_amplitude(acceleration, dt, centres):
    """Smoothed |A(f)| in m/s at the centres (Hz) of an acceleration (m/s2) every dt (s)."""
    samples = PADDING * len(acceleration)
    amplitude = dt * np.abs(np.fft.rfft(acceleration, samples))
    lines = np.fft.rfftfreq(samples, dt)
    return smoothed(lines[1:], amplitude[1:], centres)


def ratio(above, below):
    """The ratio of two spectra; NaN where the lower one is below a fiftieth of its peak."""
    found = np.full(len(below), np.nan)
    known = below >= LOWEST_SHARE * below.max()
    found[known] = above[known] / below[known]
    return found
