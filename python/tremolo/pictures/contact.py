"""Pressure and shear on the surface of structures: pressure outwards, shear outwards where it turns the structure counter-clockwise."""

import numpy as np

from tremolo import style
from tremolo.pictures import diagrams

# Name, what is drawn, which sign is outwards, unit.
DRY = (("pressure", "pressure of the ground", 1.0, "kPa"), ("shear", "shear of the ground", 1.0, "kPa"))
WET = (("pressure", "effective pressure", 1.0, "kPa"), DRY[1], ("water_pressure", "excess pore pressure", 1.0, "kPa"))


def picture(run, folder, name, times=None):
    """contact_NAME.png; None of a run whose frames have no contact forces on the structure."""
    stress = run.contact_stress(name)
    if not np.any(stress.pressure):
        return None
    # Contact has no forces yet in a frame before the first step.
    first = int(np.argmax(np.any(stress.pressure != 0.0, axis=1)))
    time = stress.time[first:]

    def values(component):
        return getattr(stress, component)[first:]

    rows = [int(np.argmin(np.abs(time - wanted))) for wanted in times] if times else diagrams.telling_rows(values("pressure"))
    figure = diagrams.sheet(
        WET if np.any(stress.water_pressure) else DRY,
        lambda ax, component, sign: diagrams.draw(ax, stress.outline, stress.places, stress.outwards, values(component), time, rows, sign),
        values, time)
    figure.axes[0].legend(loc="upper left", frameon=False)  # beside what is slender
    figure.suptitle(f"{name}: contact with the ground and other structures", fontsize=10)
    return style.save(figure, folder, f"contact_{name}.png")
