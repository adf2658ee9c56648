# SPDX-License-Identifier: AGPL-3.0-or-later
"""What goes wrong, a class for each error code of the protocol.

Catch the one that you can do something about, or `TeditError` for all. Codes are never renamed or used for something
else; one that this package does not know yet comes as a plain `TeditError` with its `code`.
"""
from __future__ import annotations

import dataclasses
import re
import typing


@dataclasses.dataclass(frozen=True)
class Most:
    """What the same edit may ask for instead; the server has tried it."""

    parameter: str  #: Id of the parameter that asked for too much.
    value: float  #: In its SI unit: the same request with this value succeeds.


@dataclasses.dataclass(frozen=True)
class Rival:
    """Whose change a request did not know of."""

    version_id: str  #: Of the head as it is.
    number: int
    client: str  #: Who made it, as that program named itself; empty: not known.
    cause: str  #: "import", "edit", "undo", "redo", "goto"; empty: not known.
    operation: str  #: Of an edit.
    made_at: str  #: UTC: "2026-11-23T08:45:00Z".


class TeditError(Exception):
    """A request that was not carried out. Its text is one line for a person: message, place and remedy."""

    code: str = ""  #: The stable lower-case name, for example "under_constrained".

    def __init__(
        self,
        message: str,
        *,
        remedy: str = "",
        where: str = "",
        code: str = "",
        most_that_works: Most | None = None,
        rival: Rival | None = None,
    ) -> None:
        place = f" ({where})" if where else ""
        super().__init__(f"{message}{place}" + (f". {remedy}" if remedy else ""))
        self.code = code or type(self).code
        self.message = message  #: What is wrong, with the numbers.
        self.remedy = remedy  #: What a person can do about it; may be empty.
        self.where = where  #: File and line, byte offset, element or surface; may be empty.
        self.most_that_works = most_that_works  #: Of an edit that asked for too much, where it is known.
        self.rival = rival  #: Of a conflict, when somebody else changed the document.


# -- input


class Usage(TeditError):
    """The command line or a request is malformed."""


class InvalidArgument(TeditError):
    """A value is outside what the call accepts."""


class BadInput(TeditError):
    """A file's content is malformed; `where` gives line or offset."""


class UnsupportedFormat(TeditError):
    """The file is of a kind, version or element type that is not read."""


class IoError(TeditError):
    """The operating system refused to read or write."""


# -- mesh


class InvalidMesh(TeditError):
    """A mesh invariant is broken; the message names the element."""


class InvertedTet(TeditError):
    """A tet has negative volume."""


class DegenerateTet(TeditError):
    """A tet has zero volume."""


class NonManifold(TeditError):
    """The boundary is no closed, oriented 2-manifold."""


class SurfaceNotFound(TeditError):
    """A surface id is not in the version's table."""


class PostconditionFailed(TeditError):
    """A candidate version broke a postcondition of an edit."""


# -- operations


class OperationNotFound(TeditError):
    """No plugin offers this operation."""


class InvalidParameter(TeditError):
    """A parameter is unknown, of the wrong type or out of its range."""


class EmptySelection(TeditError):
    """Nothing was selected, or nothing that the operation can act on."""


class NotAHole(TeditError):
    """The selected surfaces do not bound a hole."""


class NonPlanarRim(TeditError):
    """A rim of the selection does not lie in a plane."""


class MixedRim(TeditError):
    """A rim is neither convex nor concave all around."""


class CapIntersects(TeditError):
    """A cap would cut the part or another cap."""


class FlatPlug(TeditError):
    """The space to fill has next to no volume."""


class NotAProtrusion(TeditError):
    """The selected surfaces bound no boss, rib or fin."""


class MesherFailed(TeditError):
    """The tetrahedral mesher gave no usable mesh."""


class PluginRefused(TeditError):
    """A plugin could not be loaded; the message says why."""


# -- finite elements


class UnderConstrained(TeditError):
    """Rigid-body motion is left; the message names the free modes."""


class InvalidMaterial(TeditError):
    """A material's numbers are outside physics, or a region has none."""


class InvalidLoad(TeditError):
    """A load acts on nothing or is not a finite number."""


class NotConverged(TeditError):
    """The solver did not reach the tolerance."""


class DeviceUnavailable(TeditError):
    """The requested device does not exist or cannot do the work."""


class DeviceLost(TeditError):
    """The device failed while it worked."""


class OutOfMemory(TeditError):
    """The work needs more memory than there is."""


# -- running


class Cancelled(TeditError):
    """The caller cancelled the work."""


class Superseded(TeditError):
    """A newer version made the work pointless."""


class Timeout(TeditError):
    """The work did not end within its time limit."""


class ServiceUnavailable(TeditError):
    """A worker or server that is needed is not there."""


class ConnectionLost(ServiceUnavailable):
    """The connection to the server broke, or none could be made. What was asked may have been done."""

    code = "service_unavailable"


class NotFound(TeditError):
    """The named document, version or page does not exist."""


class Conflict(TeditError):
    """The request refers to a state that is no longer current; `rival` says whose change it is."""


class ProtocolError(TeditError):
    """A message could not be understood."""


class StorageError(TeditError):
    """The document's storage failed."""


class Internal(TeditError):
    """A defect of the program itself."""


class PermissionDenied(TeditError):
    """The caller's role is too low; the message names the least one."""


class UntrustedServer(TeditError):
    """A server's certificate is not one that the client trusts."""


def _code_of(name: str) -> str:
    return re.sub(r"(?<!^)(?=[A-Z])", "_", name).lower()


#: Each error code and its class.
BY_CODE: dict[str, type[TeditError]] = {}
for _class in TeditError.__subclasses__():
    _class.code = _code_of(_class.__name__)
    BY_CODE[_class.code] = _class


def from_message(message: typing.Any) -> TeditError:
    """The exception for a `tedit.v1.Error`."""
    most = message.most_that_works
    rival = message.conflict
    return BY_CODE.get(message.code, TeditError)(
        message.message,
        remedy=message.remedy,
        where=message.where,
        code=message.code,
        most_that_works=Most(most.parameter, most.value) if message.HasField("most_that_works") else None,
        rival=Rival(rival.version_id, rival.number, rival.client, rival.cause, rival.operation, rival.made_at)
        if message.HasField("conflict")
        else None,
    )
