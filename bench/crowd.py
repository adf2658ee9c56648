#!/usr/bin/env python3
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Many clients on many documents of one server, some of which edit at once, and bad ones beside them.

usage: bench/crowd.py [--program build/release/bin/tedit] [--clients 200] [--documents 50] [--editors 10] [--minutes 30]
                      [--think 5] [--mesh MESH --load-case FILE --surfaces 1,2]

Each document has the part with its load case; its clients watch surface and field and ask for the history now and then. The first
EDITORS documents are edited by one of theirs: a hole is filled and that taken back in turn, THINK seconds on the mean after the
field of the one before. A quarter of the time the honest ones are alone; in the others there is beside them a client that reads
10 kB/s of what it watches, one that never reads and asks for files, and one that sends a message in frames of one byte.
Printed: acknowledgement and edit-to-field (p50, p99, ms) of each quarter; memory, descriptors and threads of the server, and the
memory of its workers, over time.
"""
import argparse
import asyncio
import os
import pathlib
import random
import subprocess
import sys
import tempfile
import time

import websockets
from google.protobuf import json_format

from wire import ROOT, Client, envelope, load_case

PLATE = ROOT / "examples/ctc01_plate"


def quantile(values, part):
    ordered = sorted(values)
    return ordered[min(len(ordered) - 1, int(part * len(ordered)))] if ordered else float("nan")


class Server:
    def __init__(self, program):
        self.folder = tempfile.TemporaryDirectory()
        folder = pathlib.Path(self.folder.name)
        self.log = open(folder / "server.log", "w", encoding="utf-8")
        ready = folder / "ready"
        self.process = subprocess.Popen(
            [program, "serve", "--port", "0", "--documents", str(folder / "documents"), "--token-file", str(folder / "token"),
             "--ready-file", str(ready), "--device", "cpu"], stdout=self.log, stderr=self.log)
        for _ in range(300):
            if ready.exists():
                break
            time.sleep(0.1)
        self.url = ready.read_text(encoding="utf-8").split('"url":"')[1].split('"')[0]
        self.token = (folder / "token").read_text(encoding="utf-8").strip()

    def children(self):
        found, last = {self.process.pid}, 0
        parents = {}
        for entry in pathlib.Path("/proc").iterdir():
            if entry.name.isdigit():
                try:
                    parents[int(entry.name)] = int((entry / "stat").read_text().rsplit(")", 1)[1].split()[1])
                except OSError:
                    pass
        while len(found) != last:
            last = len(found)
            found |= {pid for pid, parent in parents.items() if parent in found}
        return found - {self.process.pid}

    @staticmethod
    def resident(pid):
        try:
            for line in pathlib.Path(f"/proc/{pid}/status").read_text().splitlines():
                if line.startswith("VmRSS"):
                    return int(line.split()[1]) / 1024
        except OSError:
            pass
        return 0.0

    def figures(self):
        pid = self.process.pid
        return (self.resident(pid), len(os.listdir(f"/proc/{pid}/fd")), len(os.listdir(f"/proc/{pid}/task")),
                sum(map(self.resident, self.children())))


class Crowd:
    def __init__(self, server, wanted):
        self.server, self.wanted = server, wanted
        self.quarter, self.acks, self.fields, self.edits = 0, {}, {}, 0
        self.ending = False
        self.connected = 0

    async def client(self, document):
        # A server takes 64 connections of one address.
        here = f"127.0.0.{2 + self.connected // 50}"
        self.connected += 1
        one = Client(await websockets.connect(self.server.url, max_size=64 << 20, ping_interval=None, local_addr=(here, 0)))
        await one.open(document, self.server.token, 10)
        return one

    async def fill(self, document, first):
        """The part and its load case into a new document."""
        await first.send_file(self.wanted.mesh)
        loads = json_format.Parse(pathlib.Path(self.wanted.load_case).read_text(), load_case.LoadCase())
        await first.ask("set_load_case", load_case=loads)
        await first.ask("solve", element_order=2, device="cpu")

    async def edit(self, one):
        surfaces = [int(s) for s in self.wanted.surfaces.split(",")]
        while not self.ending:
            for step in ({"name": "apply_edit", "operation": "fill_hole", "surfaces": surfaces}, {"name": "undo"}):
                await asyncio.sleep(random.expovariate(1 / self.wanted.think))
                if self.ending:
                    return
                quarter, began = self.quarter, time.perf_counter()
                fields = dict(step)
                made = await one.ask(fields.pop("name"), **fields)
                if step["name"] == "apply_edit":
                    self.acks.setdefault(quarter, []).append(1e3 * (time.perf_counter() - began))
                await one.arrived("field", made.head.version_id, began)
                if step["name"] == "apply_edit":
                    self.fields.setdefault(quarter, []).append(1e3 * (time.perf_counter() - began))
                    self.edits += 1

    async def look(self, one):
        while not self.ending:
            await asyncio.sleep(random.expovariate(1 / 20))
            if not self.ending:
                await one.ask("get_history")

    async def gather(self):
        per_document = max(1, self.wanted.clients // self.wanted.documents)
        self.all = []
        for number in range(self.wanted.documents):
            document = f"part-{number}"
            first = await self.client(document)
            await self.fill(document, first)
            self.all.append([first] + [await self.client(document) for _ in range(per_document - 1)])

    def begin(self):
        self.tasks = [asyncio.create_task(self.edit(clients[0])) for clients in self.all[: self.wanted.editors]]
        self.tasks += [asyncio.create_task(self.look(one)) for clients in self.all for one in clients[1:]]


class BadClient:
    """A connection by hand: it reads as slowly, and frames its messages as oddly, as it likes."""

    def __init__(self, server):
        self.server = server

    async def connect(self, document):
        host, port = self.server.url.split("//")[1].split("/")[0].split(":")
        self.reader, self.writer = await asyncio.open_connection(host, int(port), limit=1 << 12)
        self.writer.write(f"GET /v1 HTTP/1.1\r\nHost: {host}:{port}\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
                          "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\nSec-WebSocket-Version: 13\r\n\r\n".encode())
        await self.reader.readuntil(b"\r\n\r\n")
        self.say(1, "hello", protocol_major=1, protocol_minor=10, client="bad", token=self.server.token)
        self.say(2, "open_document", name=document, watch_surface=True, watch_fields=True)
        await self.writer.drain()

    def frame(self, opcode, data, last=True):
        head = bytes([(0x80 if last else 0) | opcode])
        size = len(data)
        head += bytes([0x80 | size]) if size < 126 else bytes([0x80 | 126]) + size.to_bytes(2, "big")
        self.writer.write(head + b"\0\0\0\0" + data)

    @staticmethod
    def message(number, name, **fields):
        made = envelope.ClientMessage(request_id=number)
        body = getattr(made, name)
        body.SetInParent()
        for field, value in fields.items():
            setattr(body, field, value)
        return made.SerializeToString()

    def say(self, number, name, **fields):
        self.frame(2, self.message(number, name, **fields))

    async def read_slowly(self):
        while await self.reader.read(1000):
            await asyncio.sleep(0.1)

    async def never_read(self, document):
        for number in range(3, 300):
            self.say(number, "export_file", document=document, format="vtu")
            await asyncio.sleep(0.05)
        await asyncio.sleep(3600)

    async def read_all(self):
        while await self.reader.read(1 << 16):
            pass

    async def send_bytes_alone(self, document):
        reading = asyncio.create_task(self.read_all())  # So that it is not the one who never reads.
        try:
            await self.frames_of_a_byte(document)
        finally:
            reading.cancel()

    async def frames_of_a_byte(self, document):
        number = 2
        while True:
            number += 1
            data = self.message(number, "get_history", document=document)
            for i, byte in enumerate(data):
                self.frame(2 if i == 0 else 0, bytes([byte]), i == len(data) - 1)
                await self.writer.drain()
            await asyncio.sleep(0)


NAMES = ["alone", "beside one that reads 10 kB/s", "beside one that never reads", "beside one that sends frames of a byte"]


async def misbehave(server, which):
    """A bad client; it comes back when it is thrown out."""
    while True:
        try:
            one = BadClient(server)
            await one.connect("part-0")
            await (one.read_slowly() if which == 1 else one.never_read("part-0") if which == 2 else one.send_bytes_alone("part-0"))
        except (OSError, EOFError, asyncio.IncompleteReadError):
            pass
        await asyncio.sleep(1)


async def keep_figures(crowd, server, started, lines):
    while True:
        rss, files, threads, workers = server.figures()
        lines.append((time.monotonic() - started, rss, files, threads, workers, crowd.edits))
        await asyncio.sleep(crowd.wanted.minutes * 60 / 24)


def report(crowd, lines):
    print("| | edits | acknowledged p50 / p99 ms | edit to field p50 / p99 ms |\n|---|---|---|---|")
    for which, name in enumerate(NAMES):
        acks, fields = crowd.acks.get(which, []), crowd.fields.get(which, [])
        print(f"| {name} | {len(acks)} | {quantile(acks, .5):.0f} / {quantile(acks, .99):.0f} | "
              f"{quantile(fields, .5):.0f} / {quantile(fields, .99):.0f} |")
    print("\n| minute | server MiB | descriptors | threads | workers MiB | edits so far |\n|---|---|---|---|---|---|")
    for at, rss, files, threads, workers, edits in lines:
        print(f"| {at / 60:.1f} | {rss:.0f} | {files} | {threads} | {workers:.0f} | {edits} |")


async def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default=str(ROOT / "build/release/bin/tedit"))
    parser.add_argument("--clients", type=int, default=200)
    parser.add_argument("--documents", type=int, default=50)
    parser.add_argument("--editors", type=int, default=10)
    parser.add_argument("--minutes", type=float, default=30)
    parser.add_argument("--think", type=float, default=5)
    parser.add_argument("--mesh", default=str(PLATE / "ctc01_plate.coarse.msh"))
    parser.add_argument("--load-case", default=str(PLATE / "load_case.json"))
    parser.add_argument("--surfaces", default="1,2")
    wanted = parser.parse_args()
    server = Server(wanted.program)
    lines = []
    try:
        crowd = Crowd(server, wanted)
        await crowd.gather()
        print(f"{wanted.clients} clients on {wanted.documents} documents are there", file=sys.stderr)
        started = time.monotonic()
        crowd.begin()
        noting = asyncio.create_task(keep_figures(crowd, server, started, lines))
        for which in range(len(NAMES)):
            crowd.quarter = which
            bad = asyncio.create_task(misbehave(server, which)) if which else None
            await asyncio.sleep(wanted.minutes * 15)
            if bad:
                bad.cancel()
            for task in crowd.tasks:
                if task.done():
                    task.result()
        crowd.ending = True
        noting.cancel()
        report(crowd, lines)
    finally:
        server.process.terminate()
        server.process.wait()


if __name__ == "__main__":
    asyncio.run(main())
