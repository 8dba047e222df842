"""What the machine, its owner and its other users may do to a run: sockets, keys, disks, descriptors, clocks."""

import os
import resource
import signal
import subprocess
import tempfile
from pathlib import Path

import zmq
from fault_lab import require
from faults import BRIEF, GONE, SLOPE_SOURCES, VERDICT, fault


def folder_left_by_a_kill(faults, parent):
    with faults.attack(duration=60.0, environment={"XDG_RUNTIME_DIR": parent}) as run:
        run.await_phase("stepping")
        run.process.kill()
        run.wait(GONE)
    return list(Path(parent).iterdir())


@fault("the socket's folder that a killed launcher left", "the next run removes it", in_suite=True)
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
    return "reported"


@fault("an address that other machines can reach, no keys", "refused by the participant")
def open_address(faults):
    with faults.attack() as run:
        run.await_phase("handshake")
        done = subprocess.run([Path(faults.tremolo).parent / "tremolo-wave", "--case", run.folder / "case.toml", "--name", "right",
                               "--endpoint", "tcp://10.255.255.1:5555"], capture_output=True, text=True,
                              env=os.environ | {"TREMOLO_SESSION": "0" * 16})
        require(done.returncode == 1 and "can be reached from other machines: it needs CURVE keys" in done.stderr, done.stderr)
        run.must_succeed()
    return "refused"


@fault("files may have 200 kB (RLIMIT_FSIZE)", "ends, file and reason reported, what was written is readable")
def file_size_limit(faults):
    limit = 200_000
    with faults.attack(duration=60.0, preexec=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit))) as run:
        # A source keeps its steps in a file too, which may be too large first.
        run.must_fail("(run.h5|cannot keep the free field in).*File too large", 60.0, run.started)
    return "reported; the file is readable"


@fault("output on a tmpfs of 400 kB", "ends, file and reason reported", in_suite=True)
def full_disk(faults):
    if os.geteuid() != 0:
        return "not tried: needs root"
    with tempfile.TemporaryDirectory(prefix="tf-") as disk:
        mounted = subprocess.run(["mount", "-t", "tmpfs", "-o", "size=400k", "tmpfs", disk], capture_output=True, text=True)
        if mounted.returncode != 0:
            return "not tried: " + mounted.stderr.strip()
        try:
            with faults.attack(duration=60.0, out=Path(disk) / "run") as run:
                run.must_fail("run/run.*: No space left on device", 60.0, run.started)
        finally:
            subprocess.run(["umount", disk], check=True)
    return "reported; the file is readable"


@fault("an output folder that cannot be written", "ends before any process starts")
def read_only_output(faults):
    with tempfile.TemporaryDirectory(prefix="tf-") as folder:
        out = Path("/proc/tremolo") if os.geteuid() == 0 else Path(folder) / "run"  # root may write anywhere else
        os.chmod(folder, 0o500)
        with faults.attack(out=out) as run:
            run.must_fail("cannot|denied|not permitted|No such file", 2.0)
            require(not run._seen, "a process was started")
        os.chmod(folder, 0o700)
    return "reported at once"


@fault("8, 10, ... 32 open files at most (ulimit -n)", "a normal run, or the reason reported at once")
def few_descriptors(faults):
    words = []
    for most in (8, 10, 12, 16, 20, 24, 32):
        with faults.attack(preexec=lambda: resource.setrlimit(resource.RLIMIT_NOFILE, (most, most))) as run:
            run.wait(60.0, run.started)
            require(run.process.returncode in (0, 1), run.output())
            require(run.process.returncode == 0 or "raise `ulimit -n`" in run.output(), run.output())
            words.append(f"{most}: {'runs' if run.process.returncode == 0 else 'reported'}")
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
