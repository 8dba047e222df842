"""Wave fronts along the base: a time-distance picture, and the apparent horizontal velocity measured from it.

A plane wave of horizontal slowness p moves every point of a level as v(x, t) = f(t - p x). The slowness is measured by
a slant stack: of all trial values, the one for which the traces, shifted by p x, add up to the most energy.
"""

import numpy as np

from tremolo import style
from tremolo.histories import even_steps

STEEPEST = 0.02  # s/m: the largest slowness tried, an apparent velocity of 50 m/s
PARALLEL = 1e-5  # s/m: below it (faster than 100 km/s) fronts are called parallel to the base


def base_traces(run, component=0):
    """The soil's velocity along the base of the model: x [n] (m), t [m] (s), v [m, n] (m/s)."""
    boundary = run.boundary
    base = np.flatnonzero(boundary["normal"][:, 1] < -0.5)
    base = base[np.argsort(boundary["position"][base, 0])]
    return boundary["position"][base, 0], boundary["time"], boundary["domain_velocity"][:, base, component]


def slowness(x, t, v):
    """Horizontal slowness (s/m) of v(x, t) = f(t - p x): a slant stack over trial values, refined three times.

    The shift by p x is a phase exp(i w p x) of the padded spectrum, exact for what the sampling resolves. A run writes
    at the first step after each interval, so its times are uniform only to a step: they are made so first.
    """
    dt = even_steps(t, t)[1]
    v = np.column_stack([even_steps(t, trace)[0] for trace in v.T])
    spectrum = np.fft.rfft(v, 2 * len(v), axis=0)
    omega = 2.0 * np.pi * np.fft.rfftfreq(2 * len(v), dt)
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
    x, t, v = base_traces(run)
    p = slowness(x, t, v)
    limit = float(np.percentile(np.abs(v), 99.7)) or 1.0
    figure, ax = style.plt.subplots(figsize=(5.6, 4.2), layout="constrained")
    drawn = ax.pcolormesh(x, t, v, cmap=style.DIVERGING, vmin=-limit, vmax=limit, shading="nearest", rasterized=True)
    figure.colorbar(drawn, ax=ax, label="horizontal particle velocity (m/s)", extend="both")
    peak = t[np.argmax(np.abs(v[:, len(x) // 2]))]
    ax.plot(x, peak + p * (x - x[len(x) // 2]), color="black", linestyle="--", linewidth=1.0)
    speed = "fronts parallel to the base" if abs(p) < PARALLEL else f"apparent velocity {1.0 / p:.0f} m/s along x"
    ax.set(xlabel="x (m)", ylabel="t (s)", ylim=(t[0], t[-1]))
    ax.set_title(f"{speed} (dashed), measured along the base", loc="left")
    return style.save(figure, folder, "fronts.png")
