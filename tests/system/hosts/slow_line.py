"""A slow line between two network namespaces that loses packets, for kernels without netem.

    usage: slow_line.py NAMESPACE ADDRESS/BITS NAMESPACE ADDRESS/BITS DELAY_S LOSS SEED

Each namespace gets a TUN interface `line`; what the kernel sends into one comes out of the other DELAY_S seconds later, or,
by chance, never. TCP repairs the loss as it does on a real line. Prints `ready`; at SIGTERM `PACKETS sent, N lost`.
"""

import ctypes
import fcntl
import heapq
import os
import random
import select
import signal
import struct
import subprocess
import sys
import time

CLONE_NEWNET = 0x40000000
TUNSETIFF, IFF_TUN, IFF_NO_PI = 0x400454CA, 0x0001, 0x1000
LIBC = ctypes.CDLL(None, use_errno=True)


def enter(descriptor):
    if LIBC.setns(descriptor, CLONE_NEWNET) != 0:
        raise OSError(ctypes.get_errno(), "setns")


def tunnel_end(namespace, address):
    """A TUN interface in a namespace; it stays there when we have left."""
    home = os.open("/proc/self/ns/net", os.O_RDONLY)
    enter(os.open(f"/var/run/netns/{namespace}", os.O_RDONLY))
    end = os.open("/dev/net/tun", os.O_RDWR | os.O_NONBLOCK)
    fcntl.ioctl(end, TUNSETIFF, struct.pack("16sH", b"line", IFF_TUN | IFF_NO_PI))
    for words in (["addr", "add", address, "dev", "line"], ["link", "set", "line", "up"]):
        subprocess.run(["ip", *words], check=True)
    enter(home)
    return end


def main(one, one_address, two, two_address, delay, loss, seed):
    ends = [tunnel_end(one, one_address), tunnel_end(two, two_address)]
    other = dict(zip(ends, reversed(ends)))
    chance, under_way, sent, lost = random.Random(int(seed)), [], 0, 0
    over = []
    signal.signal(signal.SIGTERM, lambda *_: over.append(True))
    print("ready", flush=True)
    while not over:
        wait = under_way[0][0] - time.monotonic() if under_way else 0.1
        for end in select.select(ends, [], [], max(0.0, min(wait, 0.1)))[0]:
            packet = os.read(end, 65536)
            sent += 1
            if chance.random() < float(loss):
                lost += 1
            else:
                heapq.heappush(under_way, (time.monotonic() + float(delay), sent, other[end], packet))
        while under_way and under_way[0][0] <= time.monotonic():
            _, _, end, packet = heapq.heappop(under_way)
            os.write(end, packet)
    print(f"{sent} sent, {lost} lost", flush=True)


main(*sys.argv[1:])
