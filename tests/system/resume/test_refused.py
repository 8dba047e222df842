"""What `tremolo resume` refuses, and in which words.

    usage: test_refused.py TREMOLO SOURCE_DIR
"""

import sys
import unittest
import zlib
from pathlib import Path

TREMOLO, SOURCE = sys.argv.pop(1), Path(sys.argv.pop(1))
sys.path[:0] = [str(SOURCE / "python"), str(Path(__file__).parent)]

import h5py
from broken_run import BoxWorkspace, checkpoints, differences, killed, model, resumed, whole_run, with_checkpoints

SETTINGS = {"left": model("fe"), "right": model("ode"), "base": model("wave"), "duration": 1.0}


class Refused(unittest.TestCase):
    """One broken run, spoilt in one way after the other."""

    @classmethod
    def setUpClass(cls):
        cls.work = cls.enterClassContext(with_checkpoints(BoxWorkspace(TREMOLO, **SETTINGS), every_steps=40))
        cls.folder = cls.work.path / "broken"
        victim, text = killed(cls.work, cls.folder, ["run", cls.work.case, "--out", cls.folder], 80, victim="domain")
        assert victim == "domain", text
        cls.set = cls.folder / "checkpoints" / f"{checkpoints(cls.folder)[-1]:010}"

    def refusal(self, folder=None):
        result = resumed(self.work, folder or self.folder)
        self.assertNotEqual(0, result.returncode, result.stdout)
        self.assertNotIn("terminate", result.stderr)
        return result.stdout + result.stderr

    def spoilt(self, file, old, new):
        """What is said when a file reads otherwise; it is mended again."""
        text = file.read_text()
        self.assertIn(old, text)
        file.write_text(text.replace(old, new))
        try:
            return self.refusal()
        finally:
            file.write_text(text)

    def test_another_case_with_the_line_that_differs(self):
        message = self.spoilt(self.folder / "case.toml", "velocity = 0.1", "velocity = 0.2")
        for part in ("case", "velocity = 0.1", "velocity = 0.2", "[motion]"):
            self.assertIn(part, message)

    def test_another_schema_and_another_build_with_both(self):
        manifest = self.set / "manifest.json"
        message = self.spoilt(manifest, '"schema_version": "1.8"', '"schema_version": "7.4"')
        self.assertIn("schema_version is 7.4 in the checkpoint, 1.8 in this run", message)
        build = next(line for line in manifest.read_text().splitlines() if '"build"' in line)
        message = self.spoilt(manifest, build, ' "build": "0.0.1",')
        self.assertIn("build is 0.0.1 in the checkpoint", message)

    def list_again(self, manifest, old, new):
        """Puts another checksum of a file into the manifest, whose own is that of all its other lines."""
        lines = [line for line in manifest.read_text().replace(old, new).splitlines() if not line.startswith(' "crc"')]
        crc = zlib.crc32("\n".join(lines).encode())
        manifest.write_text("\n".join([lines[0], f' "crc": "{crc:08x}",', *lines[1:]]))

    def test_a_source_that_does_not_compute_the_same_again(self):
        file, manifest = self.set / "left.h5", self.set / "manifest.json"
        good, listed = file.read_bytes(), manifest.read_text()
        with h5py.File(file, "r+") as saved:
            saved["total.last"][3] += 1.0
        self.list_again(manifest, f"{zlib.crc32(good):08x}", f"{zlib.crc32(file.read_bytes()):08x}")
        try:
            message = self.refusal()
            for part in ("left", "total", "before the checkpoint", f"could not go on from its newest checkpoint, {self.set}"):
                self.assertIn(part, message)
            self.assertNotIn("tremolo resume", message)
        finally:
            file.write_bytes(good)
            manifest.write_text(listed)

    def test_no_set_that_is_whole(self):
        everything = sorted(file for file in (self.folder / "checkpoints").rglob("*.h5"))
        good = [file.read_bytes() for file in everything]
        for file, text in zip(everything, good):
            file.write_bytes(text[: len(text) // 2])
        try:
            message = self.refusal()
            self.assertIn("is damaged", message)
            self.assertIn("no complete checkpoint", message)
        finally:
            for file, text in zip(everything, good):
                file.write_bytes(text)

    def test_folders_without_a_run_or_a_checkpoint_and_complete_runs(self):
        empty = self.work.path / "empty"
        empty.mkdir()
        self.assertIn("no folder of a run", self.refusal(empty))
        (empty / "case.toml").write_text(self.work.case.read_text())
        message = self.refusal(empty)
        self.assertIn("no complete checkpoint", message)
        self.assertIn(f"tremolo run {empty / 'case.toml'}", message)
        self.assertIn("is complete", self.refusal(self.work.run("complete", "--threads", 1)))

    def test_z_what_was_mended_goes_on(self):
        result = resumed(self.work, self.folder)
        self.assertEqual(0, result.returncode, result.stdout + result.stderr)
        self.assertEqual([], differences(self.folder, whole_run(self.work)))


if __name__ == "__main__":
    unittest.main()
