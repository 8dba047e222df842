"""Damaged checkpoints: `tremolo resume` goes on from the newest set that is whole, and says so.

    usage: test_damaged.py TREMOLO SOURCE_DIR
"""

import shutil
import sys
import unittest
from pathlib import Path

TREMOLO, SOURCE = sys.argv.pop(1), Path(sys.argv.pop(1))
sys.path[:0] = [str(SOURCE / "python"), str(Path(__file__).parent)]

import h5py
import numpy as np
from broken_run import (BoxWorkspace, checkpoints, differences, exchange_differences, killed, model, record, resumed, whole_run,
                        with_checkpoints)

SETTINGS = {"left": model("fe"), "right": model("ode"), "base": model("wave"), "duration": 0.7}


def halved(file):
    file.write_bytes(file.read_bytes()[: file.stat().st_size // 2])


def one_bit(file):
    content = bytearray(file.read_bytes())
    content[len(content) // 2] ^= 1
    file.write_bytes(content)




class Damaged(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.work = cls.enterClassContext(with_checkpoints(record(BoxWorkspace(TREMOLO, **SETTINGS)), every_steps=40))
        cls.folder = cls.work.path / "broken"
        victim, text = killed(cls.work, cls.folder, ["run", cls.work.case, "--out", cls.folder], 80, victim="domain")
        assert victim == "domain", text
        assert len(checkpoints(cls.folder)) == 2, checkpoints(cls.folder)
        cls.whole = whole_run(cls.work)

    def copy(self, name):
        return Path(shutil.copytree(self.folder, self.work.path / name, symlinks=True))

    def test_goes_on_from_the_set_before_to_the_same_bits(self):
        self.goes_on_from_the_set_before({"left.h5": one_bit})

    def test_acceptance_goes_on_whichever_file_is_damaged(self):
        self.goes_on_from_the_set_before({"domain.h5": halved, "recording.h5": Path.unlink, "manifest.json": halved})

    def goes_on_from_the_set_before(self, damages):
        older, newer = checkpoints(self.folder)
        for file, damage in damages.items():
            with self.subTest(file):
                folder = self.copy(f"without_{file}")
                damage(folder / "checkpoints" / f"{newer:010}" / file)
                result = resumed(self.work, folder)
                self.assertEqual(0, result.returncode, result.stdout + result.stderr)
                self.assertIn(f"checkpoints/{newer:010} cannot be used: ", result.stderr)
                self.assertIn(file, result.stderr)
                self.assertIn(f"going on from step {older},", result.stdout)
                self.assertEqual([], differences(folder, self.whole))
                self.assertEqual([], exchange_differences(folder, self.whole))
                self.assertNotIn("json.exception", result.stderr)

    def test_a_damaged_run_file_is_named_before_anything_starts(self):
        for name, at in {"energy": (3, 1), "monitors/surface": (5, 4), "boundary/traction": (2, 0, 1), "frames/0000/velocity": (7, 1)}.items():
            with self.subTest(name):
                folder = self.copy(f"bad_{name.replace('/', '_')}")
                with h5py.File(folder / "run.h5", "r+") as file:
                    file[name][at] = np.nextafter(file[name][at], np.inf)
                before = (folder / "run.h5").read_bytes()
                self.refused(folder, name.rsplit("/", 1)[0] if name.startswith("frames") else name)
                self.assertEqual(before, (folder / "run.h5").read_bytes())

    def test_a_run_file_that_cannot_be_read_is_named_before_anything_starts(self):
        for damage in (halved, Path.unlink):
            folder = self.copy(f"run_{damage.__name__}")
            damage(folder / "run.h5")
            self.refused(folder, "run.h5")

    def refused(self, folder, word):
        result = resumed(self.work, folder)
        self.assertNotEqual(0, result.returncode, result.stdout)
        for part in (word, "cannot go on", f"tremolo run {folder / 'case.toml'}"):
            self.assertIn(part, result.stderr)
        self.assertNotIn("tremolo resume", result.stderr)
        self.assertNotIn("going on from step", result.stdout)

    def test_folders_that_are_no_sets_are_left_alone(self):
        folder = self.copy("strange")
        for name in ("zzz", "notes", "99999x9999"):
            (folder / "checkpoints" / name).mkdir()
        result = resumed(self.work, folder)
        self.assertEqual(0, result.returncode, result.stdout + result.stderr)
        self.assertNotIn("cannot be used", result.stderr)
        self.assertEqual(["99999x9999", "notes", "zzz"], sorted(f.name for f in (folder / "checkpoints").iterdir() if not f.name.isdigit()))

    def test_a_recording_that_is_gone_ends_the_resumption(self):
        for damage in (Path.unlink, halved):
            folder = self.copy(f"no_recording_{damage.__name__}")
            damage(folder / "exchange.h5")
            result = resumed(self.work, folder)
            self.assertEqual(1, result.returncode, result.stdout + result.stderr)
            self.assertIn("the recording of the exchange cannot go on", result.stderr)
            self.assertIn(str(folder / "exchange.h5"), result.stderr)
            self.assertNotIn("tremolo resume", result.stderr)
            self.assertNotIn("filesystem error", result.stderr)


if __name__ == "__main__":
    unittest.main()
