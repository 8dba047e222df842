"""What `tremolo explain` calls "at most" bounds what a run writes, and is near it where numbers do not compress.

    usage: test_output_size.py TREMOLO SOURCE_DIR
"""

import json
import sys
import unittest
from pathlib import Path

TREMOLO, SOURCE = sys.argv.pop(1), Path(sys.argv.pop(1))
sys.path[:0] = [str(SOURCE / "python")] + [str(Path(__file__).parents[1] / folder) for folder in ("runs", "structures")]

from small_case import SLOPE_BOXES, SlopeWorkspace, Workspace, refine
from structure_cases import BlockWorkspace, FrameWorkspace, LinedWorkspace, TunnelWorkspace

EVERY_FIELD = '["displacement", "velocity", "acceleration", "stress", "state"]'


def changed(work, *changes):
    """Replaces texts of the case, which must be there."""
    text = work.case.read_text()
    for old, new in changes:
        assert old in text, old
        text = text.replace(old, new)
    work.case.write_text(text)
    return work


class OutputSize(unittest.TestCase):
    def expect_bound(self, work, share):
        """At least this share of the bound is written, and no more than the bound."""
        most = json.loads(work.command("explain", work.case, "--json").stdout)["plan"]["output_bytes"]
        folder = work.run("run")
        written = sum((folder / name).stat().st_size for name in ("run.h5", "run.xdmf"))
        print(f"{self.id()}: {written / most:.2f} of the bound")
        self.assertLess(written, most)
        self.assertGreater(written, share * most)

    def test_of_many_small_frames(self):
        with Workspace(TREMOLO, duration=2.0, size=2.5, every=0.01) as work:
            self.expect_bound(changed(work, ("history_every_s = 0.005", "history_every_s = 1.0")), 0.6)

    def test_of_long_histories(self):
        with Workspace(TREMOLO, duration=20.0, size=2.5, every=20.0) as work:
            self.expect_bound(work, 0.7)

    def test_of_refined_soil_that_yields(self):
        with SlopeWorkspace(TREMOLO, duration=0.5) as work:
            refine(work, *SLOPE_BOXES)
            self.expect_bound(changed(work, ("every_s = 0.1\n", f"every_s = 0.02\nfields = {EVERY_FIELD}\n")), 0.3)

    def test_of_structures_rigid_and_elastic(self):
        for kind in ("rigid = true", "young = 500e6\npoisson = 0.2"):
            with self.subTest(kind), BlockWorkspace(TREMOLO, kind=kind, duration=0.5) as work:
                self.expect_bound(changed(work, ("every_s = 0.1\n", "every_s = 0.01\n")), 0.3)

    def test_of_linings(self):
        with LinedWorkspace(TREMOLO) as work:
            self.expect_bound(work, 0.3)

    def test_of_sections(self):
        with FrameWorkspace(TREMOLO, duration=0.5) as work:
            self.expect_bound(work, 0.3)

    def test_of_pore_water(self):
        fields = 'fields = ["displacement", "pore_pressure", "excess_pore_pressure", "darcy_velocity"]\n'
        with TunnelWorkspace(TREMOLO, duration=0.5, drainage="coupled") as work:
            self.expect_bound(changed(work, ("every_s = 0.2\n", "every_s = 0.02\n" + fields)), 0.3)


if __name__ == "__main__":
    unittest.main()
