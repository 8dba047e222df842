"""The medians and deviations of many responses of one site as tables: name of the file -> columns, with the unit at the end of each
name."""

from tremolo.extract import tables
from tremolo.intensity import GRAVITY
from tremolo.site import suite


def _columns(families, place, of, name, unit, scale=1.0):
    """`place`, then median and sigma_ln of each family."""
    found = {}
    for family in families:
        curves = of(family.responses)
        median, sigma = curves.statistics()
        before = "_".join(word for word in (family.name.replace(", ", "_").replace(" ", ""), name) if word)
        found |= {place: curves.places} if not found else {}
        found |= {f"{before}_median_{unit}": scale * median, f"{before}_sigma_ln_1": sigma}
    return found


def of_suite(families):
    first = families[0].responses[0]
    below = suite.below(families[0].responses)
    found = {"spectra": _columns(families, "period_s", suite.spectra, "surface", "g"),
             "amplification_fourier": _columns(families, "frequency_Hz", suite.fourier_amplification, f"surface_to_{below}", "1")}
    if below == "outcrop":
        found["spectra"] |= _columns(families, "period_s", lambda responses: suite.spectra(responses, "outcrop"), "outcrop", "g")
        found["amplification"] = _columns(families, "period_s", suite.spectral_amplification, "surface_to_outcrop", "1")
    found["profile_vs"] = _columns(families, "depth_m", suite.speeds, "vs", "m_s")
    found["profile"] = (
        _columns(families, "depth_m", lambda responses: suite.peaks(responses, f"peak_{first.acceleration}"), "pga", "g", 1.0 / GRAVITY)
        | _columns(families, "depth_m", lambda responses: suite.peaks(responses, f"peak_{first.strain}"), "strain", "percent", 100.0))
    return found


def write(families, folder):
    """Writes them as comma-separated files; yields their paths."""
    for name, table in of_suite(families).items():
        yield tables.write(folder / f"{name}.csv", table)
