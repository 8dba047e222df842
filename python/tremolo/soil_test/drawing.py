"""The picture of a soil test: what `tremolo soiltest --plot` writes.

Stress-strain and stress path stand in every picture; what else there is follows from the test: pore pressure and strain
against cycles, cyclic strength, modulus and damping. Axes in kPa and per cent, compression positive.
"""

from pathlib import Path

import numpy as np

from matplotlib.cm import ScalarMappable
from matplotlib.colors import BoundaryNorm, ListedColormap
from matplotlib.ticker import MaxNLocator, NullFormatter

from tremolo import style
from tremolo.soil_test import overlay, record, response
from tremolo.soil_test.view import View, law_lines

LAWS = {
    "linear_elastic": "linear elastic",
    "mohr_coulomb": "Mohr-Coulomb",
    "drucker_prager": "Drucker-Prager",
    "multi_yield_clay": "clay of nested surfaces",
    "pm4sand": "PM4Sand",
    "pdmy03": "PDMY03",
}
CRITERIA = {
    "cycles_1pc": ("1 % strain", "o"),
    "cycles_3pc": ("3 % strain", "s"),
    "cycles_5pc": ("5 % strain", "^"),
    "cycles_ru98": ("$r_u$ = 0.98", "D"),
}
REFERENCE = {"color": "0.72", "linewidth": 2.8, "solid_joinstyle": "round", "zorder": 1}
GUIDE = {"color": "0.75", "linewidth": 0.6, "zorder": 0}


def draw_pair(ax, ours, below, x, y):
    """Ours over the references, quantities x and y of the views."""
    for number, view in enumerate(below):
        ax.plot(getattr(view, x), getattr(view, y), **REFERENCE, label=None if number else "reference")
    for (name, view), colour in zip(ours.items(), colours(len(ours))):
        ax.plot(getattr(view, x), getattr(view, y), color=colour, linewidth=0.8, zorder=2, label=name)


FEW = 4


def colours(count):
    """Of curves that are few, distinct ones; of many, a sequence from dark to light."""
    return style.COLOURS[:FEW] if count <= FEW else style.plt.get_cmap(style.SEQUENTIAL)(np.linspace(0.0, 0.85, count))


def colour_bar(figure, axes, labels):
    """Which colour is which of many curves."""
    edges = np.arange(len(labels) + 1) - 0.5
    colouring = ScalarMappable(BoundaryNorm(edges, len(labels)), ListedColormap(colours(len(labels))))
    bar = figure.colorbar(colouring, ax=axes, ticks=np.arange(len(labels)), pad=0.01)
    bar.ax.set_yticklabels(labels, fontsize=7)
    bar.ax.tick_params(length=0)
    bar.minorticks_off()
    bar.outline.set_visible(False)


def log_ticks(ax):
    """Plain numbers on a logarithmic abscissa: the decades, with 2 and 5 between them where there is room."""
    low, high = ax.get_xlim()
    steps = (1.0, 2.0, 5.0) if high < 300.0 * low else (1.0,)
    ticks = [step * 10.0**power for power in range(-6, 9) for step in steps]
    ax.set_xticks([tick for tick in ticks if low <= tick <= high])
    ax.xaxis.set_major_formatter("{x:g}")
    ax.xaxis.set_minor_formatter(NullFormatter())


def guides(ax, *levels):
    """Lines that say where a criterion lies; they do not widen the axes."""
    limits = ax.get_ylim()
    for level in levels:
        ax.axhline(level, **GUIDE)
    ax.set_ylim(limits)


def zero_lines(ax):
    ax.axhline(0.0, **GUIDE)
    ax.axvline(0.0, **GUIDE)


def first(ours):
    return next(iter(ours.values()))


def one_of_several(test):
    """Whether the histories drawn are those of one stress ratio of several, which has to be said."""
    return test.strength_curve is not None


def draw_stress_strain(ax, ours, below, test):
    draw_pair(ax, ours, below, "strain", "stress")
    ax.set(xlabel=first(ours).strain_label, ylabel=first(ours).stress_label)
    zero_lines(ax)
    if below or 1 < len(ours) <= FEW or one_of_several(test):
        ax.legend(loc="best")


def draw_stress_path(ax, ours, below, test):
    """Path of the stresses under the lines of the law; in shear the lines bound the shear stress from both sides."""
    draw_pair(ax, ours, below, "p", "stress")
    view = first(ours)
    views = [*ours.values(), *below]
    right = 1.06 * max(v.p.max() for v in views)
    top, bottom = max(v.stress.max() for v in views), min(v.stress.min() for v in views)
    span = max(abs(top), abs(bottom), 1e-3 * right)
    sides = (1.0, -1.0) if min(top, -bottom) > 0.05 * span else (1.0 if top >= -bottom else -1.0,)
    for label, stroke, colour, line in law_lines(test):
        for side in sides:
            shear = side * view.line_scale * line["q"] / 1e3
            ax.plot(line["p"] / 1e3, shear, stroke, color=colour, linewidth=0.9, zorder=1.5,
                    label=label if side == sides[0] else None)
    ax.xaxis.set_major_locator(MaxNLocator(5))
    ax.set(xlabel=view.p_label, ylabel=view.stress_label, xlim=(0.0, right))
    low = -1.15 * span if -1.0 in sides else min(0.0, 1.1 * bottom)
    ax.set_ylim(low, 1.15 * span if 1.0 in sides else 1.1 * top)
    zero_lines(ax)
    handles, labels = ax.get_legend_handles_labels()
    hidden = {"reference"} if one_of_several(test) else {"reference", *ours}
    known = [(h, label) for h, label in zip(handles, labels) if label not in hidden]
    if known:
        # Above the axes: inside, the lines themselves go where there is room.
        ax.legend(*zip(*known), loc="lower left", bbox_to_anchor=(0.0, 1.0), ncols=len(known) if len(known) < 4 else 2,
                  handlelength=1.8, columnspacing=1.0, borderaxespad=0.1)


def name_test(ax, ours, test):
    """Which of several stress ratios a panel shows."""
    if one_of_several(test):
        ax.set_title(next(iter(ours)), loc="left")


def draw_pore_pressure_cycles(ax, ours, below, test):
    draw_pair(ax, ours, below, "cycle", "ru")
    name_test(ax, ours, test)
    guides(ax, 0.98)
    ax.set(xlabel="cycles", ylabel="excess pore pressure ratio $r_u$", xlim=(0.0, None))


def draw_strain_cycles(ax, ours, below, test):
    draw_pair(ax, ours, below, "cycle", "strain")
    name_test(ax, ours, test)
    guides(ax, -3.0, 3.0)
    ax.set(xlabel="cycles", ylabel=first(ours).strain_label, xlim=(0.0, None))


def draw_volume_cycles(ax, ours, below, test):
    draw_pair(ax, ours, below, "cycle", "volume")
    name_test(ax, ours, test)
    ax.set(xlabel="cycles", ylabel="volumetric strain, compression (%)", xlim=(0.0, None))


def draw_pore_pressure_strain(ax, ours, below, _test):
    draw_pair(ax, ours, below, "strain", "ru")
    ax.set(xlabel=first(ours).strain_label, ylabel="excess pore pressure ratio $r_u$")
    zero_lines(ax)


def draw_volume_strain(ax, ours, below, _test):
    draw_pair(ax, ours, below, "strain", "volume")
    ax.set(xlabel=first(ours).strain_label, ylabel="volumetric strain, compression (%)")
    zero_lines(ax)


def draw_compression(ax, ours, below, test):
    stress, label = ("p", "mean effective stress p' (kPa)")
    if test.about["kind"] == "oedometer":
        stress, label = ("vertical", "vertical effective stress (kPa)")
    draw_pair(ax, ours, below, stress, "volume")
    ax.set(xlabel=label, ylabel="volumetric strain, compression (%)", xscale="log")
    log_ticks(ax)
    ax.invert_yaxis()


def draw_strength_curve(ax, test):
    """Stress ratio against cycles to each criterion, and the curve that a soil of this density should have."""
    curve = test.strength_curve
    for name, (label, marker) in CRITERIA.items():
        reached = np.isfinite(curve[name])
        if reached.any():
            ax.semilogx(curve[name][reached], curve["stress_ratio"][reached], marker + "-", markersize=4, linewidth=0.9,
                        label=label)
    if test.strength_target is not None:
        ax.semilogx(test.strength_target["cycles"], test.strength_target["stress_ratio"], "k--", linewidth=1.1,
                    label="Idriss & Boulanger")
    ax.set(xlabel="uniform cycles", ylabel="cyclic stress ratio CSR", ylim=(0.0, None))
    log_ticks(ax)
    ax.grid(which="both", color="0.92", linewidth=0.5)
    ax.legend(loc="best")


def draw_modulus(ax, test):
    curve = test.modulus_curve
    ax.semilogx(100 * curve["strain_amplitude"], curve["modulus_ratio"], "o-", markersize=3.5)
    ax.set(xlabel="shear strain amplitude (%)", ylabel="G / Gmax", ylim=(0.0, 1.05))
    log_ticks(ax)
    ax.grid(which="both", color="0.92", linewidth=0.5)


def draw_damping(ax, test):
    curve = test.modulus_curve
    ax.semilogx(100 * curve["strain_amplitude"], 100 * curve["damping"], "s-", markersize=3.5, color=style.COLOURS[1])
    ax.set(xlabel="shear strain amplitude (%)", ylabel="damping ratio (%)", ylim=(0.0, None))
    log_ticks(ax)
    ax.grid(which="both", color="0.92", linewidth=0.5)


HISTORY_PANELS = {
    "loops": draw_stress_strain,
    "path": draw_stress_path,
    "ru_cycles": draw_pore_pressure_cycles,
    "strain_cycles": draw_strain_cycles,
    "volume_cycles": draw_volume_cycles,
    "ru_strain": draw_pore_pressure_strain,
    "volume_strain": draw_volume_strain,
    "compression": draw_compression,
}
CURVE_PANELS = {"strength": draw_strength_curve, "modulus": draw_modulus, "damping": draw_damping}


def panels(test):
    """The rows of the picture, each a list of panels."""
    drained = test.about["drainage"] == "drained"
    if test.about["kind"] == "isotropic_compression":
        return [["compression"]]
    if test.about["kind"] == "oedometer":
        return [["compression", "path"]]
    if test.modulus_curve is not None:
        # A law without lines has neither a stress path nor a volume worth looking at.
        above = ["path", "volume_strain" if drained else "ru_cycles"] if test.lines else []
        return [["loops", *above], ["modulus", "damping"]]
    if test.about["loading"] == "cyclic_stress":
        below = ["volume_cycles" if drained else "ru_cycles", "strain_cycles"]
        return [["loops", "path"], below] if test.strength_curve is None else [["loops", "path", "strength"], below]
    return [["loops", "path", "volume_strain" if drained else "ru_strain"]]


def telling_tests(test):
    """Names of the tests whose histories are drawn: of several stress ratios the one nearest to 15 cycles."""
    names = list(test.histories)
    if test.strength_curve is None:
        return names
    distance = np.abs(np.log(test.summary["cycles_3pc"] / 15.0))
    return [names[int(np.nanargmin(distance))]] if np.isfinite(distance).any() else names[-1:]


def label_of(test, name):
    row = list(test.summary["test"]).index(name)
    ratio, amplitude = test.summary["stress_ratio"][row], test.summary["strain_amplitude"][row]
    if np.isfinite(ratio) and ratio > 0.0:
        return f"CSR {ratio:.4g}"
    return f"{100 * amplitude:.3g} % strain" if np.isfinite(amplitude) and amplitude > 0.0 else test.about["law"]


def heading(test):
    about = test.about
    state = f"$\\sigma'_v$ = {about['vertical_stress'] / 1e3:.4g} kPa, $K_0$ = {about['k0']:.3g}"
    kind, drainage = (about[name].replace("_", " ") for name in ("kind", "drainage"))
    return f"{about['title']}\n{', '.join((LAWS.get(about['law'], about['law']), kind, drainage, state))}"


def draw(test, references=(), labels=None, title=None):
    """The figure of a soil test; reference curves (read_reference) lie below ours. `labels` name its histories."""
    names = telling_tests(test)
    in_plane = response.is_in_plane(test.histories[names[0]])
    kind = test.about["kind"]
    if labels is None:
        labels = ["tremolo"] if references and len(test.histories) == 1 else [label_of(test, name) for name in names]
    ours = {label: View(test.histories[name], kind, in_plane) for label, name in zip(labels, names)}
    below = [View(reference, kind, in_plane) for reference in references]
    rows = panels(test)
    width = max(3.7 * max(map(len, rows)), 5.5)
    figure, axes = style.plt.subplot_mosaic(
        [[[row]] for row in rows], figsize=(width, 0.6 + 3.0 * len(rows)), layout="constrained"
    )
    for name, ax in axes.items():
        if name in CURVE_PANELS:
            CURVE_PANELS[name](ax, test)
        else:
            HISTORY_PANELS[name](ax, ours, below, test)
    if len(ours) > FEW:
        colour_bar(figure, [axes[name] for name in rows[0]], labels)
    figure.suptitle(title or heading(test), fontsize=9)
    return figure


def picture(path, over=None, stress_unit="kPa"):
    """Draws OUT.png beside OUT.h5, over a reference curve where one is given; returns its path."""
    test = record.read(path)
    references = [] if over is None else [overlay.overlay(test, over, stress_unit, telling_tests(test))]
    return style.save(draw(test, references), Path(path).parent, Path(path).stem + ".png")
