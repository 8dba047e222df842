#!/usr/bin/env python3
"""Why models of one site differ in surface acceleration: how damping depends on frequency, whether soil yields, and how it
unloads. A Markdown table, site.png (the accelerations) and ratio.png (what damping laws do over frequency).

    cases/layered_site/study.py [TREMOLO [FOLDER]]      default: build/release/bin/tremolo, runs/layered_site
"""

import sys
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "python"))

from tremolo import column, style
from tremolo.variants import run_column

CASE = Path(__file__).resolve().parent / "case.toml"
GRAVITY = 9.81  # m/s2
CURVES = {
    "clay": 'curve = "darendeli"\nplasticity_index = 30.0\nmean_stress = 50e3\nunloading = "masing"\n',
    "sand": 'curve = "darendeli"\nplasticity_index = 0.0\nmean_stress = 120e3\nunloading = "masing"\n',
}
LAWS = {"clay": 'model = "mkz"\ndensity = 1742.5', "sand": 'model = "mkz"\ndensity = 1990.0'}
LINEAR = {text: "" for text in CURVES.values()} | {text: text.replace("mkz", "linear_elastic") for text in LAWS.values()}
REDUCED = {text: text.replace('"masing"', '"mrdf"') for text in CURVES.values()}
DAMPING = 'model = "constant"\nreference_hz = 3.0\n'


def damping(model, reference):
    return {DAMPING: f'model = "{model}"\nreference_hz = {reference}\n'}


HYSTERETIC, AT_3, AT_10, CONSTANT = damping("hysteretic", 3.0), damping("kelvin_voigt", 3.0), damping("kelvin_voigt", 10.0), {}
# The rows of the table: name, model, changes of the case, and whether the soil yields.
ROWS = [
    ("wave", "wave", LINEAR | HYSTERETIC, False),
    ("fe, constant", "fe", LINEAR | CONSTANT, False),
    ("fe, Kelvin-Voigt at 10 Hz", "fe", LINEAR | AT_10, False),
    ("fe, Kelvin-Voigt at 3 Hz", "fe", LINEAR | AT_3, False),
    ("eql", "eql", HYSTERETIC, True),
    ("fe, constant, MRDF", "fe", REDUCED | CONSTANT, True),
    ("fe, Kelvin-Voigt at 10 Hz, MRDF", "fe", REDUCED | AT_10, True),
    ("fe, Kelvin-Voigt at 3 Hz, MRDF", "fe", REDUCED | AT_3, True),
    ("fe, constant, Masing", "fe", CONSTANT, True),
    ("fe, Kelvin-Voigt at 3 Hz, Masing", "fe", AT_3, True),
]

# Unit table of four mechanisms over 0.1 to 25 Hz (docs/free-fields/damping.md).
CENTRES = np.array([0.09748, 0.66313, 3.77, 25.64509])  # Hz
WEIGHTS = np.array([1.574927, 1.11218, 1.11218, 1.574927])


def constant(frequency):
    """Ratio over the wanted one."""
    x = frequency[:, None] / CENTRES
    return (WEIGHTS * x / (1.0 + x**2)).sum(axis=1)


def rayleigh(frequency, first, second):
    return (first * second / frequency + frequency) / (first + second)


def draw_ratios(folder):
    """Ratio over the wanted one, over frequency."""
    frequency = np.geomspace(0.03, 60.0, 400)
    laws = {
        "constant, 4 mechanisms": constant(frequency),
        "Kelvin-Voigt at 3 Hz": frequency / 3.0,
        "Kelvin-Voigt at 10 Hz": frequency / 10.0,
        "Rayleigh, 1 and 10 Hz": rayleigh(frequency, 1.0, 10.0),
    }
    figure, ax = style.plt.subplots(figsize=(7.2, 3.6), layout="constrained")
    ax.axhline(1.0, color="0.4", linewidth=0.8)
    ax.axvspan(0.1, 25.0, color="0.95", zorder=0)
    for name, ratio in laws.items():
        ax.loglog(frequency, ratio, label=name)
    ax.set(xlabel="frequency (Hz)", ylabel="damping ratio over that wanted", ylim=(0.1, 10.0), xlim=(0.03, 60.0))
    ax.legend()
    return style.save(figure, folder, "ratio.png")


def draw_site(results, folder):
    """Surface accelerations as bars, and their spectra."""
    figure, (bars, spectra) = style.plt.subplots(2, 1, figsize=(8.4, 7.6), layout="constrained", height_ratios=(1.0, 1.2))
    for number, (name, yields, peak, spectrum, _) in enumerate(results):
        colour = style.COLOURS[1 if yields else 0]
        bars.barh(number, peak / GRAVITY, color=colour)
        bars.annotate(f"{peak / GRAVITY:.2f}", (peak / GRAVITY, number), xytext=(3, 0), textcoords="offset points", va="center")
    bars.set_yticks(range(len(results)), [name for name, *_ in results])
    bars.invert_yaxis()
    bars.set(xlabel="peak acceleration of the surface (g); soil that yields in the second colour")
    for name, yields, _, spectrum, _ in results:
        if yields:
            spectra.semilogx(spectrum["period"], spectrum["surface"] / GRAVITY, label=name)
    spectra.semilogx(spectrum["period"], spectrum["outcrop"] / GRAVITY, "k:", label="rock")
    spectra.set(xlabel="period (s)", ylabel="spectral acceleration, 5 % (g)", xlim=(0.02, 5.0), ylim=(0.0, None))
    spectra.legend(title="soil that yields")
    return style.save(figure, folder, "site.png")


def main():
    tremolo = sys.argv[1] if len(sys.argv) > 1 else ROOT / "build/release/bin/tremolo"
    folder = Path(sys.argv[2] if len(sys.argv) > 2 else "runs/layered_site")
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "motion.csv").write_bytes((CASE.parent / "motion.csv").read_bytes())
    results = []
    print("| model | soil | PGA, g | largest strain, % | CPU time, s |\n| --- | --- | --- | --- | --- |")
    for number, (name, model, changes, yields) in enumerate(ROWS):
        out, cpu = run_column(tremolo, CASE, changes, folder, f"site_{number}", model)
        _, histories, profile, spectra, _ = column.read(out)
        peak, strain = np.abs(histories[0]["ax"]).max(), profile["peak_gxy"].max()
        results.append((name, yields, peak, spectra, cpu))
        soil = "yields" if yields else "linear"
        print(f"| {name} | {soil} | {peak / GRAVITY:.2f} | {100.0 * strain:.2f} | {cpu:.1f} |", flush=True)
    print(draw_site(results, folder))
    print(draw_ratios(folder))


if __name__ == "__main__":
    main()
