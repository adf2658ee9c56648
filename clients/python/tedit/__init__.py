# SPDX-License-Identifier: AGPL-3.0-or-later
"""A client of TEdit: edits meshed parts on a server and sees their stress at once.

    with tedit.connect("ws://127.0.0.1:7464/v1", tedit.read_token()) as server:
        part = server.open("plate")
        part.import_mesh("plate.msh")

Messages are those of the protocol (`tedit.v1`, docs/protocol_reference.md); surfaces and fields are numpy arrays.
"""
from . import errors, events
from .answers import Comparison, ImportedPart, Preview, PrintCheck, Section
from .client import CancelToken, Client, connect, read_token
from .document import Document
from .errors import TeditError
from .surface import Field, Surface, TriangleMesh
from .values import make_edit_id

__all__ = [
    "CancelToken",
    "Client",
    "Comparison",
    "Document",
    "Field",
    "ImportedPart",
    "Preview",
    "PrintCheck",
    "Section",
    "Surface",
    "TeditError",
    "TriangleMesh",
    "connect",
    "errors",
    "events",
    "make_edit_id",
    "read_token",
]
