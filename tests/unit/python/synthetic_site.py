"""A site under three models whose answers are known: 10 m of clay on rock under a Ricker pulse, of which the surface has `factor`
times the acceleration of the outcrop, at all frequencies."""

import json
from pathlib import Path

import h5py
import numpy as np

from synthetic_run import ricker
from tremolo.response_spectrum import response_spectrum

DT, DURATION = 0.005, 20.0
DEPTH, RHO, VS, G = 10.0, 1800.0, 200.0, 9.80665
FACTORS = {"eql": 1.5, "fe": 1.2, "wave": 2.5}
PERIODS = np.geomspace(0.02, 5.0, 60)
UNITS = {"y": "m", "top": "m", "bottom": "m", "depth": "m", "density": "kg/m3", "vs": "m/s", "vp": "m/s", "vs30": "m/s", "mean_vs": "m/s",
         "shear_modulus": "Pa", "period": "s", "period_of_mean_vs": "s", "pga": "m/s2", "pgv": "m/s", "arias": "m/s", "cav": "m/s",
         "duration_5_75": "s", "duration_5_95": "s", "mean_period": "s", "peak_ax": "m/s2", "peak_ay": "m/s2", "peak_vx": "m/s",
         "peak_vy": "m/s", "peak_ux": "m", "peak_uy": "m", "peak_ux_relative": "m", "peak_uy_relative": "m", "peak_sxy": "Pa",
         "effective_stress": "Pa"}


def pulse():
    """Time (s) and acceleration of the outcrop (m/s2)."""
    time = np.arange(0.0, DURATION, DT)
    return time, 2.0 * ricker(time, frequency=2.0, peak_time=5.0)


def _table(file, path, **columns):
    group = file.create_group(path)
    group.attrs["columns"] = np.array([name.encode() for name in columns])
    for name, values in columns.items():
        group[name] = np.array([value.encode() for value in values]) if isinstance(values[0], str) else values
        group[name].attrs["unit"] = UNITS.get(name, "1").encode()


def _series(file, path, **columns):
    dataset = file.create_dataset(path, data=np.column_stack(list(columns.values())))
    dataset.attrs["columns"] = np.array([name.encode() for name in columns])
    dataset.attrs["units"] = np.array([b"1"] * len(columns))


def _amplitude(acceleration):
    return DT * np.abs(np.fft.rfft(acceleration))


def write_column(path, model, factor=None, vs=VS):
    """factor: of the surface, in place of the model's own; vs: of the clay, m/s."""
    factor = FACTORS[model] if factor is None else factor
    time, outcrop = pulse()
    surface = factor * outcrop
    y = np.linspace(-DEPTH, 0.0, 21)
    stress = RHO * factor * np.abs(outcrop).max() * -y
    effective = RHO * G * -y
    ratio = np.where(effective > 0.0, stress / np.where(effective > 0.0, effective, 1.0), 0.0)
    peak = factor * np.abs(outcrop).max()
    with h5py.File(path, "w") as file:
        file.attrs.update({"schema_version": np.bytes_("1.6"), "content": np.bytes_("column"), "title": np.bytes_("synthetic site"),
                           "status": np.bytes_("complete"), "model": np.bytes_(model), "wave": np.bytes_("SV"), "cpu_time": 0.5,
                           "report": np.bytes_("")})
        file["case"] = np.bytes_("title = 'synthetic site'\n")
        file.create_group("frames")
        zero = np.zeros(len(time))
        for name, acceleration in (("surface", surface), ("10 m", outcrop)):
            velocity = np.cumsum(acceleration) * DT
            _series(file, f"monitors/{name}", time=time, x=zero, y=zero, ux=np.cumsum(velocity) * DT, uy=zero, vx=velocity, vy=zero,
                    ax=acceleration, ay=zero, sxx=zero, syy=zero, sxy=1e3 * acceleration, gxy=1e-4 * acceleration, eyy=zero)
        _table(file, "levels", name=["surface", "10 m"], y=np.array([0.0, -DEPTH]))
        nothing = np.zeros(len(y))
        _table(file, "profile", y=y, peak_ax=np.full(len(y), peak), peak_ay=nothing, peak_vx=nothing, peak_vy=nothing, peak_ux=nothing,
               peak_uy=nothing, peak_ux_relative=0.01 * (y + DEPTH), peak_uy_relative=nothing, peak_gxy=stress / (RHO * vs**2),
               peak_eyy=nothing, peak_sxy=stress, effective_stress=effective, stress_ratio=ratio, cyclic_stress_ratio=0.65 * ratio)
        _table(file, "spectra", period=PERIODS, surface=response_spectrum(surface, DT, PERIODS), outcrop=response_spectrum(outcrop, DT, PERIODS))
        frequency = np.fft.rfftfreq(len(time), DT)
        _table(file, "transfer", frequency=frequency, surface_to_base=np.full(len(frequency), factor), surface=_amplitude(surface),
               base=_amplitude(outcrop), surface_to_outcrop=np.full(len(frequency), factor), outcrop=_amplitude(outcrop))
        _table(file, "measures", place=["outcrop", "surface", "10 m"], pga=np.array([1.0, factor, 1.0]) * np.abs(outcrop).max(),
               pgv=np.ones(3), arias=np.ones(3), duration_5_75=np.ones(3), duration_5_95=np.ones(3), cav=np.ones(3),
               mean_period=np.ones(3))
        _table(file, "layers", soil=["clay", "half-space"], top=np.array([0.0, DEPTH]), bottom=np.array([DEPTH, np.inf]),
               density=np.array([RHO, 2200.0]), vs=np.array([vs, 760.0]), vp=np.array([400.0, 1500.0]), damping=np.array([0.02, 0.0]),
               shear_modulus=np.array([RHO * vs**2, 2200.0 * 760.0**2]), impedance_contrast=np.array([4.6, np.nan]))
        _table(file, "site", vs30=np.array([394.0]), depth=np.array([DEPTH]), mean_vs=np.array([vs]), period=np.array([0.2]),
               period_of_mean_vs=np.array([0.2]), impedance_contrast=np.array([4.6]))
        if model == "eql":
            _table(file, "strain_compatible", top=np.array([0.0, 5.0]), bottom=np.array([5.0, 10.0]), vs=np.array([180.0, 150.0]),
                   modulus_ratio=np.array([0.81, 0.5625]), damping=np.array([0.05, 0.1]), largest_strain=np.array([1e-3, 2e-3]),
                   effective_strain=np.array([6.5e-4, 1.3e-3]))
            _table(file, "warnings", text=["shear strain reaches 0.2 %"])


def write(folder, refused="ode"):
    """The folder that `tremolo column --models` writes, with a model that cannot compute the site."""
    entries = []
    for model in FACTORS:
        write_column(Path(folder) / f"{model}.h5", model)
        entries.append({"model": model, "soil": "linear", "refused": "", "file": f"{model}.h5"})
    entries.append({"model": refused, "soil": "as its law says", "refused": "knows vertical incidence only"})
    text = json.dumps({"content": "site response", "title": "synthetic site", "models": entries}, indent=2)
    (Path(folder) / "site.json").write_text(text)
