# SPDX-License-Identifier: AGPL-3.0-or-later
"""The protocol as benchmarks speak it: a connection that notes when what it watches has arrived."""
import asyncio
import pathlib
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent


def load_protocol():
    files = sorted(str(f.relative_to(ROOT / "protocol")) for f in (ROOT / "protocol/tedit/v1").glob("*.proto"))
    made = tempfile.mkdtemp()
    subprocess.run(["protoc", f"--python_out={made}", "-I", str(ROOT / "protocol"), *files], check=True)
    sys.path.insert(0, made)
    from tedit.v1 import envelope_pb2, load_case_pb2

    return envelope_pb2, load_case_pb2


envelope, load_case = load_protocol()


class Client:
    """A connection that notes when what it watches has arrived."""

    def __init__(self, socket):
        self.socket, self.last, self.document = socket, 0, ""
        self.answers, self.streams = {}, {}
        self.surface = self.field = ("", 0.0)
        self.messages = self.bytes = 0
        self.changed = asyncio.Condition()
        self.task = asyncio.create_task(self.listen())

    async def listen(self):
        async for data in self.socket:
            message = envelope.ServerMessage.FromString(data)
            kind = message.WhichOneof("body")
            if kind == "chunk":
                self.receive(message.chunk)
            else:
                self.messages += 1
                self.bytes += len(data)
                self.announce(kind, getattr(message, kind))
                if message.request_id and kind != "progress":
                    self.answers[message.request_id] = (kind, getattr(message, kind))
            async with self.changed:
                self.changed.notify_all()

    def announce(self, kind, body):
        if kind == "surface_update":
            self.streams[body.stream.stream] = [body.stream.bytes, "surface", body.version_id]
        elif kind == "field_update":
            report = body.report if body.HasField("report") else body.envelope
            done = not report.interim and body.remaining == 0
            self.streams[body.stream.stream] = [body.stream.bytes, "field" if done else "", report.version_id]

    def receive(self, chunk):
        stream = self.streams.get(chunk.stream)
        if stream is None:
            return
        stream[0] -= len(chunk.data)
        if stream[0] <= 0:
            del self.streams[chunk.stream]
            if stream[1]:
                setattr(self, stream[1], (stream[2], time.perf_counter()))

    async def ask(self, name, /, **fields):
        self.last += 1
        number = self.last
        message = envelope.ClientMessage(request_id=number)
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
        async with self.changed:
            await self.changed.wait_for(lambda: number in self.answers)
        kind, answer = self.answers.pop(number)
        if kind == "error":
            sys.exit(f"{name}: {answer.message}")
        return answer

    async def arrived(self, what, version, since):
        async with self.changed:
            await self.changed.wait_for(
                lambda: getattr(self, what)[0] == version and getattr(self, what)[1] >= since)
        return getattr(self, what)[1]

    async def open(self, name, token, minor):
        await self.ask("hello", protocol_major=1, protocol_minor=minor, client="watchers", token=token)
        self.document = (await self.ask("open_document", name=name, watch_surface=True, watch_fields=True)).document

    async def send_file(self, path):
        """Imports a mesh into the document."""
        data = pathlib.Path(path).read_bytes()
        for offset in range(0, len(data), 1 << 20):
            message = envelope.ClientMessage(request_id=10**6 + offset)
            chunk = message.upload_chunk
            chunk.upload, chunk.offset, chunk.data = 1, offset, data[offset : offset + (1 << 20)]
            await self.socket.send(message.SerializeToString())
        return await self.ask("import_mesh", upload=1, size=len(data), file_name=str(path))
