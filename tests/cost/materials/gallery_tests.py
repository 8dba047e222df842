"""The soil tests of the gallery as files for `tremolo soiltest`, from the parameters of the reference curves."""

KILO = 1e3

PDMY03 = {f"c{letter}": f"contraction_{letter}" for letter in "abcde"}
PDMY03 |= {f"d{letter}": f"dilation_{letter}" for letter in "abc"}
CEMENTED = {
    "model": "mohr_coulomb", "density": 1700.0, "young": 40e6, "poisson": 0.28, "cohesion_peak": 4e3,
    "cohesion_residual": 0.0, "friction_peak_deg": 45.0, "friction_residual_deg": 28.0, "softening": 15.0,
}
PERFECT = CEMENTED | {"cohesion_residual": 4e3, "friction_residual_deg": 45.0, "softening": 0.0}
DILATANT = PERFECT | {
    "cohesion_peak": 10.0, "cohesion_residual": 10.0, "friction_peak_deg": 30.0, "friction_residual_deg": 30.0,
    "dilation_peak_deg": 10.0, "dilation_residual_deg": 10.0,
}
ELASTIC = {"model": "linear_elastic", "density": 1700.0, "young": 40e6, "poisson": 0.28}
CONE = {
    "model": "drucker_prager", "density": 1700.0, "young": 40e6, "poisson": 0.28, "cohesion": 5e3, "friction_deg": 30.0,
}
CLAY = {
    "model": "multi_yield_clay", "density": 1700.0, "young": 59.6e6, "poisson": 0.49, "undrained_strength": 40e3,
    "peak_strain": 0.05,
}
HYPERBOLIC = {"model": "hyperbolic", "density": 1900.0, "vs": 200.0, "vp": 400.0, "reference_strain": 1e-3}


def value(entry):
    """A TOML value."""
    if isinstance(entry, str):
        return f'"{entry}"'
    if isinstance(entry, (list, tuple)):
        return f"[{', '.join(map(value, entry))}]"
    if isinstance(entry, int):
        return str(entry)
    return f"{entry:.10g}" if "." in f"{entry:.10g}" or "e" in f"{entry:.10g}" else f"{entry:.10g}.0"


def toml(title, **tables):
    lines = [f'title = "{title}"']
    for name, table in tables.items():
        lines += ["", f"[{name}]", *(f"{key} = {value(entry)}" for key, entry in table.items())]
    return "\n".join(lines) + "\n"


def soil(parameters):
    """[soil] of a reference curve's manifest entry."""
    if parameters["mat"] == "pm4":
        return {
            "model": "pm4sand", "density": 1950.0, "relative_density": parameters["Dr"],
            "shear_modulus_coefficient": float(parameters["G0"]), "contraction_rate": parameters["hpo"],
        }
    given = {
        "model": "pdmy03", "density": KILO * parameters["rho"], "shear_modulus": KILO * parameters["Gr"],
        "bulk_modulus": KILO * parameters["Br"], "friction_deg": parameters["phi"],
        "phase_transformation_deg": parameters["PT"],
    }
    return given | {ours: float(parameters[theirs]) for theirs, ours in PDMY03.items()}


def state(parameters):
    """What [test] says of the state before loading."""
    table = {"vertical_stress": KILO * parameters["sv"], "k0": float(parameters["K0"])}
    if "tau0" in parameters:
        table |= {"shear_bias": parameters["tau0"] / parameters["sv"], "bias_applied": "in_initial_stress"}
    return table


def increment(parameters):
    return parameters.get("dg", 5e-6)


def sand(name):
    """Law and density of a reference curve in words."""
    return f"{'PM4Sand' if name.startswith('pm4_') else 'PDMY03'}, D_R {name.split('_dr')[1][:2]} %"


def words(name, parameters):
    """The test of a reference curve in words."""
    if parameters["test"] == "ucdss" and "csr" in parameters:
        bias = f", static shear {parameters['tau0'] / parameters['sv']:.2g}" if "tau0" in parameters else ""
        return f"{sand(name)}, stress cycles, CSR {parameters['csr']}{bias}"
    if "amps" in parameters:
        return f"{sand(name)}, cycles of constant strain"
    return f"{sand(name)}, {'monotonic' if parameters['test'].startswith('mono') else 'strains of all directions'}"


def own_test(name, parameters):
    """The reference's test as an engineer would describe it: cycles of stress or strain, or monotonic loading."""
    drained = bool(parameters.get("drained", 0)) or parameters["test"] == "dcdss"
    test = {
        "kind": "plane_strain_compression" if parameters["test"] == "mono_psc" else "direct_simple_shear",
        "drainage": "drained" if drained else "constant_volume",
        **state(parameters),
        "strain_increment": increment(parameters),
        "every": int(parameters["every"]),
    }
    if parameters["test"] == "ucdss":
        loading = {
            "kind": "cyclic_stress", "stress_ratio": [parameters["csr"]], "largest_strain": parameters["gmax_stop"],
        }
    elif "amps" in parameters:
        amplitudes = [float(amplitude) for amplitude in parameters["amps"].split(":")]
        loading = {"kind": "cyclic_strain", "strain_amplitude": amplitudes, "cycles": parameters["ncyc"]}
    else:
        loading = {"kind": "monotonic", "strain": parameters["gstop"]}
    return toml(words(name, parameters), soil=soil(parameters), test=test, loading=loading)


def replay(name, parameters, curve):
    """The reference's strains, step by step."""
    loading = {"kind": "path", "file": str(curve)}
    test = {"kind": "path", "drainage": "drained", **state(parameters), "every": 1}
    return toml(words(name, parameters), soil=soil(parameters), test=test, loading=loading)


def strength_test(name, parameters, stress_ratios, relative_density):
    """Cyclic simple shear at several stress ratios; the density is what the target strength is found by."""
    test = {"kind": "direct_simple_shear", "drainage": "constant_volume", **state(parameters), "every": 20}
    loading = {"kind": "cyclic_stress", "stress_ratio": list(stress_ratios), "largest_strain": 0.055}
    soil_table = soil(parameters) | {"relative_density": relative_density}
    return toml(f"{sand(name)}, cyclic strength", soil=soil_table, test=test, loading=loading)


def calibration_test(name, parameters, target):
    """The fit of the contraction rate, begun at another value than the published one."""
    test = {"kind": "direct_simple_shear", "drainage": "constant_volume", **state(parameters)}
    wanted = "the curve of Idriss & Boulanger" if "curve" in target else "the strength of the reference"
    target = target | {"cycles": 15.0, "criterion": "strain_3pc"}
    soil_table = soil(parameters) | {"contraction_rate": 1.0}
    return toml(f"{sand(name)}, contraction rate for {wanted}", soil=soil_table, test=test, target=target)


def modulus_test(title, soil_table, amplitudes, drainage="drained", vertical_stress=100e3):
    test = {"kind": "direct_simple_shear", "drainage": drainage, "vertical_stress": vertical_stress, "k0": 1.0}
    loading = {"kind": "modulus_curve", "strain_amplitude": list(amplitudes), "cycles": 3}
    return toml(title, soil=soil_table, test=test, loading=loading)


def simple_test(title, soil_table, kind, vertical_stress, strain, k0=1.0, drainage="drained", step=1e-5, every=20):
    """Monotonic loading of a law that has closed forms."""
    test = {
        "kind": kind, "drainage": drainage, "vertical_stress": vertical_stress, "k0": k0, "strain_increment": step,
        "every": every,
    }
    return toml(title, soil=soil_table, test=test, loading={"kind": "monotonic", "strain": strain})
