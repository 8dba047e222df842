"""The tutorial's commands, typed in the order of its page, all work, and its numbers are those that they print. So does
the case of the front page.

    usage: test_tutorial.py TREMOLO SOURCE_DIR
"""

import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

TREMOLO, SOURCE = Path(sys.argv.pop(1)), Path(sys.argv.pop(1))


def commands():
    """The indented lines of the page."""
    return [line.strip() for line in (SOURCE / "docs/tutorial.md").read_text().splitlines() if line.startswith("    ")]


def needs_the_slope(command):
    """Whether it computes the slope under two angles or reads what came of it: two minutes."""
    return "runs/vertical" in command or "runs/oblique" in command


class Typed(unittest.TestCase):
    def typed(self, commands, files):
        """What the commands print; they make these files."""
        environment = {**os.environ, "PATH": f"{TREMOLO.parent}:/usr/bin:/bin"}
        printed = {}
        with tempfile.TemporaryDirectory(prefix="tremolo_tutorial_") as folder:
            for command in commands:
                done = subprocess.run(command, shell=True, cwd=folder, env=environment, capture_output=True, text=True, timeout=200)
                self.assertEqual(0, done.returncode, f"{command}\n{done.stdout}{done.stderr}")
                printed[command] = done.stdout
            for made in files:
                self.assertTrue((Path(folder) / made).is_file(), made)
        return printed


class Tutorial(Typed):
    def test_every_command_works_but_those_of_the_slope(self):
        chosen = [command for command in commands() if not needs_the_slope(command)]
        self.assertGreater(len(chosen), 11)
        printed = self.typed(chosen, ("motion.png", "sand_water.png", "choices.html", "runs/box/verify.png"))
        self.assertAlmostEqual(2.8, float(re.search(r"whole +\d+ +([\d.]+) %", printed["tremolo verify runs/box"])[1]), delta=0.05)
        ladder = next(text for command, text in printed.items() if command.startswith("tremolo cost"))
        errors = [float(found) for found in re.findall(r"^\d +([\d.]+) %", ladder, re.MULTILINE)]
        self.assertEqual([41, 11, 3], [round(error) for error in errors])


class FrontPage(Typed):
    def test_its_case_follows_the_exact_wave(self):
        case = (SOURCE / "README.md").read_text().split("```toml\n")[1].split("```")[0]
        self.assertLess(case.count("\n"), 16)
        verify = "tremolo verify run"
        printed = self.typed([f"cat > case.toml << 'END'\n{case}END", "tremolo run case.toml --out run", verify], ("run/verify.png",))
        self.assertLess(float(re.search(r"whole +\d+ +([\d.]+) %", printed[verify])[1]), 1.0)


class AcceptanceTutorial(Typed):
    def test_every_command_works(self):
        self.assertGreater(len(commands()), 15)
        printed = self.typed(commands(), ("slope.html", "choices.html"))
        failed = next(text for command, text in printed.items() if command.startswith("tremolo failure"))
        self.assertRegex(failed, r"vertical: 0 degrees, fails at (?:9\.[89]|10\.0)[^\n]*\n[^\n]*oblique: 15 degrees, fails at 9\.[789]")


if __name__ == "__main__":
    unittest.main()
