"""The numbers of a site as tables: name of the file -> columns, each with its unit at the end of its name. Depths grow from the top
down; NaN stands for what is not known."""

import numpy as np

from tremolo.extract import tables
from tremolo.site import amplification
from tremolo.site.read import GRAVITY


def models(site):
    """A row a model: what the surface does."""
    rows = list(site.models.values())
    peak = "peak_gxy" if site.direction == "x" else "peak_eyy"
    columns = {"model": [model.name for model in rows], "soil": [model.soil for model in rows]}
    columns["pga_g"] = [model.measure("surface", "pga") / GRAVITY if "surface" in model.places() else np.nan for model in rows]
    for name, unit in (("pgv", "m_s"), ("arias", "m_s"), ("duration_5_75", "s"), ("duration_5_95", "s"), ("mean_period", "s")):
        columns[f"{name}_{unit}"] = [model.measure("surface", name) if "surface" in model.places() else np.nan for model in rows]
    columns["largest_strain_percent"] = [100.0 * model.profile[peak].max() for model in rows]
    columns["its_depth_m"] = [model.depth()[np.argmax(model.profile[peak])] for model in rows]
    columns["cpu_time_s"] = [model.run.attribute("cpu_time") for model in rows]
    return columns


def layers(site):
    """From the surface down, the half-space last."""
    found = site.layers
    units = {"top": "m", "bottom": "m", "density": "kg_m3", "vs": "m_s", "vp": "m_s", "damping": "1", "shear_modulus": "Pa",
             "impedance_contrast": "1"}
    bottom = np.where(np.isfinite(found["bottom"]), found["bottom"], np.nan)
    return {"soil": found["soil"]} | {f"{name}_{unit}": bottom if name == "bottom" else found[name] for name, unit in units.items()}


def facts(site):
    """One row."""
    units = {"vs30": "m_s", "depth": "m", "mean_vs": "m_s", "period": "s", "period_of_mean_vs": "s", "impedance_contrast": "1"}
    return {f"{name}_{units[name]}": [value] for name, value in site.facts.items()}


def measures(site):
    """A row a model and place."""
    units = {"pga": "m_s2", "pgv": "m_s", "arias": "m_s", "duration_5_75": "s", "duration_5_95": "s", "cav": "m_s", "mean_period": "s"}
    rows = [(model, number) for model in site.models.values() for number in range(len(model.measures["place"]))]
    columns = {"model": [model.name for model, _ in rows], "place": [model.measures["place"][number] for model, number in rows]}
    return columns | {f"{name}_{unit}": [model.measures[name][number] for model, number in rows] for name, unit in units.items()}


def spectra(site):
    """Pseudo-acceleration at 5 % of critical damping."""
    first = site.first.spectra
    columns = {"period_s": first["period"]} | ({"outcrop_g": first["outcrop"] / GRAVITY} if site.has_outcrop else {})
    return columns | {f"{model.name}_g": np.interp(first["period"], model.spectra["period"], model.spectra["surface"]) / GRAVITY
                      for model in site.models.values()}


def smoothed_amplification(site):
    below = amplification.reference(site)
    frequency, _ = amplification.smoothed(site.first, below)
    ratios = {model.name: np.interp(frequency, *amplification.smoothed(model, below)) for model in site.models.values()}
    return {"frequency_Hz": frequency} | {f"{name}_surface_to_{below}": ratio for name, ratio in ratios.items()}


def raw_amplification(site):
    below = amplification.reference(site)
    frequency, _ = amplification.raw(site.first, below)
    ratios = {model.name: np.interp(frequency, *amplification.raw(model, below)) for model in site.models.values()}
    return {"frequency_Hz": frequency} | {f"{name}_surface_to_{below}": ratio for name, ratio in ratios.items()}


def profile(model):
    """Peak values from the surface down; an interface twice, from above and from below."""
    down = slice(None, None, -1)
    found = {name: values[down] for name, values in model.profile.items()}
    units = {"peak_ax": "m_s2", "peak_ay": "m_s2", "peak_vx": "m_s", "peak_vy": "m_s", "peak_ux": "m", "peak_uy": "m",
             "peak_ux_relative": "m", "peak_uy_relative": "m", "peak_gxy": "1", "peak_eyy": "1", "peak_sxy": "Pa",
             "effective_stress": "Pa", "stress_ratio": "1", "cyclic_stress_ratio": "1"}
    return {"depth_m": model.depth()[down]} | {f"{name}_{unit}": found[name] for name, unit in units.items()}


def strain_compatible(model):
    """What the equivalent linear iteration ended with, layer by layer from the surface down."""
    units = {"top": "m", "bottom": "m", "vs": "m_s", "modulus_ratio": "1", "damping": "1", "largest_strain": "1", "effective_strain": "1"}
    return {f"{name}_{unit}": model.strain_compatible[name] for name, unit in units.items()}


def of_site(site):
    """All of them by the name of their file."""
    found = {"models": models(site), "layers": layers(site), "site": facts(site), "measures": measures(site), "spectra": spectra(site),
             "amplification": smoothed_amplification(site), "amplification_raw": raw_amplification(site)}
    for model in site.models.values():
        found[f"profile_{model.name}"] = profile(model)
        if model.strain_compatible:
            found[f"strain_compatible_{model.name}"] = strain_compatible(model)
    return found


def write(site, folder):
    """Writes them as comma-separated files; yields their paths."""
    for name, table in of_site(site).items():
        yield tables.write(folder / f"{name}.csv", table)
