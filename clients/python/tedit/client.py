# SPDX-License-Identifier: AGPL-3.0-or-later
"""The connection to a server, and the documents that it has."""
from __future__ import annotations

import asyncio
import concurrent.futures
import os
import pathlib
import threading
import typing

from . import errors
from ._link import Answer, Link, Progress
from .answers import ImportedPart
from .document import Document
from .events import Reconnected
from .streams import Arrays
from .v1 import envelope_pb2 as envelope
from .v1 import library_pb2 as library
from .v1 import operation_pb2 as operation
from .v1 import session_pb2 as session
from .values import FileLike, contents

#: Asked twice these do something else the second time, and have no edit id that would keep them from it.
NOT_REPEATED = ("copy_document", "delete_document", "add_document", "import_part")
#: Of the time for connecting again, how long one try may take, s.
TRY_S = 5


class CancelToken:
    """Hand it to a call that takes long; `cancel` ends that call from another thread, with `errors.Cancelled`."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._cancelled = False
        self._running: set[concurrent.futures.Future[typing.Any]] = set()

    @property
    def cancelled(self) -> bool:
        return self._cancelled

    def cancel(self) -> None:
        with self._lock:
            self._cancelled = True
            running = list(self._running)
        for future in running:
            future.cancel()

    def _add(self, future: concurrent.futures.Future[typing.Any]) -> None:
        with self._lock:
            self._running.add(future)
            if not self._cancelled:
                return
        future.cancel()

    def _drop(self, future: concurrent.futures.Future[typing.Any]) -> None:
        with self._lock:
            self._running.discard(future)


class Client:
    """A connection to a server. All calls block, may come from any thread, and raise `errors.TeditError`.

    When the connection breaks it is made anew, for up to `reconnect_s` seconds; documents are opened again, and what
    was asked is asked again where that is safe: questions, and changes, which have an edit id and so are made once.
    """

    def __init__(
        self,
        url: str,
        token: str,
        *,
        name: str = "tedit-python",
        timeout: float = 60,
        reconnect_s: float = 30,
        traceparent: typing.Callable[[], str] | None = None,
    ) -> None:
        """`timeout`: seconds for connecting and for what is answered soon. `reconnect_s` 0: a broken connection stays so.
        `traceparent`: what each call is a part of, as that header of the W3C's Trace Context; asked in the thread that calls."""
        self.url = url
        self._traceparent = traceparent
        self._token, self._name, self._timeout, self._reconnect_s = token, name, timeout, reconnect_s
        self._documents: dict[str, Document] = {}  # By the name of today; touched in the loop only.
        self._closed = False
        self._loop = asyncio.new_event_loop()
        self._thread = threading.Thread(target=self._loop.run_forever, name="tedit", daemon=True)
        self._thread.start()
        self._link: Link
        self._repair: asyncio.Task[None] | None = None
        try:
            self._run(self._start())
        except BaseException:
            self.close()
            raise

    def __enter__(self) -> Client:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def close(self) -> None:
        """Ends the connection. Documents stay on the server."""
        if self._closed:
            return
        self._closed = True
        self._run(self._end())
        self._loop.call_soon_threadsafe(self._loop.stop)
        self._thread.join()
        self._loop.close()

    @property
    def welcome(self) -> envelope.Welcome:
        """What the server said of itself: its version, `formats` of files, `results` of solves."""
        return self._link.welcome

    # -- the server

    def operations(self) -> operation.Catalogue:
        """What edits the server offers, with their parameters, and the plugins that it does not use."""
        return self._ask("list_operations", envelope.ListOperations()).body

    def status(self) -> envelope.ServerStatus:
        return self._ask("get_status", envelope.GetStatus()).body

    # -- its documents

    def documents(self) -> list[library.DocumentInfo]:
        return list(self._ask("list_documents", library.ListDocuments()).body.documents)

    def open(self, name: str = "", *, surface: bool = True, fields: bool = True) -> Document:
        """Opens a document; one that is not there is made. Without a name it is a temporary one. `surface` and
        `fields` say what is sent and kept current by itself."""
        document = Document(self, name, surface=surface, fields=fields)
        self._run(self._open(document))
        return document

    def copy_document(self, document: str, name: str, *, cancel: CancelToken | None = None) -> None:
        """Gives another name a copy of a document with all its versions; the copy is not opened."""
        self._ask("copy_document", library.CopyDocument(document=document, name=name), cancel=cancel, quick=False)

    def delete_document(self, document: str) -> None:
        """Takes a document from the server for good. Raises `Conflict` while others have it open."""
        name = self._ask("delete_document", library.DeleteDocument(document=document), quick=False).body.document
        self._loop.call_soon_threadsafe(self._forget, name)

    def add_document(
        self, file: FileLike, name: str, *, or_next_free: bool = False, progress: Progress | None = None, cancel: CancelToken | None = None
    ) -> str:
        """Makes a document file (.tedit) a document of the server and returns its name."""
        body = library.AddDocument(name=name, or_next_free=or_next_free)
        return self._ask("add_document", body, file=contents(file)[0], progress=progress, cancel=cancel, quick=False).body.document

    def import_part(
        self,
        file: FileLike,
        name: str = "",
        *,
        fineness: str = "medium",
        length_unit: str = "",
        local_sizes: typing.Mapping[str | int, float] | None = None,
        or_next_free: bool = False,
        progress: Progress | None = None,
        cancel: CancelToken | None = None,
    ) -> ImportedPart:
        """Meshes a CAD file (STEP, IGES, BREP) or a closed surface (STL, OBJ, PLY, 3MF) on the server and makes it a
        document; without a name a temporary one. `fineness` is "coarse", "medium" or "fine"; `local_sizes` has the longest edge, m, on surfaces of a CAD
        file by their number or name; `length_unit` is that of an STL, OBJ or PLY: "mm", "cm", "m", "in"."""
        data, file_name = contents(file)
        sizes = [library.ImportPart.LocalSize(surface=str(one), edge_length=size) for one, size in (local_sizes or {}).items()]
        body = library.ImportPart(
            name=name, or_next_free=or_next_free, file_name=file_name, fineness=fineness, length_unit=length_unit, local_sizes=sizes
        )
        made = self._ask("import_part", body, file=data, progress=progress, cancel=cancel, quick=False).body
        return ImportedPart(made.document, tuple(made.warnings))

    # -- for documents

    def _ask(
        self,
        kind: str,
        body: typing.Any,
        *,
        file: bytes | None = None,
        progress: Progress | None = None,
        cancel: CancelToken | None = None,
        quick: bool = True,
        arrived: typing.Callable[[typing.Any], None] | None = None,
    ) -> Answer:
        part_of = self._traceparent() if self._traceparent else ""
        how = {"progress": progress, "limit": self._timeout if quick else None, "arrived": arrived, "traceparent": part_of}
        return self._run(self._ask_until_answered(kind, body, file, how), cancel)

    def _run(self, work: typing.Coroutine[typing.Any, typing.Any, typing.Any], cancel: CancelToken | None = None) -> typing.Any:
        if threading.current_thread() is self._thread:
            work.close()
            raise RuntimeError("a blocking call from a progress callback: it would wait for itself")
        if not self._thread.is_alive():
            work.close()
            raise errors.ConnectionLost("the client was closed")
        future = asyncio.run_coroutine_threadsafe(work, self._loop)
        if cancel:
            cancel._add(future)
        try:
            return future.result()
        except concurrent.futures.CancelledError:
            raise errors.Cancelled("the call was cancelled") from None
        except BaseException:
            future.cancel()  # An interrupt: the server need not go on.
            raise
        finally:
            if cancel:
                cancel._drop(future)

    # -- in the loop

    async def _start(self) -> None:
        self._link = await self._connect(self._timeout)

    async def _end(self) -> None:
        if self._repair:  # First: it would make another link.
            await _stop(self._repair)
        if hasattr(self, "_link"):
            await self._link.close()
        for task in asyncio.all_tasks() - {asyncio.current_task()}:  # Calls of other threads.
            await _stop(task)

    async def _connect(self, limit: float) -> Link:
        return await Link.open(self.url, self._token, self._name, limit, self._take_event, self._take_loss)

    async def _ask_until_answered(self, kind: str, body: typing.Any, file: bytes | None, how: dict[str, typing.Any]) -> Answer:
        while True:
            link = await self._connected()
            try:
                if file is None:
                    return await link.ask(kind, body, **how)
                return await link.ask_with_file(file, kind, body, **how)
            except errors.ConnectionLost:
                if not self._reconnect_s or kind in NOT_REPEATED or self._closed:
                    raise

    async def _connected(self) -> Link:
        if self._link.end and self._reconnect_s and not self._closed and (not self._repair or self._repair.done()):
            self._begin_repair()
        if self._repair and not self._repair.done():
            try:
                await asyncio.shield(self._repair)
            except asyncio.CancelledError:
                if self._closed:
                    raise errors.ConnectionLost("the client was closed") from None
                raise
        return self._link

    async def _open(self, document: Document) -> None:
        def adopt(state: session.DocumentState) -> None:
            self._adopt(document, state)

        while True:
            link = await self._connected()
            try:
                await link.ask("open_document", document._request(), arrived=adopt)
                return
            except errors.ConnectionLost:
                if not self._reconnect_s or not document.name or self._closed:  # Asked twice without a name it would make two.
                    raise

    def _adopt(self, document: Document, state: session.DocumentState) -> None:
        """Before anything of it arrives."""
        before = self._documents.get(state.document)
        if before and before is not document:
            before._take_loss(errors.Cancelled("the document was opened again"), for_good=True)
        self._drop(document)
        self._documents[state.document] = document
        document._take_state(state)

    def _forget(self, name: str) -> None:
        document = self._documents.pop(name, None)
        if document:
            document._take_loss(errors.Cancelled("the document was deleted"), for_good=True)

    def _drop(self, document: Document) -> None:
        self._documents = {name: one for name, one in self._documents.items() if one is not document}

    def _take_loss(self, link: Link) -> None:
        if getattr(self, "_link", None) is not link or (self._repair and not self._repair.done()):
            return
        if self._reconnect_s and not self._closed:
            self._begin_repair()
        else:
            self._tell_loss(link.end or errors.ConnectionLost("the connection was closed"), for_good=True)

    def _begin_repair(self) -> None:
        self._tell_loss(self._link.end or errors.ConnectionLost("the connection was closed"), for_good=False)
        self._repair = self._loop.create_task(self._reconnect())
        self._repair.add_done_callback(lambda task: task.cancelled() or task.exception())  # Who asks next is told.

    def _tell_loss(self, reason: errors.TeditError, *, for_good: bool) -> None:
        for document in self._documents.values():
            document._take_loss(reason, for_good=for_good)

    async def _reconnect(self) -> None:
        until = self._loop.time() + self._reconnect_s
        wait = 0.1
        while True:
            try:
                self._link = await self._connect(min(self._timeout, TRY_S))
                for document in list(self._documents.values()):
                    await self._open_again(document)
                return
            except errors.TeditError as problem:
                if not isinstance(problem, errors.ConnectionLost) or self._loop.time() + wait > until:
                    self._tell_loss(problem, for_good=True)
                    raise
            await asyncio.sleep(wait)
            wait = min(2 * wait, 2)

    async def _open_again(self, document: Document) -> None:
        had_versions = document.head is not None
        try:
            await self._link.ask("open_document", document._request(), arrived=lambda state: self._adopt(document, state))
            if had_versions and document.head is None:  # A name that leads nowhere begins a new document.
                await self._link.ask("close_document", session.CloseDocument(document=document.name))
                raise errors.NotFound(f"the document {document.name} was deleted")
            if document.wants_fields:  # A solve may have ended meanwhile.
                await self._link.ask("watch_fields", document._watch_again())
            document._tell(Reconnected(document.name))
        except errors.ConnectionLost:
            raise
        except errors.TeditError as problem:  # Deleted meanwhile, for example: the others go on.
            self._drop(document)
            document._take_loss(problem, for_good=True)

    def _take_event(self, kind: str, body: typing.Any, arrays: Arrays | None) -> None:
        if kind == "document_renamed":
            document = self._documents.pop(body.before, None)
            if document:
                self._documents[body.document] = document
        if kind == "backlog_notice":  # Of the connection: all of its documents tell it.
            for document in list(self._documents.values()):
                document._tell(body)
            return
        document = self._documents.get(getattr(body, "document", ""))
        if document:
            document._take(kind, body, arrays)


async def _stop(task: asyncio.Task[typing.Any]) -> None:
    """Cancels a task until it has ended: one whose `asyncio.wait_for` is just done goes on as if nobody had."""
    while not task.done():
        task.cancel()
        await asyncio.wait({task}, timeout=0.05)


def connect(url: str, token: str, **options: typing.Any) -> Client:
    """As `Client`: `tedit.connect("ws://127.0.0.1:7464/v1", tedit.read_token())`."""
    return Client(url, token, **options)


def read_token(path: str | os.PathLike[str] | None = None) -> str:
    """The token of a server of this user: what `tedit serve` wrote into its token file."""
    if path is None:
        state = os.environ.get("XDG_STATE_HOME") or pathlib.Path.home() / ".local/state"
        path = pathlib.Path(state) / "tedit/token"
    return pathlib.Path(path).read_text(encoding="utf-8").strip()
