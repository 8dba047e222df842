"""The numbers of a site as tables: name of the file -> columns, each with its unit at the end of its name. Depths grow from the top
down; NaN stands for what is not known."""

import numpy as np

from tremolo.extract import tables
from tremolo.intensity import GRAVITY
from tremolo.site import amplification


def _with_units(model, table, columns):
    """The columns with the units that the table has in the model's file; texts have none."""
    units = model.run.table_units(table)
    return {name if isinstance(values[0], str) else f"{name}_{units[name].replace('/', '_')}": values for name, values in columns.items()}


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
    bottom = np.where(np.isfinite(found["bottom"]), found["bottom"], np.nan)
    return _with_units(site.first, "layers", found | {"bottom": bottom})


def facts(site):
    """One row."""
    return _with_units(site.first, "site", {name: [value] for name, value in site.facts.items()})


def measures(site):
    """A row a model and place."""
    rows = [(model, number) for model in site.models.values() for number in range(len(model.measures["place"]))]
    columns = {name: [model.measures[name][number] for model, number in rows] for name in site.first.measures}
    return {"model": [model.name for model, _ in rows]} | _with_units(site.first, "measures", columns)


def spectra(site):
    """Pseudo-acceleration at 5 % of critical damping; of both components where the case has two."""
    first = site.first.spectra
    columns = {"period_s": first["period"]} | ({"outcrop_g": first["outcrop"] / GRAVITY} if site.has_outcrop else {})
    for model in site.models.values():
        for column, name in (("surface", f"{model.name}_g"), ("surface_vertical", f"{model.name}_vertical_g")):
            if column in model.spectra:
                columns[name] = np.interp(first["period"], model.spectra["period"], model.spectra[column]) / GRAVITY
    return columns


def amplifications(site, ratio):
    """`ratio` is amplification.raw or amplification.smoothed."""
    below = amplification.reference(site)
    found = {model.name: ratio(model, below) for model in site.models.values()}
    frequency, _ = found[site.first.name]
    return {"frequency_Hz": frequency} | {f"{name}_surface_to_{below}": np.interp(frequency, *one) for name, one in found.items()}


def profile(model):
    """Peak values from the surface down; an interface twice, from above and from below."""
    down = slice(None, None, -1)
    found = {name: values[down] for name, values in model.profile.items() if name != "y"}
    return {"depth_m": model.depth()[down]} | _with_units(model, "profile", found)


def strain_compatible(model):
    """What the equivalent linear iteration ended with, layer by layer from the surface down."""
    return _with_units(model, "strain_compatible", model.strain_compatible)


def of_site(site):
    """All of them by the name of their file."""
    found = {"models": models(site), "layers": layers(site), "site": facts(site), "measures": measures(site), "spectra": spectra(site),
             "amplification": amplifications(site, amplification.smoothed),
             "amplification_raw": amplifications(site, amplification.raw)}
    for model in site.models.values():
        found[f"profile_{model.name}"] = profile(model)
        if model.strain_compatible:
            found[f"strain_compatible_{model.name}"] = strain_compatible(model)
    return found


def write(site, folder):
    """Writes them as comma-separated files; yields their paths."""
    for name, table in of_site(site).items():
        yield tables.write(folder / f"{name}.csv", table)
