"""Runs under attack: starts `tremolo run` on a small model, finds its processes and phases, and judges how it ends."""

import os
import re
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import h5py

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "runs"))
import small_case
from processes import alive

HERE = Path(__file__).resolve().parent
PROGRAMS = {"mpirun", "tremolo-wave", "tremolo-column", "tremolo-domain", "rogue_source.py"}
PATIENCE = 60.0  # s, for what must come

COUPLING = """
[coupling]
mode = "{mode}"
window_steps = {window}
connect_deadline_s = {connect}
step_deadline_s = {step}
"""


class Failed(AssertionError):
    """A fault that did not end as promised."""


def require(condition, text):
    if not condition:
        raise Failed(text)


def await_until(condition, what):
    end = time.monotonic() + PATIENCE
    while time.monotonic() < end:
        if result := condition():
            return result
        time.sleep(0.002)
    raise Failed(f"{what} did not come within {PATIENCE:.0f} s")


def results(folder):
    """All numbers of a run but those that tell how long it took."""
    found = {}
    with h5py.File(folder / "run.h5") as file:
        status = file.attrs["status"]
        for group in ("frames", "monitors", "energy", "boundary"):
            if group not in file:
                continue
            if isinstance(file[group], h5py.Dataset):
                found[group] = file[group][()].tobytes()
            else:
                file[group].visititems(lambda name, item, group=group: found.update(
                    {f"{group}/{name}": item[()].tobytes()} if isinstance(item, h5py.Dataset) else {}))
    status = status.decode() if isinstance(status, bytes) else str(status)
    return status, found


class Attack:
    """One run; `folder` holds its case and its results."""

    def __init__(self, tremolo, *, template="slope", rogue=None, mode="window", window=64, connect=20.0, step=20.0, options=(), environment=None,
                 preexec=None, out=None, more="", change=None, **changes):
        self._temporary = tempfile.TemporaryDirectory(prefix="tf-")
        self.folder = Path(self._temporary.name)
        self.out = Path(out or self.folder / "run")
        # Sockets go to a folder of this run's own: what is left in it, the run has left.
        self.sockets = self.folder / "s"
        self.sockets.mkdir()
        text, defaults = ((small_case.SLOPE, small_case.SlopeWorkspace.defaults) if template == "slope" else
                          (small_case.CASE, small_case.DEFAULTS))
        text = text.format(**{**defaults, **changes}) + COUPLING.format(mode=mode, window=window, connect=connect, step=step) + more
        if change is not None:
            text = change(text)
        if rogue is not None:
            text = text.replace('left = { model = "wave" }',
                                f'left = {{ model = "external", program = "{HERE / "rogue_source.py"}" }}')
        case = self.folder / "case.toml"
        case.write_text(text)
        self._environment = {**os.environ, "XDG_RUNTIME_DIR": str(self.sockets), "TREMOLO_ROGUE": rogue or "",
                             **(environment or {})}
        self.started = time.monotonic()
        self._output = open(self.folder / "output", "w+")
        self.process = subprocess.Popen([tremolo, "run", str(case), "--out", str(self.out), *options], text=True,
                                        stdout=self._output, stderr=subprocess.STDOUT, env=self._environment,
                                        preexec_fn=preexec)
        self._seen = {}

    def __enter__(self):
        return self

    def __exit__(self, *_):
        for pid in [self.process.pid, *self._seen.values()]:
            if alive(pid):
                os.kill(pid, signal.SIGKILL)
        self.process.wait()
        self._output.close()
        self._temporary.cleanup()

    def participants(self):
        """Processes that the launcher has started: name in the run to process id."""
        try:
            pids = Path(f"/proc/{self.process.pid}/task/{self.process.pid}/children").read_text().split()
        except OSError:
            return {}
        for pid in map(int, pids):
            try:
                words = Path(f"/proc/{pid}/cmdline").read_bytes().decode().split("\0")
            except OSError:
                continue
            if any(Path(word).name in PROGRAMS for word in words[:2]) and "--name" in words:
                self._seen[words[words.index("--name") + 1]] = pid
        return {name: pid for name, pid in self._seen.items() if alive(pid)}

    def await_phase(self, phase):
        """handshake: a process is there; mapping: the boundary is declared; stepping: a frame is written."""
        if phase == "handshake":
            await_until(lambda: self.participants() or self.ended(), "a process")
        elif phase == "mapping":
            await_until(lambda: (self.out / "run.h5").exists() or self.ended(), "run.h5")
        elif phase == "stepping":
            await_until(lambda: self.ended() or self.frames() >= 2, "the second frame")
        self.participants()

    def frames(self):
        try:
            with h5py.File(self.out / "run.h5") as file:
                return len(file["frames"])
        except (OSError, KeyError):
            return 0

    def pid(self, victim):
        """Of "launcher", or of a participant; None if it is not there (yet, or any more)."""
        return self.process.pid if victim == "launcher" else self.participants().get(victim)

    def ended(self):
        return self.process.poll() is not None

    def output(self):
        self._output.flush()
        return (self.folder / "output").read_text(errors="replace")

    def endpoint(self):
        """The hub's address, as the participants are reported it."""
        words = Path(f"/proc/{next(iter(self.participants().values()))}/cmdline").read_bytes().decode().split("\0")
        return words[words.index("--endpoint") + 1]

    def wait(self, limit, since=None):
        """Seconds from `since` to the end of the last process; fails if somebody stays longer than `limit`."""
        since = since or time.monotonic()
        while time.monotonic() - since < limit + 5.0:
            if self.ended() and not any(alive(pid) for pid in self._seen.values()):
                seconds = time.monotonic() - since
                require(seconds <= limit, f"ended only after {seconds:.2f} s, promised are {limit} s")
                return seconds
            time.sleep(0.002)
        left = [name for name, pid in {**self._seen, "launcher": self.process.pid}.items() if alive(pid)]
        raise Failed(f"still there after {limit + 5.0:.1f} s: {left}; it said:\n{self.output()}")

    def must_fail(self, message, limit, since=None, status=1):
        """Ends within the limit, without success, with the cause reported once; nothing is left behind."""
        seconds = self.wait(limit, since)
        said = self.output()
        require(self.process.returncode == status, f"exit status {self.process.returncode}, expected {status}:\n{said}")
        require(re.search(message, said, re.DOTALL), f"the message lacks '{message}':\n{said}")
        require(not re.search(r"Traceback|terminate called|Assertion", re.sub(r"(?m)^    .*", "", said)), f"a stack trace:\n{said}")
        require(not list(self.sockets.iterdir()), f"sockets are left: {list(self.sockets.iterdir())}")
        if (self.out / "run.h5").exists():
            state, _ = results(self.out)
            require(state.startswith("aborted") or state == "complete", f"run.h5 says '{state}'")
        return seconds

    def must_succeed(self, expected=None, limit=120.0):
        """Ends well, with the results of the undisturbed run."""
        seconds = self.wait(limit, self.started)
        require(self.process.returncode == 0, f"exit status {self.process.returncode}:\n{self.output()}")
        state, found = results(self.out)
        require(state == "complete", f"run.h5 says '{state}'")
        if expected is not None:
            require(found.keys() == expected.keys(), "the runs hold different data")
            differ = [name for name in expected if found[name] != expected[name]]
            require(not differ, f"not the bits of the undisturbed run: {differ[:5]}")
        return seconds

    def numbers(self):
        return results(self.out)[1]
