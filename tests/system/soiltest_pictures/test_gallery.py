"""The gallery of laws: every test file that the page offers runs, the program gives the numbers that the page prints,
its pictures are there, and the script that makes it says what it misses.

    usage: test_gallery.py TREMOLO SOURCE_DIR
"""

import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SOURCE = Path(sys.argv.pop())
TREMOLO = sys.argv.pop()
PAGES = SOURCE / "docs" / "materials"
sys.path[:0] = [str(SOURCE / "tests" / "cost" / "materials"), str(SOURCE / "python")]

import gallery_rows as rows
from tremolo.soil_test import record


def printed(section, name):
    """The cells after the name in the rows of a test, of one table of the page."""
    page = (PAGES / "gallery.md").read_text(encoding="utf-8")
    table = page.split(f"<!-- {section} -->")[1].split(f"<!-- /{section} -->")[0]
    found = [line.strip(" |").split(" | ") for line in table.splitlines() if line.startswith(f"| `{name}` |")]
    return [cells[1:] for cells in found]


def ours(cell):
    """Our number of a cell that holds "ours / reference", with the digits printed."""
    return cell.split(" / ")[0]


def one_of_each(files):
    """The first file of each law, with or without cycles."""
    kinds = {(file.stem.split("_")[0], "mono" in file.stem, "calibration" in file.stem): file for file in reversed(files)}
    return list(kinds.values())


class Gallery(unittest.TestCase):
    def test_test_files_run(self):
        self.expect_to_run(one_of_each(self.files()))

    def test_acceptance_every_test_file_runs(self):
        self.expect_to_run(self.files())

    def files(self):
        files = sorted((PAGES / "tests").glob("*.toml"))
        self.assertGreater(len(files), 40)
        return files

    def expect_to_run(self, files):
        for file in files:
            with self.subTest(file.stem):
                command = "calibrate" if "calibration" in file.stem else "soiltest"
                done = subprocess.run([TREMOLO, command, file], capture_output=True, text=True, check=False)
                self.assertEqual(done.returncode, 0, done.stderr)

    def history(self, name):
        with tempfile.TemporaryDirectory() as folder:
            out = Path(folder) / "out.h5"
            command = [TREMOLO, "soiltest", PAGES / "tests" / f"{name}.toml", "--out", out]
            subprocess.run(command, capture_output=True, text=True, check=True)
            return record.read(out).histories["000"]

    def expect_printed(self, section, name, cells):
        """The rows that our history makes beside itself have the numbers of the page."""
        page = printed(section, name)
        self.assertEqual(len(page), len(cells), f"{section}, {name}")
        for on_page, now in zip(page, cells):
            self.assertEqual([ours(cell) for cell in on_page], [ours(cell) for cell in now], f"{section}, {name}")

    def test_cycles_are_those_of_the_page(self):
        for law, names in (
            ("pm4sand", ("pm4_dr35_ucdss_csr0090_k05_s101", "pm4_dr55_ucdss_bias01_csr0147_s101")),
            ("pdmy03", ("pdmy03_dr33_ucdss_csr0090_k05_s101", "pdmy03_dr57_ucdss_bias01_csr0160")),
        ):
            for name in names:
                with self.subTest(name):
                    history = self.history(name)
                    self.expect_printed(f"{law}-cyclic", name, [rows.cycles(history, history)])

    def test_loops_are_those_of_the_page(self):
        for law, name in (("pm4sand", "pm4_dr55_dcdss_s100"), ("pdmy03", "pdmy03_dr57_ucdss_strainctl_s100")):
            with self.subTest(name):
                history = self.history(name)
                self.expect_printed(f"{law}-loops", name, rows.loops(history, history))

    def test_strengths_and_volumes_are_those_of_the_page(self):
        for law, name in (
            ("pm4sand", "pm4_dr55_mono_dss_d_p100_k05"), ("pm4sand", "pm4_dr55_mono_psc_d_p100_k10"),
            ("pdmy03", "pdmy03_dr57_mono_dss_d_p100_k05"), ("pdmy03", "pdmy03_dr57_mono_psc_u_p25_k10"),
        ):
            with self.subTest(name):
                history = self.history(name)
                self.expect_printed(f"{law}-monotonic", name, [rows.monotonic(history, history, "_dss_" in name)])

    def test_mohr_coulomb_is_that_of_the_page(self):
        for name, column, sign in (
            ("mc_seed_psc_d_s50", "sig_yy", -1.0), ("mc_perfect45_dss_d_s100_k05", "sig_xy", 1.0),
            ("mc_perfect30psi10_dss_d_s100_k05", "sig_xy", 1.0), ("mc_seed_dss_d_s100_k05", "sig_xy", 1.0),
        ):
            with self.subTest(name):
                end = sign * self.history(name)[column][-1]
                _, _, tremolo, _ = printed("mohr_coulomb", name)[-1]
                self.assertEqual(tremolo, f"{end / 1e3:.6g} kPa")

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
