"""Sections of the gallery that hold the other laws against closed forms."""

import gallery_closed_forms as exact
import gallery_rows as rows
import gallery_tests as tests
import numpy as np
from gallery_runs import only, save
from tremolo.soil_test import response


def closed(gallery, name, text):
    return only(gallery.run_kept(text, name))


def closed_row(what, ours, expected, name, scale=1e3, unit="kPa"):
    difference = f"{abs(ours / expected - 1.0):.1g}"
    return [f"`{name}`", what, f"{expected / scale:.6g} {unit}", f"{ours / scale:.6g} {unit}", difference]


CLOSED_HEAD = ["test", "quantity", "closed form", "tremolo", "relative difference"]


def linear_elastic(gallery):
    name = "linear_elastic_oedometer"
    history = closed(gallery, name, tests.simple_test("elastic soil", tests.ELASTIC, "oedometer", 100e3, 0.01, 0.5))
    modulus = (history["sig_yy"][-1] - history["sig_yy"][0]) / history["eps_yy"][-1]
    lateral = (history["sig_xx"][-1] - history["sig_xx"][0]) / (history["sig_yy"][-1] - history["sig_yy"][0])
    young, poisson = tests.ELASTIC["young"], tests.ELASTIC["poisson"]
    ratio = poisson / (1.0 - poisson)
    return rows.table(CLOSED_HEAD, [
        closed_row("constrained modulus", modulus, exact.oedometer_modulus(young, poisson), name, 1e6, "MPa"),
        closed_row("lateral over vertical stress", lateral, ratio, name, 1.0, ""),
    ])


def softened_strength(history, lateral=None):
    """sigma_1 in compression under a lateral stress, or tau in shear under 100 kPa, at each row's plastic strain."""
    soil = tests.CEMENTED
    strain = history["equivalent_plastic_strain"]
    part = np.exp(-soil["softening"] * strain)
    cohesion = soil["cohesion_residual"] + (soil["cohesion_peak"] - soil["cohesion_residual"]) * part
    friction = soil["friction_residual_deg"] + (soil["friction_peak_deg"] - soil["friction_residual_deg"]) * part
    if lateral is None:
        return exact.simple_shear_strength(100e3, cohesion, friction)
    return exact.compression_strength(lateral, cohesion, friction)


def mohr_coulomb(gallery):
    body = []
    name = "mc_seed_psc_d_s50"
    text = tests.simple_test("cemented soil that softens", tests.CEMENTED, "plane_strain_compression", 50e3, 0.4)
    test = gallery.run_kept(text, name)
    yielding = only(test)["equivalent_plastic_strain"] > 0.0
    expected, ours = softened_strength(only(test), 50e3)[yielding], -only(test)["sig_yy"][yielding]
    worst = np.argmax(np.abs(ours / expected - 1.0))
    body.append(closed_row("axial stress as it softens, worst row", ours[worst], expected[worst], name))
    body.append(closed_row("axial stress at the end", ours[-1], expected[-1], name))
    save(test, "mohr_coulomb_compression", [gallery.curve(name)])
    for name, title, soil, what in (
        ("mc_perfect45_dss_d_s100_k05", "cemented soil without softening", tests.PERFECT, "shear strength"),
        ("mc_perfect30psi10_dss_d_s100_k05", "dilatant soil", tests.DILATANT, "shear strength, dilatant (Davis)"),
    ):
        test = gallery.run_kept(tests.simple_test(title, soil, "direct_simple_shear", 100e3, 0.1, 0.5), name)
        given = soil["cohesion_peak"], soil["friction_peak_deg"], soil.get("dilation_peak_deg", 0.0)
        body.append(closed_row(what, only(test)["sig_xy"][-1], exact.simple_shear_strength(100e3, *given), name))
    name = "mc_seed_dss_d_s100_k05"
    text = tests.simple_test("cemented soil that softens", tests.CEMENTED, "direct_simple_shear", 100e3, 0.4, 0.5)
    test = gallery.run_kept(text, name)
    expected = softened_strength(only(test))[-1]
    body.append(closed_row("shear stress after softening, at the end", only(test)["sig_xy"][-1], expected, name))
    save(test, "mohr_coulomb_shear", [gallery.curve(name)])
    return rows.table(CLOSED_HEAD, body)


def drucker_prager(gallery):
    body = []
    for name, kind, cone in (
        ("drucker_prager_triaxial", "triaxial_compression", "triaxial_compression"),
        ("drucker_prager_plane_strain", "plane_strain_compression", "plane_strain"),
    ):
        soil = tests.CONE | {"cone": cone}
        title = f"cone of {cone.replace('_', ' ')}"
        test = gallery.run_kept(tests.simple_test(title, soil, kind, 100e3, 0.05), name)
        strength = exact.compression_strength(100e3, soil["cohesion"], soil["friction_deg"])
        body.append(closed_row("axial stress at failure", -only(test)["sig_yy"][-1], strength, name))
        if cone == "plane_strain":
            save(test, "drucker_prager")
    return rows.table(CLOSED_HEAD, body)


def multi_yield_clay(gallery):
    body = []
    strength = tests.CLAY["undrained_strength"]
    for name, kind, factor, what in (
        ("clay_simple_shear", "direct_simple_shear", 1.0, "shear stress at the peak strain, $s_u$"),
        ("clay_plane_strain", "plane_strain_compression", 2.0, "deviator, $2 s_u$"),
        ("clay_triaxial", "triaxial_compression", np.sqrt(3.0), r"deviator, $\sqrt{3} s_u$"),
    ):
        text = tests.simple_test("clay", tests.CLAY, kind, 100e3, 0.1, drainage="constant_volume")
        history = closed(gallery, name, text)
        shear = kind == "direct_simple_shear"
        ours = history["sig_xy"][-1] if shear else response.deviator_of_plane(history)[-1]
        body.append(closed_row(what, ours, factor * strength, name))
    return rows.table(CLOSED_HEAD, body)


def hyperbolic(gallery):
    name = "hyperbolic_modulus"
    amplitudes = [1e-5, 3e-5, 1e-4, 3e-4, 1e-3, 3e-3, 1e-2]
    test = gallery.run_kept(tests.modulus_test("hyperbolic soil", tests.HYPERBOLIC, amplitudes), name)
    save(test, "hyperbolic", title="hyperbolic soil, direct simple shear, drained; every amplitude on a fresh specimen")
    curve = test.modulus_curve
    body = []
    columns = (curve[name] for name in ("strain_amplitude", "modulus_ratio", "damping"))
    for amplitude, ratio, damping in zip(*columns, strict=True):
        g, d = exact.hyperbola(amplitude, tests.HYPERBOLIC["reference_strain"])
        body.append([f"{100 * amplitude:.3g} %", rows.pair(ratio, g), rows.pair(100 * damping, 100 * d, 3)])
    return rows.table(["shear strain", "G/Gmax, ours / closed form", "damping (%), ours / closed form"], body)
