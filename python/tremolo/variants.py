"""Runs of cases that differ from one on disk in a few words, for studies."""

import subprocess
from pathlib import Path

from .run import Run


def variant(case, changes):
    """Text of a case file in which every key of `changes` is replaced by its value.

    A key that does not stand there exactly once ends the program, so that no study runs the unchanged case in silence.
    """
    text = Path(case).read_text()
    for old, new in changes.items():
        if text.count(old) != 1:
            raise SystemExit(f"{case}: expected exactly one '{old.strip()}'")
        text = text.replace(old, new)
    return text


def run_variant(tremolo, case, changes, folder, name):
    """The run `folder`/`name` of a variant; it is made unless it stands there already."""
    out = Path(folder) / name
    if not (out / "run.h5").exists():
        written = Path(folder) / f"{name}.toml"
        written.write_text(variant(case, changes))
        subprocess.run([tremolo, "run", written, "--out", out], check=True, stdout=subprocess.DEVNULL)
    return Run(out)


def cpu_time(run):
    """CPU time of all processes of a run, s."""
    return float(sum(run.table("processes")["cpu_time"]))
