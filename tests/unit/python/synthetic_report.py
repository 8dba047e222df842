"""The report of a synthetic run."""

import shutil
from pathlib import Path

import h5py

from test_pictures import run_command


def text_of_report(test, run, folder):
    """The report of a synthetic run, made in a folder; skips the test where Plotly is missing."""
    try:
        import plotly  # noqa: F401
    except ImportError:
        test.skipTest("python3-plotly is missing (scripts/setup.sh installs it)")
    copy = Path(folder) / "run.h5"
    shutil.copy(run, copy)
    with h5py.File(copy, "a") as file:
        del file["energy"]  # the synthetic ledger has no residual
    status, _, error = run_command("report", copy, "--out", Path(folder) / "report.html")
    test.assertEqual((0, ""), (status, error))
    return (Path(folder) / "report.html").read_text(encoding="utf-8")
