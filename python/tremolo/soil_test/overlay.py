"""A curve from a file that shall lie below a soil test: read, and held against the test it goes with."""

import numpy as np

from tremolo.soil_test import record


def overlay(test, path, stress_unit, names):
    """Columns of the curve `path`, stresses in Pa, to lie below the histories `names` of a test.

    Raises ValueError where the curve lacks what the picture shows, or where its stresses are in another unit.
    """
    curve = record.read_reference(path, stress_unit)
    if "cycle" not in curve and test.about["loading"] in ("cyclic_stress", "cyclic_strain", "modulus_curve"):
        raise ValueError(f"{path}: has no column cycle, but the picture of this test counts cycles")
    _require_same_unit(test, path, stress_unit, curve, names)
    return curve


def _require_same_unit(test, path, stress_unit, curve, names):
    """A thousand times too much or too little, to half a decade, is the other unit and no other test."""
    theirs = abs(curve["sig_yy"][0])
    for name in names:
        ours = abs(test.histories[name]["sig_yy"][0])
        if theirs == 0.0 or ours == 0.0 or abs(abs(np.log10(theirs / ours)) - 3.0) > 0.5:
            continue
        other = "Pa" if stress_unit == "kPa" else "kPa"
        mended = (theirs > ours) == (other == "Pa")
        advice = f"looks like {other}: give --stress-unit {other}" if mended else "neither Pa nor kPa makes them alike"
        raise ValueError(
            f"{path}: in {stress_unit} its first vertical stress is {theirs / 1e3:.4g} kPa, that of {test.path.name} "
            f"is {ours / 1e3:.4g} kPa: {advice}"
        )
