"""Wet sand with a berm that stages place and remove."""

from rest_case import RestWorkspace

FILL = """
[soil.fill]
model = "linear_elastic"
density = 1900.0
young = 20e6
poisson = 0.3
"""
BERM = """
[[region]]
name = "berm"
soil = "fill"
polygon = [[2.0, 0.0], [6.0, 0.0], [6.0, 1.0], [2.0, 1.0]]
"""
WIDER = {"level = 0.0\n\n[soil.sand]": "level = 0.0\nbulk_modulus = 2.2e8\n\n[soil.sand]",
         "[[0.0, -6.0], [2.0, -6.0], [2.0, 0.0], [0.0, 0.0]]": "[[0.0, -6.0], [8.0, -6.0], [8.0, 0.0], [0.0, 0.0]]",
         "box = [0.0, -6.0, 2.0, 0.0]": "box = [0.0, -6.0, 8.0, 2.0]",
         "point = [1.25, -2.5]": "point = [4.25, -2.5]"}


def stage(kind, name, keys, ramp):
    return f'\n[[stage]]\nkind = "{kind}"\nname = "{name}"\nramp_s = {ramp}\n{keys}\n'


class BermWorkspace(RestWorkspace):
    """8 m of the sand between periodic sides, with a berm that comes when the stages say so."""

    def __init__(self, tremolo, stages, **changes):
        super().__init__(tremolo, rest=stages, soil=FILL, boundary='sides = "periodic"', **changes)

    def __enter__(self):
        super().__enter__()
        text = self.case.read_text()
        for old, new in WIDER.items():
            assert old in text, old
            text = text.replace(old, new)
        self.case.write_text(text + BERM)
        return self
