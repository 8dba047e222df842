"""The tutorial's commands, typed in the order of its page, all work, and its numbers are those that they print. So does
the case of the front page. The suite leaves out the commands that take long.

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


def takes_long(command):
    """Whether it computes the slope, the ladder of cells, other free fields, sand or layers, or reads what came of them: three
    minutes."""
    return any(result in command for result in ("runs/vertical", "runs/oblique", "runs/cost", "runs/swap", "sand.h5", "runs/layers"))


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
    def has_the_error_of_the_box(self, printed):
        self.assertAlmostEqual(2.8, float(re.search(r"whole +\d+ +([\d.]+) %", printed["tremolo verify runs/box"])[1]), delta=0.05)

    def test_every_command_works_that_is_fast(self):
        chosen = [command for command in commands() if not takes_long(command)]
        self.assertGreater(len(chosen), 9)
        self.has_the_error_of_the_box(self.typed(chosen, ("motion.png", "runs/box/verify.png")))

    def test_acceptance_every_command_works(self):
        self.assertGreater(len(commands()), 15)
        printed = self.typed(commands(), ("motion.png", "sand_water.png", "runs/box/verify.png", "slope.html", "choices.html"))
        self.has_the_error_of_the_box(printed)
        ladder = next(text for command, text in printed.items() if command.startswith("tremolo cost"))
        errors = [float(found) for found in re.findall(r"^\d +([\d.]+) %", ladder, re.MULTILINE)]
        self.assertEqual([41, 11, 3], [round(error) for error in errors])
        failed = next(text for command, text in printed.items() if command.startswith("tremolo failure"))
        self.assertRegex(failed, r"vertical: 0 degrees, fails at (?:9\.[89]|10\.0)[^\n]*\n[^\n]*oblique: 15 degrees, fails at 9\.[789]")


class FrontPage(Typed):
    def test_its_case_follows_the_exact_wave(self):
        case = (SOURCE / "README.md").read_text().split("```toml\n")[1].split("```")[0]
        self.assertLess(case.count("\n"), 16)
        verify = "tremolo verify run"
        printed = self.typed([f"cat > case.toml << 'END'\n{case}END", "tremolo run case.toml --out run", verify], ("run/verify.png",))
        self.assertLess(float(re.search(r"whole +\d+ +([\d.]+) %", printed[verify])[1]), 1.0)


if __name__ == "__main__":
    unittest.main()
