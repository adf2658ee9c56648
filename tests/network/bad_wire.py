# SPDX-License-Identifier: AGPL-3.0-or-later
"""Machines of one machine: network namespaces on an Ethernet switch in user space, whose ports delay, lose, slow down and
cut. Needs root, `ip` and /dev/net/tun; no kernel module for bad networks is needed."""
import ctypes
import dataclasses
import fcntl
import heapq
import os
import random
import selectors
import struct
import subprocess
import threading
import time

CLONE_NEWNET = 0x40000000
TUNSETIFF = 0x400454CA
IFF_TAP, IFF_NO_PI = 0x0002, 0x1000
LONGEST_QUEUE_S = 0.5  # A port that is behind by more drops frames, as a switch does.


def ip(*words):
    subprocess.run(["ip", *words], check=True, capture_output=True, text=True)


@dataclasses.dataclass
class Port:
    """One machine's line to the switch."""

    name: str
    address: str
    tap: int
    delay_s: float = 0.0  # Each way.
    loss: float = 0.0  # Of frames, each way.
    bytes_s: float = 0.0  # To the machine and from it, each; 0: no bound.
    deaf: bool = False  # Nothing reaches it.
    mute: bool = False  # Nothing comes from it.
    sent: int = 0  # Bytes from the machine, headers included.
    received: int = 0
    free_at: dict = dataclasses.field(default_factory=lambda: {"in": 0.0, "out": 0.0})


class Wire:
    """Use it with `with`: namespaces and devices go at the end."""

    def __init__(self, machines, seed=1, mtu=1500):
        self.mtu = mtu  # The switch carries some 20,000 frames a second: 1 Gbit/s takes large ones.
        self.prefix = f"w{os.getpid() % 10000}"
        self.random = random.Random(seed)
        self.ports = {}
        self.stopped = threading.Event()
        for number, name in enumerate(machines, 1):
            self.ports[name] = self.make_port(name, number)
        self.thread = threading.Thread(target=self.run, daemon=True)
        self.thread.start()

    def make_port(self, name, number):
        space, device = self.space_of(name), f"{self.prefix}t{number}"
        address = f"10.77.0.{number}"
        tap = os.open("/dev/net/tun", os.O_RDWR | os.O_NONBLOCK)
        fcntl.ioctl(tap, TUNSETIFF, struct.pack("16sH", device.encode(), IFF_TAP | IFF_NO_PI))
        ip("netns", "add", space)
        ip("link", "set", device, "netns", space)
        for words in (["addr", "add", f"{address}/24", "dev", device], ["link", "set", device, "mtu", str(self.mtu), "up"], ["link", "set", "lo", "up"]):
            ip("-n", space, *words)
        return Port(name, address, tap)

    def space_of(self, name):
        return f"{self.prefix}-{name}"

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.stopped.set()
        self.thread.join()
        for port in self.ports.values():
            os.close(port.tap)
            subprocess.run(["ip", "netns", "del", self.space_of(port.name)], check=False)

    def __getitem__(self, name):
        return self.ports[name]

    def start(self, name, command, **how):
        """A program on that machine."""
        return subprocess.Popen(["ip", "netns", "exec", self.space_of(name), *command], **how)

    def move_in(self, name):
        """This thread, and those that it starts from now on, are on that machine."""
        with open(f"/run/netns/{self.space_of(name)}", encoding="ascii") as space:
            if ctypes.CDLL(None, use_errno=True).setns(space.fileno(), CLONE_NEWNET) != 0:
                raise OSError(ctypes.get_errno(), "setns")

    def heal(self, *names):
        for name in names or self.ports:
            port = self.ports[name]
            port.delay_s, port.loss, port.bytes_s, port.deaf, port.mute = 0.0, 0.0, 0.0, False, False

    # -- the switch ---------------------------------------------------------------------------------

    def run(self):
        at, places, due = selectors.DefaultSelector(), {}, []
        for port in self.ports.values():
            at.register(port.tap, selectors.EVENT_READ, port)
        count = 0
        while not self.stopped.is_set():
            wait = max(0.0, min(due[0][0] - time.monotonic(), 0.05)) if due else 0.05
            for key, _ in at.select(wait):
                for frame in self.frames_of(key.data):
                    places[frame[6:12]] = key.data
                    whom = places.get(frame[:6])
                    for to in [whom] if whom else self.ports.values():
                        when = self.time_for(frame, key.data, to) if to is not key.data else None
                        if when is not None:
                            count += 1
                            heapq.heappush(due, (when, count, to, frame))
            now = time.monotonic()
            while due and due[0][0] <= now:
                _, _, to, frame = heapq.heappop(due)
                self.deliver(to, frame)

    def frames_of(self, port):
        for _ in range(64):
            try:
                frame = os.read(port.tap, self.mtu + 64)
            except (BlockingIOError, OSError):
                return
            port.sent += len(frame)
            yield frame

    def time_for(self, frame, source, to):
        """When the frame arrives; None: it does not."""
        if source.mute or to.deaf or self.random.random() < source.loss or self.random.random() < to.loss:
            return None
        when = time.monotonic()
        for port, way in ((source, "out"), (to, "in")):
            if port.bytes_s > 0:
                begin = max(when, port.free_at[way])
                if begin - when > LONGEST_QUEUE_S:
                    return None
                port.free_at[way] = when = begin + len(frame) / port.bytes_s
            when += port.delay_s
        return when

    @staticmethod
    def deliver(port, frame):
        try:
            port.received += os.write(port.tap, frame)
        except (BlockingIOError, OSError):
            pass
