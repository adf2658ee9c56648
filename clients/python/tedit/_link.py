# SPDX-License-Identifier: AGPL-3.0-or-later
"""One connection: requests and their answers, streams, and what is sent unasked. All of it runs in one event loop."""
from __future__ import annotations

import asyncio
import collections
import itertools
import typing

import websockets

from . import errors
from .streams import Arrays, IncomingStream
from .v1 import envelope_pb2 as envelope
from .v1 import session_pb2 as session
from .v1.protocol_version import MAJOR, MINOR

#: The largest message that is taken from a server, bytes.
MAX_MESSAGE = 64 << 20
#: Bytes of one piece of an upload.
PIECE = 256 << 10
#: A slow line may be busy for long with what was sent before a ping.
PING_PATIENCE_S = 60
MAX_STREAMS = 256

Progress = typing.Callable[[float, str], None]
#: A message's name in the protocol ("committed"), the message, and the arrays of its stream.
OnEvent = typing.Callable[[str, typing.Any, typing.Optional[Arrays]], None]
OnLost = typing.Callable[["Link"], None]


class Answer(typing.NamedTuple):
    kind: str  #: "committed", "file_ready", ...
    body: typing.Any
    stream: IncomingStream | None  #: Complete; of those that announce one.

    @property
    def arrays(self) -> Arrays:
        return self.stream.arrays() if self.stream else {}

    def data(self, name: str) -> bytes:
        """One array's bytes, as a file's."""
        return self.stream.data(name) if self.stream else b""


class _Pending:
    def __init__(self, progress: Progress | None, arrived: typing.Callable[[typing.Any], None] | None = None) -> None:
        self.future: asyncio.Future[Answer] = asyncio.get_running_loop().create_future()
        self._progress = progress
        self._arrived = arrived

    def finish(self, answer: Answer) -> None:
        if self.future.done():
            return
        if self._arrived:
            self._arrived(answer.body)
        self.future.set_result(answer)

    def report(self, progress: envelope.Progress) -> None:
        """A fault of the caller's function is not the connection's."""
        try:
            if self._progress:
                self._progress(progress.fraction, progress.stage)
        except Exception as problem:
            context = {"message": "a progress callback raised an exception", "exception": problem}
            asyncio.get_running_loop().call_exception_handler(context)

    def fail(self, problem: errors.TeditError) -> None:
        if not self.future.done():
            self.future.set_exception(problem)


class _Arrival:
    """A stream on its way, and the answer or event that announced it."""

    def __init__(self, kind: str, body: typing.Any, stream: IncomingStream, request: _Pending | None) -> None:
        self.kind, self.body, self.stream, self.request = kind, body, stream, request


def _stream_of(kind: str, body: typing.Any) -> session.Stream | None:
    """What a message announces."""
    if kind in ("version_surface", "edit_preview"):
        return body.surface.stream
    if kind in ("surface_update", "field_update", "file_ready", "section_ready", "versions_compared", "print_checked"):
        return body.stream
    return None


class Link:
    """A connection from Hello to its end. It does not come back: make another one."""

    def __init__(self, socket: typing.Any, on_event: OnEvent, on_lost: OnLost) -> None:
        self._socket = socket
        self._on_event = on_event
        self._on_lost = on_lost
        self._ids = itertools.count(1)
        self._uploads = itertools.count(1)
        self._pending: dict[int, _Pending] = {}
        self._streams: dict[int, _Arrival] = {}
        self._surfaces: collections.deque[_Arrival] = collections.deque()  # As they were announced.
        self._last_word: errors.TeditError | None = None  # An Error for no request: why the server will close.
        self._end: errors.TeditError | None = None
        self._reader = asyncio.create_task(self._read())
        self.welcome = envelope.Welcome()

    @staticmethod
    async def open(url: str, token: str, name: str, limit: float, on_event: OnEvent, on_lost: OnLost) -> Link:
        try:
            socket = await websockets.connect(  # type: ignore[attr-defined]
                url, max_size=MAX_MESSAGE, compression=None, open_timeout=limit, ping_timeout=PING_PATIENCE_S, close_timeout=2
            )
        except asyncio.TimeoutError as problem:
            raise errors.ConnectionLost(f"no server answers at {url} within {limit:g} s") from problem
        except (OSError, websockets.WebSocketException) as problem:  # type: ignore[attr-defined]
            raise errors.ConnectionLost(f"there is no server at {url}: {problem}", remedy="Start one with: tedit serve") from problem
        link = Link(socket, on_event, on_lost)
        try:
            hello = envelope.Hello(protocol_major=MAJOR, protocol_minor=MINOR, client=name, token=token)
            link.welcome = (await link.ask("hello", hello, limit=limit)).body
        except BaseException:
            await link.close()
            raise
        return link

    @property
    def end(self) -> errors.TeditError | None:
        """Why the connection is gone; nothing while it is there."""
        return self._end

    async def close(self) -> None:
        self._end = self._end or errors.ConnectionLost("the connection was closed")
        await self._socket.close()
        await asyncio.gather(self._reader, return_exceptions=True)

    # -- requests

    async def ask(
        self,
        kind: str,
        body: typing.Any,
        *,
        progress: Progress | None = None,
        limit: float | None = None,
        arrived: typing.Callable[[typing.Any], None] | None = None,
        traceparent: str = "",
    ) -> Answer:
        """Sends a request and gives its answer. Whoever cancels this coroutine cancels the request on the server.
        `arrived` has the answer before any message that comes after it. Raises what the server says, `Timeout` after
        `limit` seconds, `ConnectionLost`."""
        if self._end:
            raise self._end
        number = next(self._ids)
        request = self._pending[number] = _Pending(progress, arrived)
        try:
            await self._send(number, kind, body, traceparent)
            return await asyncio.wait_for(request.future, limit)
        except asyncio.TimeoutError:
            await self._cancel(number)
            raise errors.Timeout(f"the server gave no answer within {limit:g} s") from None
        except asyncio.CancelledError:
            await self._cancel(number)
            raise
        finally:
            self._forget(request)
            self._pending.pop(number, None)
            if not request.future.cancel() and not request.future.cancelled():
                request.future.exception()  # Seen, also when sending failed before.

    async def ask_with_file(self, data: bytes, kind: str, body: typing.Any, **how: typing.Any) -> Answer:
        """Uploads a file, then asks for what `body` says of it."""
        body.upload, body.size = next(self._uploads), len(data)
        number = next(self._ids)
        refusal = _Pending(None)
        self._pending[number] = refusal  # Pieces have no answer, but may be refused: they share one number.
        try:
            for offset in range(0, len(data), PIECE):
                if refusal.future.done():
                    break
                piece = session.UploadChunk(upload=body.upload, offset=offset, data=data[offset : offset + PIECE])
                await self._send(number, "upload_chunk", piece)
            return await self.ask(kind, body, **how)
        except errors.ProtocolError:
            if refusal.future.done():
                refusal.future.result()  # A piece that was refused is the reason.
            raise
        finally:
            self._pending.pop(number, None)
            refusal.future.cancel()

    async def _send(self, number: int, kind: str, body: typing.Any, traceparent: str = "") -> None:
        message = envelope.ClientMessage(request_id=number, traceparent=traceparent)
        getattr(message, kind).CopyFrom(body)
        getattr(message, kind).SetInParent()
        data = message.SerializeToString()
        if self.welcome.max_message_bytes and len(data) > self.welcome.max_message_bytes:
            raise errors.InvalidArgument(f"the request has {len(data)} bytes, the server takes {self.welcome.max_message_bytes}")
        try:
            await self._socket.send(data)
        except websockets.ConnectionClosed:  # type: ignore[attr-defined]
            await asyncio.gather(self._reader, return_exceptions=True)  # Which knows why.
            raise (self._end or errors.ConnectionLost("the connection broke")) from None

    async def _cancel(self, number: int) -> None:
        """What is not there any more needs no answer: that to Cancel is not waited for."""
        try:
            await self._send(next(self._ids), "cancel", envelope.Cancel(request_id=number))
        except errors.TeditError:
            pass

    def _forget(self, request: _Pending) -> None:
        for arrival in self._streams.values():
            if arrival.request is request:
                arrival.request = None
                arrival.stream.discard()

    # -- what comes

    async def _read(self) -> None:
        end: errors.TeditError = errors.ConnectionLost("the connection was closed")
        try:
            async for data in self._socket:
                message = envelope.ServerMessage.FromString(data)
                self._last_word = None  # It explains the end only as the last word.
                self._take(message.request_id, message.WhichOneof("body"), message)
        except websockets.ConnectionClosed as problem:  # type: ignore[attr-defined]
            end = errors.ConnectionLost(f"the connection broke: {problem}", remedy="Connect again.")
        except errors.TeditError as problem:
            end = problem
        except Exception as problem:  # No message of the protocol.
            end = errors.ProtocolError(f"the server sent what cannot be understood: {problem}")
        self._end = self._end or self._last_word or end
        for request in self._pending.values():
            request.fail(self._end)
        self._streams.clear()
        self._on_lost(self)
        await self._socket.close()

    def _take(self, number: int, kind: str | None, message: envelope.ServerMessage) -> None:
        if kind is None:
            return  # An event that a newer server knows.
        body = getattr(message, kind)
        request = self._pending.get(number) if number else None
        if kind == "chunk":
            self._take_chunk(body)
        elif kind == "progress":
            if request:
                request.report(body)
        elif kind == "error":
            self._take_error(number, request, errors.from_message(body))
        elif (header := _stream_of(kind, body)) is not None:
            self._begin(_Arrival(kind, body, IncomingStream(header, keep=number == 0 or request is not None), request))
        else:
            if number == 0 or kind in ("committed", "solved"):
                self._on_event(kind, body, None)
            if request:
                request.finish(Answer(kind, body, None))

    def _take_error(self, number: int, request: _Pending | None, problem: errors.TeditError) -> None:
        if request:
            request.fail(problem)
        elif number == 0:
            self._last_word = problem

    def _begin(self, arrival: _Arrival) -> None:
        if len(self._streams) >= MAX_STREAMS or arrival.stream.number in self._streams:
            raise errors.ProtocolError(f"the server announces stream {arrival.stream.number} before others are done")
        self._streams[arrival.stream.number] = arrival
        if arrival.kind == "surface_update":
            self._surfaces.append(arrival)
        if arrival.stream.complete:
            self._finish(arrival)

    def _take_chunk(self, chunk: session.Chunk) -> None:
        arrival = self._streams.get(chunk.stream)
        if arrival is None:
            raise errors.ProtocolError(f"the server sends a piece of stream {chunk.stream}, which it has not announced")
        arrival.stream.append(chunk)
        if arrival.stream.complete:
            self._finish(arrival)

    def _finish(self, arrival: _Arrival) -> None:
        del self._streams[arrival.stream.number]
        if arrival.kind == "surface_update":
            # Differences build on each other in the order of their announcements.
            while self._surfaces and self._surfaces[0].stream.complete:
                first = self._surfaces.popleft()
                self._on_event(first.kind, first.body, first.stream.arrays())
        elif arrival.kind == "field_update":
            self._on_event(arrival.kind, arrival.body, arrival.stream.arrays())
        elif arrival.request:
            arrival.request.finish(Answer(arrival.kind, arrival.body, arrival.stream))
