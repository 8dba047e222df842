"""A history in the quantities of the axes, and the lines of a law in the plane of its stress path."""

import numpy as np

from tremolo import style
from tremolo.soil_test import response

LINES = {
    "critical_state": ("critical state", "-", "#000000"),
    "bounding": ("bounding", "--", "#D55E00"),
    "dilation": ("dilation", ":", "#009E73"),
    "phase_transformation": ("phase transformation", ":", "#009E73"),
    "failure": ("failure", "--", "#D55E00"),
    "residual": ("residual", ":", "#D55E00"),
}


class View:
    """One history, ours or a reference, in the quantities of the axes: kPa, per cent, compression positive."""

    def __init__(self, history, kind, in_plane):
        self.cycle = history.get("cycle")
        self.p = response.mean_stress(history, in_plane) / 1e3
        shear = sheared(history, kind)
        if shear:
            self.strain, self.strain_label = 100 * history["gamma_xy"], "shear strain (%)"
            self.stress, self.stress_label = history["sig_xy"] / 1e3, "shear stress (kPa)"
            # In simple shear towards failure the whole deviator is shear stress: q = 2 tau, in space sqrt(3) tau.
            self.line_scale = 0.5 if in_plane else 1.0 / np.sqrt(3.0)
        else:
            self.strain, self.strain_label = -100 * history["eps_yy"], "axial strain (%)"
            q = response.deviator_of_plane(history) if in_plane else response.deviator_of_space(history)
            sign = np.where(history["sig_yy"] > history["sig_xx"], -1.0, 1.0)
            self.stress, self.stress_label = sign * q / 1e3, "deviator stress q (kPa)"
            self.line_scale = 1.0
        self.p_label = f"mean effective stress {'in the plane ' if in_plane else ''}p' (kPa)"
        self.volume = 100 * response.volumetric_strain(history)
        held = "sig_yy" if shear else "sig_xx"
        given = "ru" in history and kind != "path"
        self.ru = history["ru"] if given else response.pore_pressure_ratio(history, held)
        self.vertical = -history["sig_yy"] / 1e3


def sheared(history, kind):
    """Whether a test is looked at in simple shear; a path is where it shears more than it shortens."""
    if kind == "path":
        return bool(np.abs(history["gamma_xy"]).max() > np.abs(history["eps_yy"]).max())
    return kind == "direct_simple_shear"


def residual_line(test):
    """What softening Mohr-Coulomb ends at, q = 2 c cos(phi) + 2 p sin(phi) in the plane; None for other soils."""
    values = dict(zip(test.parameters.get("name", ()), test.parameters.get("value", ())))
    if "failure" not in test.lines or not {"cohesion_residual", "friction_residual_deg"} <= values.keys():
        return None
    ends = values["cohesion_residual"], values["friction_residual_deg"]
    if ends == (values["cohesion_peak"], values["friction_peak_deg"]):
        return None
    p, phi = test.lines["failure"]["p"], np.radians(ends[1])
    return {"p": p, "q": 2.0 * (ends[0] * np.cos(phi) + p * np.sin(phi))}


def law_lines(test):
    """Label, stroke, colour and points (p, q in Pa) of every line of the law, the residual strength among them."""
    residual = residual_line(test)
    lines = test.lines if residual is None else test.lines | {"residual": residual}
    for name, points in lines.items():
        yield *LINES.get(name, (name.replace("_", " "), "-.", style.COLOURS[3])), points
