"""Rows of the gallery's tables: a soil test of ours beside its reference curve."""

import numpy as np
from tremolo.soil_test import response

NONE = "-"


def number(value, digits=4):
    """A value as it stands in a table; what does not exist is a dash."""
    return f"{value:.{digits}g}" if np.isfinite(value) else NONE


def percent(value):
    """A difference to a hundredth of a per cent, without a sign where it rounds to nothing."""
    text = f"{100 * value:+.2f} %"
    return text[1:] if float(text[:-1]) == 0.0 else text


def pair(ours, reference, digits=4):
    """ours (difference in per cent), over the reference."""
    if not (np.isfinite(ours) and np.isfinite(reference)):
        return f"{number(ours, digits)} / {number(reference, digits)}"
    return f"{number(ours, digits)} / {number(reference, digits)} ({percent(response.relative(ours, reference))})"


def cycles(ours, reference):
    """Cycles to r_u = 0.98 and to 1, 3, 5 % strain, ours / reference.

    Soil that softens falls back from a stress that it had reached; cycles do not run backwards with it.
    """
    cells = []
    for measure, level in (("ru", 0.98), ("strain", 0.01), ("strain", 0.03), ("strain", 0.05)):
        both = []
        for history in (ours, reference):
            pressure = measure == "ru"
            values = response.pore_pressure_ratio(history) if pressure else np.abs(history["gamma_xy"])
            both.append(response.cycles_to(np.maximum.accumulate(history["cycle"]), values, level))
        cells.append(NONE if np.isnan(both).all() else " / ".join(f"{n:.2f}" if np.isfinite(n) else NONE for n in both))
    return cells


def replay(ours, reference, vertical_stress, low_pressure):
    """Largest stress difference along the same strains, kPa and % of sigma'_v: until p' first falls below
    `low_pressure`, and in all."""
    difference, rows = response.stress_differences(ours, reference)
    pressure = response.mean_stress(reference, in_plane=True)[rows]
    low = np.flatnonzero(pressure < low_pressure)
    until = low[0] if len(low) else len(rows)
    parts = difference[:until].max(), difference.max()
    return [f"{part / 1e3:.3f} kPa, {100 * part / vertical_stress:.3f} %" for part in parts]


def loops(ours, reference):
    """A row an amplitude, of its last loop: secant modulus (MPa), damping (%) and volumetric strain at its end (%)."""
    found = []
    for history in (ours, reference):
        strain, stress, volume = history["gamma_xy"], history["sig_xy"], response.volumetric_strain(history)
        slices = response.last_loops(strain)
        found.append([(*response.secant_and_damping(strain[one], stress[one]), volume[one][-1]) for one in slices])
    table_rows = []
    for (amplitude, *mine), (_, *theirs) in zip(*found, strict=True):
        (g, d, v), (g_ref, d_ref, v_ref) = mine, theirs
        volume = pair(100 * v, 100 * v_ref, 3) if abs(v_ref) > 1e-9 else NONE
        modulus, damping = pair(g / 1e6, g_ref / 1e6), pair(100 * d, 100 * d_ref, 3)
        table_rows.append([f"{100 * amplitude:.3g} %", modulus, damping, volume])
    return table_rows


def volume_all_the_way(ours, reference):
    """A sentence on where the volumetric strains of the same increments are furthest apart."""
    mine, theirs = response.common_rows(ours, reference)
    ours_there, reference_there = (
        100.0 * response.volumetric_strain(history)[rows] for history, rows in ((ours, mine), (reference, theirs))
    )
    k = np.argmax(np.abs(ours_there - reference_there))
    strain, cycle = 100.0 * reference["gamma_xy"][theirs][k], reference["cycle"][theirs][k]
    return (
        "Over all increments of the drained cycles they are at most "
        f"{abs(ours_there[k] - reference_there[k]):.2g} % apart,\n"
        f"{ours_there[k]:.3g} / {reference_there[k]:.3g} % after {cycle:.3g} cycles at {strain:.3g} % shear strain."
    )


def monotonic(ours, reference, shear):
    """Peak shear stress or deviator (kPa), the same at the end, and volumetric strain at the end (%)."""

    def strength(history):
        return np.abs(history["sig_xy"]) if shear else response.deviator_of_plane(history)

    peaks = [strength(history).max() / 1e3 for history in (ours, reference)]
    ends = [strength(history)[-1] / 1e3 for history in (ours, reference)]
    volumes = [100 * response.volumetric_strain(history)[-1] for history in (ours, reference)]
    undrained = np.abs(volumes).max() < 1e-9
    return [pair(*peaks), pair(*ends), NONE if undrained else pair(*volumes, 3)]


def table(head, rows):
    """Markdown."""
    lines = [f"| {' | '.join(head)} |", f"|{'---|' * len(head)}"]
    return "\n".join(lines + [f"| {' | '.join(row)} |" for row in rows])
