"""Amplification of a site: Fourier amplitudes of the surface over those of the outcrop, or of the base where there is none.

Raw ratios of two spectra have spikes where the lower one has holes. Smoothed ones are ratios of spectra that were each
smoothed with the window of Konno & Ohmachi (report/spectra.py).
"""

import numpy as np

from tremolo.report import spectra


def reference(site):
    """"outcrop", or "base"."""
    return "outcrop" if site.has_outcrop else "base"


def raw(model, below):
    """Frequencies (Hz) and ratios; NaN where they say nothing."""
    ratio = model.transfer[f"surface_to_{below}"]
    return model.transfer["frequency"], np.where(ratio > 0.0, ratio, np.nan)


def smoothed_frequencies(model):
    """Frequencies (Hz), even on a logarithmic axis, of its smoothed spectra."""
    frequency = model.transfer["frequency"]
    return spectra.frequencies(1.0 / frequency[1], 0.5 / frequency[-1])


def smoothed(model, below):
    """smoothed_frequencies(), and ratios of smoothed spectra there."""
    frequency = model.transfer["frequency"]
    centres = smoothed_frequencies(model)
    amplitudes = np.column_stack([model.transfer[name][1:] for name in ("surface", below)])
    return centres, spectra.ratio(*spectra.smoothed(frequency[1:], amplitudes, centres).T)
