"""Two network namespaces in the place of two machines: nothing but the line between them connects their networks. They share
the files, as the machines of a cluster do.
"""

import itertools
import os
import re
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
_numbers = itertools.count()


def ip(*words, check=True):
    return subprocess.run(["ip", *words], check=check, capture_output=True, text=True)


def lacking():
    """Why there can be no namespaces here; None if there can."""
    if os.geteuid() != 0:
        return "network namespaces need root"
    name = f"tremolo-{os.getpid()}-try"
    try:
        made = ip("netns", "add", name, check=False)
    except FileNotFoundError:
        return "network namespaces need `ip` (package iproute2)"
    if made.returncode == 0:
        ip("netns", "del", name)
        return None
    return f"no network namespaces can be made here: {made.stderr.strip()}"


class TwoHosts:
    """The names of two namespaces, `here` and `there`, joined by a veth pair, or by a slow line that loses packets."""

    here_address, there_address = "10.77.0.1", "10.77.0.2"

    def __init__(self, delay=0.0, loss=0.0, seed=1):
        number = next(_numbers)
        self.here, self.there = (f"tremolo-{os.getpid()}-{number}{side}" for side in "ab")
        self._relay = None
        for namespace in (self.here, self.there):
            ip("netns", "add", namespace)
            ip("-n", namespace, "link", "set", "lo", "up")
        addresses = [f"{self.here_address}/24", f"{self.there_address}/24"]
        if delay or loss:
            self._relay = subprocess.Popen([sys.executable, "-B", str(HERE / "slow_line.py"), self.here, addresses[0], self.there,
                                            addresses[1], str(delay), str(loss), str(seed)], stdout=subprocess.PIPE, text=True)
            assert self._relay.stdout.readline() == "ready\n"
            return
        ip("link", "add", "line", "netns", self.here, "type", "veth", "peer", "name", "line", "netns", self.there)
        for namespace, address in zip((self.here, self.there), addresses):
            ip("-n", namespace, "addr", "add", address, "dev", "line")
            ip("-n", namespace, "link", "set", "line", "up")

    def __enter__(self):
        return self

    def __exit__(self, *_):
        if self._relay:
            self.packets()
        for namespace in (self.here, self.there):
            ip("netns", "del", namespace)

    def line(self, state):
        """Takes the line `down` or `up`."""
        ip("-n", self.there, "link", "set", "line", state)

    def packets(self):
        """Ends the slow line: how many packets it was given and how many of them it lost."""
        self._relay.terminate()
        sent, lost = re.match(r"(\d+) sent, (\d+) lost", self._relay.communicate()[0]).groups()
        self._relay = None
        return int(sent), int(lost)


def inside(namespace, words):
    """The words of a command, run in a namespace; None is this machine as it is."""
    return [*(["ip", "netns", "exec", namespace] if namespace else []), *map(str, words)]


def put_stubs(folder, namespace=None):
    """`ssh` and `srun` that run the command in a namespace, where it outlives them when they are killed, as on another machine. ssh
    takes nothing of the environment there, srun all."""
    go = {"ssh": inside(namespace, ["setsid", "--wait", "env", "-i", 'PATH="$PATH"']), "srun": inside(namespace, ["setsid", "--wait"])}
    stubs = {"ssh": 'while [ "$1" != "--" ]; do shift; done; shift 2', "srun": 'while [ "${1#-}" != "$1" ]; do shift; done'}
    starts = {"ssh": 'sh -c "$*"', "srun": '"$@"'}
    folder.mkdir(exist_ok=True)
    for name, words in stubs.items():
        (folder / name).write_text(f"#!/bin/sh\n{words}\nexec {' '.join(go[name])} {starts[name]}\n")
        (folder / name).chmod(0o755)
    return folder
