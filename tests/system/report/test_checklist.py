"""The commands of a report's reviewer's list, typed as they stand, all work.

    usage: test_checklist.py TREMOLO SOURCE_DIR
"""

import subprocess
import sys
import unittest
from pathlib import Path

TREMOLO, SOURCE = sys.argv.pop(1), Path(sys.argv.pop(1))
sys.path[:0] = [str(SOURCE / "python"), str(Path(__file__).parents[1] / "stages")]

from rest_case import RestWorkspace
from tremolo import Run
from tremolo.report import checklist


class Checklist(unittest.TestCase):
    def test_commands_work(self):
        self.type_commands(2)

    def test_acceptance_every_command_works(self):
        self.type_commands(3)

    def type_commands(self, count):
        with RestWorkspace(TREMOLO, shaking=0.1) as work:
            work.case.write_text(work.case.read_text().replace("[output]\n", '[output]\nfields = ["stress"]\n'))
            folder = work.run("run")
            done = work.command("report", folder)
            self.assertEqual(0, done.returncode, done.stdout + done.stderr)
            page = (folder / "report.html").read_text(encoding="utf-8")
            with Run(folder) as run:
                rows = checklist.checklist(run).rows
            commands = [row[-1] for row in rows if row[-1].startswith("tremolo ")]
            self.assertEqual(["soiltest", "sweep", "sweep"], [command.split()[1] for command in commands])
            for command in commands[:count]:
                self.assertIn(command, page)
                typed = subprocess.run([TREMOLO, *command.split()[1:]], cwd=folder, capture_output=True, text=True, timeout=200)
                self.assertEqual(0, typed.returncode, f"{command}\n{typed.stdout}{typed.stderr}")


if __name__ == "__main__":
    unittest.main()
