"""docs/validation.md names tests, programs, scripts, commands and pages; all of them exist.

    usage: test_validation.py CTEST BUILD_DIR SOURCE_DIR
"""

import json
import re
import subprocess
import sys
import unittest
from pathlib import Path

SOURCE = Path(sys.argv.pop(3))
BUILD = Path(sys.argv.pop(2))
CTEST = sys.argv.pop(1)
PAGE = SOURCE / "docs/validation.md"
COLUMNS = ["claim", "number", "against", "held by", "bound", "more"]
NOTHING = "no test"  # how a row begins that has neither test nor command


def rows():
    """Number of the line and cells of each row of the page's tables of claims."""
    claims = False
    for number, line in enumerate(PAGE.read_text(encoding="utf-8").splitlines(), 1):
        cells = [cell.strip() for cell in line.strip("|").split("|")]
        if not line.startswith("|"):
            claims = False
        elif cells == COLUMNS:
            claims = True
        elif claims and not line.startswith("|---"):
            yield number, cells


def quoted(text):
    return re.findall(r"`([^`]+)`", text)


def is_path(word):
    return word.startswith(("cases/", "docs/", "tests/"))


def is_test(words):
    return len(words) == 1 and not is_path(words[0]) and not words[0].startswith("cost_")


class Validation(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.held_by = [(number, words.split()) for number, cells in rows() for words in quoted(cells[3])]

    def missing(self, wanted, exists):
        return [f"docs/validation.md:{number}: {' '.join(words)}" for number, words in self.held_by
                if wanted(words) and not exists(words)]

    def test_every_row_is_whole_and_says_what_stands_behind_it(self):
        found = list(rows())
        self.assertGreater(len(found), 100)
        for number, cells in found:
            with self.subTest(line=number):
                self.assertEqual(len(COLUMNS), len(cells), "a cell too many or too few")
                self.assertTrue(cells[3].startswith(NOTHING) or quoted(cells[3]), "neither test nor command")

    def test_every_test_exists(self):
        done = subprocess.run([CTEST, "--test-dir", BUILD, "--show-only=json-v1"], capture_output=True, text=True,
                              check=True)
        names = [test["name"] for test in json.loads(done.stdout)["tests"]]
        unbuilt = [name for name in names if name.endswith("_NOT_BUILT")]
        if unbuilt:
            self.skipTest(f"the names of {len(unbuilt)} test programs are not known before they are built")
        # A name stands for itself and for all below it: of a program, a suite, or a test with parameters.
        known = {name[:end] for name in names for end in range(1, len(name) + 1)
                 if end == len(name) or name[end] in "./ "}
        self.assertEqual([], self.missing(is_test, lambda words: words[0] in known))

    def test_every_program_of_costs_exists(self):
        text = "".join(path.read_text(encoding="utf-8") for path in (SOURCE / "tests/cost").rglob("CMakeLists.txt"))
        programs = {f"cost_{name}" for name in re.findall(r"tremolo_(?:benchmark|study)\((\w+)", text)}
        self.assertGreater(len(programs), 10)
        self.assertEqual([], self.missing(lambda words: words[0].startswith("cost_"), lambda words: words[0] in programs))

    def test_every_command_exists(self):
        text = subprocess.run([BUILD / "bin/tremolo", "--help"], capture_output=True, text=True, check=True).stdout
        known = re.findall(r"^  (\w+) ", text, re.MULTILINE)
        self.assertIn("run", known)
        self.assertEqual([], self.missing(lambda words: words[0] == "tremolo", lambda words: words[1] in known))

    def test_every_file_of_a_command_exists(self):
        self.assertEqual([], self.missing(lambda words: any(map(is_path, words)),
                                          lambda words: all((SOURCE / word).exists() for word in words if is_path(word))))

    def test_every_link_leads_somewhere(self):
        links = re.findall(r"\]\(([^)#\s]+)", PAGE.read_text(encoding="utf-8"))
        self.assertGreater(len(links), 100)
        self.assertEqual([], sorted({link for link in links if not (PAGE.parent / link).exists()}))


if __name__ == "__main__":
    unittest.main()
