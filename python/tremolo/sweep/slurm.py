"""The runs of a sweep as job arrays of Slurm.

Runs that record what others replay are a first array with those that nobody waits for; the others are a second one that begins
when the first has ended (`--dependency=afterany`). A task that Slurm requeues makes its run anew. The numbers of the jobs lie in
slurm.json, so that a command that was interrupted watches the same jobs again.
"""

import json
import shlex
import subprocess
import sys
import time

from tremolo.sweep.plan import FAILED, MISSING, Order

# States of a task that may still compute; all others are ends.
GOING = {"PENDING", "RUNNING", "CONFIGURING", "COMPLETING", "SUSPENDED", "REQUEUED", "REQUEUE_HOLD", "REQUEUE_FED", "RESIZING",
         "SIGNALING", "STAGE_OUT", "STOPPED", "SPECIAL_EXIT"}
FIRST_PAUSE, LONGEST_PAUSE = 0.5, 10.0  # s between two looks at the queue
LATE = 10.0  # s that a result may take to be seen through a shared file system
GONE = "Invalid job id"

SCRIPT = """#!/bin/bash
# A run of {folder}: task N is run N of its sweep.json.
export PYTHONPATH={path}
exec {python} -m tremolo sweep-task {folder} "$SLURM_ARRAY_TASK_ID" --tremolo {tremolo} --threads "${{SLURM_CPUS_PER_TASK:-1}}" --ranks {ranks}{records}
"""


def _end(state, reason):
    """In words; a task that is cancelled before it starts is not in the queue any more."""
    if state in GOING:
        return f"left the queue, where it was last {state}, as cancelled tasks do,"
    return f"ended as {state}" + (f" ({reason})" if reason not in ("None", "") else "")


def _asked(command):
    """What a command of Slurm answers."""
    try:
        return subprocess.run(command, capture_output=True, text=True)
    except OSError as error:
        raise OSError(f"--slurm: {command[0]} cannot be started ({error.strerror}): the commands of Slurm must be on the PATH; without "
                      "--slurm the runs are made on this machine") from error


def _words(options):
    """The options of sbatch one by one."""
    try:
        return shlex.split(options)
    except ValueError as error:
        raise ValueError(f"--slurm {options}: {error}") from error


class Arrays:
    """Two job arrays at most; submits them, or finds those that an earlier command submitted."""

    def __init__(self, plan, options, tremolo, jobs=None, ranks=1):
        self._plan, self._options, self._tremolo, self._jobs, self._ranks = plan, _words(options), tremolo, jobs, ranks
        self._file = plan.folder / "slurm.json"
        self.states = {}  # "12_3" -> (state, reason) as last seen

    @property
    def jobs(self):
        """Numbers of the jobs -> numbers of their runs."""
        return json.loads(self._file.read_text(encoding="utf-8")) if self._file.exists() else {}

    def submit(self, pending):
        order = Order(self._plan, pending)
        first = self._submit("first", order.first, order.records, [])
        jobs = {first: order.first}
        if order.followers:
            jobs[self._submit("second", order.followers, [], [f"--dependency=afterany:{first}"])] = order.followers
        self._file.write_text(json.dumps(jobs), encoding="utf-8")

    def _submit(self, name, numbers, records, more):
        folder = self._plan.folder.resolve()
        log = folder / "log"
        log.mkdir(parents=True, exist_ok=True)
        script = folder / "cases" / f"slurm_{name}.sh"
        option = f" --records {','.join(map(str, records))}" if records else ""
        script.write_text(SCRIPT.format(folder=shlex.quote(str(folder)), python=shlex.quote(sys.executable),
                                        path=shlex.quote(":".join(filter(None, sys.path))), tremolo=shlex.quote(str(self._tremolo)),
                                        ranks=self._ranks, records=option), encoding="utf-8")
        at_a_time = f"%{self._jobs}" if self._jobs else ""
        # The ranks of a run share one machine, each as a task of the job.
        ranks = ["--nodes=1", f"--ntasks={self._ranks}"] if self._ranks > 1 else []
        command = ["sbatch", "--parsable", "--requeue", "--job-name=tremolo-sweep", f"--output={log}/slurm_%A_%a.txt", *ranks, *self._options,
                   *more, f"--array={','.join(map(str, numbers))}{at_a_time}", str(script)]
        done = _asked(command)
        if done.returncode != 0:
            raise ValueError(f"sbatch: {done.stderr.strip() or done.stdout.strip()}")
        return done.stdout.strip().split(";")[0]

    def _look(self):
        """Takes up the states of all tasks; returns whether one may still compute. None: the queue cannot be seen."""
        jobs = self.jobs
        done = _asked(["squeue", "--noheader", "--array", "--states=all", f"--jobs={','.join(jobs)}", "--format=%i|%T|%r"])
        if done.returncode != 0 and GONE not in done.stderr:
            return None
        seen = {}
        for line in done.stdout.splitlines():
            task, state, reason = line.strip().split("|", 2)
            seen[task] = state, reason
        self.states |= seen
        return any(state in GOING for state, _ in seen.values())

    def going(self):
        """Whether jobs of an earlier command may still compute."""
        return bool(self.jobs) and self._look() is not False

    def watch(self):
        """Yields the number of each run as its result appears, until all jobs have ended."""
        waited = {number for numbers in self.jobs.values() for number in numbers}
        pause, blind = FIRST_PAUSE, False
        while True:
            going = self._look()
            if going is None and not blind:
                print("  the queue of Slurm cannot be seen; the jobs may go on, and so does this command", file=sys.stderr, flush=True)
            blind = going is None
            for number in sorted(waited):
                if self._plan.runs[number].status() != MISSING:
                    waited.discard(number)
                    pause = FIRST_PAUSE
                    yield number
            if going is False or not waited:
                break
            time.sleep(pause)
            pause = min(1.3 * pause, LONGEST_PAUSE)
        yield from self._late(waited)
        self._file.unlink()

    def _late(self, waited):
        """Results that are seen after the end of their jobs; a task that left none has failed."""
        task_of = {number: f"{job}_{number}" for job, numbers in self.jobs.items() for number in numbers}
        end = time.monotonic() + LATE
        while waited:
            for number in sorted(waited):
                state, reason = self.states.get(task_of[number], ("PENDING", ""))
                run = self._plan.runs[number]
                ended = state not in GOING and state != "COMPLETED"
                if run.status() == MISSING and (ended or time.monotonic() > end):
                    run.write_result(status=FAILED, message=f"Slurm: task {task_of[number]} {_end(state, reason)} and left no result",
                                     replayed=None, settings=None, measures={})
                if run.status() != MISSING:
                    waited.discard(number)
                    yield number
            time.sleep(FIRST_PAUSE)
