"""Ranks that share the domain, and the mpirun that started them, are killed, stopped, or fail in a step."""

import os
import signal
import time

from fault_lab import await_until, require
from faults import BRIEF, DEADLINE, GONE, PROMPT, VERDICT, fault
from rank_lab import RankAttack, has_mpi

RANKS = (2, 3, 4)
# Where kills of a campaign fall, and how many of them.
PHASES = {"start-up": 0.2, "gravity stage": 0.2, "steps": 0.35, "a checkpoint": 0.15, "leaving": 0.1}
FRAMES = 5  # of all that a run writes, so many are there shortly before its end
SLOW = VERDICT + 2.0  # s: ranks that are more than processors
NO_MPI = "not tried: this build has no MPI"


class Timed:
    """A run of ranks that nobody disturbs: its results, and when its ranks are there, its first file, its last frames, and its end, s."""

    def __init__(self, faults, structures=False):
        with RankAttack(faults.tremolo, 3, structures) as run:
            self.has_mpi = has_mpi(faults.tremolo, run.folder / "case.toml")
            if not self.has_mpi:
                return
            clock = lambda: time.monotonic() - run.started
            await_until(lambda: "rank 2" in run.participants() or run.ended(), "the last rank")
            self.ranks = clock()
            run.await_phase("mapping")
            self.file = clock()
            await_until(lambda: run.ended() or run.frames() >= FRAMES, "the last frames")
            self.last_frames = clock()
            run.must_succeed()
            self.end = clock()
            self.results = run.numbers()


def is_of_ranks(fault):
    return fault.check.__module__ == __name__


def timed(faults, structures=False):
    name = "ranks_with_structures" if structures else "ranks"
    if not hasattr(faults, name):
        setattr(faults, name, Timed(faults, structures))
    return getattr(faults, name)


def await_moment(faults, run, phase, structures=False):
    """A moment of the phase, by chance."""
    whole, chance = timed(faults, structures), faults.random
    until = lambda seconds: time.sleep(max(0.0, run.started + seconds - time.monotonic()))
    if phase == "start-up":
        await_until(lambda: run.ended() or "rank 0" in run.participants(), "a rank")
        time.sleep(chance.uniform(0.0, 0.3))
    elif phase == "gravity stage":
        until(chance.uniform(whole.ranks, whole.file))
    elif phase == "steps":
        run.await_phase("mapping")
        time.sleep(chance.uniform(0.0, 0.8 * (whole.end - whole.file)))
    elif phase == "a checkpoint":
        await_until(lambda: run.ended() or run.checkpoints(), "a checkpoint")
        time.sleep(chance.uniform(0.0, 0.02))
    else:
        await_until(lambda: run.ended() or run.frames() >= FRAMES, "the last frames")
        time.sleep(chance.uniform(0.0, whole.end - whole.last_frames))
    run.participants()


def name_of(victim, phase):
    """How the message names a victim. mpirun does not always tell of a rank that dies while MPI comes up."""
    if victim == "domain":
        return "'domain' was killed by signal 9"
    rank = rf"process rank {victim.split()[1]} "
    return rf"{rank}|'domain' exited with code 137" if phase == "start-up" else rank


def killed_once(faults, phase, count, victim, structures=False):
    """SIGKILL to a rank or to mpirun; seconds until all are gone, and the number of ranks that went on, if a checkpoint was there.
    None if the run was over before."""
    with RankAttack(faults.tremolo, count, structures) as run:
        await_moment(faults, run, phase, structures)
        pid = run.pid(victim)
        if pid is None or run.ended():
            return None
        os.kill(pid, signal.SIGKILL)
        moment = time.monotonic()
        seconds = run.wait(GONE, moment)
        if run.process.returncode == 0 or "its results were complete before that" in run.output():
            return None  # it had done its work
        run.must_fail(name_of(victim, phase), GONE, moment)
        others = None
        if run.checkpoints():
            others = faults.random.choice([ranks for ranks in (1, 2, 3, 4) if ranks != count])
            run.resume(faults.tremolo, others, timed(faults, structures).results)
        return seconds, others


def killed_by_chance(faults, phase, structures=False):
    """Any rank of 2 to 4, or mpirun; tried until a living one is met."""
    for _ in range(20):
        count = faults.random.choice(RANKS)
        victim = faults.random.choice(["domain", *(f"rank {rank}" for rank in range(count))])
        if found := killed_once(faults, phase, count, victim, structures):
            return found
    raise AssertionError(f"no rank could be caught in {phase}")


def killed_in_phases(faults, structures=False):
    if not timed(faults, structures).has_mpi:
        return NO_MPI
    measured = [killed_by_chance(faults, phase, structures) for phase in PHASES if phase != "leaving"]
    resumed = sum(others is not None for _, others in measured)
    return f"{len(measured)} of {len(measured)} within 2 s, {resumed} resumed with another number; the longest {max(s for s, _ in measured):.2f} s"


@fault("kill -9 of a random rank of 2 to 4, or of mpirun, in its start, gravity stage, steps, a checkpoint",
       "all gone within 2 s, the victim named; others go on to the same bits")
def killed_rank(faults):
    return killed_in_phases(faults)


@fault("the same where a rigid and an elastic structure with a prop between them stand on the slope", "the same")
def killed_rank_with_structures(faults):
    return killed_in_phases(faults, structures=True)


@fault("SIGSTOP of a rank for ever, step deadline 2 s", "ends 1 s after the deadline, the domain named; nothing of it is left")
def stopped_rank(faults):
    if not timed(faults).has_mpi:
        return NO_MPI
    seconds = []
    for rank in (0, 2):
        with RankAttack(faults.tremolo, 3, **BRIEF) as run:
            run.await_phase("stepping")
            run.stop(f"rank {rank}")
            seconds.append(run.must_fail(r"the hub waits for the velocities of step \d+ of domain 'domain'.*last sign of life", SLOW))
    return f"rank 0: {seconds[0]:.2f} s, rank 2: {seconds[1]:.2f} s"


@fault("SIGSTOP of a rank for ever in the gravity stage, step deadline 2 s", "the same")
def stopped_rank_in_gravity(faults):
    if not timed(faults).has_mpi:
        return NO_MPI
    with RankAttack(faults.tremolo, 2, **{**BRIEF, "connect": DEADLINE}) as run:
        await_moment(faults, run, "gravity stage")
        run.stop("rank 1")
        # What the ranks have to do before they miss it comes on top.
        return f"{run.must_fail('domain', SLOW + timed(faults).file):.2f} s"


@fault("SIGSTOP of each rank and of mpirun for 1 s, then SIGCONT", "the same bits as undisturbed")
def stopped_and_continued_ranks(faults):
    if not timed(faults).has_mpi:
        return NO_MPI
    with RankAttack(faults.tremolo, 3) as run:
        run.await_phase("stepping")
        for victim in ("rank 0", "rank 1", "rank 2", "domain"):
            if run.pid(victim) is not None:
                run.stop(victim)
                time.sleep(1.0)
                run.go_on(victim)
        run.must_succeed(timed(faults).results)
    return "the same bits"


@fault("SIGSTOP of mpirun for ever", "steps go on; killed after the shutdown deadline, which is said; the results are complete")
def stopped_mpirun(faults):
    if not timed(faults).has_mpi:
        return NO_MPI
    with RankAttack(faults.tremolo, 2) as run:
        run.await_phase("stepping")
        run.stop("domain")
        run.must_succeed(timed(faults).results)
        require("killed 'domain', which was still there 2 s after the domain had finished" in run.output(), run.output())
    return "killed after 2 s; the same bits"


def failing(faults, rank):
    library = faults.clock.replace("jumping_clock", "failing_rank")
    call = str(faults.random.randrange(200, 2000))
    with RankAttack(faults.tremolo, 3, environment={"LD_PRELOAD": library, "TREMOLO_FAILING_RANK": str(rank), "TREMOLO_FAILING_CALL": call},
                    duration=60.0) as run:
        await_until(run.ended, "the end")
        reported = f"rank {rank} of the domain, on " if rank > 0 else "'domain' exited with code|this step fails on purpose"
        run.must_fail(rf"{reported}.*this step fails on purpose" if rank > 0 else reported, GONE)


@fault("a rank whose step throws", "all gone, the rank and its words reported", in_suite=True)
def failing_rank(faults):
    if not timed(faults).has_mpi:
        return NO_MPI
    failing(faults, 0)
    failing(faults, 2)
    return "reported, of rank 0 and of rank 2"


@fault("Ctrl-C in a run of ranks", "files closed, exit status 130, nothing of it is left")
def interrupted_ranks(faults):
    if not timed(faults).has_mpi:
        return NO_MPI
    with RankAttack(faults.tremolo, 3, duration=60.0) as run:
        run.await_phase("stepping")
        run.process.send_signal(signal.SIGINT)
        return f"{run.must_fail('interrupted by Ctrl-C', PROMPT, status=130):.2f} s"
