"""The shipped pit, smaller and with softer walls: the strut has its prestress when it stands, and bears more when the pit is dug deeper.

    usage: test_propped_pit.py TREMOLO SOURCE_DIR
"""

import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

TREMOLO, SOURCE = sys.argv.pop(1), Path(sys.argv.pop(1))
CASE = SOURCE / "cases" / "propped_pit"
sys.path[:0] = [str(SOURCE / "python"), str(CASE)]

import numpy as np
from study import PROP, STAGE, stage
from tremolo import Run
from tremolo.variants import variant

# A smaller model, walls that do not set the step, and a glimpse of the shaking: a sketch of the case.
SKETCH = (("-18.0", "-14.0"), ("thickness = 18.0", "thickness = 14.0"), ("-30.0", "-18.0"), ("30.0", "22.0"), ("young = 6.5e9\n", "young = 2.8e8\n"),
          ("kind = \"construction\"\n", "kind = \"construction\"\nresidual = 1e-5\n"), ("duration_s = 4.0\n", "duration_s = 0.05\n"))


def sketch(folder, name, changes):
    text = variant(CASE / "case.toml", changes)
    for old, new in SKETCH:
        text = text.replace(old, new)
    case = Path(folder) / f"{name}.toml"
    case.write_text(text)
    done = subprocess.run([TREMOLO, "run", case, "--out", Path(folder) / name], capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr
    return Run(Path(folder) / name)


class ProppedPit(unittest.TestCase):
    def test_its_strut_has_its_prestress_and_then_bears_what_is_dug_away(self):
        with tempfile.TemporaryDirectory(prefix="tremolo_test_") as folder, sketch(folder, "propped", {}) as run:
            np.testing.assert_allclose(stage(run, "strut").prop("strut").force, [-50e3])
            dug = stage(run, "dig to 6 m").prop("strut").force[-1]
            self.assertLess(dug, -60e3)
            self.assertAlmostEqual(dug, run.prop("strut").force[0], delta=1e3)


class AcceptanceProppedPit(unittest.TestCase):
    def test_its_walls_bend_more_without_a_strut(self):
        with tempfile.TemporaryDirectory(prefix="tremolo_test_") as folder, sketch(folder, "propped", {}) as propped, \
                sketch(folder, "cantilever", {PROP: "", STAGE: ""}) as cantilever:
            # The strut takes back what soil bends the walls outwards at the level of the cut.
            for name in ("west", "east"):
                self.assertLess(propped.section(name)["m"][0], cantilever.section(name)["m"][0] - 20e3)


if __name__ == "__main__":
    unittest.main()
