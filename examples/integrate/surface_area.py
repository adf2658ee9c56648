#!/usr/bin/env python3
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Reads bulk data: has a server import a mesh, takes the surface that it sends, and adds up its area from the arrays of
positions and facets.

usage: surface_area.py SERVER TOKEN_FILE MESH

Needs what hole_study.py needs, which stands beside it.
"""
import asyncio
import math
import pathlib
import sys

from hole_study import Refused, Server, envelope, session, websockets

# As Python's memoryview calls the types of values.
FORMATS = {
    session.ArrayInfo.UINT8: ("B", 1), session.ArrayInfo.UINT32: ("I", 4), session.ArrayInfo.INT64: ("q", 8),
    session.ArrayInfo.FLOAT32: ("f", 4), session.ArrayInfo.FLOAT64: ("d", 8)}


def arrays_of(stream, data):
    """The arrays of a complete stream by name, flat. Those of older servers have no offset: each begins where the one
    before ends."""
    result, at = {}, 0
    for array in stream.arrays:
        letter, size = FORMATS[array.type]
        if array.HasField("offset"):
            at = array.offset
            assert at % 8 == 0, f"{array.name} begins at byte {at}"
        length = size * array.components * array.items
        result[array.name] = memoryview(data)[at:at + length].cast(letter)
        at += length
    return result


async def next_surface(socket):
    """The next SurfaceUpdate and its arrays; other messages pass by."""
    update, data = None, bytearray()
    while update is None or len(data) < update.stream.bytes:
        message = envelope.ServerMessage.FromString(await socket.recv())
        kind = message.WhichOneof("body")
        if kind == "surface_update":
            update = message.surface_update
        elif kind == "chunk" and update is not None and message.chunk.stream == update.stream.stream:
            data += message.chunk.data
    return update, arrays_of(update.stream, bytes(data))


def area_of(arrays):
    """m2; vertices and facets are slots, so points are looked up by their number."""
    places = {slot: 3 * i for i, slot in enumerate(arrays["vertices"])}
    positions, corners = arrays["positions"], arrays["facet_vertices"]

    def side(a, b):
        return [positions[places[b] + i] - positions[places[a] + i] for i in range(3)]

    area = 0
    for f in range(0, len(corners), 3):
        u, v = side(corners[f], corners[f + 1]), side(corners[f], corners[f + 2])
        normal = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
        area += math.hypot(*normal) / 2
    return area


async def show(url, token_file, mesh):
    async with websockets.connect(url, max_size=16 << 20) as socket:
        server = Server(socket)
        token = pathlib.Path(token_file).read_text().strip()
        await server.ask("hello", protocol_major=1, protocol_minor=10, client="surface_area", token=token)
        server.document = (await server.ask("open_document")).document
        await server.upload(mesh)
        await server.ask("open_document", name=server.document, watch_surface=True)  # The surface follows.
        update, arrays = await next_surface(socket)
        told = sum(surface.area_m2 for surface in update.surfaces)
        print(f"{len(arrays['facets'])} facets, {len(arrays['vertices'])} vertices, {len(update.surfaces)} surfaces, "
              f"area {area_of(arrays) * 1e4:.6g} cm2 (the server says {told * 1e4:.6g})")


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    try:
        asyncio.run(show(*sys.argv[1:]))
    except (Refused, OSError, websockets.WebSocketException) as reason:
        sys.exit(str(reason))
