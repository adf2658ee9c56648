#!/usr/bin/env python3
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Strangers at each port of a server, one after the other, and whether it minds.

usage: tests/network/hostile_sessions.py [--program build/release/bin/tedit] [--sessions 1000000] [--ports clients,secure,nodes] [--seed 1]
       PYTHONPATH must have the package tedit (build/release/clients/python).

Ports: `clients` (WebSocket without TLS), `secure` (the same with TLS), `nodes` (workers of other machines). A session is a connection that
sends noise, the changed beginning of something honest (HTTP, a WebSocket frame, a message of the protocol, a TLS handshake), all of it cut
off somewhere, or nothing, and goes, mostly in the middle; every fiftieth at `clients` has the right token and then sends changed requests. They
come from many addresses of this machine. Meanwhile an honest client undoes and redoes an edit. Printed for each port: sessions a second, what
the honest client's changes took (p50, p99, ms), the server's memory (as it was, after a tenth, at the end), its descriptors, and whether it
is the same process still. Exit status 1 when it is not, when a worker died, or when an honest change failed.
"""
import argparse
import multiprocessing
import os
import pathlib
import random
import socket
import ssl
import struct
import subprocess
import sys
import tempfile
import threading
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
CORPUS = ROOT / "tests/fuzz/gateway_corpus"
PLATE = ROOT / "examples/ctc01_plate"
LOOK_S = 0.05  # How long a session waits for an answer that it wants to see.


def changed(data, random_):
    """One to eight bytes other, some left out, some twice, or cut off."""
    out = bytearray(data)
    for _ in range(random_.randint(1, 8)):
        if not out:
            break
        at = random_.randrange(len(out))
        what = random_.randrange(4)
        if what == 0:
            out[at] = random_.randrange(256)
        elif what == 1:
            out[at] ^= 1 << random_.randrange(8)
        elif what == 2:
            del out[at : at + random_.randint(1, 16)]
        else:
            out[at:at] = out[at : at + random_.randint(1, 64)]
    return bytes(out[: random_.randrange(len(out) + 1)] if random_.random() < 0.2 else out)


def frame(payload, random_, *, opcode=2):
    mask = random_.randbytes(4)
    size = len(payload)
    length = bytes([0x80 | size]) if size < 126 else b"\xfe" + struct.pack(">H", size) if size < 65536 else b"\xff" + struct.pack(">Q", size)
    return bytes([0x80 | opcode]) + length + mask + bytes(byte ^ mask[i % 4] for i, byte in enumerate(payload))


class Stranger:
    """Makes sessions at one port."""

    def __init__(self, port, secure, token, seed):
        from tedit.v1 import envelope_pb2 as envelope

        self.port, self.secure, self.random = port, secure, random.Random(seed)
        self.upgrade = (f"GET /v1 HTTP/1.1\r\nHost: 127.0.0.1:{port}\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
                        "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\nSec-WebSocket-Version: 13\r\n\r\n").encode()
        hello = envelope.Hello(protocol_major=1, protocol_minor=10, client="stranger", token=token)
        self.hello = envelope.ClientMessage(request_id=1, hello=hello).SerializeToString()
        self.requests = [one.read_bytes() for one in sorted(CORPUS.iterdir())]
        self.greeting = self.tls_greeting()

    @staticmethod
    def tls_greeting():
        """The first bytes of an honest client's TLS."""
        wire = ssl.MemoryBIO()
        line = ssl.create_default_context().wrap_bio(ssl.MemoryBIO(), wire, server_hostname="127.0.0.1")
        try:
            line.do_handshake()
        except ssl.SSLWantReadError:
            pass
        return wire.read()

    def connect(self):
        line = socket.socket()
        line.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, struct.pack("ii", 1, 0))  # Goes without a word.
        line.bind((f"127.{self.random.randint(1, 200)}.{self.random.randrange(256)}.{self.random.randint(1, 254)}", 0))
        line.settimeout(5)
        line.connect(("127.0.0.1", self.port))
        line.settimeout(LOOK_S)
        return line

    def secured(self, line):
        context = ssl.SSLContext(ssl.PROTOCOL_TLS_CLIENT)
        context.check_hostname, context.verify_mode = False, ssl.CERT_NONE
        line.settimeout(5)
        return context.wrap_socket(line)

    def speak(self, line, admitted):
        """Something of the clients' protocol, more or less."""
        kind = 9 if admitted else self.random.randrange(6)
        if kind == 0:
            return line.sendall(self.random.randbytes(self.random.randint(1, 2000)))
        if kind == 1:
            return line.sendall(changed(self.upgrade, self.random))
        line.sendall(self.upgrade)
        if kind == 2:
            return line.sendall(self.random.randbytes(self.random.randint(1, 500)))
        if kind == 3:
            return line.sendall(changed(frame(self.hello, self.random), self.random))
        if kind == 4:
            return line.sendall(frame(changed(self.hello, self.random), self.random, opcode=self.random.choice((0, 1, 2, 8, 9, 10))))
        if kind == 5:
            return line.sendall(frame(self.random.choice(self.requests), self.random))
        line.sendall(frame(self.hello, self.random))
        for _ in range(self.random.randint(1, 5)):
            line.sendall(frame(changed(self.random.choice(self.requests), self.random), self.random))

    def session(self, number):
        line = self.connect()
        try:
            if self.secure is None:  # Nodes: nobody gets further than the handshake.
                line.sendall(self.random.choice((self.greeting, changed(self.greeting, self.random), self.random.randbytes(300))))
            elif self.secure and number % 20:
                line.sendall(changed(self.greeting, self.random) if number % 2 else self.random.randbytes(self.random.randint(1, 600)))
            else:
                if self.secure:
                    line = self.secured(line)
                self.speak(line, self.secure is False and number % 50 == 0)
            if number % 40 == 0:
                line.settimeout(LOOK_S)
                line.recv(4096)
        except (OSError, ssl.SSLError):
            pass  # The server may have gone first.
        finally:
            line.close()


def strangers(port, secure, token, seed, count):
    one = Stranger(port, secure, token, seed)
    for number in range(count):
        one.session(number)


class Server:
    def __init__(self, program, folder, secure):
        self.folder = folder
        self.log = open(folder / "server.log", "w", encoding="utf-8")
        ca, hall, ready = folder / "ca", folder / "hall", folder / "ready"
        for words in (["init", ca], ["issue", ca, "--role", "server", "--name", "hall", "--host", "127.0.0.1", "-o", hall]):
            subprocess.run([program, "--quiet", "certs", *map(str, words)], check=True, capture_output=True)
        lines = ["--certificates", str(hall)] if secure else []
        self.process = subprocess.Popen(
            [program, "serve", "--port", "0", "--documents", str(folder / "documents"), "--token-file", str(folder / "token"), "--ready-file",
             str(ready), "--node-certificates", str(hall), "--node-port", "0", "--device", "cpu", *lines], stdout=self.log, stderr=self.log)
        while not ready.exists():
            time.sleep(0.05)
        import json

        said = json.loads(ready.read_text(encoding="utf-8"))
        self.url, self.node_port = said["url"], said["node_port"]
        self.port = int(self.url.rsplit(":", 1)[1].split("/")[0])
        self.token = (folder / "token").read_text(encoding="utf-8").strip()
        if secure:
            os.environ["SSL_CERT_FILE"] = str(hall / "ca.crt")

    def memory(self):
        status = pathlib.Path(f"/proc/{self.process.pid}/status").read_text(encoding="utf-8")
        return int(status.split("VmRSS:")[1].split()[0]) / 1024

    def descriptors(self):
        return len(os.listdir(f"/proc/{self.process.pid}/fd"))

    def worker_deaths(self):
        return pathlib.Path(self.folder / "server.log").read_text(encoding="utf-8").count("was ended by") + \
            pathlib.Path(self.folder / "server.log").read_text(encoding="utf-8").count("ended with status")


class Honest(threading.Thread):
    """Changes a document all the time."""

    def __init__(self, server):
        super().__init__(daemon=True)
        import tedit

        self.client = tedit.connect(server.url, server.token)
        self.part = self.client.open("part")
        self.part.import_mesh(PLATE / "ctc01_plate.coarse.msh", unit="mm")
        self.part.edit("fill_hole", [1, 2])
        self.times, self.failures, self.over = [], [], threading.Event()

    def run(self):
        while not self.over.is_set():
            begin = time.monotonic()
            try:
                self.part.undo()
                self.part.redo()
                self.times.append((time.monotonic() - begin) * 500)
            except Exception as problem:  # pylint: disable=broad-except
                self.failures.append(problem)
            self.over.wait(0.2)

    def end(self):
        self.over.set()
        self.join()
        surface = self.part.wait_surface()
        self.client.close()
        return surface.version_id


def try_port(name, arguments):
    with tempfile.TemporaryDirectory() as folder:
        server = Server(str(arguments.program), pathlib.Path(folder), name == "secure")
        try:
            return attack(name, server, arguments)
        finally:
            server.process.terminate()
            server.process.wait(30)


def attack(name, server, arguments):
    honest = Honest(server)
    honest.start()
    secure = {"clients": False, "secure": True, "nodes": None}[name]
    port = server.node_port if name == "nodes" else server.port
    memory = [server.memory()]
    begin = time.monotonic()
    for part in (arguments.sessions // 10, arguments.sessions - arguments.sessions // 10):
        crowd = [multiprocessing.Process(target=strangers, args=(port, secure, server.token, arguments.seed + len(memory) * 10 + i, part // 2))
                 for i in range(2)]
        for one in crowd:
            one.start()
        for one in crowd:
            one.join()
        memory.append(server.memory())
    took = time.monotonic() - begin
    honest.end()
    alive = server.process.poll() is None
    deaths = server.worker_deaths()
    times = sorted(honest.times)
    print(f"{name}: {arguments.sessions} sessions in {took:.0f} s, {arguments.sessions / took:.0f}/s; honest changes {len(times)}, "
          f"p50 {times[len(times) // 2]:.1f} p99 {times[int(0.99 * len(times))]:.1f} ms, failed {len(honest.failures)}; memory "
          + ", ".join(f"{one:.1f}" for one in memory) + f" MiB; descriptors {server.descriptors() if alive else 0}; "
          f"{'the same process' if alive else 'THE SERVER DIED'}, workers lost {deaths}", flush=True)
    if honest.failures:
        print("   first failure:", honest.failures[0])
    return alive and not deaths and not honest.failures


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", type=pathlib.Path, default=ROOT / "build/release/bin/tedit")
    parser.add_argument("--sessions", type=int, default=1_000_000)
    parser.add_argument("--ports", default="clients,secure,nodes")
    parser.add_argument("--seed", type=int, default=1)
    arguments = parser.parse_args()
    good = [try_port(name, arguments) for name in arguments.ports.split(",")]
    sys.exit(0 if all(good) else 1)


if __name__ == "__main__":
    main()
