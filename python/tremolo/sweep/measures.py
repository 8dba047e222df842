"""What is measured of a run of a sweep. Names end with the unit: `_m`, `_s`, `_m_s2`, `_rad`; those without one are ratios.

    MONITOR.peak_displacement_m, final_displacement_m    |u|, largest and last
    MONITOR.final_ux_m, final_uy_m, peak_ax_m_s2         components; largest |a_x|
    MONITOR.peak_r_u, final_r_u                          excess pore pressure ratio, below a water table
    STRUCTURE.peak_tilt_rad, final_tilt_rad              |tilt|
    STRUCTURE.settlement_m, final_shift_m                of the centre of mass, downwards and along x
    failure_time_s                                       of a slope (failure.py); None where it holds
    run_out_m                                            of a slope: how far beyond the toe, along x, soil from above it lies at last
    spectral_ratio_Ts                                    S_a of one monitor over that of another, 5 % damping, at period T
    cpu_s, wall_s                                        CPU time of all processes; time from start to end
"""

import numpy as np

from tremolo import failure
from tremolo.histories import even_steps
from tremolo.response_spectrum import response_spectrum

UNITS = {"_m_s2": "m/s2", "_m_s": "m/s", "_rad": "rad", "_m": "m", "_s": "s"}


def unit(name):
    """By the end of the name; "1" for ratios."""
    if name.startswith("spectral_ratio_"):
        return "1"
    return next((text for end, text in UNITS.items() if name.endswith(end)), "1")


def _of_monitor(run, name):
    series = run.monitor(name)
    if len(series) == 0:
        return {}
    moved = np.hypot(series["ux"], series["uy"])
    found = {
        "peak_displacement_m": moved.max(), "final_displacement_m": moved[-1], "final_ux_m": series["ux"][-1],
        "final_uy_m": series["uy"][-1], "peak_ax_m_s2": np.abs(series["ax"]).max(),
    }
    if "pore_pressure_ratio" in series.columns:
        ratio = series["pore_pressure_ratio"]
        found |= {"peak_r_u": ratio.max(), "final_r_u": ratio[-1]}
    return {f"{name}.{measure}": float(value) for measure, value in found.items()}


def _of_structure(run, name):
    body = run.body(name)
    if len(body) == 0:
        return {}
    tilt = np.abs(body["tilt"])
    found = {"peak_tilt_rad": tilt.max(), "final_tilt_rad": tilt[-1], "settlement_m": body["y"][0] - body["y"][-1],
             "final_shift_m": body["x"][-1] - body["x"][0]}
    return {f"{name}.{measure}": float(value) for measure, value in found.items()}


def is_slope(run):
    """Whether failure and run-out are defined."""
    fields = run.has_field("equivalent_plastic_strain") and run.has_field("displacement")
    return bool(fields) and "toe" in run.monitors and len(set(run.attribute("surface_levels"))) > 1


def run_out(run):
    """How far beyond the toe, along x, the soil that began above it lies in the last frame, m; 0 where none does."""
    left, right = run.attribute("surface_levels")
    toe = run.monitor("toe")["x"][0]
    last = len(run.times) - 1
    position = run.field(last, "position")
    began = position - run.field(last, "displacement")
    above = began[:, 1] > min(left, right)
    beyond = (toe - position[above, 0]) * (1.0 if left < right else -1.0)
    return float(max(0.0, beyond.max(initial=0.0)))


def _spectra(run, ratio):
    periods = np.asarray(ratio["periods"], dtype=float)
    one, other = (
        response_spectrum(*even_steps(run.monitor(name)["time"], run.monitor(name)["ax"]), periods) for name in (ratio["of"], ratio["over"])
    )
    return {f"spectral_ratio_{period:g}s": float(a / b) if b > 0.0 else None for period, a, b in zip(periods, one, other)}


def measured(run, settings):
    """All measures of a run that has ended: name -> number, or None where there is none.

    settings: `failure_strain` and `spectral_ratio` of the study.
    Raises ValueError, OSError and KeyError for a run that does not hold what it should.
    """
    found = {}
    for name in run.monitors:
        found |= _of_monitor(run, name)
    for name in run.bodies:
        found |= _of_structure(run, name)
    if is_slope(run):
        found["failure_time_s"] = failure.failure_time(run, settings["failure_strain"])
        found["run_out_m"] = run_out(run)
    if settings["spectral_ratio"]:
        found |= _spectra(run, settings["spectral_ratio"])
    processes = run.table("processes")
    found |= {"cpu_s": float(sum(processes["cpu_time"])), "wall_s": float(max(processes["wall_time"]))}
    return found
