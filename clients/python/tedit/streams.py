# SPDX-License-Identifier: AGPL-3.0-or-later
"""Bulk data: pieces put together, and read as numpy arrays."""
from __future__ import annotations

import typing

import numpy as np
import numpy.typing as npt

from .errors import ProtocolError
from .v1 import session_pb2 as session

Array = npt.NDArray[typing.Any]
Arrays = dict[str, Array]

#: The largest stream that is received, bytes.
MAX_BYTES = 4 << 30

TYPES: dict[int, np.dtype[typing.Any]] = {
    session.ArrayInfo.UINT8: np.dtype("<u1"),
    session.ArrayInfo.UINT32: np.dtype("<u4"),
    session.ArrayInfo.INT64: np.dtype("<i8"),
    session.ArrayInfo.FLOAT32: np.dtype("<f4"),
    session.ArrayInfo.FLOAT64: np.dtype("<f8"),
}


class IncomingStream:
    """What a `tedit.v1.Stream` announced: filled by pieces, then read as arrays."""

    def __init__(self, header: session.Stream, *, keep: bool = True) -> None:
        """With `keep` false the bytes are counted and thrown away. Raises `ProtocolError` when the sizes do not add
        up, arrays overlap, or one is of no known type."""
        self.number = header.stream
        self._header = header
        self._keep = keep
        self._data = bytearray()
        self._received = 0
        self._places = self._lay_out()

    def _lay_out(self) -> list[tuple[session.ArrayInfo, np.dtype[typing.Any], int]]:
        places = []
        end = 0
        for array in self._header.arrays:
            if array.type not in TYPES or array.components == 0:
                raise self._fault(f'has array "{array.name}" of an unknown type')
            at = array.offset if array.HasField("offset") else end
            if at < end:
                raise self._fault(f'has array "{array.name}" inside the one before')
            end = at + TYPES[array.type].itemsize * array.components * array.items
            places.append((array, TYPES[array.type], at))
        if end != self._header.bytes:
            raise self._fault(f"announces {self._header.bytes} bytes, but its arrays end at {end}")
        if end > MAX_BYTES:
            raise self._fault(f"is larger than {MAX_BYTES} bytes")
        return places

    def _fault(self, what: str) -> ProtocolError:
        return ProtocolError(f"stream {self.number} {what}")

    @property
    def complete(self) -> bool:
        return self._received == self._header.bytes

    def discard(self) -> None:
        """Throws the data away, those to come too; the pieces are still checked."""
        self._keep = False
        self._data = bytearray()

    def append(self, chunk: session.Chunk) -> None:
        """Takes the next piece; raises `ProtocolError` when it is not the next one or too long."""
        if chunk.offset != self._received:
            raise self._fault(f"goes on at byte {chunk.offset} after {self._received} bytes")
        if len(chunk.data) > self._header.bytes - self._received:
            raise self._fault(f"brings more than the announced {self._header.bytes} bytes")
        if self._keep:
            self._data += chunk.data
        self._received += len(chunk.data)

    def arrays(self) -> Arrays:
        """The arrays of a complete stream by name, views of its memory that cannot be written to. One with several
        components has two dimensions."""
        result = {}
        for array, kind, at in self._places:
            flat = np.frombuffer(self._data, kind, array.items * array.components, at) if array.items else np.empty(0, kind)
            flat.flags.writeable = False
            result[array.name] = flat if array.components == 1 else flat.reshape(-1, array.components)
        return result

    def data(self, name: str) -> bytes:
        """One array's bytes, as a file's."""
        for array, kind, at in self._places:
            if array.name == name:
                return bytes(memoryview(self._data)[at : at + kind.itemsize * array.components * array.items])
        return b""
