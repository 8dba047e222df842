"""`tremolo extract`: what a run stores, as tables that practice reads, and as pictures of them."""

import numpy as np

from tremolo import outputs
from tremolo.extract import newmark, pictures, points, profiles, ratios, tables
from tremolo.intensity import GRAVITY
from tremolo.run import Run

YIELDED = 1e-3  # equivalent plastic strain


def _histories(run, folder, wanted, base, draw):
    """A table a point, with displacements relative to the base."""
    written = {}
    for point in wanted:
        written[point.name] = profiles.history(point.series, base and base.series)
        yield tables.write(folder / tables.file_name("history", point.name), written[point.name])
    if draw and base and written:
        yield pictures.relative_displacement(written, base.name, folder / "relative_displacement.png")


def _ratios(folder, wanted, base, draw):
    for point in wanted:
        if point.name == base.name:
            continue
        if point.of_frames:
            yield f"{point.name}: frames are too far apart for its spectral ratios; they need the history of a [[monitor]]"
            continue
        fourier, response = ratios.fourier(point.series, base.series), ratios.response(point.series, base.series)
        yield tables.write(folder / tables.file_name("fourier_ratio", point.name, "over", base.name), fourier)
        yield tables.write(folder / tables.file_name("response_ratio", point.name, "over", base.name), response)
        if draw:
            path = folder / tables.file_name("ratio", point.name, "over", base.name)
            yield pictures.ratios(fourier, response, f"{point.name} over {base.name}", path.with_suffix(".png"))


def _profiles(run, folder, base, draw):
    for name in run.lines:
        of_line = points.of_line(run, name)
        if not of_line:
            yield f"{name}: this line has no history yet"
            continue
        table = profiles.profile(of_line, base and base.series)
        path = tables.write(folder / tables.file_name("profile", name), table)
        yield path
        if draw:
            yield pictures.profile(table, f"{run.title}: {name}", path.with_suffix(".png"))


def _downslope(run, given):
    """+1 or -1 along x. Raises ValueError where it is neither given nor shown by the surfaces."""
    if given:
        return {"left": -1.0, "right": 1.0}[given]
    left, right = run.attribute("surface_levels", [0.0, 0.0])
    if left == right:
        raise ValueError(f"{run.path}: its ground is as high at both sides: say with --downslope left or right where the mass slides to")
    return -1.0 if left < right else 1.0


def _yielded(run):
    """The largest equivalent plastic strain of the last frame; 0 where there is none."""
    if len(run.times) == 0 or not run.has_field("equivalent_plastic_strain"):
        return 0.0
    return float(run.field(len(run.times) - 1, "equivalent_plastic_strain").max())


def _analyses(mass, base):
    """Accelerations of the ground by the name of the analysis that takes them."""
    found = {"decoupled": mass}
    return found | {"rigid_block": base.series} if base else found


def _require_newmark(run, coefficients):
    for value in coefficients:
        if not (np.isfinite(value) and value > 0.0):
            raise ValueError(f"--ky {value:g}: a yield coefficient is a number above 0, in parts of gravity")
    if not run.sliding_masses:
        raise ValueError(f"{run.path}: stores no sliding mass: put [[sliding_mass]] into the case and run it again")


def _newmark(run, folder, base, coefficients, sign, draw):
    if (strain := _yielded(run)) > YIELDED:
        yield (f"note: soil yields in this run, with equivalent plastic strains of up to {strain:.2g}; the decoupled analysis wants "
               "the acceleration of a mass that does not slide, from a run whose soil does not fail")
    for name in run.sliding_masses:
        mass = run.sliding_mass(name)
        if len(mass) < 2:
            yield f"{name}: this sliding mass has no history yet"
            continue
        histories, summary = {}, {"k_y": np.array(coefficients)}
        for analysis, ground in _analyses(mass, base).items():
            drives = newmark.driving(ground["ax"], sign)
            table = {"time_s": ground["time"], "driving_m_s2": drives}
            for k_y in coefficients:
                table[f"displacement_ky_{k_y:g}_m"] = newmark.sliding_displacement(ground["time"], drives, k_y * GRAVITY)
            histories[analysis] = table
            last = np.array([table[f"displacement_ky_{k_y:g}_m"][-1] for k_y in coefficients])
            summary |= {f"{analysis}_k_max": np.full(len(coefficients), drives.max() / GRAVITY), f"{analysis}_displacement_m": last}
            yield tables.write(folder / tables.file_name("newmark", name, analysis), table)
            for k_y, moved in zip(coefficients, last):
                yield (f"{name}: {analysis.replace('_', ' ')}, k_y = {k_y:g}, k_max = {drives.max() / GRAVITY:.3g}: slides "
                       f"{moved:.3g} m")
        yield tables.write(folder / tables.file_name("newmark", name), summary)
        if draw:
            yield pictures.newmark(histories, f"{run.title}: {name}", folder / tables.file_name("newmark", name).replace(".csv", ".png"))


def carry_out(arguments):
    """Yields what is said, and the path of every file as it is written."""
    run = Run(arguments.run)
    base = None
    if arguments.base:
        base, said = points.find(run, arguments.base)
        if base.of_frames:
            raise ValueError(f"{run.path}: stores no history near {arguments.base}, and that of a base cannot be taken from frames: put a "
                             "[[monitor]] there into the case and run it again")
        if said:
            yield said
    wanted = {}
    for text in arguments.point or []:
        point, said = points.find(run, text)
        if said:
            yield said
        wanted[point.name] = point
    wanted = list(wanted.values()) if arguments.point else points.monitors(run)
    if not wanted and not run.lines and not run.sliding_masses:
        raise ValueError(f"{run.path}: stores no histories: put [[monitor]], [[line]] or [[sliding_mass]] into the case and run it again, "
                         "or follow soil through the frames with --point X,Y")
    if arguments.ky:
        _require_newmark(run, arguments.ky)
        sign = _downslope(run, arguments.downslope)
    folder = outputs.made_folder(arguments.out or run.path.parent / "tables")
    yield from _histories(run, folder, wanted, base, arguments.plot)
    if base:
        yield from _ratios(folder, wanted, base, arguments.plot)
    yield from _profiles(run, folder, base, arguments.plot)
    if arguments.ky:
        yield from _newmark(run, folder, base, arguments.ky, sign, arguments.plot)
