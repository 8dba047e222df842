"""Soil tests made by formulas, in the layout of app/soiltest/soiltest_output.hpp."""

import h5py
import numpy as np

VERTICAL_STRESS = 100e3  # Pa
K0 = 0.5
ABOUT = {
    "title": "made by formulas", "law": "pm4sand", "library": "", "kind": "direct_simple_shear",
    "drainage": "constant_volume", "loading": "cyclic_stress", "vertical_stress": VERTICAL_STRESS, "k0": K0,
    "shear_bias": 0.0, "test_file": "",
}


def history(cycles=10.0, amplitude=0.01, shear=10e3, relief=0.9):
    """Simple shear in cycles of constant stress amplitude; strain and r_u grow steadily, the latter to `relief`."""
    cycle = np.linspace(0.0, cycles, 2001)
    part = cycle / cycles
    wave = np.sin(2.0 * np.pi * cycle)
    vertical = -VERTICAL_STRESS * (1.0 - relief * part)
    horizontal = -VERTICAL_STRESS * (1.0 - relief * part) * (K0 + (1.0 - K0) * part)
    zero = np.zeros_like(cycle)
    columns = {
        "step": np.arange(len(cycle)), "cycle": cycle, "eps_xx": zero, "eps_yy": zero, "eps_zz": zero,
        "gamma_xy": amplitude * part * wave, "sig_xx": horizontal, "sig_yy": vertical,
        "sig_zz": 0.3 * (horizontal + vertical), "sig_xy": shear * wave, "ru": relief * part,
    }
    columns["p"] = -0.5 * (horizontal + vertical)
    columns["q"] = 2.0 * np.hypot(0.5 * (horizontal - vertical), columns["sig_xy"])
    return columns


def compression(drop=0.0):
    """Drained shortening at constant lateral stress, invariants of the plane; `drop` takes the stress out of plane away
    from the lateral one."""
    columns = history()
    shortening = np.linspace(0.0, 0.05, 2001)
    columns["eps_yy"], columns["eps_xx"] = -shortening, 0.8 * shortening
    columns["sig_xx"] = np.full(2001, -50e3)
    columns["sig_yy"] = -50e3 - 100e3 * (1.0 - np.exp(-shortening / 0.01))
    columns["sig_zz"] = columns["sig_xx"] - drop
    columns["sig_xy"], columns["gamma_xy"] = np.zeros(2001), np.zeros(2001)
    columns["p"] = -0.5 * (columns["sig_xx"] + columns["sig_yy"])
    columns["q"] = columns["sig_xx"] - columns["sig_yy"]
    return columns


def _write_table(file, path, columns):
    group = file.create_group(path)
    for name, values in columns.items():
        values = np.atleast_1d(values)
        group[name] = values.astype("S") if values.dtype.kind == "U" else values.astype(float)


def write(path, histories, about=None, tables=None, amplitudes=None):
    """A file of these histories, of stress cycles or, with `amplitudes`, strain cycles; `about`, `tables` add."""
    names = [f"{number:03}" for number in range(len(histories))]
    count = len(names)
    summary = {
        "test": names, "stress_ratio": 0.1 + 0.02 * np.arange(count), "strain_amplitude": np.full(count, np.nan),
        "cycles_1pc": np.full(count, 8.0), "cycles_3pc": np.full(count, 12.0), "cycles_5pc": np.full(count, np.nan),
        "cycles_ru98": np.full(count, np.nan), "largest_ru": np.full(count, 0.9), "peak_q": np.full(count, 20e3),
        "steps": np.full(count, 2000), "seconds": np.full(count, 0.1),
    }
    if amplitudes is not None:
        summary |= {"stress_ratio": np.full(count, np.nan), "strain_amplitude": amplitudes}
    pressure = np.linspace(0.0, 200e3, 50)
    with h5py.File(path, "w") as file:
        _write_table(file, "about", ABOUT | (about or {}))
        for name, columns in zip(names, histories):
            _write_table(file, f"tests/{name}/history", columns)
        _write_table(file, "summary", summary)
        for name, slope in (("critical_state", 1.09), ("bounding", 1.2), ("dilation", 1.0)):
            _write_table(file, f"lines/{name}", {"p": pressure, "q": slope * pressure})
        for name, columns in (tables or {}).items():
            _write_table(file, name, columns)
