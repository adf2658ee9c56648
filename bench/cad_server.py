#!/usr/bin/env python3
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Whether who edits notices that a server makes the edits on the CAD model, too.

usage: bench/cad_server.py CAD_FILE LOAD_CASE --wall ID [--size coarse] [--edits 8] [--rounds 4] [--jobs 1] [--pause 0] [--program build/release/bin/tedit]

Two servers with the same document from a CAD file, one of which makes edits on the model (work.cad_jobs 1 and 0). In turn a client of each
thickens a wall EDITS times, each time by another depth, waits for the field and takes that back; it does not wait for the model, so that
each edit runs beside the work on the ones before. Between two turns the server rests until all is known. Printed: acknowledgement,
edit-to-field and undo-to-field, ms (median, 90 %), and how long after the last edit of a turn all of them were known on the model.
"""
import argparse
import asyncio
import pathlib
import shutil
import statistics
import subprocess
import sys
import tempfile
import time

import websockets
from google.protobuf import json_format

from wire import ROOT, Client, load_case

from tedit.v1 import operation_pb2 as operation

MINOR = 10


class Timed(Client):
    """Counts states on the CAD model that become known."""

    def __init__(self, socket):
        self.known = {}
        super().__init__(socket)

    def announce(self, kind, body):
        super().announce(kind, body)
        if kind == "cad_state_changed":
            self.known[body.version.number] = body.version.cad


class Server:
    def __init__(self, options, folder, name, jobs):
        self.folder = folder / name
        (self.folder / "documents").mkdir(parents=True, mode=0o700)
        shutil.copy(folder / "part.tedit", self.folder / "documents/part.tedit")
        config = self.folder / "config.toml"
        config.write_text(f"[work]\ncad_jobs = {jobs}\n", encoding="utf-8")
        self.process = subprocess.Popen(
            [options.program, "serve", "--config", str(config), "--quiet", "--port", "0", "--documents", str(self.folder / "documents"),
             "--token-file", str(self.folder / "token"), "--ready-file", str(self.folder / "ready"), "--device", "cpu"],
            stdout=subprocess.DEVNULL)
        while not (self.folder / "ready").exists():
            time.sleep(0.05)

    async def connect(self):
        url = (self.folder / "ready").read_text(encoding="utf-8").split('"url":"')[1].split('"')[0]
        client = Timed(await websockets.connect(url, max_size=None))
        await client.open("part", (self.folder / "token").read_text(encoding="utf-8").strip(), MINOR)
        return client


async def one_edit(client, wall, depth, pause, times):
    """An edit and its undo."""
    await asyncio.sleep(pause)
    value = operation.ParameterValue(real=depth)
    began = time.perf_counter()
    made = await client.ask("apply_edit", operation="thicken", surfaces=[wall], parameters={"depth": value})
    times["acknowledged"].append(time.perf_counter() - began)
    times["edit to field"].append(await client.arrived("field", made.head.version_id, began) - began)
    began = time.perf_counter()
    back = await client.ask("undo")
    times["undo to field"].append(await client.arrived("field", back.head.version_id, began) - began)
    return made.head


async def wait_known(client, heads, times):
    began = time.perf_counter()
    async with client.changed:
        await client.changed.wait_for(lambda: all(one.number in client.known for one in heads))
    times["last one known"].append(time.perf_counter() - began)
    for number, state in client.known.items():
        if state.status != state.SAME:
            print(f"version {number} is not on the model: {state.reason}", file=sys.stderr)


async def measure(options, servers):
    loads = json_format.Parse(pathlib.Path(options.load_case).read_text(encoding="utf-8"), load_case.LoadCase())
    clients = {name: await server.connect() for name, server in servers.items()}
    times = {name: {} for name in clients}
    for client in clients.values():
        await client.ask("set_load_case", load_case=loads)
        await client.ask("solve")
    for turn in range(-1, options.rounds):  # The first one warms up.
        for name, client in clients.items():
            took = {what: [] for what in ("acknowledged", "edit to field", "undo to field", "last one known")}
            heads = []
            for n in range(options.edits):
                heads.append(await one_edit(client, options.wall, 1e-3 + 1e-6 * (1 + turn * options.edits + n), options.pause, took))
            if heads[0].HasField("cad"):
                await wait_known(client, heads, took)
            if turn >= 0:
                for what, values in took.items():
                    times[name].setdefault(what, []).extend(values)
    print("| | " + " | ".join(f"{name}, median / 90 % ms" for name in times) + " |\n|---|" + "---|" * len(times))
    for what in times["with the CAD model"]:
        cells = []
        for each in times.values():
            ordered = sorted(each[what])
            cells.append(f"{1e3 * statistics.median(ordered):.0f} / {1e3 * ordered[int(0.9 * (len(ordered) - 1))]:.0f}" if ordered else "")
        print(f"| {what} | " + " | ".join(cells) + " |")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("cad_file")
    parser.add_argument("load_case")
    parser.add_argument("--wall", type=int, required=True)
    parser.add_argument("--size", default="coarse")
    parser.add_argument("--edits", type=int, default=8)
    parser.add_argument("--rounds", type=int, default=4)
    parser.add_argument("--pause", type=float, default=0, help="seconds before each edit")
    parser.add_argument("--jobs", type=int, default=1, help="of the first server; with 0 both do the same")
    parser.add_argument("--program", default=str(ROOT / "build/release/bin/tedit"))
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        subprocess.run([options.program, "import", options.cad_file, "--size", options.size, "-o", str(folder / "part.tedit")], check=True,
                       stdout=subprocess.DEVNULL)
        servers = {"with the CAD model": Server(options, folder, "with", options.jobs), "without": Server(options, folder, "without", 0)}
        try:
            asyncio.run(measure(options, servers))
        finally:
            for server in servers.values():
                server.process.terminate()
                server.process.wait()


if __name__ == "__main__":
    main()
