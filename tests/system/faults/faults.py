"""The faults that a run must survive or end well. Each is a function of a Faults that returns what was measured, in words,
and fails by an exception; FAULTS lists them with what is injected and what is promised."""

import dataclasses
import os
import random
import re
import resource
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path

import zmq

from fault_lab import Attack, Failed, alive, await_until, require

GONE = 2.0  # s, from a death to the end of the last process
DEADLINE = 2.0  # s, the step deadline where it is to pass
# Survivors have 1 s to close their files; the machine may be loaded.
VERDICT = DEADLINE + 3.0
# A wait begins when the domain has used up what it holds: little, with this window.
BRIEF = {"duration": 60.0, "step": DEADLINE, "window": 2}
SLOPE_SOURCES = ("left-base", "right")


@dataclasses.dataclass
class Fault:
    name: str
    injected: str
    promised: str
    check: Callable


FAULTS: list[Fault] = []


def fault(injected, promised):
    def register(check):
        FAULTS.append(Fault(check.__name__.replace("_", " "), injected, promised, check))
        return check
    return register


class Faults:
    """What the checks share: the program, the chance, the results of undisturbed runs."""

    def __init__(self, tremolo, clock, seed):
        self.tremolo, self.clock, self.random = tremolo, clock, random.Random(seed)
        self._reference = {}

    def attack(self, **options):
        return Attack(self.tremolo, **options)

    def rogue(self, misdeed, step=None, **options):
        """The small box with the rogue source on its left, at a random step of its 500."""
        step = self.random.randrange(500) if step is None else step
        return self.attack(template="box", rogue=f"{misdeed} {step}", step=options.pop("step_deadline", 20.0),
                           **{"angle": 0.0, **options})

    def undisturbed(self, start, key):
        """Results and wall time of the same run left alone."""
        if key not in self._reference:
            with start() as run:
                run.must_succeed()
                self._reference[key] = (run.numbers(), time.monotonic() - run.started)
        return self._reference[key]

    def slope(self):
        return self.undisturbed(self.attack, "slope")

    def box(self):
        return self.undisturbed(lambda: self.rogue("none"), "box")[0]


def kill_once(faults, victim, phase):
    """SIGKILL to a process at a random moment of a phase; seconds until nobody is left, or None if the run was over."""
    whole = faults.slope()[1]
    with faults.attack(duration=1.5 if phase == "shutdown" else 60.0) as run:
        if phase == "shutdown":
            time.sleep(max(0.0, whole - 0.15))
            run.participants()
            time.sleep(faults.random.uniform(0.0, 0.3))
        else:
            run.await_phase(phase)
            time.sleep(faults.random.uniform(0.0, 0.3 if phase == "stepping" else 0.05))
        pid = run.pid(victim)
        if pid is None or run.ended():
            return None
        os.kill(pid, signal.SIGKILL)
        moment = time.monotonic()
        if victim == "launcher":
            seconds = run.wait(GONE, moment)
            require(run.process.returncode == -signal.SIGKILL, f"exit status {run.process.returncode}")
            return seconds
        seconds = run.wait(GONE, moment)
        if run.process.returncode == 0:
            return None  # it had ended already
        return run.must_fail(f"'{victim}' was killed by signal 9", GONE + 0.5, moment) and seconds


def kills(faults, phase, count=4):
    measured = []
    for _ in range(10 * count):
        victim = faults.random.choice(["domain", "launcher", *SLOPE_SOURCES])
        if (seconds := kill_once(faults, victim, phase)) is not None:
            measured.append(seconds)
            if len(measured) == count:
                break
    require(measured, "no process could be caught in this phase")
    return f"{len(measured)} of {len(measured)} within 2 s; the longest {max(measured):.2f} s"


@fault("kill -9 of a random process, launcher included, as the processes say HELLO", "all gone within 2 s, the victim named")
def killed_in_handshake(faults):
    return kills(faults, "handshake")


@fault("the same when the domain declares its boundary", "the same")
def killed_in_mapping(faults):
    return kills(faults, "mapping")


@fault("the same while steps are exchanged", "the same")
def killed_while_stepping(faults):
    return kills(faults, "stepping")


@fault("the same around BYE", "the same, or the run had ended well")
def killed_at_shutdown(faults):
    return kills(faults, "shutdown", 2)


@fault("Ctrl-C", "files closed, exit status 130")
def interrupted(faults):
    with faults.attack(duration=60.0) as run:
        run.await_phase("stepping")
        run.process.send_signal(signal.SIGINT)
        return f"{run.must_fail('interrupted by Ctrl-C', 10.0, status=130):.2f} s"


@fault("SIGTERM", "files closed, exit status 143")
def terminated(faults):
    with faults.attack(duration=60.0) as run:
        run.await_phase("stepping")
        run.process.send_signal(signal.SIGTERM)
        return f"{run.must_fail('interrupted by SIGTERM', 10.0, status=143):.2f} s"


@fault("SIGSTOP of each process for 1 s, then SIGCONT", "the same bits as undisturbed")
def stopped_and_continued(faults):
    expected, _ = faults.slope()
    with faults.attack() as run:
        run.await_phase("stepping")
        for victim in ("domain", "launcher", *SLOPE_SOURCES):
            pid = run.pid(victim)
            if pid is not None:
                os.kill(pid, signal.SIGSTOP)
                time.sleep(1.0)
                os.kill(pid, signal.SIGCONT)
        run.must_succeed(expected)
    return "the same bits"


def stopped(faults, victim, message):
    with faults.attack(**BRIEF) as run:
        run.await_phase("stepping")
        os.kill(run.pid(victim), signal.SIGSTOP)
        return f"{run.must_fail(message, VERDICT):.2f} s"


@fault("SIGSTOP of the domain for ever, step deadline 2 s", "ends 1 s after the deadline, the domain named")
def domain_stopped(faults):
    return stopped(faults, "domain", r"the hub waits for the velocities of step \d+ of domain 'domain'.*last sign of life")


@fault("SIGSTOP of a source for ever, step deadline 2 s", "the same, with field and step")
def source_stopped(faults):
    return stopped(faults, "right", r"domain 'domain' waits for source 'right', field 'total', step \d+, since.*last sign of life")


@fault("SIGSTOP of the launcher for ever, step deadline 2 s", "the participants leave by themselves, when they have used up what they hold")
def launcher_stopped(faults):
    with faults.attack(**BRIEF) as run:
        run.await_phase("stepping")
        participants = run.participants()
        run.process.send_signal(signal.SIGSTOP)
        before = time.monotonic()
        await_until(lambda: not any(alive(pid) for pid in participants.values()), "the end of the participants")
        seconds = time.monotonic() - before
        require(seconds < VERDICT + 1.0,  # the hub is given a second more than the others
                f"they left after {seconds:.1f} s")
        run.process.send_signal(signal.SIGCONT)
        run.must_fail("last sign of life of the hub|exited with code 1", GONE)
        return f"{seconds:.2f} s"


@fault("a source that takes up to 0.1 s a frame", "no false alarm")
def slow_source(faults):
    with faults.rogue("slow") as run:
        run.must_succeed(faults.box())
    return "the same bits"


@fault("a source that pauses 5 s, step deadline 6 s", "a line about the wait, the same bits")
def pausing_source(faults):
    with faults.rogue("pause", 130, step_deadline=6.0) as run:
        run.must_succeed(faults.box())
        require(re.search(r"waits for source 'left', field 'total', step \d+, since 3", run.output()), run.output())
    return "told after 3 s; the same bits"


@fault("a source whose solver never returns, step deadline 2 s", "ends within the deadline + 1 s, the source named")
def solver_loop(faults):
    with faults.rogue("loop", 130, step_deadline=DEADLINE) as run:
        run.must_fail("waits for source 'left', field 'total', step 1[0-9]{2}", 10.0, run.started)
    return "the source named"


@fault("a source that beats but does not get on, step deadline 2 s", "the same")
def beating_solver_loop(faults):
    with faults.rogue("circle", 130, step_deadline=DEADLINE) as run:
        run.must_fail("waits for source 'left', field 'total', step 1[0-9]{2}", 10.0, run.started)
    return "the source named"


@fault("a source that never says HELLO, connect deadline 1.5 s", "ends at the deadline, the source named")
def never_starts(faults):
    with faults.rogue("absent", connect=1.5) as run:
        return f"{run.must_fail('no HELLO from source .left. within 1.5 s', 4.0, run.started):.2f} s"


@fault("a source that starts 3 s late", "a normal run")
def starts_late(faults):
    with faults.rogue("late", 3) as run:
        run.must_succeed(faults.box())
    return "the same bits"


@fault("a source that ends with status 3", "status and last lines told")
def source_that_dies(faults):
    with faults.rogue("die") as run:
        run.must_fail(r"'left' exited with code 3.*the rogue has had enough", 10.0, run.started)
    return "its last line told"


@fault("a source that stays after BYE", "killed after the shutdown deadline, which is said; the results are complete")
def deaf_at_the_end(faults):
    with faults.rogue("deaf") as run:
        run.must_succeed(faults.box())
        require("killed 'left', which was still there 2 s after the domain had finished" in run.output(), run.output())
    return "killed after 2 s; the same bits"


@fault("a source that closes its connection and stays silent, step deadline 2 s", "ends at the deadline, the source named")
def closed_connection(faults):
    with faults.rogue("close", step_deadline=DEADLINE) as run:
        run.must_fail("waits for source 'left'", 10.0, run.started)
    return "the source named"


def folder_left_by_a_kill(faults, parent):
    with faults.attack(duration=60.0, environment={"XDG_RUNTIME_DIR": parent}) as run:
        run.await_phase("stepping")
        run.process.kill()
        run.wait(GONE)
    return list(Path(parent).iterdir())


@fault("the socket's folder that a killed launcher left", "the next run removes it")
def stale_socket(faults):
    with tempfile.TemporaryDirectory(prefix="tf-") as parent:
        left = folder_left_by_a_kill(faults, parent)
        require(len(left) == 1, f"{left}")
        with faults.attack(environment={"XDG_RUNTIME_DIR": parent}) as run:
            run.must_succeed(faults.slope()[0])
        require(not list(Path(parent).iterdir()), "it is still there")
    return "removed; the same bits"


@fault("a folder for the socket with a path of 120 bytes", "refused before anything starts")
def long_path(faults):
    with tempfile.TemporaryDirectory(prefix="tf-") as parent:
        deep = Path(parent) / ("x" * 100)
        deep.mkdir()
        with faults.attack(environment={"XDG_RUNTIME_DIR": str(deep)}) as run:
            run.must_fail("at most 107 are possible", 2.0)
    return "refused"


@fault("tcp in place of ipc, four runs at once", "each finds a port of its own")
def ports(faults):
    expected = faults.box()
    runs = [faults.rogue("none", options=("--transport", "tcp")) for _ in range(4)]
    try:
        for run in runs:
            run.must_succeed(expected)
    finally:
        for run in runs:
            run.__exit__()
    return "the same bits four times"


def make_keys(faults, folder, *names):
    done = subprocess.run([faults.tremolo, "keygen", folder, *names], capture_output=True, text=True)
    require(done.returncode == 0, done.stderr)


@fault("tcp with CURVE keys; two strangers, one without keys, one with a pair of its own", "nothing of theirs gets in, the same bits")
def strangers_at_curve(faults):
    with tempfile.TemporaryDirectory(prefix="tf-") as keys:
        make_keys(faults, keys, "domain", *SLOPE_SOURCES)
        expected = faults.slope()[0]
        with faults.attack(options=("--transport", "tcp", "--keys", keys)) as run:
            run.await_phase("stepping")
            context, strangers = zmq.Context(), []
            for pair in (None, zmq.curve_keypair()):
                stranger = context.socket(zmq.DEALER)
                stranger.linger = 0
                if pair:
                    stranger.curve_publickey, stranger.curve_secretkey = pair
                    stranger.curve_serverkey = Path(keys, "hub.public").read_bytes().strip()
                stranger.connect(run.endpoint())
                stranger.send(b"x" * 4096)
                strangers.append(stranger)
            run.must_succeed(expected)
            context.destroy()
            require("stranger" not in run.output(), run.output())
    return "the same bits"


@fault("tcp with CURVE keys, one participant's key is missing", "refused before anything starts")
def missing_key(faults):
    with tempfile.TemporaryDirectory(prefix="tf-") as keys:
        make_keys(faults, keys, "domain", SLOPE_SOURCES[0])
        with faults.attack(options=("--transport", "tcp", "--keys", keys)) as run:
            run.must_fail(r"cannot read the key .*/right.public; `tremolo keygen` makes keys", 2.0)
    return "told"


@fault("an address that other machines can reach, no keys", "refused by the participant")
def open_address(faults):
    with faults.attack() as run:
        run.await_phase("handshake")
        done = subprocess.run([Path(faults.tremolo).parent / "tremolo-wave", "--case", run.folder / "case.toml", "--name", "right",
                               "--endpoint", "tcp://10.255.255.1:5555", "--session", "0" * 16], capture_output=True, text=True)
        require(done.returncode == 1 and "can be reached from other machines: it needs CURVE keys" in done.stderr, done.stderr)
        run.must_succeed()
    return "refused"


@fault("a second process of the same name, during the run", "refused on both sides, the first undisturbed")
def duplicate(faults):
    with faults.rogue("duplicate") as run:
        run.must_succeed(faults.box())
        require("refused: 'left' is already taking part" in run.output(), run.output())
    return "refused; the same bits"


@fault("a source that comes back under its name", "refused, the run ends")
def restarted_peer(faults):
    with faults.rogue("restart") as run:
        run.must_fail("'left' is already taking part in this run; a second one was refused", 10.0, run.started)
    return "refused"


def strangers(faults, *options):
    with faults.rogue("strangers", options=options) as run:
        run.must_succeed(faults.box())
        for said in ("ignored 4096 bytes from a stranger", "refused: BYE before HELLO"):
            require(said in run.output(), run.output())
    return "noted; the same bits"


@fault("strangers at the ipc socket: HTTP, 4 KiB of random bytes, a ZMTP 1.0 greeting, half a greeting, silence; messages of "
       "4 KiB, none, a brace, BYE, a data frame, 64 MiB + 1", "ignored and noted, the same bits")
def strangers_at_the_socket(faults):
    return strangers(faults)


@fault("the same at the tcp port", "the same")
def strangers_at_the_port(faults):
    return strangers(faults, "--transport", "tcp")


def frame_fault(misdeed, injected, message):
    def check(faults):
        for mode in ("window", "lockstep"):
            with faults.rogue(misdeed, mode=mode) as run:
                run.must_fail(message, 10.0, run.started)
        return "refused in both modes"
    check.__name__ = "frame_" + misdeed.replace("-", "_")
    fault(injected, "refused before use, found and expected told")(check)


frame_fault("nan", "a frame with NaN, checksum right", r"source 'left' sent nonsense: field 'total', step \d+: value 3 of step \d+ is nan")
frame_fault("inf", "a frame with Inf, checksum right", r"value 3 of step \d+ is inf")
frame_fault("unit", "another unit tag", "unit tag is 2, expected 1")
frame_fault("version", "another protocol version", "protocol version is 2, expected 1")
frame_fault("count", "ten values a step too few", "count of values per step is 200, expected 210")
frame_fault("repeat", "a frame sent twice", r"first step is \d+, expected \d+")
frame_fault("reorder", "two steps in the wrong order", r"first step is \d+, expected \d+")
frame_fault("session", "a frame of another run", r"session is \w+, expected \w+")
frame_fault("sender", "a frame in another's name", r"sender is 2, expected 1|sender is \d+, expected \d+")
frame_fault("field", "a field that is not served", "a frame of field 7, but it serves 1 fields")
frame_fault("crc", "a wrong checksum", r"CRC-32 is 12345, expected \d+")
frame_fault("flip", "one bit flipped", r"CRC-32 is \d+, expected \d+|value \d+ of step")
frame_fault("truncate", "eight bytes missing", r"length in bytes is \d+, expected \d+")
frame_fault("two-gib", "a header that claims 2^32 - 1 steps", r"holds 4294967295 steps, expected 1 to \d+")
frame_fault("greedy", "5000 steps where 64 were asked for", r"holds 5000 steps, expected 1 to \d+")
frame_fault("empty", "a message of no bytes", "a message of 0 bytes is neither JSON nor a frame")
frame_fault("json", "a control message of unknown type", "control message of unknown type 'HALLO'")
frame_fault("broken-json", "half a control message", "control message: ")


def hello_fault(misdeed, injected, message):
    def check(faults):
        with faults.rogue("hello-" + misdeed) as run:
            run.must_fail(message, 5.0, run.started)
            require(re.search(r"the hub says REFUSE", (run.out / "log/left.log").read_text()), "not told to the participant")
        return "refused on both sides"
    check.__name__ = "hello_" + misdeed
    fault(injected, "refused with a message on both sides, no wait")(check)


hello_fault("protocol", "HELLO of another protocol version", r"'left' \(build rogue\) says protocol = 2, the hub \(build [\d.]+\) has 1")
hello_fault("session", "HELLO of another run", r"'left' belongs to session 0123456789abcdef, this run is \w{16}")
hello_fault("name", "HELLO under the domain's name", r"'domain' .*says role = source, the hub .* has domain|'domain' is already taking part")
hello_fault("unknown", "HELLO under a name the run does not have", "this run has no participant 'middle'")
hello_fault("units", "HELLO with other units", "says units = cgs, the hub .* has SI")
hello_fault("role", "HELLO in another role", "says role = domain, the hub .* has source")
hello_fault("case", "HELLO with another case", r"says case = 00000000, the hub .* has \w{8}; line \d+, \[mesh\]: 'size = 0.5' against 'size = 1.0'")


@fault("HELLO without the field that is asked for", "ends, the field named")
def hello_short(faults):
    with faults.rogue("hello-short") as run:
        run.must_fail("field 'total'|does not serve", 10.0, run.started)
    return "the field named"


@fault("HELLO with a field of 900,000 points, more than a message may hold", "refused before any step")
def hello_huge(faults):
    with faults.rogue("hello-huge") as run:
        run.must_fail("larger than what is taken", 10.0, run.started)
    return "refused"


@fault("files may have 200 kB (RLIMIT_FSIZE)", "ends, file and reason told, what was written is readable")
def file_size_limit(faults):
    limit = 200_000
    with faults.attack(duration=60.0, preexec=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit))) as run:
        run.must_fail("run.h5.*File too large", 60.0, run.started)
    return "told; the file is readable"


@fault("output on a tmpfs of 400 kB", "ends, file and reason told")
def full_disk(faults):
    if os.geteuid() != 0:
        return "not tried: needs root"
    with tempfile.TemporaryDirectory(prefix="tf-") as disk:
        mounted = subprocess.run(["mount", "-t", "tmpfs", "-o", "size=400k", "tmpfs", disk], capture_output=True, text=True)
        if mounted.returncode != 0:
            return "not tried: " + mounted.stderr.strip()
        try:
            with faults.attack(duration=60.0, out=Path(disk) / "run") as run:
                run.must_fail("run.h5.*No space left on device|is the disk full", 60.0, run.started)
        finally:
            subprocess.run(["umount", disk], check=True)
    return "told; the file is readable"


@fault("an output folder that cannot be written", "ends before any process starts")
def read_only_output(faults):
    with tempfile.TemporaryDirectory(prefix="tf-") as folder:
        out = Path("/proc/tremolo") if os.geteuid() == 0 else Path(folder) / "run"  # root may write anywhere else
        os.chmod(folder, 0o500)
        with faults.attack(out=out) as run:
            run.must_fail("cannot|denied|not permitted|No such file", 2.0)
            require(not run._seen, "a process was started")
        os.chmod(folder, 0o700)
    return "told at once"


@fault("8, 10, ... 32 open files at most (ulimit -n)", "a normal run, or the reason told at once")
def few_descriptors(faults):
    words = []
    for most in (8, 10, 12, 16, 20, 24, 32):
        with faults.attack(preexec=lambda: resource.setrlimit(resource.RLIMIT_NOFILE, (most, most))) as run:
            run.wait(60.0, run.started)
            require(run.process.returncode in (0, 1), run.output())
            require(run.process.returncode == 0 or "raise `ulimit -n`" in run.output(), run.output())
            words.append(f"{most}: {'runs' if run.process.returncode == 0 else 'told'}")
    return ", ".join(words)


@fault("a wall clock that jumps an hour forth and back ten times a second in every process", "the same bits, no deadline passes")
def jumping_clock(faults):
    with faults.attack(environment={"LD_PRELOAD": faults.clock}) as run:
        run.must_succeed(faults.slope()[0])
    with faults.attack(**BRIEF, environment={"LD_PRELOAD": faults.clock}) as run:
        run.await_phase("stepping")
        os.kill(run.pid("right"), signal.SIGSTOP)
        run.must_fail("domain 'domain' waits for source 'right'", VERDICT)
    return "the same bits; a deadline of 2 s still passes after 2 s"
