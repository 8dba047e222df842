"""Commands: python3 -m tremolo plot RUN | timeline RUN | compare RUN_A RUN_B | report RUN ... | watch RUN | extract RUN
| failure RUN ... | column OUT.h5 | site FOLDER
| soiltest OUT.h5 | sweep-runs FOLDER | safety-picture FOLDER | verify-picture PATH
| motion-picture FOLDER OUT | deconvolution-picture FOLDER OUT."""

import argparse
import json
import sys
from pathlib import Path

from tremolo import (bodies, column, comparison, cost, deconvolution, drift, failure, figures, histories, motion, outputs,
                     pore_pressure, style, swap, timeline, verification)
from tremolo.pictures import contact, fronts, linings, maps, mechanism, preview, props, sections, stages
from tremolo.soil_test import drawing, record
from tremolo.extract import command as extract_command
from tremolo.report import kinds, page, watch
from tremolo.run import Run
from tremolo.site import pictures as site_pictures
from tremolo.site import tables as site_tables
from tremolo.site.read import Site
from tremolo.sweep import command as sweep_command


def _folder(argument, run):
    return outputs.made_folder(argument or run.path.parent / "pictures")


def _port(text):
    """A port of this machine, 0 for any that is free."""
    if not (text.isascii() and text.isdigit() and int(text) <= 65535):
        raise argparse.ArgumentTypeError(f"'{text}' is no port; allowed are 1 to 65535, or 0 for a free one")
    return int(text)


def _times(arguments, run):
    wanted = arguments.time or maps.telling_times(run)
    for time in wanted:
        if not run.times[0] <= time <= run.times[-1]:
            raise ValueError(f"time {time:g} s lies outside the run's frames, {run.times[0]:g} to {run.times[-1]:g} s")
    return wanted


def _require_frames(run):
    if len(run.times) == 0:
        raise ValueError(f"{run.path}: holds no particle frame yet")


def plot(arguments):
    """Yields the path of every picture as it is written."""
    if kinds.kind_of(arguments.run) != "run":
        if arguments.time:
            raise ValueError(f"{arguments.run}: a study has no frames, to which --time belongs")
        yield from figures.write(arguments.run, arguments.out)
        return
    run = Run(arguments.run)
    _require_frames(run)
    folder = _folder(arguments.out, run)
    yield preview.preview(run, folder)
    if built := stages.picture(run, folder):
        yield built
    if run.has_field("acceleration"):
        yield maps.acceleration([run], _times(arguments, run), folder)
    if run.has_field("equivalent_plastic_strain"):
        yield maps.shear_bands([run], _times(arguments, run), folder)
    if run.has_field("pore_pressure_ratio"):
        yield maps.pore_pressure_ratio([run], _times(arguments, run), folder)
    if wet := pore_pressure.monitors(run, folder):
        yield wet
    if moved := bodies.histories(run, folder):
        yield moved
    for name in run.bodies:
        if drawn := contact.picture(run, folder, name, arguments.time):
            yield drawn
    for name in run.linings:
        for on_face in (False, True):
            if drawn := linings.picture(run, folder, name, arguments.time, on_face):
                yield drawn
    yield from sections.pictures(run, folder, arguments.time)
    if propped := props.picture(run, folder):
        yield propped
    if drifted := drift.picture(run, folder):
        yield drifted
    for name in run.monitors:
        if len(run.monitor(name)) > 1:
            yield histories.monitor(run, name, folder)
    if run.energy is not None and len(run.energy) > 1:
        yield histories.energy(run, folder)
    if run.boundary is not None and len(run.boundary["time"]) > 10:
        yield fronts.fronts(run, folder)


def waits(arguments):
    """Yields in words what each process did, then the path of the picture."""
    run = Run(arguments.run)
    yield from timeline.sentences(timeline.timelines(run))
    yield timeline.picture(run, _folder(arguments.out, run))


def _compare_maps(runs, arguments, folder):
    times = _times(arguments, runs[0])
    yield maps.acceleration(runs, times, folder, "compare_acceleration.png")
    if all(run.has_field("equivalent_plastic_strain") for run in runs):
        yield maps.shear_bands(runs, times, folder, "compare_shear_bands.png")
    if all(run.has_field("pore_pressure_ratio") for run in runs):
        yield maps.pore_pressure_ratio(runs, times, folder, "compare_pore_pressure_ratio.png")


def compare(arguments):
    """Numbers, histories and spectra at common monitors; of two runs also maps, of two free fields alone all that is drawn of a
    site."""
    paths = [arguments.run, arguments.other]
    found = [kinds.kind_of(path) for path in paths]
    for path, kind in zip(paths, found):
        if kind not in ("run", "column"):
            raise ValueError(f"{path}: is a study; runs and free fields alone are compared, and `tremolo report` sets studies side by side")
    runs = [Run(path) for path in paths]
    for run, kind in zip(runs, found):
        if kind == "run":
            _require_frames(run)
    if arguments.time and found != ["run", "run"]:
        raise ValueError("--time belongs to the frames of two runs")
    folder = _folder(arguments.out, runs[0])
    yield from comparison.lines(*runs)
    if drawn := histories.compared(runs, folder):
        yield drawn
    if found == ["run", "run"]:
        yield from _compare_maps(runs, arguments, folder)
    if found == ["column", "column"]:
        for name, figure in site_pictures.of_site(Site.of_files(paths)).items():
            yield style.save(figure, folder, f"compare_{name}.png" if name != "histories" else "compare_surface.png")


def report(arguments):
    yield page.write(arguments.runs, arguments.out)


def follow(arguments):
    yield from watch.serve(arguments.run, arguments.port)


def extract(arguments):
    kind = kinds.kind_of(arguments.run)
    if kind not in ("run", "column", "site"):
        raise ValueError(f"{arguments.run}: this study has its tables beside it already; histories are extracted from runs and free fields")
    if kind == "site":
        site = Site(arguments.run)
        yield from site_tables.write(site, outputs.made_folder(arguments.out or Path(arguments.run) / "tables"))
        return
    yield from extract_command.carry_out(arguments)
    if kind == "column":
        yield from site_tables.write(Site.of_files([arguments.run]), Path(arguments.out or Path(arguments.run).parent / "tables"))


def point(text):
    """A point of the command line, X,Y in m."""
    try:
        x, y = map(float, text.split(","))
    except ValueError:
        raise argparse.ArgumentTypeError(f"'{text}' is no point, X,Y in m; one that begins with a minus is --from=-3,2") from None
    if not (abs(x) < float("inf") and abs(y) < float("inf")):
        raise argparse.ArgumentTypeError(f"'{text}' is not finite")
    return x, y


def ends_of(arguments):
    """The points --from and --to (m), or None without them."""
    ends = (getattr(arguments, "from"), arguments.to)
    if (ends[0] is None) != (ends[1] is None):
        raise ValueError("--from and --to are the two ends of one band: give both, or neither")
    return None if ends[0] is None else ends


def failure_times(arguments):
    """Yields a line a run: when its slope failed."""
    ends = ends_of(arguments)
    for path in arguments.runs:
        run = Run(path)
        time = failure.failure_time(run, arguments.strain, ends)
        when = f"fails at {time:.2f} s" if time is not None else f"has not failed by {run.times[-1]:.2f} s"
        yield f"{run.path.parent}: {run.attribute('angle_deg'):g} degrees, {when}"


def verify_picture(arguments):
    yield verification.picture(arguments.path)


def column_picture(arguments):
    yield column.picture(arguments.path)
    if wet := pore_pressure.picture(arguments.path):
        yield wet


def site_response(arguments):
    """Yields the path of every table and picture, then that of the report."""
    folder = Path(arguments.path)
    yield from site_tables.write(Site(folder), outputs.made_folder(folder / "tables"))
    yield from figures.write(folder)
    yield page.write([folder])


def soiltest_picture(arguments):
    yield drawing.picture(arguments.path, arguments.over, arguments.stress_unit)


def motion_picture(arguments):
    yield motion.picture(arguments.folder, arguments.out, arguments.title, arguments.damping)


def deconvolution_picture(arguments):
    yield deconvolution.picture(arguments.folder, arguments.out, arguments.kind, arguments.lead, arguments.cutoff,
                                arguments.title)


def swap_report(arguments):
    yield from swap.report(arguments.path)


def cost_report(arguments):
    yield from cost.report(arguments.path)


def safety_picture(arguments):
    yield mechanism.picture(Path(arguments.path), ends_of(arguments) or ())


def sweep_runs(arguments):
    yield from sweep_command.carry_out(arguments.path, sweep_command.find_program(arguments.tremolo), arguments.jobs, arguments.slurm,
                                       arguments.ranks)


def sweep_task(arguments):
    records = [int(number) for number in arguments.records.split(",")] if arguments.records else []
    yield sweep_command.one_task(arguments.path, arguments.number, arguments.tremolo, arguments.threads, arguments.number in records,
                                 arguments.ranks)


def command_table(arguments):
    """What each command takes, as JSON: `tremolo` writes its manual from it."""
    table = {name: [_option(action) for action in command._actions if action.dest != "help"]
             for name, command in _parser().commands.items()}
    beginning = json.dumps(dict.fromkeys(list(table)[:1], []))[:-2]
    outputs.writable(arguments.path, beginning=beginning).write_text(json.dumps(table))
    return []


def _option(action):
    """An argument or an option as a row of the table."""
    name = action.metavar or action.dest
    return {
        "names": action.option_strings or [name.upper()],
        "value": "" if action.nargs == 0 or not action.option_strings else name.upper(),
        "description": action.help or "",
        "choices": [str(choice) for choice in action.choices or []],
        "has_place": not action.option_strings,
        "required": action.required,
    }


RUN_OR_STUDY = "folder of a run, or its run.h5; or what soiltest, column, swap, cost or sweep wrote"


def _parser():
    parser = argparse.ArgumentParser(prog="tremolo", description="Pictures of tremolo runs.")
    commands = parser.add_subparsers(required=True)

    def add(name, action, summary):
        command = commands.add_parser(name, help=summary, description=summary)
        command.set_defaults(action=action)
        return command

    def add_picture_options(command):
        command.add_argument("--out", metavar="DIR", help="folder of the pictures (default: pictures/ beside the run)")
        command.add_argument("--time", type=float, nargs="+", metavar="T", help="times of the contour pictures, s")

    single = add("plot", plot, "Model preview, contours of acceleration, shear bands and r_u, histories, energy, wave fronts; or the "
                 "pictures of a study.")
    single.add_argument("run", help=RUN_OR_STUDY)
    add_picture_options(single)
    waited = add("timeline", waits, "What the processes of a run did when, drawn and in words: who waited for whom.")
    waited.add_argument("run", help="folder of the run, or its run.h5")
    waited.add_argument("--out", metavar="DIR", help="folder of the picture (default: pictures/ beside the run)")
    pair = add("compare", compare, "Peaks, histories and spectra of two runs at common monitors, contours at the same times.")
    pair.add_argument("run", help="folder of a run, or its run.h5; or OUT.h5 of `tremolo column`")
    pair.add_argument("other", help="what to set beside it, likewise")
    add_picture_options(pair)
    command = add("report", report, "One HTML file of a run, of several side by side, or of studies: frames that play, charts that zoom.")
    command.add_argument("runs", nargs="+", metavar="RUN", help=RUN_OR_STUDY)
    command.add_argument("--out", metavar="FILE",
                      help="the page (default: report.html beside the run or in the study's folder; of several runs, comparison.html; "
                      "of OUT.h5, OUT.html)")
    live = add("watch", follow, "The report of a run in a browser of this machine while the run goes on, until Ctrl-C.")
    live.add_argument("run", help="folder of the run, or its run.h5")
    live.add_argument("--port", type=_port, default=0, help="of the loopback address (default: a free one)")
    taken = add("extract", extract, "Tables of a run: histories, profiles along lines, spectral ratios, Newmark's displacement.")
    taken.add_argument("run", help="folder of the run, or its run.h5; or what `tremolo column` wrote")
    taken.add_argument("--point", action="append", metavar="POINT",
                       help="whose history is written: the name of a monitor, LINE#NUMBER, or X,Y for the soil that began there, "
                       "through the frames where no history is stored (--point=X,Y where X is negative); may be repeated (default: "
                       "all monitors)")
    taken.add_argument("--base", metavar="POINT",
                       help="a point whose history is stored: displacements are also written relative to it, and spectral ratios over it; its "
                       "motion is that of the rigid block")
    taken.add_argument("--ky", type=float, nargs="+", metavar="K", help="yield coefficients, in parts of gravity: Newmark's "
                       "displacement of each [[sliding_mass]]")
    taken.add_argument("--downslope", choices=["left", "right"], metavar="SIDE",
                       help="left or right, where masses slide to (default: towards the lower surface)")
    taken.add_argument("--plot", action="store_true", help="also pictures of the tables")
    taken.add_argument("--out", metavar="DIR", help="folder of the tables (default: tables/ beside the run)")
    failed = add("failure", failure_times, "When a shear band first connects the toe of a slope with its crest, or two points.")
    failed.add_argument("runs", nargs="+", metavar="RUN", help="folder of a run, or its run.h5")
    failed.add_argument("--strain", type=float, default=0.1, help="equivalent plastic strain of the band (default 0.1)")
    failed.add_argument("--from", type=point, metavar="X,Y", help="one end of the band in the undeformed model, m (default: the monitor 'toe')")
    failed.add_argument("--to", type=point, metavar="X,Y", help="the other end (default: the ground behind the crest)")
    alone = add("column", column_picture, "Picture of a free field alone: OUT.png beside OUT.h5.")
    alone.add_argument("path", help="the file that `tremolo column` wrote")
    compared = add("site", site_response, "Tables, pictures and the report of a site under several models.")
    compared.add_argument("path", help="the folder that `tremolo column --models` wrote")
    tested = add("soiltest", soiltest_picture, "Picture of a soil test: OUT.png beside OUT.h5.")
    tested.add_argument("path", help="the file that `tremolo soiltest` wrote")
    tested.add_argument("--over", metavar="REF.csv", help="a curve to lie below: columns of a history")
    units = list(record.STRESS_UNITS)
    tested.add_argument("--stress-unit", choices=units, default=units[0],
                        help="of the stresses in REF.csv (default kPa); `tremolo soiltest --out X.csv` writes Pa")
    swapped = add("swap", swap_report, "Table and picture of one case under several free-field models.")
    swapped.add_argument("path", help="the folder that `tremolo swap` wrote")
    costly = add("cost-table", cost_report, "Tables and work-precision diagram of a ladder of settings.")
    costly.add_argument("path", help="the folder that `tremolo cost` wrote")
    safe = add("safety-picture", safety_picture, "The soil that fails in a strength reduction.")
    safe.add_argument("path", help="the folder that `tremolo safety` wrote")
    safe.add_argument("--from", type=point, metavar="X,Y", help="one end of the soil that may fail, m")
    safe.add_argument("--to", type=point, metavar="X,Y", help="the other end")
    verified = add("verify-picture", verify_picture, "Picture of a verification: error map and histories.")
    verified.add_argument("path", help="verify.json, or its folder")
    shaken = add("motion-picture", motion_picture, "Picture of a motion, from the tables of `tremolo motion`.")
    shaken.add_argument("folder", help="holds histories.csv, response.csv and fourier.csv, and perhaps target.csv")
    shaken.add_argument("out", help="the picture")
    shaken.add_argument("--title", default="")
    shaken.add_argument("--damping", type=float, default=0.05, help="of the response spectrum")
    taken_down = add("deconvolution-picture", deconvolution_picture,
                     "Picture of a deconvolution, from the tables of `tremolo deconvolve`.")
    taken_down.add_argument("folder", help="holds histories, response and fourier of record and written motion")
    taken_down.add_argument("out", help="the picture")
    taken_down.add_argument("--kind", default="outcrop", help="of the written motion")
    taken_down.add_argument("--lead", type=float, default=0.0, help="by which it begins before the record, s")
    taken_down.add_argument("--cutoff", type=float, required=True, help="Hz")
    taken_down.add_argument("--title", default="")
    swept = add("sweep-runs", sweep_runs, "Makes the runs of a sweep, its table and pictures.")
    swept.add_argument("path", help="the folder that `tremolo sweep` planned")
    swept.add_argument("--tremolo", default="tremolo", help="the program")
    swept.add_argument("--jobs", type=int, help="runs at a time")
    swept.add_argument("--slurm", metavar="OPTIONS", help="options of sbatch")
    swept.add_argument("--ranks", type=int, default=1, help="processes that share the domain of each run")
    one = add("sweep-task", sweep_task, "Makes one run of a sweep: a task of a job array.")
    one.add_argument("path", help="the folder that `tremolo sweep` planned")
    one.add_argument("number", type=int, help="of the run in sweep.json, from 0")
    one.add_argument("--tremolo", default="tremolo", help="the program")
    one.add_argument("--threads", type=int, default=1, help="of the domain, or of each of its ranks")
    one.add_argument("--ranks", type=int, default=1, help="processes that share the domain")
    one.add_argument("--records", help="numbers of the runs that record their exchange, with commas")
    table = add("command-table", command_table, "What each command takes, as JSON.")
    table.add_argument("path", help="the file to write")
    parser.commands = commands.choices
    return parser


def main(arguments=None):
    parsed = _parser().parse_args(arguments)
    try:
        for path in parsed.action(parsed):
            print(path, flush=True)
    except KeyboardInterrupt:
        return 130
    except sweep_command.Interrupted as stopped:
        print(f"tremolo: {stopped}", file=sys.stderr)
        return 130
    except sweep_command.SomeFailed as failed:
        print(f"tremolo: {failed}", file=sys.stderr)
        return 1
    except (OSError, ValueError, KeyError) as error:
        words = error.args[0] if isinstance(error, KeyError) and error.args else error  # str() of a KeyError puts it in quotes
        print(f"tremolo: {words}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
