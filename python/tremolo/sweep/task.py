"""One run of a sweep: a process `tremolo run` or `tremolo column`, then what is measured of it. The pool and the tasks of Slurm both
end here."""

import shutil
import subprocess

from tremolo.run import Run
from tremolo.site import suite
from tremolo.site.read import Model
from tremolo.sweep import measures
from tremolo.sweep.plan import COMPLETE, FAILED

LONGEST_MESSAGE = 400  # characters


def _why(log):
    """Why a run ended, from what it printed: its first line `tremolo: ...` that is no warning, with what is indented below; or the
    last line."""
    lines = [line.rstrip() for line in log.read_text(encoding="utf-8", errors="replace").splitlines() if line.strip()]
    begins = (number for number, line in enumerate(lines) if line.startswith("tremolo: ") and not line.startswith("tremolo: warning"))
    first = next(begins, max(len(lines) - 1, 0))
    end = next((number for number in range(first + 1, len(lines)) if not lines[number].startswith(" ")), len(lines))
    text = " ".join(line.strip() for line in lines[first:end])
    return text.removeprefix("tremolo: ")[:LONGEST_MESSAGE] or "it printed nothing"


class Task:
    """Carries out one run. tremolo: the program; threads: of the domain or of each of its ranks; records: whether others wait for its
    free fields."""

    def __init__(self, plan, number, tremolo, threads=1, records=False, ranks=1):
        self._plan, self._run, self._number = plan, plan.runs[number], number
        self._tremolo, self._threads, self._records, self._ranks = tremolo, threads, records, ranks
        self._process = None
        self._stopped = False

    def carry_out(self):
        """Writes the result, complete or failed; none where it was stopped."""
        run = self._run
        run.forget()
        shutil.rmtree(run.folder, ignore_errors=True)  # of a run that did not end
        source = next((other for other in self._plan.alike(self._number) if other.recording()), None)
        command = self._site_response() if run.model else self._domain(source)
        run.log.parent.mkdir(parents=True, exist_ok=True)
        with open(run.log, "w", encoding="utf-8") as log:
            if self._stopped:
                return
            self._process = subprocess.Popen(command, stdout=log, stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL)
            status = self._process.wait()
        if self._stopped:
            return
        replayed = source.name if source is not None else None
        if status != 0:
            run.write_result(status=FAILED, message=_why(run.log), replayed=replayed, settings=None, measures={})
        else:
            measure(run, self._plan.settings, replayed)

    def _domain(self, source):
        run = self._run
        command = [self._tremolo, "run", run.recorded_case if self._records else run.case, "--out", run.folder, "--local",
                   "--threads", str(self._threads), "--ranks", str(self._ranks)]
        return command + (["--replay", source.folder] if source is not None else [])

    def _site_response(self):
        run = self._run
        run.folder.mkdir(parents=True)
        return [self._tremolo, "column", run.case, "--model", run.model, "--out", run.column]

    def stop(self):
        """Ends the run as Ctrl-C does; carry_out() returns soon."""
        self._stopped = True
        if self._process is not None and self._process.poll() is None:
            self._process.terminate()


def measure(run, settings, replayed):
    """Measures a run that has ended well, and writes its result."""
    try:
        if run.model:
            with Run(run.column) as results:
                found = suite.measured(Model(run.model, results))
        else:
            with Run(run.folder) as results:
                found = measures.measured(results, settings)
    except (OSError, ValueError, KeyError) as error:
        run.write_result(status=FAILED, message=f"it ended well and cannot be measured: {error}", replayed=replayed, settings=None,
                         measures={})
        return
    run.write_result(status=COMPLETE, message="", replayed=replayed, settings=settings, measures=found)
