#!/usr/bin/python3
"""A source that does one thing wrong, named by TREMOLO_ROGUE: "MISDEED STEP". It speaks the protocol by hand, as
docs/wire-protocol.md describes it, and serves a field of its own on the left of the small box."""

import argparse
import math
import os
import random
import socket
import struct
import sys
import time
import zlib

import zmq

options = argparse.ArgumentParser()
for key in ("case", "name", "endpoint", "threads", "out", "connect-deadline", "step-deadline"):
    options.add_argument("--" + key)
options = options.parse_args()
SESSION = os.environ["TREMOLO_SESSION"]
MISDEED, AT = (os.environ["TREMOLO_ROGUE"].split() + ["none", "0"])[:2]
AT = int(AT)

POINTS, DT, STEPS, WINDOW = 21, 0.002, 1000, 64
LEVELS = [-10.0 + 0.5 * i for i in range(POINTS)]
COUNT = 10 * POINTS
HEAD = "<4sHHQIIQIII20x"


def connect():
    dealer = zmq.Context.instance().socket(zmq.DEALER)
    dealer.setsockopt(zmq.LINGER, 500)
    dealer.setsockopt(zmq.IMMEDIATE, 1)
    dealer.setsockopt(zmq.RCVTIMEO, int(1000 * float(options.connect_deadline) + 1000))
    dealer.connect(options.endpoint)
    return dealer


def hello(**changes):
    text = open(options.case).read()
    field = {"name": "total", "y": LEVELS, "x_reference": 0.0, "slowness_x": 0.0, "start_time": -0.1, "time_step": DT,
             "step_count": STEPS}
    crc = f"{zlib.crc32(text.encode()):08x}"
    return {"type": "HELLO", "protocol": 2, "session": SESSION, "name": options.name, "role": "source", "build": "rogue",
            "units": "SI", "case": crc, "case_text": text, "fields": [field], **changes}


def values(step):
    phase = 20.0 * (step * DT - 0.3)
    v, dv = (0.05 * math.exp(-phase**2), -2.0 * 20.0 * phase * 0.05 * math.exp(-phase**2))
    return [v, 0.0, 0.0, 0.0, 0.0, dv, 0.0, 0.0, 0.0, 0.0] * POINTS


def frame(first, steps, *, magic=b"TRML", version=2, units=1, session=None, sender=None, field=0, count=COUNT, body=None, crc=None,
          says=None):
    body = body or [x for n in range(first, first + steps) for x in values(n)]
    body = struct.pack(f"<{len(body)}d", *body)
    head = (HEAD, magic, version, units, int(SESSION, 16) if session is None else session,
            number if sender is None else sender, field, first, says or steps, count)
    crc = zlib.crc32(struct.pack(*head, 0) + body) if crc is None else crc
    return struct.pack(*head, crc) + body


def with_value(first, steps, value):
    body = [x for n in range(first, first + steps) for x in values(n)]
    body[3] = value
    return frame(first, steps, body=body)


def wrong_frames(first, steps):
    """What is sent in place of the frame [first, first + steps)."""
    good = frame(first, steps)
    return {
        "nan": lambda: [with_value(first, steps, math.nan)],
        "inf": lambda: [with_value(first, steps, math.inf)],
        "huge": lambda: [with_value(first, steps, 1e200)],
        "unit": lambda: [frame(first, steps, units=2)],
        "version": lambda: [frame(first, steps, version=1)],
        "count": lambda: [frame(first, steps, count=COUNT - 10, body=values(first)[10:] * steps)],
        "repeat": lambda: [good, good],
        "reorder": lambda: [frame(first + 1, 1), frame(first, 1)],
        "session": lambda: [frame(first, steps, session=1)],
        "sender": lambda: [frame(first, steps, sender=number + 1)],
        "field": lambda: [frame(first, steps, field=7)],
        "crc": lambda: [frame(first, steps, crc=12345)],
        "flip": lambda: [good[:500] + bytes([good[500] ^ 1]) + good[501:]],
        "truncate": lambda: [good[:-8]],
        "two-gib": lambda: [frame(first, 1, says=0xFFFFFFFF)],
        "greedy": lambda: [frame(first, 5000)],
        "empty": lambda: [b""],
        "json": lambda: [b'{"type": "HALLO"}'],
        "broken-json": lambda: [b'{"type": '],
    }.get(MISDEED, lambda: [good])()


def strangers():
    """Who else may knock at the hub's door; none may disturb the run."""
    path = options.endpoint.split("://", 1)[1]
    for text in (b"GET / HTTP/1.1\r\nHost: hub\r\n\r\n", random.Random(AT).randbytes(4096),
                 b"\x01\x00\x08\x00HELLO!!!",  # ZMTP 1.0: an identity, then a message of 9 bytes
                 b"\xff\x00\x00\x00\x00\x80\x00\x00\x01\x7f", b""):
        if options.endpoint.startswith("ipc"):
            stranger = socket.socket(socket.AF_UNIX)
            stranger.connect(path)
        else:
            stranger = socket.create_connection(path.split(":"))
        kept.append(stranger)
        try:
            stranger.sendall(text)
        except OSError:
            pass
    for message in (b"x" * 4096, b"", b"{", b"[" * 500_000 + b"]" * 500_000, b'{"type": "BYE"}', frame(0, 1, sender=1), b"y" * ((64 << 20) + 1)):
        dealer = connect()
        dealer.send(message)
        kept.append(dealer)


def misbehave_before(first):
    if MISDEED == "die":
        print("\x1b[31mthe rogue has had enough", file=sys.stderr)
        os._exit(3)
    if MISDEED == "pause":
        time.sleep(5.0)
    if MISDEED == "loop":
        while True:
            math.sin(first)
    if MISDEED == "circle":
        while True:
            hub.send_json({"type": "BEAT", "stage": "iterating", "done": 1})
            time.sleep(0.2)
    if MISDEED == "strangers":
        strangers()
    if MISDEED == "duplicate":
        second = connect()
        second.send_json(hello())
        assert second.recv_json()["type"] == "REFUSE"
        kept.append(second)
    if MISDEED == "restart":
        hub.close()
        again = connect()
        again.send_json(hello())
        raise SystemExit("the hub says: " + again.recv_json()["reason"])
    if MISDEED == "close":
        hub.close()
        time.sleep(1000.0)


kept = []
if MISDEED == "absent":
    time.sleep(1000.0)
if MISDEED == "late":
    time.sleep(AT)
hub = connect()
if MISDEED == "dumb":
    hub.send(b"hello")
    time.sleep(1000.0)
changes = {"hello-protocol": {"protocol": 1}, "hello-session": {"session": "0123456789abcdef"}, "hello-name": {"name": "domain"},
           "hello-unknown": {"name": "middle"}, "hello-units": {"units": "cgs"}, "hello-role": {"role": "domain"},
           "hello-case": {"case": "00000000", "case_text": open(options.case).read().replace("size = 1.0", "size = 0.5")},
           "hello-short": {"fields": []},
           "hello-steps": {"fields": [{**hello()["fields"][0], "step_count": -1}]},
           "hello-half-step": {"fields": [{**hello()["fields"][0], "step_count": 2000.5}]},
           "hello-twice": {"fields": [hello()["fields"][0]] * 2},
           "hello-colours": {"build": "\x1b[31mred\x1b[0m", "units": "cgs"},
           "hello-huge": {"fields": [{**hello()["fields"][0], "y": [float(i) for i in range(900_000)]}]},
           }.get(MISDEED, {})
if MISDEED == "delimiter":
    hub.send(b"", zmq.SNDMORE)
hub.send_json(hello(**changes))
sent = frames = 0
done = False
while True:
    message = hub.recv_json()
    if message["type"] == "WELCOME":
        number = message["number"]
    elif message["type"] == "CREDIT":
        while sent < message["steps"]:
            steps = min(WINDOW, message["steps"] - sent)
            if not done and sent + steps > AT:
                done = True
                misbehave_before(sent)
                for wrong in wrong_frames(sent, steps):
                    hub.send(wrong)
            else:
                hub.send(frame(sent, steps))
            if MISDEED == "slow":
                time.sleep(random.random() * 0.1)
            sent += steps
    elif message["type"] == "BYE":
        if MISDEED == "deaf":
            time.sleep(1000.0)
        if MISDEED == "mute":
            break
        hub.send_json({"type": "BYE", "passes": [], "waiting": 0.0})
        break
    elif message["type"] in ("REFUSE", "ABORT"):
        raise SystemExit(f"the hub says {message['type']}: {message['reason']}")
