"""Processes that are killed, stopped, or reported to end."""

import os
import signal
import time

from fault_lab import alive, await_until, require
from faults import BRIEF, GONE, PROMPT, SLOPE_SOURCES, VERDICT, fault


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


@fault("Ctrl-C", "files closed, exit status 130", in_suite=True)
def interrupted(faults):
    with faults.attack(duration=60.0) as run:
        run.await_phase("stepping")
        run.process.send_signal(signal.SIGINT)
        return f"{run.must_fail('interrupted by Ctrl-C', PROMPT, status=130):.2f} s"


@fault("Ctrl-C while a checkpoint is saved", "the same")
def interrupted_at_a_checkpoint(faults):
    with faults.attack(duration=60.0, more="\n[checkpoint]\nevery_steps = 1\n") as run:
        run.await_phase("stepping")
        run.process.send_signal(signal.SIGINT)
        return f"{run.must_fail('interrupted by Ctrl-C', PROMPT, status=130):.2f} s"


@fault("SIGTERM", "files closed, exit status 143")
def terminated(faults):
    with faults.attack(duration=60.0) as run:
        run.await_phase("stepping")
        run.process.send_signal(signal.SIGTERM)
        return f"{run.must_fail('interrupted by SIGTERM', PROMPT, status=143):.2f} s"


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


@fault("SIGSTOP of a source for ever, step deadline 2 s", "the same, with field and step", in_suite=True)
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
