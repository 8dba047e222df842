"""What a reviewer of a deformation analysis asks for: each row with the run's number, or with the command that makes it.

The commands read files that checklist() leaves in the folder `checks` beside run.h5: an element test of each sand that may
liquefy at the stress that it has in the field, and studies of its permeability and of the cells.
"""

import tomllib

import numpy as np

from tremolo.report.facts import Table

FOLDER = "checks"
SANDS = ("pm4sand", "pdmy03")
LIBRARY = {"hostun": "pm4sand"} | {sand: sand for sand in SANDS}  # by how the names of the library begin
OF_A_CASE_ALONE = ("grain_density", "permeability", "damping", "drainage", "porosity", "void_ratio", "rest_coefficient")
RATIOS = [0.08, 0.1, 0.125, 0.16, 0.2, 0.25]  # cyclic stress ratios of the strength curve
LEAST_PRESSURE = 5e3  # Pa; below it soil flows, and an angle says nothing


def _sands(case):
    """The sands of a case that may liquefy, by name."""
    def law(soil):
        return soil.get("model") or next((of for name, of in LIBRARY.items() if soil.get("library", "").startswith(name)), None)

    return {name: soil for name, soil in case.get("soil", {}).items() if law(soil) in SANDS}


def _of_soil(run, index, name):
    """Which particles of a frame are of a soil."""
    return run.field(index, "soil") == list(run.attribute("soil_names")).index(name)


def _stress(run, index):
    """(sxx, syy, sxy) of all particles, Pa, effective; None where the frames hold no stress."""
    if not run.has_field("stress"):
        return None
    stress = run.field(index, "stress")
    return stress[:, 0], stress[:, 1], stress[:, -1]


def _field_stress(run, name):
    """Median vertical effective stress of a soil before the shaking, Pa."""
    stress = _stress(run, 0)
    return None if stress is None else float(-np.median(stress[1][_of_soil(run, 0, name)]))


def _mobilised(run, index, name):
    """The 95 % quantile of the mobilised friction angle of a soil in the plane, degrees."""
    chosen = _of_soil(run, index, name)
    sxx, syy, sxy = (component[chosen] for component in _stress(run, index))
    pressure = -0.5 * (sxx + syy)
    sound = pressure > LEAST_PRESSURE
    if not np.any(sound):
        return None
    radius = np.hypot(0.5 * (sxx - syy), sxy)[sound]
    return float(np.degrees(np.arcsin(np.minimum(1.0, np.quantile(radius / pressure[sound], 0.95)))))


def _value(value):
    """A value of a TOML file."""
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, str):
        return f'"{value}"'
    if isinstance(value, list):
        return f"[{', '.join(map(_value, value))}]"
    return repr(value)


def _strength_test(name, soil, vertical_stress, k0):
    """A soil test file: the cyclic strength curve at the stress that the soil has in the field."""
    own = {key: value for key, value in soil.items() if key not in OF_A_CASE_ALONE}
    if "library" not in own:
        own.setdefault("density", 2000.0)  # an element test has no inertia
    lines = [f'title = "{name}, cyclic strength at the stress of the field"', "", "[soil]"]
    lines += [f"{key} = {_value(value)}" for key, value in own.items()]
    lines += ["", "[test]", 'kind = "direct_simple_shear"', 'drainage = "constant_volume"', f"vertical_stress = {vertical_stress:.4g}",
              f"k0 = {k0:.3g}", "every = 50", "", "[loading]", 'kind = "cyclic_stress"', f"stress_ratio = {RATIOS}"]
    return "\n".join(lines) + "\n"


def _study(title, axes):
    """A study of the run's case."""
    lines = [f'title = "{title}"', 'case = "../case.toml"', "", "[axes]", *(f"{key} = {values}" for key, values in axes.items()),
             "", "[measures]", 'intensity = "pga"']
    return "\n".join(lines) + "\n"


def files(run):
    """Name -> text of what the commands read."""
    case = tomllib.loads(run.case)
    found = {}
    for name, soil in _sands(case).items():
        vertical = _field_stress(run, name)
        if vertical is not None and vertical > 0.0:
            found[f"{name}_strength.toml"] = _strength_test(name, soil, vertical, soil.get("rest_coefficient", 0.5))
    permeable = {f"soil.{name}.permeability": [k / 10.0, k, 10.0 * k] for name, soil in case.get("soil", {}).items()
                 if (k := soil.get("permeability"))}
    if permeable:
        found["permeability.toml"] = _study("Permeability by ten", permeable) + '\n[design]\nkind = "list"\n'
    if size := case.get("mesh", {}).get("size"):
        found["cells.toml"] = _study("Cells of two sizes", {"mesh.size": [size, 0.5 * size]})
    return found


def _write(run, texts):
    folder = run.path.parent / FOLDER
    folder.mkdir(exist_ok=True)
    for name, text in texts.items():
        (folder / name).write_text(text, encoding="utf-8")


def _sand_rows(run, names):
    for name in _sands(tomllib.loads(run.case)):
        if (file := f"{name}_strength.toml") in names:
            stress = f"at its median vertical effective stress, {1e-3 * _field_stress(run, name):.3g} kPa"
            yield [f"element tests of '{name}' with its CSR-N line", stress, f"tremolo soiltest {FOLDER}/{file} --out {name}.h5 --plot"]
        else:
            yield [f"element tests of '{name}' with its CSR-N line", "the frames hold no stress", '[output] fields = ["stress", ...]']


def _angle_rows(run):
    if not run.has_field("stress") or run.attribute("soil_names") is None:
        return
    sxx, syy, _ = _stress(run, 0)
    for name in run.attribute("soil_names"):
        pressed = _of_soil(run, 0, name) & (syy < -LEAST_PRESSURE)
        if not np.any(pressed):
            continue
        low, high = np.quantile(sxx[pressed] / syy[pressed], [0.05, 0.95])
        angles = [_mobilised(run, index, name) for index in (0, len(run.times) - 1)]
        words = ", ".join("none" if angle is None else f"{angle:.1f}°" for angle in angles)
        yield [f"K0 and mobilised friction angle of '{name}'",
               f"K0 {low:.2f} to {high:.2f} (5 to 95 % of the soil); angle, 95 % of the soil, at the start and the end {words}", ""]


def _drift_row(run):
    drift = run.table("drift")
    if drift is None:
        return []
    moved = np.hypot(drift["dx"], drift["dy"])
    place, share = int(np.argmax(moved)), float(np.max(drift["strength_share"]))
    return [["base and side drift", f"at most {1e3 * moved[place]:.3g} mm beyond the free field, at x = {drift['x'][place]:.4g} m, "
             f"y = {drift['y'][place]:.4g} m; springs ask for {share:.2g} of the soil's strength at most", ""]]


def _energy_row(run):
    energy = run.energy
    if energy is None or len(energy) == 0:
        return []
    residual, given = float(np.abs(energy["residual"]).max()), float(np.abs(energy["input"]).max())
    share = f", {100.0 * residual / given:.2g} % of the largest work of the free field" if given > 0.0 else ""
    return [["energy ledger", f"largest residual {residual:.3g} J/m{share}", ""]]


def _step_row(run):
    plan = run.plan
    if not plan:
        return []
    return [["time step", f"{plan['dt_s']:.4g} s, {plan['dt_s'] / plan['critical_dt_s']:.2f} of the critical one",
             "another one: [time] fraction"]]


def checklist(run):
    """The table. Writes the files that its commands read, where the folder of the run can be written to."""
    names = files(run)
    caption = "A reviewer's list"
    try:
        _write(run, names)
    except OSError as error:
        caption += f"; the files that the commands read could not be written: {error}"
    rows = list(_sand_rows(run, names))
    if "permeability.toml" in names:
        rows.append(["permeability times and by ten", "", f"tremolo sweep {FOLDER}/permeability.toml"])
    if "cells.toml" in names:
        rows.append(["two cell sizes", "", f"tremolo sweep {FOLDER}/cells.toml"])
    rows += [*_drift_row(run), *_energy_row(run), *_angle_rows(run), *_step_row(run)]
    return Table(["asked for", "in this run", "command, in the folder of the run"], rows, caption)
