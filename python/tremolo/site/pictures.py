"""Figures of a site, one line a model: histories, spectra, amplification, profiles, and the soil that eql ended with."""

import numpy as np

from tremolo import style
from tremolo.site import amplification
from tremolo.intensity import GRAVITY, arias

PERIODS = [0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10]  # s
FREQUENCIES = [0.1, 0.2, 0.5, 1, 2, 5, 10, 20]  # Hz
OUTCROP = {"color": "0.35", "linestyle": "--"}


def _colours(site):
    return {name: style.COLOURS[number % len(style.COLOURS)] for number, name in enumerate(site.models)}


def logarithmic(ax, ticks, limits):
    ax.set_xscale("log")
    ax.set_xticks(ticks, [f"{tick:g}" for tick in ticks])
    ax.minorticks_off()
    ax.set_xlim(*limits)


def _downwards(axes, depth):
    """Panels side by side that share depth, from the surface down to `depth` (m)."""
    axes[0].set(ylabel="depth (m)", ylim=(depth, 0.0))
    for ax in axes:
        ax.grid(color="0.92", linewidth=0.6)


def _steps(tops, bottoms, values):
    """Constant values of layers as a line over depth."""
    return np.repeat(values, 2), np.column_stack([tops, bottoms]).ravel()


def histories(site):
    """Acceleration of the surface, a panel a model on one scale, and below how its Arias intensity grows."""
    colours = _colours(site)
    shown = [model for model in site.models.values() if "surface" in model.places()]
    if not shown:
        return None
    figure, axes = style.plt.subplots(len(shown) + 1, 1, figsize=(9.0, 1.4 + 1.5 * (len(shown) + 1)), layout="constrained", sharex=True)
    largest = max(model.measure("surface", "pga") for model in shown) / GRAVITY
    for ax, model in zip(axes, shown):
        series = model.run.monitor("surface")
        acceleration = series["a" + site.direction]
        ax.plot(series["time"], acceleration / GRAVITY, color=colours[model.name], linewidth=0.7, label=model.name)
        peak = model.measure("surface", "pga") / GRAVITY
        ax.set(ylabel="acceleration (g)", ylim=(-1.1 * largest, 1.1 * largest),
               title=f"surface, {model.name} (soil {model.soil}): {peak:.3f} g")
        step = series["time"][1] - series["time"][0]
        axes[-1].plot(series["time"], arias(acceleration, step), color=colours[model.name], label=model.name)
    axes[-1].set(xlabel="t (s)", ylabel="Arias intensity (m/s)", ylim=(0, None), title="surface, growth of the Arias intensity")
    axes[-1].set_xlim(series["time"][0], series["time"][-1])
    axes[-1].legend(loc="upper left")
    return figure


def spectra(site):
    """Response spectra of the surface, of both components where the case has two, and what the ground makes of those of the
    outcrop."""
    colours = _colours(site)
    panels = 2 if site.has_outcrop else 1
    figure, axes = style.plt.subplots(panels, 1, figsize=(7.6, 3.4 * panels), layout="constrained", squeeze=False)
    axes = axes[:, 0]
    for model in site.models.values():
        period, surface = model.spectra["period"], model.spectra["surface"]
        axes[0].plot(period, surface / GRAVITY, color=colours[model.name], label=model.name)
        if "surface_vertical" in model.spectra:
            axes[0].plot(period, model.spectra["surface_vertical"] / GRAVITY, color=colours[model.name], linestyle=":",
                         label=f"{model.name}, vertical")
        if site.has_outcrop:
            axes[1].plot(period, surface / model.spectra["outcrop"], color=colours[model.name], label=model.name)
    period = site.first.spectra["period"]
    if site.has_outcrop:
        axes[0].plot(period, site.first.spectra["outcrop"] / GRAVITY, label="outcrop", **OUTCROP)
        axes[1].axhline(1.0, color="0.6", linewidth=0.6, zorder=0)
        axes[1].set(ylabel="surface over outcrop, 5 % spectra", ylim=(0, None))
    axes[0].set(ylabel="spectral acceleration, 5 % (g)", ylim=(0, None))
    for ax in axes:
        logarithmic(ax, [tick for tick in PERIODS if period[0] <= tick <= period[-1]], (period[0], period[-1]))
        ax.set_xlabel("period (s)")
        ax.grid(color="0.92", linewidth=0.6)
        ax.legend()
    return figure


def amplifications(site):
    """Fourier amplitudes of the surface over those of the outcrop: smoothed, and raw below them."""
    colours = _colours(site)
    below = amplification.reference(site)
    centres = amplification.smoothed_frequencies(site.first)
    figure, axes = style.plt.subplots(2, 1, figsize=(7.6, 6.8), layout="constrained")
    for ax, ratio, kind in zip(axes, (amplification.smoothed, amplification.raw), ("smoothed (Konno & Ohmachi, b = 40)", "raw")):
        for model in site.models.values():
            ax.plot(*ratio(model, below), color=colours[model.name], linewidth=1.2 if ratio is amplification.smoothed else 0.5,
                    label=model.name)
        fundamental = 1.0 / site.facts["period"]
        ax.plot([fundamental, fundamental], [0.0, 1.0], color="0.5", linestyle=":", label=f"1/T0 = {fundamental:.3g} Hz",
                transform=ax.get_xaxis_transform())
        ax.set(title=kind, ylabel=f"surface over {below}, Fourier", ylim=(0, None), xlabel="frequency (Hz)")
        logarithmic(ax, [tick for tick in FREQUENCIES if centres[0] <= tick <= centres[-1]], (centres[0], centres[-1]))
        ax.grid(color="0.92", linewidth=0.6)
        ax.legend()
    return figure


def profiles(site):
    """Wave speed, and peak values over depth. Strain has a logarithmic axis, since a soft layer would flatten all others."""
    colours = _colours(site)
    direction, strain = site.direction, "gxy" if site.direction == "x" else "eyy"
    panels = [("peak_a" + direction, 1.0 / GRAVITY, "peak acceleration (g)"), ("peak_" + strain, 100.0, "peak strain (%)"),
              (f"peak_u{direction}_relative", 100.0, "displacement to base (cm)"), ("stress_ratio", 1.0, "$\\tau_{max}/\\sigma'_{v0}$"),
              ("cyclic_stress_ratio", 1.0, "$0.65\\,\\tau_{max}/\\sigma'_{v0}$")]
    if direction == "y":
        panels = panels[:3]
    figure, axes = style.plt.subplots(1, 1 + len(panels), figsize=(2.0 + 2.05 * (1 + len(panels)), 5.0), layout="constrained", sharey=True)
    layers, base = site.layers, site.facts["depth"]
    inside = np.isfinite(layers["bottom"])
    axes[0].plot(*_steps(layers["top"][inside], layers["bottom"][inside], layers["vs"][inside]), color="0.2", label="small strain")
    for model in site.models.values():
        if model.strain_compatible:
            table = model.strain_compatible
            axes[0].plot(*_steps(table["top"], table["bottom"], table["vs"]), color=colours[model.name], label=model.name)
    axes[0].set(xlabel="Vs (m/s)", xlim=(0, None))
    axes[0].legend()
    for ax, (column, scale, label) in zip(axes[1:], panels):
        for model in site.models.values():
            values = scale * model.profile[column]
            ax.plot(np.where(values > 0.0, values, np.nan), model.depth(), color=colours[model.name], label=model.name)
        ax.set_xlabel(label)
        if "strain" in label:
            most = max(scale * model.profile[column].max() for model in site.models.values())
            ax.set_xscale("log")
            ax.set_xlim(1e-3 * most, 2.0 * most)
        else:
            ax.set_xlim(0, None)
    axes[1].legend()
    _downwards(axes, base)
    return figure


def strain_compatible(model):
    """Stiffness, damping and strain that the equivalent linear iteration ended with; None of another model."""
    table = model.strain_compatible
    if not table:
        return None
    figure, axes = style.plt.subplots(1, 3, figsize=(7.6, 4.4), layout="constrained", sharey=True)
    panels = [("modulus_ratio", 1.0, "G/G0"), ("damping", 100.0, "damping (%)"), ("effective_strain", 100.0, "effective strain (%)")]
    for ax, (column, scale, label) in zip(axes, panels):
        ax.plot(*_steps(table["top"], table["bottom"], scale * table[column]), label=model.name)
        ax.set(xlabel=label, xlim=(0, None))
    axes[0].set_xlim(0, 1)
    _downwards(axes, table["bottom"].max())
    return figure


def of_site(site):
    """Figures by name, in the order in which one reads them."""
    found = {"histories": histories(site), "spectra": spectra(site), "amplification": amplifications(site), "profiles": profiles(site)}
    found |= {f"strain_compatible_{model.name}": strain_compatible(model) for model in site.models.values()}
    return {name: figure for name, figure in found.items() if figure is not None}
