"""A study of a box whose runs take a tenth of a second, and what `tremolo sweep` made of it."""

import csv
import os
import subprocess
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1] / "runs"))

import small_case

CASE = {"size": 2.0, "duration": 0.6, "every": 0.2}

# Two angles have two free fields; three soils have none of their own.
STUDY = """
case = "case.toml"

[axes]
motion.angle_deg = [0, 15]
soil.box.young = [40e6, 60e6, 80e6]
"""


class SweepWorkspace(small_case.Workspace):
    """A temporary folder with the case and a study of it."""

    def __init__(self, tremolo, study=STUDY, **changes):
        super().__init__(tremolo, **{**CASE, **changes})
        self.study = self.path / "study.toml"
        self.study.write_text(study)
        self.out = self.path / "out"
        self.environment = None

    def command_line(self, *arguments):
        return [self.tremolo, "sweep", str(self.study), "--out", str(self.out), *map(str, arguments)]

    def sweep(self, *arguments):
        """Runs `tremolo sweep` to its end."""
        return subprocess.run(self.command_line(*arguments), cwd=self.path, capture_output=True, text=True, timeout=240,
                              env=self.environment)

    def swept(self, *arguments):
        """What it says; fails the test where it fails."""
        done = self.sweep(*arguments)
        assert done.returncode == 0, done.stdout + done.stderr
        return done.stdout

    def start(self, *arguments):
        """The command in a session of its own, as a shell starts it, while it goes on."""
        return subprocess.Popen(self.command_line(*arguments), cwd=self.path, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                                start_new_session=True, env=self.environment)

    def rows(self):
        with open(self.out / "sweep.csv", newline="", encoding="utf-8") as stream:
            return list(csv.DictReader(stream))

    def made(self):
        """When each run file was made: a run that is made again has another time."""
        return {path.parent.name: path.stat().st_mtime_ns for path in (self.out / "runs").glob("*/run.h5")}


def processes_of_session(session):
    """Those that still live."""
    found = []
    for path in Path("/proc").glob("[0-9]*/stat"):
        try:
            state, _, _, its_session = path.read_text().rpartition(")")[2].split()[:4]
        except OSError:
            continue
        if int(its_session) == session and state != "Z":
            found.append(path.parent.name)
    return found


def alive(session):
    """Processes of a session besides this one."""
    return [pid for pid in processes_of_session(session) if int(pid) != os.getpid()]
