"""Runs that are killed, and what a resumed one must be the same as."""

import os
import random
import signal
import subprocess
import sys
import time
from pathlib import Path

sys.path[:0] = [str(Path(__file__).parents[1] / "recordings")]

import h5py
import numpy as np
from recorded_case import BoxWorkspace, SlopeWorkspace, differences, model, record

__all__ = ["BoxWorkspace", "SlopeWorkspace", "checkpoints", "differences", "exchange_differences", "goes_on_with_the_same_bits", "killed",
           "model", "record", "resumed", "resumes_with_the_same_bits", "whole_run", "with_checkpoints"]


def with_checkpoints(work, **settings):
    """Adds [checkpoint] to the case of a workspace."""
    lines = "".join(f"{key} = {value}\n" for key, value in settings.items())
    work.case.write_text(work.case.read_text() + "\n[checkpoint]\n" + lines)
    return work


def checkpoints(folder):
    """Steps of the complete sets, the oldest first."""
    found = folder / "checkpoints"
    return sorted(int(s.name) for s in found.iterdir() if s.suffix != ".part") if found.is_dir() else []


def whole_run(work, *options):
    """The folder of a run that nobody breaks."""
    return work.run("whole", "--threads", 1, *options)


def resumed(work, folder, *options):
    return work.command("resume", folder, "--threads", 1, *options)


def participants(launcher):
    """Process ids of a run by name, the launcher's too."""
    found = {"tremolo": launcher}
    for child in Path(f"/proc/{launcher}/task/{launcher}/children").read_text().split():
        words = Path(f"/proc/{child}/cmdline").read_text().split("\0")
        if "--name" in words:
            found[words[words.index("--name") + 1]] = int(child)
    return found


def killed(work, folder, command, after_step, victim=None, chance=random):
    """Starts a command on a run's folder and kills one of its processes a moment after the checkpoint of a step.

    Returns the victim's name and the output, or None for the name if the run was over before."""
    with open(work.path / "output.txt", "w+") as output:
        run = subprocess.Popen([work.tremolo, *map(str, command), "--threads", "1"], cwd=work.path, stdout=output, stderr=subprocess.STDOUT)
        while run.poll() is None and max(checkpoints(folder), default=0) < after_step:
            time.sleep(0.002)
        time.sleep(chance.uniform(0.0, 0.05))
        name = None
        try:
            names = participants(run.pid)
            name = victim or chance.choice(sorted(names))
            os.kill(names[name], signal.SIGKILL)
        except (OSError, KeyError):
            name = None
        status = run.wait(timeout=60)
        output.seek(0)
        text = output.read()
    return (None if status == 0 or is_complete(folder) else name), text


def resumes_with_the_same_bits(test, work, whole, after_step):
    """Kills the domain of a run after the checkpoint of a step, and resumes it."""
    folder = work.path / "broken"
    victim, text = killed(work, folder, ["run", work.case, "--out", folder], after_step, victim="domain")
    test.assertEqual("domain", victim, text)
    result = resumed(work, folder)
    test.assertEqual(0, result.returncode, result.stdout + result.stderr)
    test.assertEqual([], differences(folder, whole))


def goes_on_with_the_same_bits(test, work, whole, before_last=400):
    """Breaks a run this many steps before the last checkpoint of a whole one, and resumes it; then tries two threads."""
    resumes_with_the_same_bits(test, work, whole, checkpoints(whole)[-1] - before_last)
    test.assertEqual([], differences(work.run("threads", "--threads", 2), whole))


def is_complete(folder):
    """Whether the domain had written all its results before anybody was killed."""
    try:
        with h5py.File(folder / "run.h5") as file:
            return file.attrs["status"] in ("complete", b"complete")
    except OSError:
        return False


def exchange_differences(folder, reference):
    """Names of the recorded quantities that are not the same bits, over the steps that both hold; the checksums of frames name the
    session, and a source may have been a frame further ahead when the run ended."""
    wrong = []
    with h5py.File(folder / "exchange.h5") as found, h5py.File(reference / "exchange.h5") as expected:
        names = []
        expected.visititems(lambda name, item: names.append(name) if isinstance(item, h5py.Dataset) else None)
        assert len(names) > 10, "the reference recording holds next to nothing"
        for name in names:
            if name == "case":
                continue
            if name not in found:
                wrong.append(name)
                continue
            a, b = found[name][()], expected[name][()]
            if name.endswith("frames"):
                a, b = a[:, :2], b[:, :2]
            if name.startswith("sources/"):
                steps = min(len(a), len(b))
                a, b = a[:steps], b[:steps]
                if steps == 0 and max(len(found[name]), len(expected[name])) > 64:
                    wrong.append(name)
            if np.asarray(a).tobytes() != np.asarray(b).tobytes():
                wrong.append(name)
    return wrong
