"""A box small enough to run in a second, and the `tremolo` command on it."""

import subprocess
import tempfile
from pathlib import Path

GROUND = """
[surface]
level = 0.0

[halfspace]
density = 1700.0
young = 40e6
poisson = 0.28
"""

# Six metres of sand on rock.
SAND_ON_ROCK = """
[surface]
level = 0.0

[halfspace]
density = 2200.0
vs = 760.0
vp = 1900.0

[[profile]]
thickness = 6.0
soil = "sand"
"""

CASE = """
title = "small box"

[motion]
pulse = {{ shape = "ricker", frequency = 3.0, time = 0.5, velocity = 0.1 }}
wave = "SV"
angle_deg = {angle}
reference = [0.0, -10.0]
""" + GROUND + """
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

[fe]
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

    template, defaults = CASE, DEFAULTS

    def __init__(self, tremolo, **changes):
        self._folder = tempfile.TemporaryDirectory(prefix="tremolo_test_")
        self.tremolo = tremolo
        self.path = Path(self._folder.name)
        self.case = self.path / "case.toml"
        self.case.write_text(self.template.format(**{**self.defaults, **changes}))

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


class PeriodicWorkspace(Workspace):
    """The box without free fields at its sides, which are what `sides` says."""

    template = CASE.replace("""left = {{ model = "{side}" }}
right = {{ model = "{side}" }}""", 'sides = "{sides}"')
    defaults = {**DEFAULTS, "angle": 0.0, "sides": "periodic"}


def add_inclusion(work, x):
    """Soft soil of 4 m by 4 m at the surface of the small box, its left end at x, and the monitor 5 m right of it."""
    polygons = (f"[[{x}, -4.0], [{x + 4}, -4.0], [{x + 4}, 0.0], [{x}, 0.0]]",
                f"[[0.0, -10.0], [20.0, -10.0], [20.0, 0.0], [{x + 4}, 0.0], [{x + 4}, -4.0], [{x}, -4.0], [{x}, 0.0], [0.0, 0.0]]")
    text = work.case.read_text()
    text = text.replace("[[0.0, -10.0], [20.0, -10.0], [20.0, 0.0], [0.0, 0.0]]", polygons[1])
    text = text.replace("point = [10.0, 0.0]", f"point = [{x + 5.25}, -0.25]")
    soft = '[soil.soft]\nmodel = "linear_elastic"\ndensity = 1700.0\nyoung = 10e6\npoisson = 0.28\n'
    work.case.write_text(f'{text}\n{soft}\n[[region]]\nsoil = "soft"\npolygon = {polygons[0]}\n')
    return work


SLOPE = """
title = "small slope"

[motion]
pulse = {{ shape = "ricker", frequency = 2.0, time = 0.7, velocity = {velocity} }}
wave = "SV"
angle_deg = 15.0
reference = [0.0, -6.0]
""" + GROUND + """
[soil.slope]
model = "mohr_coulomb"
density = 1700.0
young = 40e6
poisson = 0.28
cohesion_peak = 4e3
cohesion_residual = 0.0
friction_peak_deg = 45.0
friction_residual_deg = 28.0
softening = 15.0
reference_size = 1.0

[[region]]
soil = "slope"
polygon = [[0.0, -6.0], [40.0, -6.0], [40.0, 8.0], [20.0, 8.0], [12.0, 0.0], [0.0, 0.0]]

[mesh]
size = 1.0
box = [0.0, -6.0, 40.0, 8.0]

[boundary]
left = {{ model = "wave", surface = 0.0 }}
right = {{ model = "wave", surface = 8.0 }}
base = {{ model = "wave", form = "incident" }}

[[stage]]
kind = "gravity"

[[stage]]
kind = "shaking"
duration_s = {duration}

[[monitor]]
name = "toe"
point = [12.0, 0.0]

[output]
every_s = 0.1
history_every_s = 0.01
"""


class SlopeWorkspace(Workspace):
    """An 8 m slope with all that the oblique slope has: gravity, softening, two wave fields, incident base."""

    template, defaults = SLOPE, {"velocity": 0.5, "duration": 1.5}


def refine(work, *boxes):
    """Adds [[refine]] to the case of a workspace: a box and its level each."""
    lines = "".join(f"\n[[refine]]\nbox = {list(box)}\nlevel = {level}\n" for box, level in boxes)
    work.case.write_text(work.case.read_text() + lines)
    return work


def subcycled(work):
    """Adds the key to the case of a workspace, which has a [time] or not."""
    text = work.case.read_text()
    key = "subcycle = true\n"
    work.case.write_text(text.replace("[time]\n", "[time]\n" + key) if "[time]\n" in text else f"{text}\n[time]\n{key}")
    return work


# Around face and toe of the small slope, and a finest box that soil moves into when the wave is strong.
SLOPE_BOXES = (([6.0, -3.0, 22.0, 8.0], 1), ([9.0, -1.0, 11.8, 2.0], 2))
