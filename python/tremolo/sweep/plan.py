"""The plan of a sweep, as `tremolo sweep` wrote it into its folder, and what has come of its runs.

    sweep.json           the plan: axes, what is measured, and of each run its values and what it reads
    cases/NNNN.toml      the case of a run; NNNN.recorded.toml also records its exchange
    runs/NNNN/           the run; of a site response MODEL.h5 alone
    log/NNNN.txt         what the run printed
    results/NNNN.json    what came of it: status, message, measures
"""

import json
import os
from collections import Counter
from pathlib import Path

import h5py

FILE = "sweep.json"
COMPLETE, FAILED, MISSING = "complete", "failed", "missing"


class PlannedRun:
    """One run: `name`, its `values` in the order of the axes, `motion`, the measures of its incident wave (may be None), and `model`
    of a site response (None: a domain runs)."""

    def __init__(self, entry, folder):
        self.name, self.values, self.motion, self.model = entry["name"], entry["values"], entry["motion"], entry.get("model")
        self.inputs = entry["inputs"]  # files and their checksums
        self.free_fields = entry["free_fields"]  # number that runs with the same free fields share; None: it shares them with none
        self.case = folder / "cases" / f"{self.name}.toml"
        self.recorded_case = folder / "cases" / f"{self.name}.recorded.toml"
        self.folder = folder / "runs" / self.name
        self.column = self.folder / f"{self.model}.h5"  # of a site response
        self.log = folder / "log" / f"{self.name}.txt"
        self._result = folder / "results" / f"{self.name}.json"

    def result(self):
        """What came of it as a dictionary; None where it has not ended, or was another run: of the same case with other files."""
        try:
            found = json.loads(self._result.read_text(encoding="utf-8"))
        except (FileNotFoundError, json.JSONDecodeError):
            return None
        return found if found.get("inputs") == self.inputs else None

    def status(self):
        found = self.result()
        return found["status"] if found else MISSING

    def write_result(self, **content):
        """All of it or nothing: who reads meanwhile finds the old result or the new one."""
        self._result.parent.mkdir(parents=True, exist_ok=True)
        scratch = self._result.with_suffix(f".{os.getpid()}")
        scratch.write_text(json.dumps({"inputs": self.inputs, **content}, indent=1), encoding="utf-8")
        scratch.replace(self._result)

    def forget(self):
        self._result.unlink(missing_ok=True)

    def recording(self):
        """Whether the folder holds the whole exchange, for others to replay."""
        path = self.folder / "exchange.h5"
        if self.status() != COMPLETE or not path.exists():
            return False
        try:
            with h5py.File(path, "r") as file:
                status = file.attrs.get("status", b"")
        except OSError:
            return False
        return (status.decode() if isinstance(status, bytes) else status) == "complete"

    def drop_recording(self):
        (self.folder / "exchange.h5").unlink(missing_ok=True)


class Plan:
    """A sweep: `title`, `keys` of its axes, `units` by key, `settings` of its measures, `runs`."""

    def __init__(self, folder):
        self.folder = Path(folder)
        content = json.loads((self.folder / FILE).read_text(encoding="utf-8"))
        self.title, self.study, self.case = content["title"], content["study"], content["case"]
        self.keys = [axis["key"] for axis in content["axes"]]
        self.units = {axis["key"]: axis["unit"] for axis in content["axes"]}
        self.settings = content["measures"]
        self.keeps_recordings = content["keeps_recordings"]
        self.runs = [PlannedRun(entry, self.folder) for entry in content["runs"]]
        self.has_site_responses = any(run.model for run in self.runs)

    def pending(self):
        """Numbers of the runs that have not ended well."""
        return [number for number, run in enumerate(self.runs) if run.status() != COMPLETE]

    def alike(self, number):
        """The other runs with the same free fields."""
        run = self.runs[number]
        return [other for other in self.runs if run.free_fields is not None and other is not run and other.free_fields == run.free_fields]

    def varied(self):
        """Keys that have more than one value."""
        return [key for i, key in enumerate(self.keys) if len({json.dumps(run.values[i]) for run in self.runs}) > 1]

    def setting(self, run):
        """"motion.angle_deg = 15, motion.file = a" of a run: what is varied."""
        varied = self.varied()
        return ", ".join(f"{key} = {in_words(value)}" for key, value in zip(self.keys, run.values) if key in varied)


def in_words(value):
    """A value in words."""
    return f"{value:.6g}" if isinstance(value, float) else value if isinstance(value, str) else json.dumps(value)


class Order:
    """Which runs go first: those that others wait for, since they record the free fields that these replay.

    pending: numbers of runs. first: carried out at once; records: those of them that record; then: by the number of the one that
    records, those that follow it.
    """

    def __init__(self, plan, pending):
        self.first, self.records, self.then = [], [], {}
        recorded = {run.free_fields for run in plan.runs if run.free_fields is not None and run.recording()}
        waiting = Counter(plan.runs[number].free_fields for number in pending)
        leader = {}
        for number in pending:
            group = plan.runs[number].free_fields
            if group is None or group in recorded or waiting[group] == 1:
                self.first.append(number)
            elif group in leader:
                self.then[leader[group]].append(number)
            else:
                leader[group] = number
                self.then[number] = []
                self.records.append(number)
        self.first = self.records + self.first

    @property
    def followers(self):
        return [number for numbers in self.then.values() for number in numbers]
