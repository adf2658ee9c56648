# SPDX-License-Identifier: AGPL-3.0-or-later
"""Answers of several values."""
from __future__ import annotations

import dataclasses

from .streams import Arrays
from .surface import Surface
from .v1 import comparison_pb2 as comparison
from .v1 import print_pb2
from .v1 import report_pb2
from .v1 import session_pb2 as session


@dataclasses.dataclass(frozen=True)
class ImportedPart:
    """A document that was made of a CAD file or a surface."""

    document: str
    warnings: tuple[str, ...]  #: What a person should know, a sentence each.


@dataclasses.dataclass(frozen=True)
class Preview:
    """What an edit would make."""

    message: session.EditPreview
    arrays: Arrays  #: The difference to the head's surface.

    @property
    def report(self) -> report_pb2.EditReport:
        """As `Committed.report` would be."""
        return self.message.report

    def surface(self, head: Surface) -> Surface:
        """The surface that the edit would make of the head's; `ProtocolError` when it is of another version."""
        return head.apply(self.message.surface, self.arrays)


@dataclasses.dataclass(frozen=True)
class Section:
    """A plane through the part."""

    message: session.SectionReady
    arrays: Arrays  #: positions (m) and triangles; of a solved version von_mises_pa, displacement_m, ...


@dataclasses.dataclass(frozen=True)
class Comparison:
    """What two versions differ in."""

    message: comparison.VersionsCompared
    arrays: Arrays  #: vertices, difference_mark, von_mises_pa_difference, ...; none without a load case.


@dataclasses.dataclass(frozen=True)
class PrintCheck:
    """What hinders printing a version."""

    message: print_pb2.PrintChecked
    arrays: Arrays  #: facets (slots, ascending) and marks of those that are marked: 1 thin, 2 overhanging, 3 both.

    @property
    def watertight(self) -> bool:
        return self.message.open_edges == 0
