"""What a report says in tables and words: model, plan, motion measures, differences, verification, versions, warnings."""

import numpy as np

from tremolo import comparison, style, timeline, verification
from tremolo.histories import even_steps
from tremolo.intensity import arias


class Table:
    """Headings and rows of texts; the first column names the row."""

    def __init__(self, headings, rows, caption=""):
        self.headings, self.rows, self.caption = headings, rows, caption


def model(run):
    """What the model is, a fact a row."""
    rows = []

    def add(what, value):
        if value not in (None, ""):
            rows.append([what, value])

    add("wave", run.attribute("wave"))
    angle = run.attribute("angle_deg")
    add("angle of incidence from the vertical", None if angle is None else f"{angle:g}°")
    vertical = run.attribute("vertical_angle_deg")
    add("angle of the P wave with the vertical motion", None if vertical is None else f"{vertical:g}°")
    box = run.attribute("box")
    if box is not None:
        add("model", f"{box[2] - box[0]:g} m wide, {box[3] - box[1]:g} m high")
    mesh = run.attribute("mesh_size")
    if len(run.times) and mesh:
        sizes, counts = np.unique(np.round(np.atleast_1d(style.sizes(run, 0)), 9), return_counts=True)
        particles = len(run.field(0, "position"))
        if len(sizes) == 1:
            counts = [particles]
        for size, count in sorted(zip(sizes, counts), reverse=True):
            add(f"cells of {mesh * size / style.spacing(run):g} m", f"{count:,} particles of {size:g} m")
    add("soils", ", ".join(run.attribute("soil_names") or []))
    for name in run.bodies:
        body = run.body(name)
        add(f"structure {name}", f"{body.mass:,.4g} kg/m, {body.inertia:,.4g} kg m about its centre of mass")
    for name in run.linings:
        lining = run.lining(name)
        add(f"lining {name}", f"{lining.thickness:g} m thick, EA {lining.axial_stiffness:.4g} N/m, EI {lining.bending_stiffness:.4g} N m, "
            f"{len(lining.nodes)} elements, {len(lining.hinges)} hinges")
    for name in run.props:
        prop = run.prop(name)
        if len(prop):
            add(f"prop {name}", f"from {prop.ends[0]} to {prop.ends[1]}, {prop.length[0]:.3g} m; {prop.force[0] / 1e3:.4g} kN/m at the start, "
                f"{prop.force.min() / 1e3:.4g} to {prop.force.max() / 1e3:.4g} kN/m over time")
    for name in run.sections:
        section = run.section(name)
        add(f"section {name}", f"{'a cut' if section.centre is None else f'{len(section.cuts)} cuts'} through {section.structure}, "
            f"{section.thickness.min():.3g} m thick")
    for name in run.monitors:
        series = run.monitor(name)
        if len(series):
            add(f"monitor {name}", f"x = {series['x'][0]:.2f} m, y = {series['y'][0]:.2f} m at the start")
    if len(run.times):
        add("frames", f"{len(run.times)}, {run.times[0]:.3g} to {run.times[-1]:.3g} s")
    return Table(["what", "value"], rows, "The model")


def _bytes(number):
    return f"{number / 1e6:,.3g} MB"


def plan(run):
    """The plan of effects as tables; nothing where the run holds none."""
    content = run.plan
    if not content:
        return []
    effects = [["on" if effect["on"] else "off", effect["name"], effect["why"]] for effect in content["effects"]]
    free_fields = f"Free fields; base: {content['base']}" if content.get("base") else "Free fields"
    served = [
        [source["name"], source["program"], source["model"], ", ".join(f"{side} ({what})" for side, what in source["serves"].items())]
        for source in content.get("sources", [])
    ]
    levels = [
        [f"{level['cell_size_m']:g}", f"{level['particle_size_m']:g}", f"{level['cells']:,.0f}", f"{level['particles']:,.0f}",
         f"{level['dt_s']:.4g}", f"{level['critical_dt_s']:.4g}"]
        for level in content.get("levels", [])
    ]
    size = [
        ["time steps", f"{content['steps']:,.0f} of {content['dt_s']:.4g} s"],
        ["arrays in the domain", _bytes(content["memory_bytes"])],
        ["results, at most", _bytes(content["output_bytes"])],
        ["time on one thread, of the order of magnitude", f"{content['estimated_time_s']:.3g} s"],
    ]
    tables = [
        Table(["stage", "kind", "what changes", "lasts"],
              [[stage[key] for key in ("name", "kind", "changes", "lasts")] for stage in content.get("stages", [])], "Stages"),
        Table(["", "effect", "why"], effects, "Effects"),
        Table(["source", "program", "model", "serves"], served, free_fields),
        Table(["cell size (m)", "particle size (m)", "cells", "particles", "time step (s)", "critical time step (s)"], levels,
              "Levels of the mesh"),
        Table(["what", "value"], size, "Size"),
    ]
    if content.get("notes"):
        tables.append(Table(["", "remark"], [[str(i), note] for i, note in enumerate(content["notes"], 1)], "Remarks"))
    return tables


def _duration(acceleration, dt):
    """Arias intensity (m/s) and the time between 5 and 95 % of it (s)."""
    passed = arias(acceleration, dt)
    if passed[-1] == 0.0:
        return 0.0, 0.0
    begin, end = np.searchsorted(passed, [0.05 * passed[-1], 0.95 * passed[-1]])
    return float(passed[-1]), float((end - begin) * dt)


def measures(run):
    """Peaks, Arias intensity and significant duration at every monitor and in both directions."""
    rows = []
    for name in run.monitors:
        series = run.monitor(name)
        if len(series) < 2:
            continue
        for direction, text in (("x", "horizontal"), ("y", "vertical")):
            peaks = [float(np.abs(series[quantity + direction]).max()) for quantity in "avu"]
            acceleration, dt = even_steps(series["time"], series["a" + direction])
            arias, duration = _duration(acceleration, dt)
            last = series["u" + direction][-1]
            rows.append([f"{name}, {text}", *(f"{value:.4g}" for value in (*peaks, last, arias, duration))])
    headings = ["monitor", "peak acceleration (m/s²)", "peak velocity (m/s)", "peak displacement (m)", "last displacement (m)",
                "Arias intensity (m/s)", "5-95 % duration (s)"]
    return Table(headings, rows, "Motion measures")


def stage_measures(run):
    """What each shaking and each rest has brought to each monitor; None where there is one such stage."""
    timed = [stage for stage in run.plan.get("stages", []) if "from_s" in stage]
    if len(timed) < 2:
        return None
    rows = []
    for name in run.monitors:
        series = run.monitor(name)
        time = series["time"]
        for stage in timed:
            during = (time >= stage["from_s"]) & (time <= stage["to_s"])
            if np.count_nonzero(during) < 2:
                continue
            acceleration, dt = even_steps(time[during], series["ax"][during])
            moved = [series[direction][during][-1] - series[direction][during][0] for direction in ("ux", "uy")]
            values = [np.abs(acceleration).max(), _duration(acceleration, dt)[0], *moved]
            wet = "pore_pressure_ratio" in series.columns
            ratio = series["pore_pressure_ratio"][during] if wet else []
            rows.append([f"{name}, {stage['name']}", *(f"{value:.4g}" for value in values),
                         *((f"{ratio.max():.3g}", f"{ratio[-1]:.3g}") if wet else ("-", "-"))])
    headings = ["monitor, stage", "peak horizontal acceleration (m/s²)", "Arias intensity (m/s)", "it moves by ux (m)", "by uy (m)",
                "largest r_u", "r_u at its end"]
    return Table(headings, rows, "Stages at the monitors") if rows else None


def differences(first, second, titles):
    """Peaks at the monitors of both runs, over the time that both cover, and how far the histories differ."""
    common = [name for name in first.monitors if name in second.monitors and len(first.monitor(name)) > 1 and len(second.monitor(name)) > 1]
    rows = []
    for name in common:
        one, other = first.monitor(name), second.monitor(name)
        end = min(one["time"][-1], other["time"][-1])
        for (quantity, unit), text in zip(comparison.QUANTITIES, ("acceleration", "velocity", "displacement")):
            a, b = (comparison.peak(series, quantity, end) for series in (one, other))
            ratio = f"{b / a:.3f}" if a > 0.0 else "-"
            share = f"{100.0 * comparison.difference(one, other, quantity):.2f}"
            rows.append([f"{name}, peak {text} ({unit})", f"{a:.4g}", f"{b:.4g}", ratio, share])
    return Table(["monitor", *titles, "ratio", "difference of the histories (%)"], rows, f"{titles[1]} against {titles[0]}")


def verified(run):
    """The table of `tremolo verify` and the tables of its histories; None where the run has not been verified."""
    path = run.path.parent / "verify.json"
    if not path.exists():
        return None
    _, summary, tables = verification.load(path)
    rows = [
        [region["name"], f"{region['particles']:,}", f"{100.0 * region['relative_l2']:.3g}", f"{100.0 * region['peak_error']:.3g}",
         f"{region['phase_lag']:.3g}"]
        for region in summary["regions"]
    ]
    verdict = "passed" if summary["passed"] else "failed"
    caption = f"Against the exact field: {verdict}, tolerance {100.0 * summary['tolerance']:g} %"
    return Table(["region", "particles", "relative L2 error (%)", "peak error (%)", "phase lag (s)"], rows, caption), tables


def waits(run):
    """In words, who computed and who waited; nothing where the run has not ended well."""
    return [] if run.table("timeline") is None else list(timeline.sentences(timeline.timelines(run)))


def processes(run):
    table = run.table("processes")
    if table is None:
        return None
    columns = ("wall_time", "cpu_time", "waiting")
    rows = [[name, *(f"{table[column][i]:.2f}" for column in columns)] for i, name in enumerate(table["process"])]
    return Table(["process", "wall time (s)", "CPU time (s)", "waiting (s)"], rows, "Processes")


def origin(run):
    """Versions and machine."""
    names = {"build_version": "tremolo", "build_flags": "build", "compiler": "compiler", "host": "machine", "started": "started",
             "status": "status", "schema_version": "schema of the run file"}
    rows = [[text, str(run.attribute(name)).strip()] for name, text in names.items() if run.attribute(name) is not None]
    return Table(["what", "value"], [["file", str(run.path.resolve())], *rows], "Versions and machine")


def warnings(run):
    """What the processes warn of in their logs beside the run."""
    found = []
    for log in sorted((run.path.parent / "log").glob("*.log")):
        lines = log.read_text(encoding="utf-8", errors="replace").splitlines()
        found += [f"{log.stem}: {line.strip()}" for line in lines if "warning: " in line]
    return found
