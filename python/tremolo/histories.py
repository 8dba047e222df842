"""Histories: monitors with their response spectra, and the energy ledger."""

import numpy as np

from tremolo import style
from tremolo.response_spectrum import response_spectrum

PERIODS = np.geomspace(0.05, 4.0, 80)  # s
TICKS = [0.05, 0.1, 0.2, 0.5, 1, 2, 4]  # s


def even_steps(time, values):
    """Values resampled linearly to equal steps, and the step (s): output follows a time step that may vary."""
    steps = np.diff(time)
    dt = float(np.median(steps))
    if (first := float(np.median(steps[:100]))) < 0.5 * dt:  # a rest with longer intervals follows
        dt = first
    even = np.arange(time[0], time[-1] + 0.5 * dt, dt)
    return np.interp(even, time, values), dt


def monitor(run, name, folder):
    series = run.monitor(name)
    time = series["time"]
    figure, axes = style.plt.subplot_mosaic(
        [["a", "s"], ["v", "s"], ["u", "s"]], figsize=(9.0, 4.8), layout="constrained", width_ratios=[1.8, 1.0]
    )
    labels = {"a": "acceleration (m/s²)", "v": "velocity (m/s)", "u": "displacement (m)"}
    for quantity, label in labels.items():
        ax = axes[quantity]
        for direction, text in (("x", "horizontal"), ("y", "vertical")):
            ax.plot(time, series[quantity + direction], label=text, linewidth=0.8)
        ax.axhline(0.0, color="0.6", linewidth=0.5, zorder=0)
        ax.set_ylabel(label)
        ax.set_xlim(time[0], time[-1])
        if quantity != "u":
            ax.tick_params(labelbottom=False)
    axes["u"].set_xlabel("t (s)")
    axes["a"].legend(loc="upper right", ncols=2)
    for direction, text in (("x", "horizontal"), ("y", "vertical")):
        acceleration, dt = even_steps(time, series["a" + direction])
        shown = PERIODS >= 2.0 * dt
        axes["s"].semilogx(PERIODS[shown], response_spectrum(acceleration, dt, PERIODS[shown]), label=text)
    axes["s"].set(xlabel="period (s)", ylabel="spectral acceleration, 5 % damping (m/s²)", ylim=(0, None))
    axes["s"].set_xlim(PERIODS[0], PERIODS[-1])
    axes["s"].set_xticks(TICKS, [f"{tick:g}" for tick in TICKS])
    axes["s"].minorticks_off()
    figure.suptitle(f"{name}, starting at x = {series['x'][0]:.2f} m, y = {series['y'][0]:.2f} m", fontsize=10)
    return style.save(figure, folder, f"monitor_{name}.png")


def common_monitors(runs):
    """Names of the monitors of all runs that have a history."""
    return [name for name in runs[0].monitors if all(name in run.monitors and len(run.monitor(name)) > 1 for run in runs)]


def compared(runs, folder):
    """Acceleration and response spectrum at the common monitors, a line a run: compare_histories.png. Of each monitor the
    direction in which the first run moves more. None where no monitor is common."""
    names = common_monitors(runs)
    if not names:
        return None
    figure, axes = style.plt.subplots(len(names), 2, figsize=(10.0, 0.8 + 2.2 * len(names)), squeeze=False, layout="constrained",
                                      width_ratios=[1.8, 1.0])
    for (history, spectrum), name in zip(axes, names):
        first = runs[0].monitor(name)
        direction = max("xy", key=lambda one: np.abs(first["a" + one]).max())
        for number, run in enumerate(runs):
            series, line = run.monitor(name), "-" if number == 0 else "--"
            history.plot(series["time"], series["a" + direction], line, linewidth=0.8, label=run.name)
            acceleration, dt = even_steps(series["time"], series["a" + direction])
            shown = PERIODS >= 2.0 * dt
            spectrum.semilogx(PERIODS[shown], response_spectrum(acceleration, dt, PERIODS[shown]), line, label=run.name)
        history.set(title=name, ylabel=f"$a_{direction}$ (m/s²)")
        spectrum.set(title=name, ylabel="5 % spectrum (m/s²)", ylim=(0, None), xlim=(PERIODS[0], PERIODS[-1]))
        spectrum.set_xticks(TICKS, [f"{tick:g}" for tick in TICKS])
        spectrum.minorticks_off()
    axes[0][0].legend()
    axes[-1][0].set_xlabel("t (s)")
    axes[-1][1].set_xlabel("period (s)")
    return style.save(figure, folder, "compare_histories.png")


def energy(run, folder):
    """Every entry of the ledger over time; below it their absolute values, so that small ones show beside what the base takes in."""
    ledger = run.energy
    figure, (ax, sizes) = style.plt.subplots(2, figsize=(7.2, 5.6), layout="constrained", sharex=True)
    entries = [column for column in ledger.columns[1:] if np.any(ledger[column])]
    for number, column in enumerate(entries):
        line = "-" if number < len(style.COLOURS) else "--"
        ax.plot(ledger["time"], ledger[column] / 1e3, line, label=column.replace("_", " "))
        sizes.plot(ledger["time"], np.abs(ledger[column]) / 1e3, line)
    ax.axhline(0.0, color="0.6", linewidth=0.5, zorder=0)
    ax.set(ylabel="energy (kJ per m of thickness)")
    top = 2.0 * max(np.abs(ledger[column]).max() for column in entries) / 1e3 if entries else 1.0
    sizes.set(xlabel="t (s)", ylabel="absolute value (kJ per m)", yscale="log", ylim=(1e-7 * top, top))
    ax.set_xlim(ledger["time"][0], ledger["time"][-1])
    ax.legend(loc="center left", bbox_to_anchor=(1.0, 0.5))
    return style.save(figure, folder, "energy.png")
