"""A free-field model of one's own as a process of a run: the wire protocol (docs/wire-protocol.md) for sources.

    def motion(y, t):                 # elevations [points], m, and times [times], s
        ...
        return values                 # [times, points, 5]: vx, vy (m/s), sxx, syy, sxy (Pa, tension positive)

    Participant().serve([Field("total", motion, levels, start_time, time_step, step_count)])

The function says what moves at which points and when; this module does the rest: the command line that `tremolo
run` gives a process, the handshake, credit, frames, deadlines. It needs pyzmq and numpy.
"""

import argparse
import dataclasses
import json
import os
import struct
import time
import tomllib
import zlib
from collections.abc import Callable
from pathlib import Path

import numpy as np
import zmq

PROTOCOL = 2
VALUES_PER_POINT = 10
HEADER = struct.Struct("<4sHHQIIQIII20x")
OPTIONS = ("case", "name", "endpoint", "threads", "out", "connect-deadline", "step-deadline")


class RunEnded(SystemExit):
    """The run was ended by another's failure, or its hub is gone; ends this process with the reason."""


@dataclasses.dataclass
class Field:
    """What a source serves: motion on the vertical line x = x_reference.

    name         "total", with the free surface, or "incident", the upgoing wave alone
    motion       a function of (y, t) as above; it may append the time derivatives of the five values, otherwise they
                 are found by differences. It is asked for each step once, in ascending order, several times in a call
    y            elevations of the points, m, ascending; two equal ones are an interface of layers
    start_time   s, of step 0; step n is at start_time + n time_step
    slowness_x   s/m: at another x the motion is the same, later by slowness_x (x - x_reference)
    """

    name: str
    motion: Callable
    y: np.ndarray
    start_time: float
    time_step: float
    step_count: int
    x_reference: float = 0.0
    slowness_x: float = 0.0

    def __post_init__(self):
        self.y = np.asarray(self.y, dtype=float)
        if self.y.ndim != 1 or len(self.y) < 2 or np.any(np.diff(self.y) < 0.0) or not np.all(np.isfinite(self.y)):
            raise ValueError(f"field '{self.name}': y = {self.y}, must be two or more finite elevations, ascending")
        if not (np.isfinite(self.time_step) and self.time_step > 0.0):
            raise ValueError(f"field '{self.name}': time_step = {self.time_step} s, must be finite and > 0")
        if self.step_count != int(self.step_count) or self.step_count < 2:
            raise ValueError(f"field '{self.name}': step_count = {self.step_count}, must be a whole number, 2 or more")
        self.step_count = int(self.step_count)

    def times(self, first, count):
        """Times of steps [first, first + count), s."""
        return self.start_time + self.time_step * np.arange(first, first + count)

    def values(self, first, count):
        """Values and rates of steps [first, first + count), [count, points, 10]. Rates that the model does not give
        are fourth-order central differences over half a step."""
        t, points = self.times(first, count), len(self.y)
        values = np.asarray(self.motion(self.y, t), dtype=float)
        if values.shape == (count, points, VALUES_PER_POINT):
            return values
        if values.shape != (count, points, VALUES_PER_POINT // 2):
            raise ValueError(f"field '{self.name}': the model returned an array of shape {values.shape} for {count} "
                             f"times and {points} points; wanted is ({count}, {points}, 5), or 10 with the rates")
        e = 0.25 * self.time_step
        near, far = (self.motion(self.y, t + d) - self.motion(self.y, t - d) for d in (e, 2.0 * e))
        return np.concatenate([values, (8.0 * near - far) / (12.0 * e)], axis=2)


class Participant:
    """A source of a run.

    .case   the case file as a dictionary, for a model that wants to know its soil or the size of the box
    """

    def __init__(self, arguments=None):
        parser = argparse.ArgumentParser(description="A free-field model; started by `tremolo run` or `tremolo conform`.")
        for option in OPTIONS:
            parser.add_argument("--" + option, required=option not in ("threads", "out"))
        parser.add_argument("--keys", help="folder of CURVE keys, for a hub on another machine")
        self._options = parser.parse_args(arguments)
        self._session = os.environ.get("TREMOLO_SESSION")
        if self._session is None:
            parser.error("TREMOLO_SESSION is not set: the run that starts this process gives it its session there")
        with open(self._options.case, "rb") as file:
            self._text = file.read()
        self.case = tomllib.loads(self._text.decode("utf-8"))

    def serve(self, fields):
        """Serves the fields until the domain has finished."""
        steps_per_frame = self._introduce(fields)
        sent, computing, waiting = [0] * len(fields), 0.0, 0.0
        while True:
            started = time.monotonic()
            message = self._receive()
            waiting += time.monotonic() - started
            if message["type"] == "BYE":
                self._say(type="BYE", passes=[{"name": "motion", "seconds": computing}], waiting=waiting)
                self._socket.close()
                return
            if message["type"] != "CREDIT":
                continue
            f = message["field"]
            field, credit = fields[f], min(message["steps"], fields[f].step_count)
            most = steps_per_frame[f]
            while credit - sent[f] >= most or sent[f] < credit == field.step_count:
                steps = min(most, credit - sent[f])
                started = time.monotonic()
                values = field.values(sent[f], steps)
                computing += time.monotonic() - started
                self._send_frame(f, sent[f], values)
                sent[f] += steps

    def beat(self, done):
        """A sign of life, for a model that computes longer than the step deadline between two calls; `done` says how
        much of the work is done, and only a beat that reports more than the last one prolongs the deadline."""
        self._say(type="BEAT", stage="computing", done=done)

    def _introduce(self, fields):
        options = self._options
        self._socket = zmq.Context.instance().socket(zmq.DEALER)
        self._socket.setsockopt(zmq.LINGER, 500)
        self._socket.setsockopt(zmq.IMMEDIATE, 1)
        # The hub knows more than a participant does: its verdict on a deadline comes first.
        self._socket.setsockopt(zmq.RCVTIMEO, int(1000.0 * (float(options.connect_deadline) + 1.0)))
        self._socket.setsockopt(zmq.SNDTIMEO, int(1000.0 * float(options.step_deadline)))
        if options.keys:
            own_public, own_secret, hub = (Path(options.keys, name).read_bytes().strip() for name in (
                options.name + ".public", options.name + ".secret", "hub.public"))
            self._socket.curve_publickey, self._socket.curve_secretkey = own_public, own_secret
            self._socket.curve_serverkey = hub
        self._socket.connect(options.endpoint)
        described = [vars(field) | {"y": field.y.tolist()} for field in fields]
        for field in described:
            del field["motion"]
        self._say(type="HELLO", protocol=PROTOCOL, session=self._session, name=options.name, role="source",
                  build=f"python, pyzmq {zmq.__version__}", units="SI", case=f"{zlib.crc32(self._text):08x}",
                  case_text=self._text.decode("utf-8"), fields=described)
        while (welcome := self._receive())["type"] != "WELCOME":
            pass
        self._number = welcome["number"]
        self._socket.setsockopt(zmq.RCVTIMEO, int(1000.0 * (float(options.step_deadline) + 1.0)))
        own = next(source for source in welcome["sources"] if source["number"] == self._number)
        return [field["steps_per_frame"] for field in own["fields"]]

    def _say(self, **message):
        self._socket.send(json.dumps(message).encode("utf-8"))

    def _receive(self):
        try:
            message = json.loads(self._socket.recv())
        except zmq.Again:
            seconds = self._socket.getsockopt(zmq.RCVTIMEO) / 1000.0
            raise RunEnded(f"'{self._options.name}' has heard nothing from the hub for {seconds:.0f} s") from None
        if message["type"] in ("ABORT", "REFUSE"):
            raise RunEnded(f"'{self._options.name}': the hub says {message['type']}: {message['reason']}")
        return message

    def _send_frame(self, field, first, values):
        if not np.all(np.isfinite(values)):
            step, point, _ = np.argwhere(~np.isfinite(values))[0]
            reason = (f"source '{self._options.name}', field {field}: the model's value at step {first + step}, "
                      f"point {point} is not finite")
            self._say(type="ABORT", reason=reason)
            raise RunEnded(reason)
        body = values.astype("<f8").tobytes()
        head = [b"TRML", PROTOCOL, 1, int(self._session, 16), self._number, field, first, len(values),
                values[0].size]
        crc = zlib.crc32(HEADER.pack(*head, 0) + body)
        self._socket.send(HEADER.pack(*head, crc) + body)
