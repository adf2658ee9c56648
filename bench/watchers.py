#!/usr/bin/env python3
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Edits and solves over the socket with watchers beside, of two programs in turns.

usage: bench/watchers.py MESH LOAD_CASE SURFACES --program A[:MINOR] [--program B[:MINOR]]
                         [--watchers 1] [--edits 5] [--rounds 3] [--order 2]

Each program serves a document of its own; MINOR is the protocol_minor that it wants (10). In each round each program fills
the hole of SURFACES (ids with commas) and takes it back, EDITS times; the field follows by itself. Printed are medians over
all rounds, ms: `edit` to the answer, `surface` until all who watch have it, `field` until all have the final fields, `undo`
(the field is at hand) to its fields; and what the one who asks receives for an edit: messages, and bytes without chunks.
"""
import argparse
import asyncio
import pathlib
import statistics
import subprocess
import tempfile
import time

import websockets
from google.protobuf import json_format

from wire import Client, load_case

class Served:
    """A program that serves, with one client that asks and others that watch."""

    def __init__(self, program, port):
        self.program, _, minor = program.partition(":")
        self.minor, self.port = int(minor or 10), port
        self.folder = tempfile.TemporaryDirectory()
        token = pathlib.Path(self.folder.name) / "token"
        self.process = subprocess.Popen(
            [self.program, "serve", "--port", str(port), "--documents", self.folder.name, "--token-file", str(token)],
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        for _ in range(200):
            if token.exists() and token.read_text().strip():
                break
            time.sleep(0.1)
        self.token = token.read_text().strip()
        self.figures = {}

    async def connect(self, wanted):
        for _ in range(100):
            try:
                socket = await websockets.connect(f"ws://127.0.0.1:{self.port}/v1", max_size=64 << 20)
                break
            except OSError:
                await asyncio.sleep(0.1)
        self.asks = Client(socket)
        await self.asks.open("part", self.token, self.minor)
        await self.asks.send_file(wanted.mesh)
        loads = json_format.Parse(pathlib.Path(wanted.load_case).read_text(), load_case.LoadCase())
        await self.asks.ask("set_load_case", load_case=loads)
        await self.asks.ask("solve", element_order=wanted.order, device="cpu")
        self.watching = [self.asks]
        for _ in range(wanted.watchers - 1):
            one = Client(await websockets.connect(f"ws://127.0.0.1:{self.port}/v1", max_size=64 << 20))
            await one.open("part", self.token, self.minor)
            self.watching.append(one)

    def note(self, name, value):
        self.figures.setdefault(name, []).append(value)

    async def edit(self, surfaces):
        asks = self.asks
        asks.messages = asks.bytes = 0
        began = time.perf_counter()
        made = await asks.ask("apply_edit", operation="fill_hole", surfaces=surfaces)
        self.note("edit", 1e3 * (time.perf_counter() - began))
        await self.all_have("surface", made.head.version_id, began, "surface")
        await self.all_have("field", made.head.version_id, began, "field")
        self.note("messages", asks.messages)
        self.note("bytes", asks.bytes)
        began = time.perf_counter()
        back = await asks.ask("undo")
        await self.all_have("field", back.head.version_id, began, "undo")

    async def all_have(self, what, version, began, name):
        times = await asyncio.gather(*(one.arrived(what, version, began) for one in self.watching))
        self.note(name, 1e3 * (max(times) - began))


async def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("mesh")
    parser.add_argument("load_case")
    parser.add_argument("surfaces")
    parser.add_argument("--program", action="append", required=True)
    parser.add_argument("--watchers", type=int, default=1)
    parser.add_argument("--edits", type=int, default=5)
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--order", type=int, default=2)
    wanted = parser.parse_args()
    surfaces = [int(one) for one in wanted.surfaces.split(",")]
    servers = [Served(program, 17400 + i) for i, program in enumerate(wanted.program)]
    try:
        for one in servers:
            await one.connect(wanted)
            await one.edit(surfaces)
            one.figures.clear()
        for _ in range(wanted.rounds):
            for one in servers:
                for _ in range(wanted.edits):
                    await one.edit(surfaces)
        for one in servers:
            print(one.program, f"{wanted.watchers} watching:",
                  ", ".join(f"{name} {statistics.median(values):.1f}" for name, values in one.figures.items()))
    finally:
        for one in servers:
            one.process.terminate()


if __name__ == "__main__":
    asyncio.run(main())
