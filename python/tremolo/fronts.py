"""Wave fronts along the base: a time-distance picture, and the apparent horizontal velocity measured from it.

A plane wave of horizontal slowness p moves every point of a level as v(x, t) = f(t - p x). The slowness is measured by
a slant stack: of all trial values, the one for which the traces, shifted by p x, add up to the most energy.
"""

import numpy as np

from tremolo import style

STEEPEST = 0.02  # s/m: the largest slowness tried, an apparent velocity of 50 m/s
PARALLEL = 1e-5  # s/m: below it (faster than 100 km/s) fronts are called parallel to the base


def level_traces(run, height=0.1, component=0, bin_width=None):
    """Velocity along a level near the base: x [n] (m), t [m] (s), v [m, n] (m/s).

    height: of the level above the base, as a share of the model's height.
    """
    start = run.field(0, "position")
    low, high = start.min(axis=0), start.max(axis=0)
    width = bin_width or run.attribute("mesh_size") or 2.0 * style.spacing(run)
    level = low[1] + height * (high[1] - low[1])
    edges = np.arange(low[0], high[0] + 0.5 * width, width)
    traces = []
    for index in range(len(run.times)):
        position = run.field(index, "position")
        near = np.abs(position[:, 1] - level) <= width
        bins = np.clip(np.digitize(position[near, 0], edges) - 1, 0, len(edges) - 2)
        velocity = run.field(index, "velocity")[near, component]
        count = np.bincount(bins, minlength=len(edges) - 1)
        traces.append(np.bincount(bins, velocity, minlength=len(edges) - 1) / np.maximum(count, 1))
    return 0.5 * (edges[1:] + edges[:-1]), run.times, np.array(traces)


def slowness(x, t, v):
    """Horizontal slowness (s/m) of v(x, t) = f(t - p x): a slant stack over trial values, refined three times.

    The shift by p x is a phase exp(i w p x) of the padded spectrum, exact for what the sampling resolves.
    """
    spectrum = np.fft.rfft(v, 2 * len(t), axis=0)
    omega = 2.0 * np.pi * np.fft.rfftfreq(2 * len(t), t[1] - t[0])
    strong = np.sum(np.abs(spectrum), axis=1) > 1e-3 * np.sum(np.abs(spectrum), axis=1).max()
    offset = x - 0.5 * (x[0] + x[-1])

    def energy(p):
        phase = np.exp(1j * np.outer(omega[strong], p * offset))
        return np.sum(np.abs(np.sum(spectrum[strong] * phase, axis=1)) ** 2)

    trials = np.linspace(-STEEPEST, STEEPEST, 401)
    for _ in range(3):
        step = trials[1] - trials[0]
        best = trials[np.argmax([energy(p) for p in trials])]
        trials = np.linspace(best - step, best + step, 41)
    return float(best)


def fronts(run, folder):
    x, t, v = level_traces(run)
    p = slowness(x, t, v)
    limit = float(np.percentile(np.abs(v), 99.7)) or 1.0
    figure, ax = style.plt.subplots(figsize=(5.6, 4.2), layout="constrained")
    drawn = ax.pcolormesh(x, t, v, cmap=style.DIVERGING, vmin=-limit, vmax=limit, shading="nearest", rasterized=True)
    figure.colorbar(drawn, ax=ax, label="horizontal particle velocity (m/s)", extend="both")
    peak = t[np.argmax(np.abs(v[:, len(x) // 2]))]
    ax.plot(x, peak + p * (x - x[len(x) // 2]), color="black", linestyle="--", linewidth=1.0)
    speed = "fronts parallel to the base" if abs(p) < PARALLEL else f"apparent velocity {1.0 / p:.0f} m/s along x"
    ax.set(xlabel="x (m)", ylabel="t (s)", ylim=(t[0], t[-1]))
    ax.set_title(f"{speed} (dashed), measured 10 % above the base", loc="left")
    return style.save(figure, folder, "fronts.png")
