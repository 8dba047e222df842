"""The shipped cases, coarse and shaken for a short time: the same bits with 2, 3, 4 and 8 ranks as with one process.

    usage: test_shipped_cases.py TREMOLO SOURCE_DIR mpi|alone [RANKS ...] [TEST ...]
"""

import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

TREMOLO, SOURCE, BUILD = sys.argv.pop(1), Path(sys.argv.pop(1)).resolve(), sys.argv.pop(1)
COUNTS = [int(word) for word in sys.argv[1:] if word.isdigit()] or [2, 3, 4, 8]
sys.argv[1:] = [word for word in sys.argv[1:] if not word.isdigit()]
sys.path[:0] = [str(SOURCE / "python"), str(Path(__file__).parents[1] / "recordings")]

from recorded_case import differences

SHAKEN, RESTED = 0.25, 0.05  # s

# The length of the coarser cells, m, where the case's own would take minutes.
CASES = {
    "adjacent_buildings/case": 1.0,
    "block_on_slope/case": None,
    "embankment_on_sand/case": None,
    "halfspace_box/case": 2.0,
    "leap_ucd_2017/container": None,
    "level_ground/case": None,
    "level_ground/slope": None,
    "lined_tunnel/case": None,
    "lined_tunnel/liquefied": None,
    "propped_pit/case": None,
    "shaken_block/case": None,
    "shaken_slope/case": None,
    "slope_oblique/case": None,
    "slope_oblique/uniform": 1.0,
    "tunnel_uplift/case": None,
}


def shortened(text, stage, seconds):
    """The text of a case whose stage of a kind takes so long."""
    return re.sub(rf'(kind = "{stage}"[^[]*?duration_s = )[\d.]+', rf"\g<1>{seconds}", text)


@unittest.skipUnless(BUILD == "mpi", "this build has no MPI")
class ShippedCases(unittest.TestCase):
    def run_case(self, case, folder, *options):
        done = subprocess.run([TREMOLO, "run", case, "--out", folder, "--threads", "1", *options], capture_output=True, text=True)
        self.assertEqual(0, done.returncode, done.stdout + done.stderr)
        return folder


def of_case(name, size):
    def test(self):
        file = SOURCE / "cases" / f"{name}.toml"
        text = shortened(shortened(file.read_text(), "shaking", SHAKEN), "rest", RESTED)
        if size is not None:
            text, count = re.subn(r"(\[mesh\]\nsize = )[\d.]+", rf"\g<1>{size}", text)
            self.assertEqual(1, count)
        text = re.sub(r'(file = ")([^"/]+")', rf"\g<1>{file.parent}/\g<2>", text)
        with tempfile.TemporaryDirectory(prefix="tremolo_ranks_") as place:
            case = Path(place) / "case.toml"
            case.write_text(text)
            whole = self.run_case(case, Path(place) / "whole")
            for count in COUNTS:
                with self.subTest(ranks=count):
                    shared = self.run_case(case, Path(place) / f"ranks_{count}", "--ranks", str(count), "--oversubscribe")
                    self.assertEqual([], differences(shared, whole))

    return test


for name, size in CASES.items():
    setattr(ShippedCases, f"test_{name.replace('/', '_')}", of_case(name, size))


if __name__ == "__main__":
    unittest.main()
