#!/usr/bin/env python3
# SPDX-License-Identifier: AGPL-3.0-or-later
"""One document through a long day: many edits, then undo to any version, closing, opening again, `tedit doc gc`.

usage: bench/long_session.py MESH SURFACES [--edits 1000] [--depth-mm .02] [--program build/release/bin/tedit]

Each edit erodes or thickens one of SURFACES (ids with commas) by up to the depth, chosen at random from a fixed seed, and
the next one of that wall brings it back, so that none wanders away; where one is refused, a step is undone and another
one asked for, so that the history is a tree. Printed over the run: median ms of an edit to its answer, the document's size with
its log, resident memory of the server and of all its workers. Then ms to go to 50 random versions, ms to open the document
in a new server, and what `doc gc` leaves beside what one version takes.
"""
import argparse
import asyncio
import json
import pathlib
import random
import statistics
import subprocess
import sys
import tempfile
import time

import websockets

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "examples/integrate"))
import hole_study  # noqa: E402  (the protocol, and requests with their answers)
from tedit.v1 import operation_pb2  # noqa: E402

PROTOCOL_MINOR = 10


class Host:
    """A server of its own, and what it takes up."""

    def __init__(self, program, folder):
        self.folder = folder
        ready = folder / "ready.json"
        ready.unlink(missing_ok=True)
        self.process = subprocess.Popen(
            [program, "serve", "--port", "0", "--documents", folder / "documents", "--token-file", folder / "token",
             "--ready-file", ready], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        while not ready.exists() or not ready.read_text():
            time.sleep(.02)
        self.url = json.loads(ready.read_text())["url"]

    def resident_mib(self):
        """Of the server, and of all its workers together."""
        tasks = pathlib.Path(f"/proc/{self.process.pid}/task").glob("*/children")
        children = [pid for task in tasks for pid in task.read_text().split()]
        return self._resident(self.process.pid), sum(self._resident(pid) for pid in children)

    @staticmethod
    def _resident(pid):
        lines = pathlib.Path(f"/proc/{pid}/status").read_text().splitlines()
        return sum(int(line.split()[1]) for line in lines if line.startswith("VmRSS")) / 1024

    def document_mib(self):
        return sum(f.stat().st_size for f in (self.folder / "documents").glob("part.tedit*")) / 2**20

    def stop(self):
        self.process.terminate()
        self.process.wait()


async def enter(socket, host):
    server = hole_study.Server(socket)
    token = (host.folder / "token").read_text().strip()
    await server.ask("hello", protocol_major=1, protocol_minor=PROTOCOL_MINOR, client="long_session", token=token)
    started = time.perf_counter()
    state = await server.ask("open_document", name="part")
    server.document = state.document
    return server, state, (time.perf_counter() - started) * 1e3


async def edit_often(server, host, surfaces, given):
    choose = random.Random(7)
    made, refused, block, away, before = 0, [], [], {}, [(0, {})]
    print("edits  median ms  document MiB  server MiB  workers MiB")
    while made < given.edits:
        surface = choose.choice(surfaces)
        there = (choose.choice(["erode", "thicken"]), given.depth_mm * choose.uniform(.2, 1))
        operation, depth = away.get(surface, there)
        parameter = operation_pb2.ParameterValue(real=depth)
        request = dict(operation=operation, surfaces=[surface])
        started = time.perf_counter()
        try:
            await server.ask("apply_edit", parameters={"depth_mm": parameter}, **request)
        except hole_study.Refused as why:
            refused.append(time.perf_counter() - started)
            if given.verbose:
                print(f"after {made} edits {operation} of {surface} by {depth:.4f} mm, {refused[-1]:.1f} s: {why}", file=sys.stderr)
            if len(before) > 1:  # the version before, and what was away from its place in it
                before.pop()
            number, away = before[-1][0], dict(before[-1][1])
            await server.ask("go_to_version", number=number)
            continue
        block.append((time.perf_counter() - started) * 1e3)
        made += 1
        if away.pop(surface, None) is None:
            away[surface] = ("thicken" if operation == "erode" else "erode", depth)
        before.append((made, dict(away)))
        if made in (10, 50) or made % 100 == 0:
            memory = host.resident_mib()
            print(f"{made:5}  {statistics.median(block):9.1f}  {host.document_mib():12.1f}  {memory[0]:10.0f}  {memory[1]:11.0f}",
                  flush=True)
            block = []
    print(f"{len(refused)} refused besides" + (f", median {statistics.median(refused):.1f} s, longest {max(refused):.1f} s" if refused else ""))


async def jump(server, versions):
    choose = random.Random(11)
    times = []
    for _ in range(50):
        started = time.perf_counter()
        await server.ask("go_to_version", number=choose.randrange(versions))
        times.append((time.perf_counter() - started) * 1e3)
    print(f"to any version: median {statistics.median(times):.1f} ms, longest {max(times):.1f} ms")


async def day(given, folder):
    surfaces = [int(one) for one in given.surfaces.split(",")]
    host = Host(given.program, folder)
    async with websockets.connect(host.url, max_size=64 << 20, ping_interval=None) as socket:
        server, _, _ = await enter(socket, host)
        await server.upload(given.mesh)
        print(f"imported: document {host.document_mib():.1f} MiB")
        await edit_often(server, host, surfaces, given)
        await jump(server, given.edits + 1)
    host.stop()
    print(f"closed: {host.document_mib():.1f} MiB")
    host = Host(given.program, folder)
    async with websockets.connect(host.url, max_size=64 << 20, ping_interval=None) as socket:
        _, state, ms = await enter(socket, host)
        print(f"opened again in {ms:.0f} ms, at version {state.head.number}; server {host.resident_mib()[0]:.0f} MiB")
    host.stop()


def collect(given, folder):
    file = folder / "documents/part.tedit"
    for options in ([], ["--drop-unreachable"]):
        said = subprocess.run([given.program, "doc", "gc", "--json", *options, file], capture_output=True, text=True)
        size = file.stat().st_size / 2**20
        print(f"doc gc {' '.join(options)}: {size:.1f} MiB" + ("" if said.returncode == 0 else " " + said.stdout.strip()))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("mesh")
    parser.add_argument("surfaces")
    parser.add_argument("--edits", type=int, default=1000)
    parser.add_argument("--depth-mm", type=float, default=.02)
    parser.add_argument("--verbose", action="store_true", help="say what is refused, and why")
    parser.add_argument("--program", default=str(ROOT / "build/release/bin/tedit"))
    given = parser.parse_args()
    with tempfile.TemporaryDirectory() as made:
        asyncio.run(day(given, pathlib.Path(made)))
        collect(given, pathlib.Path(made))


if __name__ == "__main__":
    main()
