"""No command writes over a file that it reads, nor over a file that is not its own. Every option of every command that names what
is written stands in the table below.

    usage: test_outputs.py TREMOLO SOURCE_DIR
"""

import re
import shutil
import sys
import unittest
from pathlib import Path

TREMOLO, SOURCE = sys.argv.pop(1), Path(sys.argv.pop(1))
sys.path[:0] = [str(SOURCE / "python"), str(Path(__file__).parents[1] / "runs")]

from small_case import Workspace

COLUMN = """
title = "ten metres on rock"
[motion]
pulse = { shape = "ricker", frequency = 2.0, time = 1.0, velocity = 0.1 }
kind = "incident"
wave = "SV"
angle_deg = 0.0
reference = [0.0, -10.0]
[surface]
level = 0.0
[halfspace]
density = 2200.0
vs = 600.0
vp = 1200.0
[soil.ground]
model = "linear_elastic"
density = 1800.0
vs = 200.0
vp = 400.0
[[profile]]
soil = "ground"
thickness = 10.0
"""

RECORD = "time (s),acceleration (m/s2)\n" + "".join(f"{0.01 * i:.2f},{(-1) ** i * 0.1 if 0 < i < 99 else 0.0}\n" for i in range(100))

FOREIGN = b"mine, and nobody else's\n1,2\n"

# What takes OUT where it writes a file, and the files that it reads. {x} are the files of the folder.
FILES = {
    ("motion", "--out"): (["motion", "{record}", "--out", "OUT"], "o.csv", ["record"]),
    ("motion", "--response"): (["motion", "{record}", "--response", "OUT"], "o.csv", ["record"]),
    ("motion", "--fourier"): (["motion", "{record}", "--fourier", "OUT"], "o.csv", ["record"]),
    ("motion", "--plot"): (["motion", "{record}", "--plot", "OUT"], "o.png", ["record"]),
    ("deconvolve", "--out"): (["deconvolve", "{column}", "{record}", "--model", "wave", "--out", "OUT"], "o.csv", ["column", "record"]),
    ("wave", "--out"): (["wave", "{column}", "--points", "{points}", "--times", "0:1:0.1", "--out", "OUT"], "o.csv", ["column", "points"]),
    ("column", "--out"): (["column", "{column}", "--model", "wave", "--out", "OUT"], "o.h5", ["column"]),
    ("column", "--record"): (["column", "{case}", "--model", "wave", "--record", "OUT"], "o.h5", ["case"]),
    ("soiltest", "--out"): (["soiltest", "{soil_test}", "--out", "OUT"], "o.h5", ["soil_test"]),
    ("calibrate", "--out"): (["calibrate", "{calibration}", "--out", "OUT"], "o.toml", ["calibration"]),
    ("import", "--out"): (["import", "{field}", "--velocity-unit", "m/s", "--stress-unit", "Pa", "--stress-sign", "tension",
                           "--depth-positive", "down", "--vertical-positive", "up", "--out", "OUT"], "o.h5", ["field"]),
    ("export", "OUT"): (["export", "{recording}", "OUT"], "o.csv", ["recording"]),
    ("report", "--out"): (["report", "{run}", "--out", "OUT"], "o.html", ["run"]),
}

# What takes OUT where it writes into a folder, and one of the files that it writes there.
FOLDERS = {
    ("plot", "--out"): (["plot", "{run}", "--out", "OUT"], "model.png"),
    ("timeline", "--out"): (["timeline", "{run}", "--out", "OUT"], "timeline.png"),
    ("compare", "--out"): (["compare", "{run}", "{run}", "--out", "OUT"], "compare_acceleration.png"),
    ("extract", "--out"): (["extract", "{run}", "--out", "OUT"], "history_surface.csv"),
    ("safety", "--out"): (["safety", "{slope}", "--out", "OUT"], "safety.csv"),
    ("cost", "--out"): (["cost", "{case}", "--knob", "mesh.size=1", "--out", "OUT"], "cost.csv"),
    ("sweep", "--out"): (["sweep", "{study}", "--out", "OUT"], "sweep.json"),
    ("docs", "FOLDER"): (["docs", "OUT"], "commands.md"),
}

# A picture or a report goes beside what the command writes, or reads.
BESIDE = {
    ("column", "--plot"): (["column", "{column}", "--model", "wave", "--out", "OUT/o.h5", "--plot"], "o.png"),
    ("deconvolve", "--plot"): (["deconvolve", "{column}", "{record}", "--model", "wave", "--out", "OUT/o.csv", "--plot"], "o.png"),
    ("soiltest", "--plot"): (["soiltest", "{soil_test}", "--out", "OUT/o.h5", "--plot"], "o.png"),
    ("verify", "RUN"): (["verify", "OUT/run.h5"], "verify.json"),
}

# These take a new folder, or one that is empty; keys never replace others; a process keeps its log in `join --out`.
NEW_FOLDERS = {("run", "--out"), ("swap", "--out"), ("new", "NAME"), ("keygen", "FOLDER"), ("join", "--out"), ("run", "--report"),
               ("extract", "--plot")}

SAYS_THAT_IT_WRITES = re.compile(r"^(Written|New folder|Folder:|Folder of the sweep|Folder for|Folder to make|folder of the (pictures?|tables)|the page|Where the keys|"
                                 r"Existing folder to write|Picture of|Draw OUT|also pictures|Write report)")


def options_that_write():
    """(command, option) of docs/commands.md whose description says so."""
    found, command = set(), None
    for line in (SOURCE / "docs" / "commands.md").read_text().splitlines():
        if line.startswith("## "):
            command = line[3:]
        elif row := re.match(r"\| `([^` ]+)[^`]*` \| (.*) \|", line):
            if SAYS_THAT_IT_WRITES.match(row[2]) or row[1] == "--out":
                found.add((command, row[1]))
    return found


class Outputs(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.work = cls.enterClassContext(Workspace(TREMOLO, duration=0.4, every=0.2))
        folder = cls.work.path
        cls.files = {"case": cls.work.case, "run": cls.work.run("run")}
        tests = SOURCE / "docs" / "materials" / "tests"
        for name, file in (("soil_test", tests / "clay_simple_shear.toml"), ("calibration", tests / "pm4_dr55_calibration_curve.toml"),
                           ("slope", SOURCE / "cases" / "static_slope" / "case.toml")):
            cls.files[name] = Path(shutil.copy(file, folder / f"{name}.toml"))
        for name, ending, text in (("column", "toml", COLUMN), ("record", "csv", RECORD), ("points", "csv", "x,y\n0,0\n"),
                                   ("field", "csv", "time,depth,vx\n0,0,0\n"),
                                   ("study", "toml", f'case = "{cls.work.case}"\n[axes]\n"motion.angle_deg" = [5.0, 10.0]\n')):
            cls.files[name] = folder / f"{name}.{ending}"
            cls.files[name].write_text(text)
        cls.files["recording"] = folder / "recording.h5"
        done = cls.work.command("column", cls.work.case, "--model", "wave", "--record", cls.files["recording"])
        assert done.returncode == 0, done.stderr

    def words(self, line, out):
        return [word.replace("OUT", str(out)).format(**self.files) if "OUT" in word else word.format(**self.files) for word in line]

    def refused(self, line, out, kept):
        """The command ends with an error that names the file, which is as it was."""
        before = kept.read_bytes()
        result = self.work.command(*self.words(line, out))
        self.assertEqual(before, kept.read_bytes(), f"{kept.name} was destroyed")
        self.assertNotEqual(0, result.returncode, result.stdout + result.stderr)
        self.assertIn(kept.name, result.stderr)
        self.assertNotIn("Traceback", result.stderr)

    def foreign(self, folder, name):
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir()
        (folder / name).write_bytes(FOREIGN)
        return folder / name

    def test_the_table_names_every_option_that_writes(self):
        self.assertEqual(set(), options_that_write() - FILES.keys() - FOLDERS.keys() - BESIDE.keys() - NEW_FOLDERS)

    def test_a_file_of_somebody_else_stays(self):
        for key, (line, name, _) in FILES.items():
            with self.subTest(key):
                path = self.foreign(self.work.path / "foreign", name)
                self.refused(line, path, path)

    def test_a_file_that_is_read_stays(self):
        for key, (line, name, inputs) in FILES.items():
            for given in inputs:
                with self.subTest(key, input=given):
                    kept = self.files[given]
                    out = kept = kept / "run.h5" if kept.is_dir() else kept
                    self.refused(line, out, kept)

    def test_another_name_of_a_file_that_is_read_does_not_hide_it(self):
        link = self.work.path / "link.csv"
        link.symlink_to(self.files["record"])
        self.refused(["motion", "{record}", "--out", "OUT"], link, link)

    def test_a_file_of_somebody_else_in_a_folder_stays(self):
        for key, (line, name) in (FOLDERS | BESIDE).items():
            with self.subTest(key):
                folder = self.work.path / "foreign"
                path = self.foreign(folder, name)
                if key[0] == "verify":
                    shutil.copy(self.files["run"] / "run.h5", folder)
                self.refused(line, folder, path)

    def test_a_command_replaces_what_it_wrote(self):
        for key in (("motion", "--out"), ("motion", "--response"), ("wave", "--out"), ("column", "--record"), ("export", "OUT")):
            line, name, _ = FILES[key]
            with self.subTest(key):
                out = self.work.path / ("again_" + name)
                out.unlink(missing_ok=True)
                for _ in range(2):
                    result = self.work.command(*self.words(line, out))
                    self.assertEqual(0, result.returncode, result.stderr)

    def test_a_picture_replaces_the_picture_before(self):
        for _ in range(2):
            result = self.work.command("timeline", self.files["run"])
            self.assertEqual(0, result.returncode, result.stderr)

    def test_tables_of_a_column_are_hdf5(self):
        result = self.work.command("column", self.files["column"], "--model", "wave", "--out", self.work.path / "x.csv")
        self.assertNotEqual(0, result.returncode)
        self.assertIn("must end with .h5", result.stderr)
        self.assertFalse((self.work.path / "x.csv").exists())


if __name__ == "__main__":
    unittest.main()
