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


def smoothed(model, below):
    """Frequencies (Hz), even on a logarithmic axis, and ratios of smoothed spectra there."""
    frequency = model.transfer["frequency"]
    centres = spectra.frequencies(1.0 / frequency[1], 0.5 / frequency[-1])
    above, under = (spectra.smoothed(frequency[1:], model.transfer[name][1:], centres) for name in ("surface", below))
    return centres, spectra.ratio(above, under)
