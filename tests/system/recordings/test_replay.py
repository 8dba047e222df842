"""A recorded exchange, served again: each participant in turn gives the same bits; what belongs to another case is refused.

    usage: test_replay.py TREMOLO SOURCE_DIR
"""

import csv
import shutil
import struct
import sys
import unittest
import zlib
from pathlib import Path

TREMOLO, SOURCE = sys.argv.pop(1), Path(sys.argv.pop(1))
sys.path[:0] = [str(SOURCE / "python"), str(Path(__file__).parent)]

import h5py
import numpy as np
from recorded_case import BoxWorkspace, SlopeWorkspace, differences, model, record, text
from angle_cases import UNDRAINED, WATER, FlatWorkspace

MIXED = {"left": model("fe"), "right": model("ode"), "base": model("wave")}
WITHOUT_SPRINGS = {side: keys + ", spring = false" for side, keys in MIXED.items()}  # they are added in the domain
WAVES = {"left": model("wave"), "right": model("wave"), "base": model("wave"), "angle": 15.0}


class ReplayCase(unittest.TestCase):
    def replays(self, work, names, mode="window"):
        live = work.run("live", "--mode", mode)
        with h5py.File(live / "exchange.h5") as file:
            self.assertEqual("complete", text(file.attrs["status"]))
        for name in names:
            options = [word for side in name.split("+") for word in ("--replay", str(live) + side)]
            again = work.run("again" + name.replace(":", "_"), *options)
            self.assertEqual([], differences(again, live), name)
        return live


class Replay(ReplayCase):
    def test_each_of_three_models_gives_the_same_bits(self):
        with record(BoxWorkspace(TREMOLO, **MIXED)) as work:
            live = self.replays(work, [":right", ":left+:base"])
            with h5py.File(live / "exchange.h5") as file:
                self.assertEqual({"left", "right", "base"}, set(file["sources"]))

    def test_a_lockstep_run_is_replayed_in_window_mode(self):
        with record(BoxWorkspace(TREMOLO, **WITHOUT_SPRINGS, duration=0.6)) as work:
            live = self.replays(work, [":left", ""], mode="lockstep")
            with h5py.File(live / "exchange.h5") as file, h5py.File(live / "run.h5") as run:
                steps, faces, _ = file["domain/traction"].shape
                self.assertEqual(file["domain/velocity"].shape, (steps, faces, 2))
                # The run file holds every so many steps of the same numbers; its last row stands for the end.
                times, chosen, rows = np.intersect1d(file["domain/time"][:], run["boundary/time"][:], return_indices=True)
                self.assertGreaterEqual(len(times), len(run["boundary/time"]) - 1)
                np.testing.assert_array_equal(file["domain/traction"][:][chosen], run["boundary/traction"][:][rows])
                np.testing.assert_array_equal(file["domain/velocity"][:][chosen], run["boundary/domain_velocity"][:][rows])

    def test_frames_so_short_that_the_source_lags_behind_the_end_are_recorded_up_to_it(self):
        short = "\n[coupling]\nwindow_steps = 1\n"
        with record(BoxWorkspace(TREMOLO, **WAVES, duration=0.5)) as work:
            work.case.write_text(work.case.read_text() + short)
            self.replays(work, ["", ":right"])

    def test_a_recording_named_in_the_case_gives_the_same_bits(self):
        with record(BoxWorkspace(TREMOLO, **MIXED, duration=0.6)) as work:
            live = work.run("live")
            case = work.case.read_text()
            work.case.write_text(case.replace('left = { model = "fe" }',
                                              'left = { model = "recording", file = "live/exchange.h5", side = "left" }'))
            self.assertEqual([], differences(work.run("again"), live))

    def test_frames_hold_their_headers_and_checksums(self):
        with record(BoxWorkspace(TREMOLO, **MIXED, duration=0.4)) as work:
            live = work.run("live", "--mode", "lockstep")
            with h5py.File(live / "exchange.h5") as file:
                session = int(text(file.attrs["session"]), 16)
                frames = 0
                for source in file["sources"].values():
                    for number, name in enumerate(source.attrs["fields"]):
                        field = source[text(name)]
                        values = np.concatenate([field[q][:] for q in ("velocity", "stress", "velocity_rate", "stress_rate")], axis=2)
                        frames += self.check_frames(field["frames"][:], values, session, source.attrs["number"], number)
                domain = file["domain"]
                velocities = np.concatenate([domain["time"][:][:, None], domain["velocity"][:].reshape(len(domain["time"]), -1)], axis=1)
                frames += self.check_frames(domain["velocity_frames"][:], velocities, session, domain.attrs["number"], 0)
                tractions = np.concatenate([domain[q][:] for q in ("traction", "free_field_velocity", "free_field_stress")], axis=2)
                frames += self.check_frames(domain["traction_frames"][:], tractions, session, 0, 0)
            self.assertGreater(frames, 400)

    def check_frames(self, frames, values, session, sender, field):
        """Builds each frame as it was on the wire; its checksum must be the recorded one."""
        following = 0
        for first, steps, crc in frames.astype(np.int64):
            self.assertEqual(following, first)
            following = first + steps
            body = np.ascontiguousarray(values[first:following]).tobytes()
            count = len(body) // 8 // steps
            header = ("<4sHHQIIQIII20x", b"TRML", 2, 1, session, sender, field, first, steps, count)
            self.assertEqual(crc, zlib.crc32(struct.pack(*header, 0) + body))
        self.assertEqual(following, len(values))
        return len(frames)


class AcceptanceOtherModels(ReplayCase):
    def test_three_models_in_turn_and_all(self):
        with record(BoxWorkspace(TREMOLO, **MIXED)) as work:
            self.replays(work, [":left", ":base", ""])

    def test_oblique_waves_of_one_source_are_served_to_one_side_and_to_all(self):
        with record(BoxWorkspace(TREMOLO, **WAVES)) as work:
            self.replays(work, [":left", ":right", ":base", ""])

    def test_wet_ground_that_yields_under_a_wave_at_an_angle(self):
        with record(FlatWorkspace(TREMOLO, ground=UNDRAINED, water=WATER, velocity=0.3, duration=0.7)) as work:
            self.replays(work, [":left", ""], mode="lockstep")

    def test_a_slope_with_gravity_softening_and_two_surfaces(self):
        with record(SlopeWorkspace(TREMOLO, duration=0.8)) as work:
            self.replays(work, [":left", ":right", ":base", ""])


class OtherCases(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.work = cls.enterClassContext(record(BoxWorkspace(TREMOLO, **MIXED, duration=0.4)))
        cls.live, cls.text = cls.work.run("live"), cls.work.case.read_text()

    def setUp(self):
        self.work.case.write_text(self.text)

    def refusal(self, *changes, side=""):
        work, case = self.work, self.text
        for old, new in changes:
            self.assertIn(old, case)
            case = case.replace(old, new)
        other = work.path / "other.toml"
        other.write_text(case)
        result = work.command("run", other, "--replay", f"{self.live}{side}", "--out", work.path / "refused")
        self.assertEqual(1, result.returncode, result.stdout + result.stderr)
        for part in (work.path / "refused").rglob("*"):
            if part.is_file():
                part.unlink()
        (work.path / "refused" / "log").rmdir()
        return result.stderr

    def test_what_differs_is_said_with_both_values(self):
        angle = self.refusal(("velocity = 0.1", "velocity = 0.2"))
        self.assertIn("motion.pulse.velocity is 0.1 in the recording, 0.2 in the case", angle)
        mesh = self.refusal(("size = 0.5", "size = 1.0"), side=":base")
        self.assertIn("mesh.size is 0.5 in the recording, 1 in the case", mesh)
        ground = self.refusal(("[surface]\nlevel = 0.0\n\n[halfspace]\ndensity = 1700.0",
                               "[surface]\nlevel = 0.0\n\n[halfspace]\ndensity = 1750.0"), side=":right")
        self.assertIn("halfspace.density is 1700 in the recording, 1750 in the case", ground)
        numerics = self.refusal(("[mesh]", "[fe]\nelement_size = 0.125\n\n[mesh]"), side=":left")
        self.assertRegex(numerics, r"fe\.element_size is not given in the recording, 0\.125 in the case")

    def test_numerics_of_a_model_that_did_not_compute_the_side_do_not_matter(self):
        self.work.case.write_text(self.text.replace("[mesh]", "[ode]\ncell_size = 0.2\n\n[mesh]"))
        other = self.work.run("other", "--replay", f"{self.live}:left")
        self.assertEqual("complete", text(h5py.File(other / "run.h5").attrs["status"]))

    def test_another_domain_on_the_same_free_field_is_welcome(self):
        self.work.case.write_text(self.text.replace("[mesh]", '[time]\ntransfer = "flip"\n\n[mesh]'))
        flip = self.work.run("flip", "--replay", self.live)
        self.assertNotEqual([], differences(flip, self.live))

    def test_a_longer_run_is_refused_with_both_ranges(self):
        self.assertRegex(self.refusal(("duration_s = 0.4", "duration_s = 0.7")),
                         r"field 'total' is recorded from .* but the case asks for it from .* to 0\.7 s")

    def test_a_newer_schema_and_other_files_are_refused(self):
        work, live = self.work, self.work.path / "newer"
        shutil.copytree(self.live, live)
        with h5py.File(live / "exchange.h5", "r+") as file:
            file.attrs["schema_version"] = np.bytes_("2.0")
        result = work.command("run", work.case, "--replay", live, "--out", work.path / "unread")
        self.assertIn("schema version 2.0 cannot be read by this build, which knows 1.0", result.stderr)
        with h5py.File(live / "exchange.h5", "r+") as file:
            file.attrs["content"] = np.bytes_("free field")
        result = work.command("run", work.case, "--replay", live, "--out", work.path / "unread")
        self.assertIn("is no recording of an exchange", result.stderr)
        missing = work.command("run", work.case, "--replay", work.path / "none:left", "--out", work.path / "unread")
        self.assertIn("none: there is no such run or recording", missing.stderr)
        (work.path / "none").mkdir()
        missing = work.command("run", work.case, "--replay", work.path / "none:left", "--out", work.path / "unread")
        self.assertRegex(missing.stderr, r"holds no exchange\.h5; a run writes it where its case has \[record\] exchange = true")
        self.assertFalse((work.path / "unread").exists())


class Export(unittest.TestCase):
    def rows(self, path):
        with open(path, encoding="ascii") as file:
            reader = csv.reader(file)
            return next(reader), np.array([[float(cell) for cell in row] for row in reader])

    def test_a_side_and_the_domain_come_back_bit_for_bit(self):
        with record(BoxWorkspace(TREMOLO, **MIXED, duration=0.4)) as work:
            live = work.run("live", "--mode", "lockstep")
            for recording in (f"{live}:left", f"{live / 'exchange.h5'}:left"):
                exported = work.command("export", recording, "left.csv")
                self.assertEqual(0, exported.returncode, exported.stderr)
            header, rows = self.rows(work.path / "left.csv")
            self.assertEqual(["time", "y", "vx", "vy", "sxx", "syy", "sxy"], header)
            with h5py.File(live / "exchange.h5") as file:
                field = file["sources/left/total"]
                steps, levels, _ = field["velocity"].shape
                table = rows.reshape(steps, levels, 7)
                np.testing.assert_array_equal(table[:, :, 2:4], field["velocity"][:])
                np.testing.assert_array_equal(table[:, :, 4:], field["stress"][:])
                np.testing.assert_array_equal(table[5, :, 1], field["levels"][:])
                times = field.attrs["start_time"] + np.arange(steps) * field.attrs["time_step"]
                np.testing.assert_allclose(table[:, 0, 0], times, rtol=0.0, atol=1e-15)  # one rounding or two
                self.assertEqual(0, work.command("export", f"{live}:domain", "domain.csv").returncode)
                header, rows = self.rows(work.path / "domain.csv")
                self.assertEqual(["time", "x", "y", "vx", "vy", "tx", "ty"], header)
                steps, faces, _ = file["domain/velocity"].shape
                table = rows.reshape(steps, faces, 7)
                np.testing.assert_array_equal(table[:, :, 3:5], file["domain/velocity"][:])
                np.testing.assert_array_equal(table[:, :, 5:], file["domain/traction"][:])
                np.testing.assert_array_equal(table[0, :, 1], file["domain/faces/x"][:])

    def test_the_base_gives_the_field_it_takes(self):
        with record(SlopeWorkspace(TREMOLO, duration=0.2)) as work:
            live = work.run("live")
            base = work.command("export", f"{live}:base", "base.csv")
            self.assertIn("field 'incident', 1 levels", base.stdout)
            whole = work.command("export", live, "base.csv")
            self.assertEqual(1, whole.returncode)
            self.assertIn("say whose", whole.stderr)


if __name__ == "__main__":
    unittest.main()
