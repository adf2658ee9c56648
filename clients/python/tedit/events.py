# SPDX-License-Identifier: AGPL-3.0-or-later
"""What a document tells by itself: messages of the protocol, and these."""
from __future__ import annotations

import collections
import dataclasses
import queue
import threading
import typing

from .errors import TeditError
from .surface import Field, Surface
from .v1 import envelope_pb2 as envelope
from .v1 import library_pb2 as library
from .v1 import session_pb2 as session

#: Events that an iterator or a slow callback may be behind; the oldest go.
KEPT_EVENTS = 1000


@dataclasses.dataclass(frozen=True)
class SurfaceChanged:
    surface: Surface  #: What the document holds now.


@dataclasses.dataclass(frozen=True)
class FieldArrived:
    field: Field  #: Of one load case or of an envelope; maybe a first one (`field.interim`).


@dataclasses.dataclass(frozen=True)
class Lost:
    reason: TeditError
    for_good: bool  #: False: the connection is being made anew.


@dataclasses.dataclass(frozen=True)
class Reconnected:
    """The connection is there again. What was said meanwhile was missed; `head` and the like are those of now."""

    document: str


Event = typing.Union[
    session.Committed,
    session.Solved,
    session.SolveStatus,
    session.LoadCasesChanged,
    session.VersionAnnotated,
    session.CadStateChanged,
    library.ParticipantChanged,
    session.DocumentRenamed,
    envelope.BacklogNotice,
    SurfaceChanged,
    FieldArrived,
    Lost,
    Reconnected,
]


class Listener:
    """Events on their way to one iterator or callback."""

    def __init__(self) -> None:
        self._events: collections.deque[Event | None] = collections.deque(maxlen=KEPT_EVENTS)
        self._there = threading.Semaphore(0)

    def put(self, event: Event | None) -> None:
        self._events.append(event)
        self._there.release()

    def get(self, timeout: float | None) -> Event | None:
        """The next one; None at the end. Raises `queue.Empty`."""
        while True:
            if not self._there.acquire(timeout=timeout):
                raise queue.Empty
            try:
                return self._events.popleft()
            except IndexError:  # One that was pushed out.
                continue
