"""Every command of docs/recordings.md, in its order, on a box whose files have the names of the page.

    usage: test_page.py TREMOLO SOURCE_DIR
"""

import shlex
import sys
import unittest
from pathlib import Path

TREMOLO, SOURCE = sys.argv.pop(1), Path(sys.argv.pop(1))
sys.path[:0] = [str(SOURCE / "python"), str(Path(__file__).parent)]

import numpy as np
from recorded_case import BoxWorkspace, differences, model, record, write_csv, write_opensees


def commands():
    """The indented lines of the page that call tremolo, continued lines joined, without comments."""
    page = (SOURCE / "docs/recordings.md").read_text(encoding="utf-8").replace("\\\n", " ")
    return [shlex.split(line, comments=True)[1:] for line in page.splitlines() if line.startswith("    tremolo ")]


class Page(unittest.TestCase):
    def test_its_commands_run(self):
        with record(BoxWorkspace(TREMOLO, left=model("wave"), right=model("wave"), base=model("wave"), duration=0.9)) as work:
            (work.path / "runs").mkdir()
            live = work.run("runs/slope")
            work.command("export", f"{live}:left", "left.csv")
            table = np.loadtxt(work.path / "left.csv", delimiter=",", skiprows=1)
            times, levels = np.unique(table[:, 0]), np.unique(table[:, 1])
            values = table.reshape(len(times), len(levels), 7)[:, :, 2:]
            write_csv(work.path / "field.csv", times, -levels, values * [1.0, 1.0, -1e-3, -1e-3, -1e-3])  # kPa, compression
            write_opensees(work.path, times, levels, values * [1.0, 1.0, 1e-3, 1e-3, 1e-3])
            self.assertEqual(0, work.command("column", work.case, "--model", "wave", "--record", "field.h5").returncode)
            found = commands()
            self.assertEqual({"run", "export", "import"}, {command[0] for command in found})
            self.assertGreaterEqual(len(found), 7)
            for number, words in enumerate(found):
                words = [str(work.case) if word == "CASE" else word for word in words]
                if words[0] == "run":
                    words += ["--out", f"again{number}"]
                result = work.command(*words)
                self.assertEqual(0, result.returncode, f"{words}: {result.stdout}{result.stderr}")
                if words[0] == "run":
                    self.assertEqual([], differences(work.path / f"again{number}", live))


if __name__ == "__main__":
    unittest.main()
