"""A box small enough to run in a second, and the `tremolo` command on it."""

import subprocess
import tempfile
from pathlib import Path

CASE = """
title = "small box"

[motion]
pulse = {{ shape = "ricker", frequency = 3.0, time = 0.5, velocity = 0.1 }}
wave = "SV"
angle_deg = {angle}
reference = [0.0, -10.0]

[surface]
level = 0.0

[halfspace]
density = 1700.0
young = 40e6
poisson = 0.28

[soil.box]
model = "linear_elastic"
density = 1700.0
young = 40e6
poisson = 0.28

[[region]]
soil = "box"
polygon = [[0.0, -10.0], [20.0, -10.0], [20.0, 0.0], [0.0, 0.0]]

[mesh]
size = {size}
box = [0.0, -10.0, 20.0, 0.0]

[column]
element_size = {element}

[boundary]
left = {{ model = "{side}" }}
right = {{ model = "{side}" }}
base = {{ model = "{side}", form = "{base}" }}

[time]
order = "{order}"

[[stage]]
kind = "shaking"
duration_s = {duration}

[[monitor]]
name = "surface"
point = [10.0, 0.0]

[output]
every_s = {every}
history_every_s = 0.005

[verify]
tolerance = {tolerance}
"""

DEFAULTS = {"angle": 15.0, "size": 1.0, "side": "wave", "base": "total", "duration": 1.0, "every": 0.05, "element": 0.25, "order": "musl",
            "tolerance": 0.03}


class Workspace:
    """A temporary folder with a case in it."""

    def __init__(self, tremolo, **changes):
        self._folder = tempfile.TemporaryDirectory(prefix="tremolo_test_")
        self.tremolo = tremolo
        self.path = Path(self._folder.name)
        self.case = self.path / "case.toml"
        self.case.write_text(CASE.format(**{**DEFAULTS, **changes}))

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self._folder.cleanup()

    def command(self, *arguments):
        """Runs `tremolo ARGUMENTS` to its end."""
        return subprocess.run([self.tremolo, *map(str, arguments)], cwd=self.path, capture_output=True, text=True,
                              timeout=120)

    def run(self, name, *arguments):
        """Runs the case into the folder `name` and returns that folder; fails the test with the output if it fails."""
        result = self.command("run", self.case, "--out", self.path / name, *arguments)
        assert result.returncode == 0, result.stdout + result.stderr
        return self.path / name
