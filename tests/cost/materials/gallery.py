#!/usr/bin/python3
"""Makes the numbers and pictures of docs/materials/gallery.md: soil tests of every law over reference curves and closed forms.

    tests/cost/materials/gallery.py build/release/bin/tremolo [--reference DIR] [--only SECTION ...]

Writes the test files of docs/materials/tests, the pictures of docs/materials/pictures/gallery_*.png, and what stands
between the markers `<!-- SECTION -->` and `<!-- /SECTION -->` of the page. The reference curves are those of
TREMOLO_REFERENCE, else of shared/reference beside the source tree; without them it says so and stops.
"""

import argparse
import io
import json
import os
import subprocess
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "python"))

import gallery_closed_forms as exact
import gallery_rows as rows
import gallery_tests as tests
import numpy as np
from PIL import Image
from tremolo import soil_record, soil_response, soiltest, style

PAGES = ROOT / "docs" / "materials"
DPI = 110


@dataclass
class Gallery:
    """Where the command, the reference curves and the results are."""

    tremolo: Path
    reference: Path
    folder: Path

    def __post_init__(self):
        self.manifest = json.loads((self.reference / "manifest.json").read_text())

    def parameters(self, name):
        return self.manifest[name]["params"]

    def curve(self, name):
        return soil_record.read_reference(self.reference / f"{name}.csv")

    def run(self, text, name):
        """Runs a test file that is not kept."""
        path = self.folder / f"{name}.toml"
        path.write_text(text)
        return self._run(path)

    def run_kept(self, text, name):
        """Runs a test file that readers of the page can run."""
        path = PAGES / "tests" / f"{name}.toml"
        path.parent.mkdir(exist_ok=True)
        path.write_text(text)
        return self._run(path)

    def _run(self, path):
        out = self.folder / f"{path.stem}.h5"
        done = subprocess.run([self.tremolo, "soiltest", path, "--out", out], capture_output=True, text=True, check=False)
        if done.returncode != 0:
            raise RuntimeError(f"{path.name}: {done.stderr.strip() or done.stdout.strip()}")
        print(f"  {path.stem}", flush=True)
        return soil_record.read(out)

    def own(self, name):
        """The test of a reference curve, as its file under docs/materials/tests describes it."""
        return self.run_kept(tests.own_test(name, self.parameters(name)), name)

    def replay(self, name):
        """The test along the strains of a reference curve, whose last row may be there twice."""
        lines = (self.reference / f"{name}.csv").read_text().splitlines(keepends=True)
        steps = [line.split(",", 1)[0] for line in lines]
        path = self.folder / f"{name}.csv"
        path.write_text("".join(line for line, step, before in zip(lines, steps, ["", *steps]) if step != before))
        return self.run(tests.replay(name, self.parameters(name), path), name)

    def strength(self, name, stress_ratios, relative_density):
        """The cyclic strength curve of the soil of a reference curve."""
        title = f"{name.split('_ucdss')[0]}_strength"
        return self.run_kept(tests.strength_test(title, self.parameters(name), stress_ratios, relative_density), title)


def only(test):
    return test.histories["000"]


def save(test, name, references=(), labels=None, title=None):
    """A picture of the page, in 256 colours so that the repository stays small."""
    figure = soiltest.draw(test, references, labels, title)
    pixels = io.BytesIO()
    figure.savefig(pixels, dpi=DPI)
    style.plt.close(figure)
    picture = Image.open(pixels).convert("RGB").quantize(256)
    picture.save(PAGES / "pictures" / f"gallery_{name}.png", optimize=True)


def together(several):
    """One test of the histories of several; the lines are those that reach furthest."""
    last = list(several.values())[-1]
    histories = {name: only(test) for name, test in several.items()}
    return soil_record.SoilTest(last.path, last.about, histories, last.summary, lines=last.lines)


def label(test):
    return f"{test.about['vertical_stress'] / 1e3:.3g} kPa"


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


# Laws with closed forms -----------------------------------------------------------------------------------------------


def closed(gallery, name, text):
    return only(gallery.run_kept(text, name))


def closed_row(what, ours, expected, name, scale=1e3, unit="kPa"):
    return [f"`{name}`", what, f"{expected / scale:.6g} {unit}", f"{ours / scale:.6g} {unit}", f"{abs(ours / expected - 1.0):.1g}"]


CLOSED_HEAD = ["test", "quantity", "closed form", "tremolo", "relative difference"]


def linear_elastic(gallery):
    name = "linear_elastic_oedometer"
    history = closed(gallery, name, tests.simple_test(name, tests.ELASTIC, "oedometer", 100e3, 0.01, 0.5))
    modulus = (history["sig_yy"][-1] - history["sig_yy"][0]) / history["eps_yy"][-1]
    lateral = (history["sig_xx"][-1] - history["sig_xx"][0]) / (history["sig_yy"][-1] - history["sig_yy"][0])
    young, poisson = tests.ELASTIC["young"], tests.ELASTIC["poisson"]
    ratio = poisson / (1.0 - poisson)
    return rows.table(CLOSED_HEAD, [
        closed_row("constrained modulus", modulus, exact.oedometer_modulus(young, poisson), name, 1e6, "MPa"),
        closed_row("lateral over vertical stress", lateral, ratio, name, 1.0, ""),
    ])


def softened_strength(history, lateral=None):
    """sigma_1 in compression under a lateral stress, or tau in simple shear under 100 kPa, at the plastic strain of each row
    that has some."""
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
    text = tests.simple_test(name, tests.CEMENTED, "plane_strain_compression", 50e3, 0.4)
    test = gallery.run_kept(text, name)
    yielding = only(test)["equivalent_plastic_strain"] > 0.0
    expected, ours = softened_strength(only(test), 50e3)[yielding], -only(test)["sig_yy"][yielding]
    worst = np.argmax(np.abs(ours / expected - 1.0))
    body.append(closed_row("axial stress as it softens, worst row", ours[worst], expected[worst], name))
    body.append(closed_row("axial stress at the end", ours[-1], expected[-1], name))
    save(test, "mohr_coulomb_compression", [gallery.curve(name)])
    for name, soil, what in (
        ("mc_perfect45_dss_d_s100_k05", tests.PERFECT, "shear strength"),
        ("mc_perfect30psi10_dss_d_s100_k05", tests.DILATANT, "shear strength, dilatant (Davis)"),
    ):
        test = gallery.run_kept(tests.simple_test(name, soil, "direct_simple_shear", 100e3, 0.1, 0.5), name)
        given = soil["cohesion_peak"], soil["friction_peak_deg"], soil.get("dilation_peak_deg", 0.0)
        body.append(closed_row(what, only(test)["sig_xy"][-1], exact.simple_shear_strength(100e3, *given), name))
    name = "mc_seed_dss_d_s100_k05"
    test = gallery.run_kept(tests.simple_test(name, tests.CEMENTED, "direct_simple_shear", 100e3, 0.4, 0.5), name)
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
        test = gallery.run_kept(tests.simple_test(name, soil, kind, 100e3, 0.05), name)
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
        test = gallery.run_kept(tests.simple_test(name, tests.CLAY, kind, 100e3, 0.1, drainage="constant_volume"), name)
        history = only(test)
        shear = kind == "direct_simple_shear"
        ours = history["sig_xy"][-1] if shear else soil_response.deviator_of_plane(history)[-1]
        body.append(closed_row(what, ours, factor * strength, name))
    return rows.table(CLOSED_HEAD, body)


def hyperbolic(gallery):
    name = "hyperbolic_modulus"
    amplitudes = [1e-5, 3e-5, 1e-4, 3e-4, 1e-3, 3e-3, 1e-2]
    test = gallery.run_kept(tests.modulus_test(name, tests.HYPERBOLIC, amplitudes), name)
    save(test, "hyperbolic")
    curve = test.modulus_curve
    body = []
    for amplitude, ratio, damping in zip(curve["strain_amplitude"], curve["modulus_ratio"], curve["damping"], strict=True):
        g, d = exact.hyperbola(amplitude, tests.HYPERBOLIC["reference_strain"])
        body.append([f"{100 * amplitude:.3g} %", rows.pair(ratio, g), rows.pair(100 * damping, 100 * d, 3)])
    return rows.table(["shear strain", "G/Gmax, ours / closed form", "damping (%), ours / closed form"], body)


SECTIONS = {
    f"{law}-{part.__name__}": (lambda gallery, part=part, law=law: part(gallery, law))
    for law in ("pm4sand", "pdmy03")
    for part in (cyclic, replays, loops, monotonic, strength)
} | {part.__name__: part for part in (mohr_coulomb, drucker_prager, multi_yield_clay, hyperbolic, linear_elastic)}


def write_between(page, section, text):
    """Replaces what stands between the markers of a section."""
    content = page.read_text(encoding="utf-8")
    begin, end = f"<!-- {section} -->\n", f"<!-- /{section} -->"
    if begin not in content or end not in content:
        raise ValueError(f"{page}: has no place for {section}: {begin.strip()} ... {end}")
    head, rest = content.split(begin, 1)
    page.write_text(f"{head}{begin}\n{text}\n\n{end}{rest.split(end, 1)[1]}", encoding="utf-8")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("tremolo", type=Path, help="the program")
    default = os.environ.get("TREMOLO_REFERENCE", ROOT.parent / "shared" / "reference")
    parser.add_argument("--reference", type=Path, default=Path(default), help="folder of the reference data")
    parser.add_argument("--only", nargs="+", choices=SECTIONS, default=list(SECTIONS), metavar="SECTION", help="these alone")
    arguments = parser.parse_args()
    reference = arguments.reference / "materials"
    if not (reference / "manifest.json").exists():
        sys.exit(f"gallery: {reference}: no reference curves here; set TREMOLO_REFERENCE or --reference")
    (PAGES / "pictures").mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as folder:
        gallery = Gallery(arguments.tremolo.resolve(), reference, Path(folder))
        for section in arguments.only:
            print(section, flush=True)
            write_between(PAGES / "gallery.md", section, SECTIONS[section](gallery))


if __name__ == "__main__":
    main()
