"""Sections of the gallery that hold PM4Sand and PDMY03 against their reference curves."""

import gallery_rows as rows
import gallery_tests as tests
import numpy as np
from gallery_runs import label, only, save, together
from tremolo import soil_response

# Cyclic simple shear at constant volume -------------------------------------------------------------------------------

CYCLIC = {
    "pm4sand": (
        "pm4_dr35_ucdss_csr0090_k05_s101", "pm4_dr55_ucdss_csr0147_k05_s101", "pm4_dr75_ucdss_csr0312_k05_s101",
        "pm4_dr55_ucdss_csr0160_k10_s100", "pm4_dr55_ucdss_bias01_csr0147_s101",
    ),
    "pdmy03": (
        "pdmy03_dr33_ucdss_csr0090_k05_s101", "pdmy03_dr57_ucdss_csr0160_k05_s101", "pdmy03_dr74_ucdss_csr0290_k05_s101",
        "pdmy03_dr57_ucdss_csr0160_k10_s101", "pdmy03_dr57_ucdss_bias01_csr0160",
    ),
}
DRAWN = {"pm4sand": CYCLIC["pm4sand"][1], "pdmy03": CYCLIC["pdmy03"][1]}


def cyclic(gallery, law):
    head = ["test", "$r_u$ = 0.98", "1 % strain", "3 % strain", "5 % strain"]
    body = []
    for name in CYCLIC[law]:
        test, reference = gallery.own(name), gallery.curve(name)
        body.append([f"`{name}`", *rows.cycles(only(test), reference)])
        if name == DRAWN[law]:
            save(test, f"{law}_cyclic", [reference])
    return rows.table(head, body)


# Replays of strain paths ----------------------------------------------------------------------------------------------

REPLAYED = {
    "pm4sand": (
        *CYCLIC["pm4sand"], "pm4_dr55_ucdss_strainctl_s100", "pm4_dr55_first400steps_mono_dss_u",
        *(f"pm4_dr55_mono_{test}" for test in (
            "dss_u_p25_k05", "dss_u_p100_k05", "dss_u_p400_k05", "psc_u_p25_k10", "psc_u_p100_k10", "psc_u_p400_k10")),
        "pm4_dr55_path_nonprop", "pm4_dr55_path_lowp",
    ),
    "pdmy03": (
        *CYCLIC["pdmy03"], "pdmy03_dr57_ucdss_strainctl_s100", "pdmy03_dr57_first400steps_mono_dss_u",
        *(f"pdmy03_dr57_mono_{test}" for test in (
            "dss_u_p25_k05", "dss_u_p100_k05", "dss_u_p400_k05", "psc_u_p25_k10", "psc_u_p100_k10", "psc_u_p400_k10")),
        "pdmy03_dr57_path_nonprop", "pdmy03_dr57_path_lowp",
    ),
}
ATMOSPHERE = 101.3e3


def low_pressure(parameters):
    """2 p_min, Pa: below it PM4Sand's authors leave the treatment to the implementation."""
    start = 0.5e3 * parameters["sv"] * (1.0 + parameters["K0"])
    return max(start, ATMOSPHERE) / 100.0


def replays(gallery, law):
    head = ["strain path", "largest stress difference until p' < 2 p_min", "in all"]
    body = []
    for name in REPLAYED[law]:
        test, reference = gallery.replay(name), gallery.curve(name)
        parameters = gallery.parameters(name)
        cells = rows.replay(only(test), reference, 1e3 * parameters["sv"], low_pressure(parameters))
        body.append([f"`{name}`", *cells])
        if name.endswith("path_nonprop"):
            save(test, f"{law}_path", [reference])
    return rows.table(head, body)


# Modulus and damping --------------------------------------------------------------------------------------------------


def loops(gallery, law):
    """Strain-controlled cycles, undrained and drained."""
    prefix = "pm4_dr55" if law == "pm4sand" else "pdmy03_dr57"
    head = ["test", "shear strain", "G (MPa), ours / reference", "damping (%)", "volumetric strain (%)"]
    body = []
    for name in (f"{prefix}_ucdss_strainctl_s100", f"{prefix}_dcdss_s100"):
        test, reference = gallery.own(name), gallery.curve(name)
        body += [[f"`{name}`", *row] for row in rows.loops(only(test), reference)]
        drained = test.about["drainage"] == "drained"
        save(test, f"{law}_{'drained' if drained else 'undrained'}_loops", [reference])
    return rows.table(head, body)


# Monotonic tests ------------------------------------------------------------------------------------------------------


def monotonic(gallery, law):
    prefix = "pm4_dr55" if law == "pm4sand" else "pdmy03_dr57"
    head = ["test", "peak (kPa), ours / reference", "at the end", "volumetric strain (%)"]
    body = []
    for kind, k0 in (("dss", "k05"), ("psc", "k10")):
        for drainage in ("u", "d"):
            names = [f"{prefix}_mono_{kind}_{drainage}_p{pressure}_{k0}" for pressure in (25, 100, 400)]
            several = {name: gallery.own(name) for name in names}
            curves = [gallery.curve(name) for name in names]
            labels = [label(test) for test in several.values()]
            for (name, test), reference in zip(several.items(), curves, strict=True):
                body.append([f"`{name}`", *rows.monotonic(only(test), reference, kind == "dss")])
            words = "direct simple shear" if kind == "dss" else "plane-strain compression", "drained" if drainage == "d" else "constant volume"
            title = f"{law}, {', '.join(words)}, vertical stress {', '.join(labels)}"
            save(together(several), f"{law}_{kind}_{drainage}", curves, labels, title)
    return rows.table(head, body)


# Cyclic strength ------------------------------------------------------------------------------------------------------

# Stress ratio to 3 % strain in 15 cycles, measured with the classes that made the reference curves.
STRENGTH = {
    "pm4sand": ((CYCLIC["pm4sand"][0], 0.35, 0.0881), (CYCLIC["pm4sand"][1], 0.55, 0.1446), (CYCLIC["pm4sand"][2], 0.75, 0.3016)),
    "pdmy03": ((CYCLIC["pdmy03"][0], 0.33, 0.0859), (CYCLIC["pdmy03"][1], 0.57, 0.1557), (CYCLIC["pdmy03"][2], 0.74, 0.2862)),
}
FACTORS = (0.8, 0.9, 1.0, 1.1, 1.25, 1.5)


def strength_at(curve, cycles=15.0):
    """Stress ratio to 3 % strain in so many cycles, straight between tests in logarithms."""
    reached = np.isfinite(curve["cycles_3pc"])
    order = np.argsort(curve["cycles_3pc"][reached])
    n, ratio = (np.log(curve[name][reached][order]) for name in ("cycles_3pc", "stress_ratio"))
    return float(np.exp(np.interp(np.log(cycles), n, ratio)))


def strength(gallery, law):
    head = ["soil", "CSR for 3 % strain in 15 cycles, ours / reference", "Idriss & Boulanger", "ours / theirs"]
    body = []
    for name, density, reference in STRENGTH[law]:
        test = gallery.strength(name, [round(factor * reference, 4) for factor in FACTORS], density)
        ours = strength_at(test.strength_curve)
        target = float(np.exp(np.interp(np.log(15.0), *(np.log(test.strength_target[c]) for c in ("cycles", "stress_ratio")))))
        body.append([f"Dr {100 * density:.0f} %", rows.pair(ours, reference), f"{target:.4g}", rows.percent(ours / target - 1.0)])
        if name == DRAWN[law]:
            save(test, f"{law}_strength")
    return rows.table(head, body)


def calibration(gallery):
    """The contraction rate of PM4Sand for 15 cycles at the strength that the reference has with the published one, and at that
    of Idriss & Boulanger."""
    head = [
        "soil", "published", "for the reference's CSR", "cycles there", "for Idriss & Boulanger", "cycles there",
    ]
    body = []
    for name, density, ratio in STRENGTH["pm4sand"]:
        parameters = gallery.parameters(name)
        row = [f"Dr {100 * density:.0f} %", f"{parameters['hpo']}"]
        for target, suffix in (({"stress_ratio": ratio}, "reference"), ({"curve": "idriss_boulanger"}, "curve")):
            title = f"pm4_dr{100 * density:.0f}_calibration_{suffix}"
            found = gallery.calibrate(tests.calibration_test(title, parameters, target), title)
            difference = rows.percent(soil_response.relative(found["contraction_rate"], parameters["hpo"]))
            row += [f"{found['contraction_rate']:.3g} ({difference})", f"{found['cycles']:.2f}"]
        body.append(row)
    return rows.table(head, body)
