"""The free field `mpm`: a periodic column of the domain's own cells, as a process of the run.

    usage: test_own_cells.py TREMOLO PYTHON_PACKAGE_DIR MY_FIELD
"""

import sys
import unittest

TREMOLO, PACKAGE, _ = sys.argv.pop(1), sys.argv.pop(1), sys.argv.pop(1)
sys.path.insert(0, PACKAGE)

import numpy as np
from free_field_cases import LAYERED, STIFF, BoxWorkspace, model, unevenness, with_frames
from tremolo import Run

EVERYWHERE = {"left": model("mpm"), "right": model("mpm"), "base": model("mpm")}


def difference(run, reference):
    """Of all monitors, relative L2."""
    velocities = [np.concatenate([r.monitor(name)[c] for name in r.monitors for c in ("vx", "vy")]) for r in (run, reference)]
    return np.linalg.norm(velocities[0] - velocities[1]) / np.linalg.norm(velocities[1])


class OwnCells(unittest.TestCase):
    def test_a_flat_domain_does_what_its_free_field_does(self):
        """Measured: 6e-4 of the largest velocity; the sides tilt with the soil by that much. With the exact wave as free
        field, which the grid's own waves lag behind, 3e-3."""
        with BoxWorkspace(TREMOLO, **EVERYWHERE) as work:
            run = Run(with_frames(work).run("own"))
            self.assertEqual("complete", run.status)
            self.assertLess(unevenness(run), 1e-3)

    def test_agrees_with_the_exact_wave(self):
        """Measured: 0.12 % with either form of the base."""
        with BoxWorkspace(TREMOLO) as work:
            wave_text = work.case.read_text()
            wave = Run(work.run("wave"))
            for form in ("total", "incident"):
                work.case.write_text(wave_text.replace('base = { model = "wave" }', f'base = {{ {model("mpm", form=form)} }}')
                                     .replace('model = "wave"', 'model = "mpm"'))
                own = Run(work.run(form))
                self.assertLess(difference(own, wave), 0.003, form)

    def test_layers_and_a_stiffer_half_space_below_the_model(self):
        """The column reaches through the layers to the half-space, 2 m below the base of the model. Measured: 0.2 %."""
        with BoxWorkspace(TREMOLO, ground=LAYERED, halfspace=STIFF, reference=-14.0, duration=1.5) as work:
            text = work.case.read_text()
            wave = Run(work.run("wave"))
            work.case.write_text(text.replace('model = "wave"', 'model = "mpm"'))
            own = Run(work.run("own"))
            self.assertLess(difference(own, wave), 0.005)

    def test_sand_that_follows_its_pressure_has_a_free_field(self):
        """PM4Sand under gravity: the free field, and with it the domain, feels the sand yield and stays even. Measured: 0.2 %."""
        sand = BOX_OF_SAND
        with BoxWorkspace(TREMOLO, ground=sand, duration=1.0, **EVERYWHERE) as work:
            text = with_frames(work).case.read_text()
            work.case.write_text(text.replace("[[stage]]\nkind = \"shaking\"", "[[stage]]\nkind = \"gravity\"\n\n[[stage]]\nkind = \"shaking\""))
            run = Run(work.run("sand"))
            self.assertEqual("complete", run.status)
            self.assertGreater(abs(run.monitor("surface")["vx"]).max(), 0.05)
            self.assertLess(unevenness(run), 0.005)


BOX_OF_SAND = """
[[profile]]
thickness = 10.0
soil = "sand"

[soil.sand]
model = "pm4sand"
density = 1700.0
relative_density = 0.55
shear_modulus_coefficient = 677.0
contraction_rate = 0.4

[[region]]
soil = "sand"
polygon = [[0.0, -10.0], [20.0, -10.0], [20.0, 0.0], [0.0, 0.0]]
"""


if __name__ == "__main__":
    unittest.main(verbosity=2)
