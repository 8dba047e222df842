"""Sections of the gallery that hold PM4Sand and PDMY03 against their reference curves."""

import gallery_rows as rows
import gallery_tests as tests
import numpy as np
from gallery_runs import label, only, save, together
from tremolo.soil_test import response

# Cyclic simple shear at constant volume -------------------------------------------------------------------------------

CYCLIC = {
    "pm4sand": (
        "pm4_dr35_ucdss_csr0090_k05_s101", "pm4_dr55_ucdss_csr0147_k05_s101", "pm4_dr75_ucdss_csr0312_k05_s101",
        "pm4_dr55_ucdss_csr0160_k10_s100", "pm4_dr55_ucdss_bias01_csr0147_s101",
    ),
    "pdmy03": (
        "pdmy03_dr33_ucdss_csr0090_k05_s101", "pdmy03_dr57_ucdss_csr0160_k05_s101",
        "pdmy03_dr74_ucdss_csr0290_k05_s101", "pdmy03_dr57_ucdss_csr0160_k10_s101", "pdmy03_dr57_ucdss_bias01_csr0160",
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
    """Strain-controlled cycles, undrained and drained; volumetric strain of the drained ones all the way."""
    prefix = "pm4_dr55" if law == "pm4sand" else "pdmy03_dr57"
    head = ["test", "shear strain", "G (MPa), ours / reference", "damping (%)", "volumetric strain (%)"]
    body = []
    for name in (f"{prefix}_ucdss_strainctl_s100", f"{prefix}_dcdss_s100"):
        test, reference = gallery.own(name), gallery.curve(name)
        body += [[f"`{name}`", *row] for row in rows.loops(only(test), reference)]
        drained = test.about["drainage"] == "drained"
        save(test, f"{law}_{'drained' if drained else 'undrained'}_loops", [reference])
        if drained:
            volume = rows.volume_all_the_way(only(test), reference)
    return f"{rows.table(head, body)}\n\nThe table has volumetric strains at ends of loops. {volume}"


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
            apparatus = "direct simple shear" if kind == "dss" else "plane-strain compression"
            water = "drained" if drainage == "d" else "constant volume"
            title = f"{tests.sand(names[0])}, {apparatus}, {water}, vertical stress {', '.join(labels)}"
            save(together(several), f"{law}_{kind}_{drainage}", curves, labels, title)
    return rows.table(head, body)


# Cyclic strength ------------------------------------------------------------------------------------------------------

# Relative density, stress ratio to 3 % strain in 15 cycles, and cycles at FACTORS of it, measured with the classes that
# made the reference curves.
STRENGTH = {
    "pm4sand": (
        (CYCLIC["pm4sand"][0], 0.35, 0.0881, (39.2, 23.7, 15.2, 10.2, 6.2, 3.2)),
        (CYCLIC["pm4sand"][1], 0.55, 0.1446, (35.3, 22.2, 14.8, 10.7, 6.7, 4.2)),
        (CYCLIC["pm4sand"][2], 0.75, 0.3016, (35.2, 22.2, 14.8, 11.2, 7.2, 4.7)),
    ),
    "pdmy03": (
        (CYCLIC["pdmy03"][0], 0.33, 0.0859, (32.2, 21.7, 15.2, 10.6, 6.6, 3.6)),
        (CYCLIC["pdmy03"][1], 0.57, 0.1557, (31.2, 21.2, 14.8, 10.7, 7.2, 4.2)),
        (CYCLIC["pdmy03"][2], 0.74, 0.2862, (30.2, 20.7, 15.2, 11.2, 7.7, 4.7)),
    ),
}
FACTORS = (0.8, 0.9, 1.0, 1.1, 1.25, 1.5)


def strength_at(curve, cycles=15.0):
    """Stress ratio to 3 % strain in so many cycles, straight between tests in logarithms."""
    reached = np.isfinite(curve["cycles_3pc"])
    order = np.argsort(curve["cycles_3pc"][reached])
    n, ratio = (np.log(curve[name][reached][order]) for name in ("cycles_3pc", "stress_ratio"))
    return float(np.exp(np.interp(np.log(cycles), n, ratio)))


def mark_reference(figure, ratios, cycles):
    """The reference's cycles to 3 % strain, as open squares in the panel of cyclic strength."""
    panel = next(ax for ax in figure.axes if ax.get_xlabel() == "uniform cycles")
    panel.plot(cycles, ratios, "s", color="none", markeredgecolor="0.45", markersize=8, label="reference, 3 % strain")
    panel.legend(loc="best")


def strength(gallery, law):
    head = [
        "soil", "CSR for 3 % strain in 15 cycles, ours / reference", "Idriss & Boulanger", "ours over theirs",
        f"cycles at {', '.join(map(str, FACTORS))} of the reference's CSR, ours / reference",
    ]
    body = []
    for name, density, reference, reference_cycles in STRENGTH[law]:
        ratios = [round(factor * reference, 4) for factor in FACTORS]
        test = gallery.strength(name, ratios, density)
        ours = strength_at(test.strength_curve)
        curve = (np.log(test.strength_target[column]) for column in ("cycles", "stress_ratio"))
        target = float(np.exp(np.interp(np.log(15.0), *curve)))
        pairs = zip(test.strength_curve["cycles_3pc"], reference_cycles, strict=True)
        cells = [rows.pair(ours, reference), f"{target:.4g}", rows.percent(ours / target - 1.0)]
        body.append([f"Dr {100 * density:.0f} %", *cells, ", ".join(f"{n:.1f} / {n_ref:.1f}" for n, n_ref in pairs)])
        if name == DRAWN[law]:
            save(test, f"{law}_strength", finish=lambda figure: mark_reference(figure, ratios, reference_cycles))
    return rows.table(head, body)


def calibration(gallery):
    """The contraction rate of PM4Sand for 15 cycles: at the strength that the reference has with the published rate,
    and at that of Idriss & Boulanger."""
    head = [
        "soil", "published", "for the reference's CSR", "cycles there", "for Idriss & Boulanger", "cycles there",
    ]
    body = []
    for name, density, ratio, _ in STRENGTH["pm4sand"]:
        parameters = gallery.parameters(name)
        row = [f"Dr {100 * density:.0f} %", f"{parameters['hpo']}"]
        for target, suffix in (({"stress_ratio": ratio}, "reference"), ({"curve": "idriss_boulanger"}, "curve")):
            title = f"pm4_dr{100 * density:.0f}_calibration_{suffix}"
            found = gallery.calibrate(tests.calibration_test(name, parameters, target), title)
            difference = rows.percent(response.relative(found["contraction_rate"], parameters["hpo"]))
            row += [f"{found['contraction_rate']:.3g} ({difference})", f"{found['cycles']:.2f}"]
        body.append(row)
    return rows.table(head, body)
