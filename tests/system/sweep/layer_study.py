"""A study of a linear layer on rock whose speed is random, and what `tremolo sweep` made of it."""

import csv
import subprocess
import tempfile
from pathlib import Path

ROCK, RHO, VS, DEPTH, DAMPING = 2000.0 * 400.0, 1800.0, 200.0, 20.0, 0.05
SIGMA, COUNT = 0.2, 16

CASE = f"""title = "one layer on rock"
[motion]
pulse = {{ shape = "ricker", frequency = 3.0, time = 1.0, velocity = 1e-3 }}
wave = "SV"
angle_deg = 0.0
reference = [0.0, -20.0]
[surface]
level = 0.0
[halfspace]
density = 2000.0
vs = 400.0
vp = 800.0
[[profile]]
thickness = {DEPTH}
density = {RHO}
vs = {VS}
vp = 400.0
[damping]
model = "hysteretic"
ratio = {DAMPING}
reference_hz = 3.0
"""

# The whole layer has one factor.
STUDY = f"""case = "case.toml"
[column]
models = ["wave"]
[axes]
random_profile.realisation = {{ count = {COUNT} }}
random_profile.site_class = ["usgs_c"]
random_profile.sigma_ln = [{SIGMA}]
random_profile.layer_thickness = [100]
"""


class Workspace:
    """A temporary folder with the case and a study of it."""

    def __init__(self, tremolo, study=STUDY, case=CASE):
        self.tremolo = tremolo
        self._place = tempfile.TemporaryDirectory()
        self.path = Path(self._place.name)
        self.out, self.study, self.case = self.path / "out", self.path / "study.toml", self.path / "case.toml"
        self.study.write_text(study)
        self.case.write_text(case)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self._place.cleanup()

    def sweep(self, *words):
        return subprocess.run([self.tremolo, "sweep", self.study, "--out", self.out, *words], capture_output=True, text=True, timeout=240,
                              cwd=self.path)

    def rows(self):
        with open(self.out / "sweep.csv", newline="", encoding="utf-8") as stream:
            return list(csv.DictReader(stream))

    def made(self):
        return {path.parent.name: path.stat().st_mtime_ns for path in (self.out / "runs").glob("*/*.h5")}
