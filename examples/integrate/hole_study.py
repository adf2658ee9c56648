#!/usr/bin/env python3
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Which hole of a part may be closed? Closes each of them on a running server, solves, says what
became of the largest stress, and takes it back: the edits of a design study in one session.

usage: hole_study.py SERVER TOKEN_FILE MESH LOAD_CASE [LEAST_MM MOST_MM]

Needs protoc and Debian's python3-protobuf and python3-websockets. The protocol's .proto files are
found beside this program (share/tedit/protocol, or protocol/ of the sources).
"""
import asyncio
import itertools
import pathlib
import subprocess
import sys
import tempfile

try:
    import websockets
    from google.protobuf import json_format
except ImportError as missing:
    sys.exit(f"{missing}: install python3-protobuf and python3-websockets (or protobuf and websockets)")


def load_protocol():
    """Has protoc make Python modules of the .proto files and imports them."""
    here = pathlib.Path(__file__).resolve().parent
    found = [up / "protocol" for up in here.parents if (up / "protocol/tedit/v1").is_dir()]
    if not found:
        sys.exit("cannot find protocol/tedit/v1/*.proto above " + str(here))
    files = sorted(str(f.relative_to(found[0])) for f in (found[0] / "tedit/v1").glob("*.proto"))
    with tempfile.TemporaryDirectory() as made:
        subprocess.run(["protoc", f"--python_out={made}", "-I", str(found[0]), *files], check=True)
        sys.path.insert(0, made)
        from tedit.v1 import envelope_pb2, load_case_pb2, report_pb2, session_pb2

    return envelope_pb2, session_pb2, load_case_pb2, report_pb2


envelope, session, load_cases, report = load_protocol()


class Refused(Exception):
    """The server's answer to a request that it did not carry out."""


class Server:
    """A connection with one document. Every request has exactly one answer."""

    def __init__(self, socket):
        self.socket = socket
        self.numbers = itertools.count(1)
        self.document = ""

    async def ask(self, name, /, **fields):
        """Sends one request and gives its answer; progress and events pass by."""
        message = envelope.ClientMessage(request_id=next(self.numbers))
        body = getattr(message, name)
        body.SetInParent()
        for field, value in fields.items():
            if isinstance(value, (list, tuple)):
                getattr(body, field).extend(value)
            elif isinstance(value, dict):
                for key, one in value.items():
                    getattr(body, field)[key].CopyFrom(one)
            elif hasattr(value, "CopyFrom"):
                getattr(body, field).CopyFrom(value)
            else:
                setattr(body, field, value)
        if "document" in body.DESCRIPTOR.fields_by_name:
            body.document = self.document
        await self.socket.send(message.SerializeToString())
        while True:
            answer = envelope.ServerMessage.FromString(await self.socket.recv())
            kind = answer.WhichOneof("body")
            if answer.request_id != message.request_id or kind in ("progress", "chunk"):
                continue
            if kind == "error":
                error = answer.error
                raise Refused(f"{error.message} ({error.where}). {error.remedy}".replace(" ()", ""))
            return getattr(answer, kind)

    async def upload(self, path, piece=1 << 20):
        """Sends a mesh file and makes it the document's head."""
        data = pathlib.Path(path).read_bytes()
        for offset in range(0, len(data), piece):
            message = envelope.ClientMessage(request_id=next(self.numbers))
            chunk = message.upload_chunk
            chunk.upload, chunk.offset, chunk.data = 1, offset, data[offset : offset + piece]
            await self.socket.send(message.SerializeToString())
        return await self.ask("import_mesh", upload=1, size=len(data), file_name=path)


def megapascal_and_mm(result):
    return f"{result.max_von_mises_pa / 1e6:.4g} MPa, {result.max_displacement_m * 1e3:.4g} mm"


async def study(url, token_file, mesh, load_case_file, least_mm="0", most_mm="1000"):
    async with websockets.connect(url, max_size=16 << 20) as socket:
        server = Server(socket)
        token = pathlib.Path(token_file).read_text().strip()
        await server.ask("hello", protocol_major=1, protocol_minor=10, client="hole_study", token=token)
        server.document = (await server.ask("open_document")).document
        await server.upload(mesh)
        loads = json_format.Parse(pathlib.Path(load_case_file).read_text(), load_cases.LoadCase())
        await server.ask("set_load_case", load_case=loads)
        print("as it is:", megapascal_and_mm((await server.ask("solve")).report))

        found = await server.ask(
            "select_surfaces", kind=session.SelectSurfaces.HOLES,
            min_diameter_m=float(least_mm) / 1e3, max_diameter_m=float(most_mm) / 1e3)
        for hole in found.features:
            print(f"hole of {hole.diameter_m * 1e3:.4g} mm:", end=" ")
            # Without the policy the edit would drop the loads and supports of a wall that goes.
            keep_loads = report.LoadPolicy(kind=report.LoadPolicy.REFUSE)
            try:
                await server.ask("apply_edit", operation="fill_hole", surfaces=hole.surfaces[:],
                                 loads=keep_loads)
            except Refused as reason:  # The part is as it was.
                print(reason)
                continue
            result = (await server.ask("solve")).report
            print(f"{megapascal_and_mm(result)}, solved in {result.total_ms:.0f} ms")
            await server.ask("undo")


if __name__ == "__main__":
    if len(sys.argv) not in (5, 7):
        sys.exit(__doc__)
    try:
        asyncio.run(study(*sys.argv[1:]))
    except (Refused, OSError, websockets.WebSocketException) as reason:
        sys.exit(str(reason))
