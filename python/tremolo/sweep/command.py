"""`tremolo sweep` behind its plan: runs what is missing, then writes table and pictures and says what was found."""

import shutil
import signal
import sys

from tremolo.sweep import pictures, pool, slurm, statistics, table, task
from tremolo.sweep.plan import COMPLETE, FAILED, Plan, in_words


class Interrupted(Exception):
    """The sweep was ended before its runs; the runs that have ended stay."""


class SomeFailed(Exception):
    """All is written, and some runs have failed."""


def _interrupt(*_):
    """Once: what follows tidies up."""
    for number in (signal.SIGINT, signal.SIGTERM):
        signal.signal(number, signal.SIG_IGN)
    raise KeyboardInterrupt


def _progress(plan, numbers, all_runs):
    """A line for each run as it ends."""
    for number in numbers:
        run, result = plan.runs[number], plan.runs[number].result()
        if result is None:
            continue
        complete, failed, _ = table.counts(plan)
        said = f"{result['measures']['cpu_s']:.1f} s of CPU" if result["status"] == COMPLETE else f"failed: {result['message']}"
        if result["replayed"] and result["status"] == COMPLETE:
            said += f", free fields of {result['replayed']}"
        yield f"  {complete + failed}/{all_runs}  {run.name}  {plan.setting(run)}: {said}"


def _remeasure(plan):
    """Runs that were measured as an earlier version of the study wanted."""
    for run in plan.runs:
        result = run.result()
        if result and result["status"] == COMPLETE and result["settings"] != plan.settings:
            task.measure(run, plan.settings, result["replayed"])


def _drop_recordings(plan):
    """Those that were made for other runs of the sweep, when these have ended well."""
    if not plan.keeps_recordings:
        unfinished = {run.free_fields for run in plan.runs if run.status() != COMPLETE}
        for run in plan.runs:
            if run.free_fields not in unfinished:
                run.drop_recording()


def found_text(sweep):
    """What was found, in lines: medians of the responses, and the colours against the first."""
    for name in statistics.responses(sweep, most=3):
        what = pictures.label(name, sweep.columns[name].unit).replace("$", "")
        for group in sweep.groups():
            count, median, low, high = sweep.spread(name, group)
            setting = [*([(sweep.colour_key, group.colour)] if sweep.colour_key else []), *group.rest]
            at = ", ".join(f"{key} = {in_words(value)}" for key, value in setting) or "all runs"
            spread = f" ({low:.4g} to {high:.4g})" if count > 1 else ""
            value = f"median {median:.4g}{spread}" if count else "none"
            yield f"  {what}; {at}: {value}, {count} of {len(group.runs)} runs"
        if sweep.colour_key and name == "failure_time_s":
            for pair in statistics.compared(sweep, name):
                yield (f"  {sweep.colour_key} = {in_words(pair.colour)} against {in_words(sweep.colours[0])}: fails earlier in {pair.smaller} "
                       f"of {pair.pairs}, later in {pair.larger}, alike in {pair.alike}")


def carry_out(folder, tremolo, jobs=None, options=None, ranks=1):
    """Yields what is said while the runs of the sweep in a folder are made, and the paths of what is written.

    jobs: runs at a time; options: of sbatch, where Slurm makes the runs; ranks: that share the domain of each.
    Raises Interrupted, and SomeFailed at the end.
    """
    for number in (signal.SIGINT, signal.SIGTERM):
        signal.signal(number, _interrupt)
    plan = Plan(folder)
    for run in plan.runs:
        if run.status() == FAILED:
            run.forget()  # another try
    pending = plan.pending()
    done = len(plan.runs) - len(pending)
    yield f"{plan.title}: {len(plan.runs)} runs" + (f", {done} of them done" if done else "")
    try:
        if options is not None:
            arrays = slurm.Arrays(plan, options, tremolo, jobs, ranks)
            if arrays.going():
                yield f"  jobs of an earlier command go on: {', '.join(arrays.jobs)}"
            elif pending:
                arrays.submit(pending)
                yield f"  submitted to Slurm: {', '.join(arrays.jobs)}"
            if arrays.jobs:
                yield from _progress(plan, arrays.watch(), len(plan.runs))
        elif pending:
            yield from _progress(plan, pool.carry_out(plan, pending, tremolo, jobs, ranks), len(plan.runs))
    except KeyboardInterrupt:
        again = "the same command goes on from here"
        if options is not None and arrays.jobs:
            again = f"the jobs of Slurm go on, and the same command watches them; scancel {' '.join(arrays.jobs)} ends them"
        raise Interrupted(f"interrupted: {again}") from None
    _remeasure(plan)
    _drop_recordings(plan)
    sweep = statistics.Sweep(plan)
    yield from table.write(plan)
    if statistics.responses(sweep):
        yield from pictures.write(sweep)
        yield from found_text(sweep)
    _, failed, _ = table.counts(plan)
    if failed:
        raise SomeFailed(f"{failed} of {len(plan.runs)} runs failed; the table says why, {plan.folder / 'log'} holds what they "
                         "printed, and the same command tries them again")


def find_program(name):
    """The program by its name or path. Raises ValueError where it is not there."""
    found = shutil.which(name)
    if found is None:
        raise ValueError(f"{name}: no such program")
    return found


def one_task(folder, number, tremolo, threads, records, ranks=1):
    """A task of a job array."""
    plan = Plan(folder)
    if not 0 <= number < len(plan.runs):
        raise ValueError(f"{folder}: has no run number {number}")
    work = task.Task(plan, number, find_program(tremolo), threads, records, ranks)
    signal.signal(signal.SIGTERM, lambda *_: work.stop())  # requeued or cancelled: leaves no result
    work.carry_out()
    status = plan.runs[number].status()
    print(f"{plan.runs[number].name}: {status}", file=sys.stderr)
    return status
