"""Pictures of the tables."""

import numpy as np

from tremolo import style

# Panels of a profile: label, factor, and the columns with their names in the legend.
PANELS = [
    ("peak acceleration (m/s²)", 1.0, {"peak_ax_m_s2": "horizontal", "peak_ay_m_s2": "vertical"}),
    ("peak velocity (m/s)", 1.0, {"peak_vx_m_s": "horizontal", "peak_vy_m_s": "vertical"}),
    ("peak displacement (m)", 1.0, {"peak_ux_m": "horizontal", "peak_uy_m": "vertical", "peak_ux_relative_m": "horizontal, relative",
                                    "peak_uy_relative_m": "vertical, relative"}),
    ("peak shear strain (%)", 100.0, {"peak_gxy": ""}),
    ("stress ratio", 1.0, {"stress_ratio": ""}),
    ("peak $r_u$", 1.0, {"peak_r_u": ""}),
]

SMALL = 0.01  # of the largest value of a panel: what stays below it is not drawn


def _shown(table, columns):
    """The columns of a panel that are there and large enough to be seen: name -> words."""
    peaks = {name: np.nanmax(table[name]) for name in columns if name in table and np.isfinite(table[name]).any()}
    return {name: columns[name] for name, peak in peaks.items() if peak > SMALL * max(peaks.values())}


def profile(table, title, path):
    """Peaks over y along a line that is steeper than 45 degrees, otherwise over x. Returns the path."""
    steep = bool(np.ptp(table["y_m"]) >= np.ptp(table["x_m"]))
    along, label = (table["y_m"], "y (m)") if steep else (table["x_m"], "x (m)")
    if "peak_ux_relative_m" in table:  # what the base itself moves would hide it
        table = {name: values for name, values in table.items() if name not in ("peak_ux_m", "peak_uy_m")}
    panels = [(text if steep else text.replace(" (", "\n("), scale, _shown(table, columns)) for text, scale, columns in PANELS]
    panels = [panel for panel in panels if panel[2]]
    rows, columns = (1, len(panels)) if steep else (len(panels), 1)
    size = (2.1 * len(panels), 3.8) if steep else (7.2, 1.5 * len(panels))
    figure, axes = style.plt.subplots(rows, columns, figsize=size, layout="constrained", squeeze=False, sharey=steep, sharex=not steep)
    for ax, (text, scale, found) in zip(axes.flat, panels):
        for name, words in found.items():
            ax.plot(*((scale * table[name], along) if steep else (along, scale * table[name])), ".-", label=words, markersize=3)
        (ax.set_xlabel if steep else ax.set_ylabel)(text)
        (ax.set_xlim if steep else ax.set_ylim)(0, None)
        if len(found) > 1:
            ax.legend()
    if steep:
        axes[0, 0].set_ylabel(label)
    else:
        axes[-1, 0].set_xlabel(label)
    figure.suptitle(title, fontsize=10)
    return style.save(figure, path.parent, path.name)


def ratios(fourier, response, title, path):
    """Spectral ratios of a point over the base. Returns the path."""
    figure, axes = style.plt.subplots(1, 2, figsize=(9.0, 3.4), layout="constrained")
    for ax, table, axis, label in ((axes[0], fourier, "frequency_Hz", "frequency (Hz)"), (axes[1], response, "period_s", "period (s)")):
        for name, line in zip(list(table)[1:], ("-", "--")):
            if np.isfinite(table[name]).any():
                ax.semilogx(table[axis], table[name], line, label="horizontal" if name.endswith("x") else "vertical")
        ax.axhline(1.0, color="0.6", linewidth=0.5, zorder=0)
        ax.set(xlabel=label, ylim=(0, None))
    axes[0].set_ylabel("ratio of smoothed Fourier amplitudes")
    axes[1].set_ylabel("ratio of response spectra, 5 % damping")
    axes[0].legend()
    figure.suptitle(title, fontsize=10)
    return style.save(figure, path.parent, path.name)


def relative_displacement(histories, base, path):
    """Displacement of points relative to the base over time. histories: name -> table. Returns the path."""
    figure, axes = style.plt.subplots(2, 1, figsize=(7.2, 4.2), layout="constrained", sharex=True)
    for ax, direction, text in zip(axes, "xy", ("horizontal", "vertical")):
        for name, table in histories.items():
            ax.plot(table["time_s"], table[f"u{direction}_relative_m"], label=name, linewidth=0.8)
        ax.axhline(0.0, color="0.6", linewidth=0.5, zorder=0)
        ax.set_ylabel(f"{text} (m)")
    axes[1].set_xlabel("t (s)")
    axes[0].legend(ncols=3)
    figure.suptitle(f"displacement relative to {base}", fontsize=10)
    return style.save(figure, path.parent, path.name)


def newmark(histories, title, path):
    """Accelerations that drive the mass, and displacements. histories: name of the analysis -> table. Returns the path."""
    figure, axes = style.plt.subplots(2, 1, figsize=(7.2, 4.6), layout="constrained", sharex=True)
    for number, (name, table) in enumerate(histories.items()):
        name = name.replace("_", " ")
        axes[0].plot(table["time_s"], table["driving_m_s2"], color=style.COLOURS[number], linewidth=0.7, label=name)
        for line, column in zip(("-", "--", ":", "-."), [column for column in table if column.startswith("displacement")]):
            axes[1].plot(table["time_s"], table[column], line, color=style.COLOURS[number],
                         label=f"{name}, $k_y$ = {column.split('_')[2]}")
    axes[0].axhline(0.0, color="0.6", linewidth=0.5, zorder=0)
    axes[0].set_ylabel("driving acceleration (m/s²)")
    axes[1].set(xlabel="t (s)", ylabel="displacement down the slope (m)", ylim=(0, None))
    for ax in axes:
        ax.legend()
    figure.suptitle(title, fontsize=10)
    return style.save(figure, path.parent, path.name)
