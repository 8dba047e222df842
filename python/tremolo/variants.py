"""Runs of cases that differ from one on disk in a few words, for studies."""

import re
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


def run_column(tremolo, case, changes, folder, name, model, *options):
    """The free field of a variant alone, `folder`/`name`.h5, and its CPU time, s; it is made unless it stands there already.

    options: of `tremolo column`, such as "--every", "0.1"
    """
    out, printed = (Path(folder) / f"{name}{end}" for end in (".h5", ".txt"))
    if not printed.exists():
        written = Path(folder) / f"{name}_column.toml"
        written.write_text(variant(case, changes))
        done = subprocess.run([tremolo, "column", written, "--model", model, "--out", out, *options],
                              check=True, capture_output=True, text=True)
        printed.write_text(done.stdout)
    return out, float(re.search(r"([\d.]+) s CPU", printed.read_text())[1])


def cpu_time(run):
    """CPU time of all processes of a run, s."""
    return float(sum(run.table("processes")["cpu_time"]))
