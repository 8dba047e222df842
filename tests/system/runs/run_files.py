"""What the tests look at in the files of a run."""

import time

import h5py
from tremolo import Run
from tremolo.run import DamagedRun


def arrays(path):
    """Every dataset of a run but its timings, as bytes."""
    found = {}

    def visit(name, item):
        if isinstance(item, h5py.Dataset) and not name.startswith(("timings", "processes", "timeline")):
            found[name] = item[()].tobytes() if item.shape != () else item[()]

    with h5py.File(path / "run.h5") as file:
        file.visititems(visit)
    return found


def wait_for_frames(work, count=3):
    """Until the run has written some frames."""
    deadline = time.monotonic() + 60.0
    while time.monotonic() < deadline:
        try:
            if len(Run(work.path / "run").times) >= count:
                return
        except (OSError, DamagedRun):
            pass  # it is being written
        time.sleep(0.05)
    raise AssertionError("the run wrote no frames within 60 s")
