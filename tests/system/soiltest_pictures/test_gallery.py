"""The gallery of laws: every test file that the page offers runs, its pictures are there, and the script that makes it
says what it misses.

    usage: test_gallery.py TREMOLO SOURCE_DIR
"""

import re
import subprocess
import sys
import unittest
from pathlib import Path

SOURCE = Path(sys.argv.pop())
TREMOLO = sys.argv.pop()
PAGES = SOURCE / "docs" / "materials"


class Gallery(unittest.TestCase):
    def test_every_test_file_runs(self):
        files = sorted((PAGES / "tests").glob("*.toml"))
        self.assertGreater(len(files), 40)
        for file in files:
            with self.subTest(file.stem):
                command = "calibrate" if "calibration" in file.stem else "soiltest"
                done = subprocess.run([TREMOLO, command, file], capture_output=True, text=True, check=False)
                self.assertEqual(done.returncode, 0, done.stderr)

    def test_pictures_of_the_page_exist(self):
        page = (PAGES / "gallery.md").read_text(encoding="utf-8")
        pictures = re.findall(r"\]\((pictures/[^)]*)\)", page)
        self.assertGreater(len(pictures), 20)
        for picture in pictures:
            self.assertTrue((PAGES / picture).exists(), picture)

    def test_without_reference_curves_it_stops(self):
        script = SOURCE / "tests" / "cost" / "materials" / "gallery.py"
        command = [sys.executable, "-B", script, TREMOLO, "--reference", "/nowhere"]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 1)
        self.assertIn("gallery: /nowhere/materials: no reference curves here", done.stderr)


if __name__ == "__main__":
    unittest.main()
