#!/usr/bin/env python3
"""Moment and thrust of the lining against the exact ring in ground that is sheared as the free field is: a Markdown table and
ovaling.png.

    cases/lined_tunnel/study.py [TREMOLO [FOLDER]]      default: build/release/bin/tremolo, runs/lined_tunnel

Runs what is not in FOLDER yet.
"""

import sys
from pathlib import Path

import numpy as np

CASE = Path(__file__).resolve().parent / "case.toml"
sys.path.insert(0, str(CASE.parents[2] / "python"))

from tremolo import style
from tremolo.variants import cpu_time, run_variant

TEXT = CASE.read_text()
CENTRE, OUTER = np.array([0.0, -15.0]), 3.15
DENSITY, SPEED, POISSON = 1900.0, 220.0, 0.3  # of the dense sand
SHEAR = DENSITY * SPEED**2
LINING = TEXT[TEXT.index("[[lining]]"):TEXT.index("[mesh]")]
CROWN = TEXT[TEXT.index('[[monitor]]\nname = "crown"'):TEXT.index("[output]")]
# The free field that the lining replaces.
ALONE = {LINING: "", CROWN: f'[[line]]\nname = "axis"\nfrom = [0.0, {CENTRE[1] + OUTER}]\nto = [0.0, {CENTRE[1] - OUTER}]\nspacing = 0.35\n\n'}
OBLIQUE = {"angle_deg = 0.0\n": "angle_deg = 15.0\n"}
BONDED = {"friction = 0.6\n": "friction = 0.6\nadhesion = 1e7\n"}
UNIFORM = {"density = 1700.0\nvs = 150.0\n": "density = 1900.0\nvs = 220.0\n"}
SMOOTH = {"friction = 0.6\n": "friction = 0.0\n"}
# Folder: label, changes, free field, whether soil sticks in the closed form.
VARIANTS = {
    "main": ("as it is, friction 0.6", {}, "free", True),
    "bonded": ("bonded", BONDED, "free", True),
    "smooth": ("full slip", SMOOTH, "free", False),
    "uniform_smooth": ("full slip, dense sand to the surface", SMOOTH | UNIFORM, "free_uniform", False),
    "oblique": ("friction 0.6, 15 degrees", OBLIQUE, "free_oblique", True),
    "oblique_bonded": ("bonded, 15 degrees", OBLIQUE | BONDED, "free_oblique", True),
    "thin": ("0.15 m thick, bonded", BONDED | {"thickness = 0.3 ": "thickness = 0.15 "}, "free", True),
    "fine": ("bonded, cells of 0.5 and 0.25 m", BONDED | {"size = 1.0\n": "size = 0.5\n"}, "free", True),
}
FREE = {"free": ALONE, "free_uniform": ALONE | UNIFORM, "free_oblique": ALONE | OBLIQUE}


def exact(section, radius, thickness, sticks, modulus=SHEAR, stressed_before=False):
    """Amplitudes of N (N/m) and M (N) of cos 2(theta - 45 degrees) for a shear strain of 1, tests/verification/mpm_domain/lining: ground
    that touches the ring at R_o = R + t/2; or of ground that had the stress of this strain before the ring stood in it."""
    ea, ei = section
    r, t, ro = radius, thickness, radius + 0.5 * thickness
    n = np.array([0.0, 0.0, ea / r, 2.0 * ea / r])  # of A, B, U, W
    m = np.array([0.0, 0.0, 4.0 * ei / r**2, 2.0 * ei / r**2])
    rr = np.array([-6.0 / ro**4, -4.0 / ro**2, 0.0, 0.0])
    rt = np.array([-6.0 / ro**4, -2.0 / ro**2, 0.0, 0.0])
    ur = np.array([2.0 / ro**3, 4.0 * (1.0 - POISSON) / ro, 0.0, 0.0]) / (2.0 * modulus)
    ut = np.array([2.0 / ro**3, -2.0 * (1.0 - 2.0 * POISSON) / ro, 0.0, 0.0]) / (2.0 * modulus)
    surface = np.array([0.0, 0.0, t / r, 1.0 + 0.5 * t / r])
    s = modulus
    moved = 0.0 if stressed_before else 0.5 * ro  # of the ground at the ring, less what the ring disturbs
    rows = [n + 4.0 / r * m - ro * (rr + t / r * rt), 2.0 * n + 2.0 / r * m - ro * (1.0 + 0.5 * t / r) * rt,
            ur - np.array([0.0, 0.0, 1.0, 0.0]), ut - surface if sticks else rt]
    right = [ro * s * (1.0 - t / r), -ro * s * (1.0 + 0.5 * t / r), -moved, moved if sticks else s]
    scale = np.array([s * ro**4, s * ro**2, ro, ro])  # the unknowns differ by many powers of ten
    matrix = np.array(rows) * scale
    size = np.abs(matrix).max(axis=1)
    found = scale * np.linalg.solve(matrix / size[:, None], np.array(right) / size)
    return abs(n @ found), abs(m @ found)


def ovaling(lining, force):
    """Amplitude of the part of a section force's change since the start that goes as 2 theta, over time."""
    values = getattr(lining, force)
    change = values - values[0]
    middles = 0.5 * (lining.nodes + np.roll(lining.nodes, -1, axis=0)) - CENTRE
    twice = 2.0 * np.arctan2(middles[:, 1], middles[:, 0])
    return np.abs(2.0 * (change @ np.exp(1j * twice)) / len(twice))


def shear_strain(run):
    """The free field's deviatoric strain, a mean from the crown to the invert: time (s), values (1)."""
    line = run.line("axis")
    exx, eyy, gxy = (line.values(name).mean(axis=1) for name in ("exx", "eyy", "gxy"))
    return line.coordinates["time"], np.hypot(exx - eyy, gxy)


def closed_form(lining, sticks):
    """exact() of a lining of the case."""
    section = lining.axial_stiffness, lining.bending_stiffness
    return exact(section, OUTER - 0.5 * lining.thickness, lining.thickness, sticks)


def errors_of(run, strain, sticks):
    """Relative errors of the peaks of M and N."""
    lining = run.lining("ring")
    thrust, moment = closed_form(lining, sticks)
    return [float(ovaling(lining, force).max() / (strain.max() * value) - 1.0) for force, value in (("moment", moment), ("axial_force", thrust))]


def row(label, run, strain, sticks):
    lining = run.lining("ring")
    thrust, moment = closed_form(lining, sticks)
    gamma = float(strain.max())
    found = [float(ovaling(lining, force).max()) / 1e3 for force in ("moment", "axial_force")]
    closed = [gamma * value / 1e3 for value in (moment, thrust)]
    errors = [100.0 * error for error in errors_of(run, strain, sticks)]
    print(f"| {label} | {1e4 * gamma:.2f}e-4 | {found[0]:.2f} | {closed[0]:.2f} | {errors[0]:+.1f} % | {found[1]:.1f} | {closed[1]:.1f} "
          f"| {errors[1]:+.1f} % | {cpu_time(run) / 60.0:.1f} |", flush=True)


def picture(runs, strains, folder):
    """M cos 2 theta over time against the closed form times the free field's strain."""
    figure, axes = style.plt.subplots(1, 2, figsize=(9.0, 3.2), sharey=True, layout="constrained")
    for ax, (key, title) in zip(axes, (("bonded", "0 degrees"), ("oblique_bonded", "15 degrees"))):
        lining = runs[key].lining("ring")
        _, moment = closed_form(lining, True)
        time, strain = strains[VARIANTS[key][2]]
        ax.plot(time, moment * strain / 1e3, color="#222222", linewidth=2.0, alpha=0.4, label="exact, strain of the free field")
        for other, text, colour in ((key, "bonded", 0), (key.replace("_bonded", "").replace("bonded", "main"), "friction 0.6", 1)):
            own = runs[other].lining("ring")
            ax.plot(own.time, ovaling(own, "moment") / 1e3, color=style.COLOURS[colour], label=text)
        ax.set(title=title, xlabel="t (s)", xlim=(0.5, 3.0))
    axes[0].set_ylabel("ovaling moment (kNm/m)")
    axes[0].legend()
    return style.save(figure, folder, "ovaling.png")


def main():
    tremolo = sys.argv[1] if len(sys.argv) > 1 else "build/release/bin/tremolo"
    folder = Path(sys.argv[2] if len(sys.argv) > 2 else "runs/lined_tunnel")
    folder.mkdir(parents=True, exist_ok=True)
    strains = {key: shear_strain(run_variant(tremolo, CASE, changes, folder, key)) for key, changes in FREE.items()}
    print("| variant | free-field strain | M, kNm/m | exact | error | N, kN/m | exact | error | CPU time, min |")
    print("| --- | --- | --- | --- | --- | --- | --- | --- | --- |")
    runs = {}
    for key, (label, changes, free, sticks) in VARIANTS.items():
        runs[key] = run_variant(tremolo, CASE, changes, folder, key)
        row(label, runs[key], strains[free][1], sticks)
    print(picture(runs, strains, folder))


if __name__ == "__main__":
    main()
