"""A source that is slow, stuck, or sends what it should not: rogue_source.py."""

import re

from fault_lab import require
from faults import DEADLINE, fault


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
    return "reported after 3 s; the same bits"


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


@fault("a source that never says HELLO, connect deadline 1.5 s", "ends at the deadline, the source named", in_suite=True)
def never_starts(faults):
    with faults.rogue("absent", connect=1.5) as run:
        return f"{run.must_fail('no HELLO from source .left. within 1.5 s', 4.0, run.started):.2f} s"


@fault("a source that starts 3 s late", "a normal run")
def starts_late(faults):
    with faults.rogue("late", 3) as run:
        run.must_succeed(faults.box())
    return "the same bits"


@fault("a source that ends with status 3, control characters in its last line", "status and last lines reported", in_suite=True)
def source_that_dies(faults):
    with faults.rogue("die") as run:
        run.must_fail(r"'left' exited with code 3.*\\x1b\[31mthe rogue has had enough", 10.0, run.started)
    return "its last line reported, the characters as bytes"


@fault("a source that stays after BYE", "killed after the shutdown deadline, which is said; the results are complete")
def deaf_at_the_end(faults):
    with faults.rogue("deaf") as run:
        run.must_succeed(faults.box())
        require("killed 'left', which was still there 2 s after the domain had finished" in run.output(), run.output())
    return "killed after 2 s; the same bits"


@fault("a source that ends with status 0 and without a BYE when it is dismissed", "said after the shutdown deadline; the results are complete")
def mute_at_the_end(faults):
    with faults.rogue("mute") as run:
        run.must_succeed(faults.box())
        require("no BYE of 'left', which ended well, came within 2 s after the domain had finished" in run.output(), run.output())
    return "said after 2 s; the same bits"


@fault("a source that closes its connection and stays silent, step deadline 2 s", "ends at the deadline, the source named")
def closed_connection(faults):
    with faults.rogue("close", step_deadline=DEADLINE) as run:
        run.must_fail("waits for source 'left'", 10.0, run.started)
    return "the source named"


@fault("a second process of the same name, during the run", "refused on both sides, the first undisturbed")
def duplicate(faults):
    with faults.rogue("duplicate") as run:
        run.must_succeed(faults.box())
        require("refused: 'left' is already taking part" in run.output(), run.output())
    return "refused; the same bits"


@fault("a source that comes back under its name", "refused, the run ends", in_suite=True)
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
       "4 KiB, none, a brace, a million brackets, BYE, a data frame, 64 MiB + 1", "ignored and noted, the same bits")
def strangers_at_the_socket(faults):
    return strangers(faults)


@fault("the same at the tcp port", "the same")
def strangers_at_the_port(faults):
    return strangers(faults, "--transport", "tcp")


def frame_fault(misdeed, injected, message, in_suite=False):
    def check(faults):
        for mode in ("window", "lockstep"):
            with faults.rogue(misdeed, mode=mode) as run:
                run.must_fail(message, 10.0, run.started)
        return "refused in both modes"
    check.__name__ = "frame_" + misdeed.replace("-", "_")
    fault(injected, "refused before use, found and expected reported", in_suite)(check)


frame_fault("nan", "a frame with NaN, checksum right", r"source 'left' sent nonsense: field 'total', step \d+: stress syy at y = -?[\d.]+ m \(point 0 of \d+\) is nan Pa, allowed are",
            in_suite=True)
frame_fault("inf", "a frame with Inf, checksum right", r"stress syy at y = .* is inf Pa, allowed are")
frame_fault("huge", "a frame with 1e200, checksum right", r"stress syy at y = .* is 1e\+200 Pa, allowed are -1e\+10 to 1e\+10 Pa")
frame_fault("unit", "another unit tag", "unit tag is 2, expected 1")
frame_fault("version", "another protocol version", "protocol version is 1, expected 2")
frame_fault("count", "ten values a step too few", "count of values per step is 200, expected 210")
frame_fault("repeat", "a frame sent twice", r"first step is \d+, expected \d+")
frame_fault("reorder", "two steps in the wrong order", r"first step is \d+, expected \d+")
frame_fault("session", "a frame of another run", r"session is \w+, expected \w+")
frame_fault("sender", "a frame in another's name", r"sender is 2, expected 1|sender is \d+, expected \d+")
frame_fault("field", "a field that is not served", "a frame of field 7, but it serves 1 fields")
frame_fault("crc", "a wrong checksum", r"CRC-32 is 12345, expected \d+", in_suite=True)
frame_fault("flip", "one bit flipped", r"CRC-32 is \d+, expected \d+|value \d+ of step")
frame_fault("truncate", "eight bytes missing", r"length in bytes is \d+, expected \d+")
frame_fault("two-gib", "a header that claims 2^32 - 1 steps", r"holds 4294967295 steps, expected 1 to \d+")
frame_fault("greedy", "5000 steps where 64 were asked for", r"holds 5000 steps, expected 1 to \d+")
frame_fault("empty", "a message of no bytes", "a message of 0 bytes is neither JSON nor a frame")
frame_fault("json", "a control message of unknown type", "control message: its type 'HALLO' is unknown")
frame_fault("broken-json", "half a control message", "control message: ")


def hello_fault(misdeed, injected, message, in_suite=False):
    def check(faults):
        with faults.rogue("hello-" + misdeed) as run:
            run.must_fail(message, 5.0, run.started)
            require(re.search(r"the hub says REFUSE", (run.out / "log/left.log").read_text()), "not reported to the participant")
        return "refused on both sides"
    check.__name__ = "hello_" + misdeed
    fault(injected, "refused with a message on both sides, no wait", in_suite)(check)


hello_fault("protocol", "HELLO of another protocol version", r"'left' \(build rogue\) says protocol = 1, the hub \(build [\d.]+\) has 2")
hello_fault("session", "HELLO of another run", r"'left' belongs to session 0123456789abcdef, which is not that of this run")
hello_fault("name", "HELLO under the domain's name", r"'domain' .*says role = source, the hub .* has domain|'domain' is already taking part")
hello_fault("unknown", "HELLO under a name the run does not have", "this run has no participant 'middle'")
hello_fault("units", "HELLO with other units", "says units = cgs, the hub .* has SI")
hello_fault("role", "HELLO in another role", "says role = domain, the hub .* has source")
hello_fault("case", "HELLO with another case", r"says case = 00000000, the hub .* has \w{8}; line \d+, \[mesh\]: 'size = 0.5' against 'size = 1.0'",
            in_suite=True)


hello_fault("steps", "HELLO with a field of -1 steps", r"'step_count' is -1, expected a whole number")
hello_fault("half-step", "HELLO with a field of 2000.5 steps", r"'step_count' is 2000\.5, expected a whole number")
hello_fault("twice", "HELLO with two fields of one name", "it serves two fields called 'total'")
hello_fault("colours", "HELLO with control characters in its build", r"\(build \\x1b\[31mred\\x1b\[0m\) says units = cgs")


@fault("HELLO behind an empty part, as a REQ socket sends it", "refused and reported")
def hello_delimiter(faults):
    with faults.rogue("delimiter") as run:
        run.must_fail("refused: a message of 2 parts, expected one", 5.0, run.started)
    return "refused and reported"


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
