"""What many responses of one site have in common: under several motions, with several profiles of Vs.

A quantity y at one period, frequency or depth is taken as lognormal,

    median = exp(mean of ln y),    sigma_ln = standard deviation of ln y,    with N - 1 in the denominator,

and a curve of it is median exp(-+ sigma_ln). It goes through the positive values, where half of the responses have one.
"""

from typing import NamedTuple

import numpy as np

from tremolo.intensity import GRAVITY
from tremolo.run import Run
from tremolo.site import amplification
from tremolo.site.read import Model

DEPTHS = 200  # of a profile of Vs
LEAST_SHARE = 0.5  # of the responses


def measured(model):
    """Measures of a free field alone: name -> number, as of the runs of a sweep (sweep/measures.py)."""
    surface = {f"surface.{name}_{unit}": model.measure("surface", name) for name, unit in (
        ("pga", "m_s2"), ("pgv", "m_s"), ("arias", "m_s"), ("duration_5_75", "s"), ("duration_5_95", "s"), ("mean_period", "s"))}
    strain = model.profile[f"peak_{_strain(model.run)}"]
    facts = model.run.table("site")
    return {**surface, "largest_strain": float(strain.max()), "largest_strain_depth_m": float(model.depth()[np.argmax(strain)]),
            "site.vs30_m_s": float(facts["vs30"][0]), "site.period_s": float(facts["period"][0]),
            "cpu_s": float(model.run.attribute("cpu_time"))}


def _strain(run):
    """The wave's own component."""
    return "gxy" if run.attribute("wave") == "SV" else "eyy"


class Response(NamedTuple):
    """The tables of a site response that curves are made of, and the names of the acceleration and strain of its wave."""

    spectra: dict
    transfer: dict
    profile: dict
    layers: dict
    acceleration: str
    strain: str

    @classmethod
    def read(cls, path):
        with Run(path) as run:
            model = Model("", run)
            strain = _strain(run)
            return cls(model.spectra, model.transfer, model.profile, run.table("layers"), "ax" if strain == "gxy" else "ay", strain)

    def depth(self):
        """The depth of each level of the profile, m, from the base up."""
        return self.profile["y"].max() - self.profile["y"]


class Curves(NamedTuple):
    """A quantity of several responses at common places: [responses, places]; NaN where one has none."""

    places: np.ndarray
    values: np.ndarray

    def statistics(self):
        """Median and sigma_ln at the places; NaN where too few responses have a value."""
        positive = self.values > 0.0
        logarithm = np.where(positive, np.log(np.where(positive, self.values, 1.0)), 0.0)
        count = positive.sum(axis=0)
        known = np.where(count >= LEAST_SHARE * len(self.values), count, np.nan)
        mean = logarithm.sum(axis=0) / known
        squares = np.where(positive, (logarithm - mean) ** 2, 0.0).sum(axis=0)
        return np.exp(mean), np.sqrt(squares / np.where(known > 1, known - 1, np.nan))


def _at(places, curves):
    """Curves (x, y), x rising, at common places; NaN beyond their ends."""
    return Curves(places, np.array([np.interp(places, x, y, left=np.nan, right=np.nan) for x, y in curves]))


def spectra(responses, name="surface"):
    """Pseudo-acceleration at 5 % over the period (s), g; None where a response has no motion of this name."""
    if any(name not in response.spectra for response in responses):
        return None
    return _at(responses[0].spectra["period"], [(response.spectra["period"], response.spectra[name] / GRAVITY) for response in responses])


def spectral_amplification(responses):
    """Response spectrum of the surface over that of the outcrop; None without one."""
    surface, outcrop = spectra(responses), spectra(responses, "outcrop")
    return outcrop and Curves(surface.places, surface.values / outcrop.values)


def fourier_amplification(responses):
    """Smoothed Fourier amplitudes of the surface over those of the outcrop, or of the base where a response has none."""
    ratios = [amplification.smoothed(response, below(responses)) for response in responses]
    return _at(ratios[0][0], ratios)


def below(responses):
    """"outcrop", or "base"."""
    return "outcrop" if spectra(responses, "outcrop") else "base"


def peaks(responses, column):
    """A column of the profile of peak values over the depth (m)."""
    depth = responses[0].depth()[::-1]
    places = np.linspace(0.0, depth[-1], DEPTHS // 2 + 1)
    return _at(places, [(response.depth()[::-1], response.profile[column][::-1]) for response in responses])


def speeds(responses):
    """Vs of the layers at small strain over the depth (m): in equal steps, at both ends of each the value of its middle."""
    ends = np.linspace(0.0, responses[0].depth().max(), DEPTHS + 1)
    middles = 0.5 * (ends[1:] + ends[:-1])
    values = [response.layers["vs"][np.searchsorted(response.layers["bottom"], middles, side="right")] for response in responses]
    return Curves(np.repeat(ends, 2)[1:-1], np.repeat(values, 2, axis=1))
