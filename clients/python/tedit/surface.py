# SPDX-License-Identifier: AGPL-3.0-or-later
"""The boundary of a part, and values on it."""
from __future__ import annotations

import dataclasses
import functools

import numpy as np
import numpy.typing as npt

from .errors import ProtocolError
from .streams import Array, Arrays
from .v1 import report_pb2
from .v1 import session_pb2 as session

Slots = npt.NDArray[np.uint32]

_NO_SLOTS = np.empty(0, np.uint32)


def _rows_of(sorted_slots: Slots, wanted: Array) -> npt.NDArray[np.intp]:
    """Where each slot stands; -1 for one that is not there."""
    rows = np.searchsorted(sorted_slots, wanted)
    rows[rows == len(sorted_slots)] = 0
    missing = sorted_slots[rows] != wanted if len(sorted_slots) else np.ones(wanted.shape, bool)
    return np.where(missing, -1, rows)


def _check_unique(name: str, slots: Array) -> None:
    if len(np.unique(slots)) != len(slots):
        raise ProtocolError(f'a surface update lists a slot twice in "{name}"')


class _Table:
    """Rows by slot, ascending. A change makes a new table; the one before keeps its values."""

    def __init__(self, slots: Slots, columns: tuple[Array, ...]) -> None:
        self.slots = slots
        self.columns = columns

    def patched(self, removed: Array, slots: Array, columns: tuple[Array, ...]) -> _Table:
        stays = ~np.isin(self.slots, np.concatenate([removed, slots]))
        joined = np.concatenate([self.slots[stays], slots])
        order = np.argsort(joined, kind="stable")
        return _Table(
            joined[order],
            tuple(np.concatenate([old[stays], new])[order] for old, new in zip(self.columns, columns)),
        )


@dataclasses.dataclass(frozen=True)
class TriangleMesh:
    """A surface as most programs want it: points, and triangles as rows of points."""

    points: npt.NDArray[np.float64]  #: m, a row each.
    triangles: npt.NDArray[np.intp]  #: Rows of `points`; the normal points outward.
    surface_ids: npt.NDArray[np.int64]  #: Of each triangle: the CAD system's number.
    vertex_slots: Slots  #: Of each point; fields are looked up by it.
    facet_slots: Slots  #: Of each triangle; stable over edits.


class Surface:
    """The boundary of one version. Never changes: an update makes a new one."""

    def __init__(self) -> None:
        self.version_id = ""
        self.surfaces: dict[int, session.SurfaceInfo] = {}  #: By id.
        self._vertices = _Table(_NO_SLOTS, (np.empty((0, 3)),))
        self._facets = _Table(_NO_SLOTS, (np.empty((0, 3), np.uint32), np.empty(0, np.int64)))

    def apply(self, update: session.SurfaceUpdate, arrays: Arrays) -> Surface:
        """The surface after an update, whole or as a difference to this one. Raises `ProtocolError` for an update
        that builds on another version or does not fit."""
        if not update.version_id:
            raise ProtocolError("a surface update names no version")
        base = self if update.base_version_id else Surface()
        if update.base_version_id and update.base_version_id != self.version_id:
            raise ProtocolError(
                f"a surface update builds on version {update.base_version_id}, but this client holds "
                + (self.version_id or "none"),
                remedy="Open the document again to get the whole surface.",
            )
        result = Surface()
        result.version_id = update.version_id
        gone = set(update.removed)
        result.surfaces = {number: info for number, info in base.surfaces.items() if number not in gone}
        result.surfaces.update((info.id, info) for info in update.surfaces)
        result._patch(base, arrays)
        return result

    def _patch(self, base: Surface, arrays: Arrays) -> None:
        vertices, facets = arrays.get("vertices", _NO_SLOTS), arrays.get("facets", _NO_SLOTS)
        for name in ("vertices", "facets", "removed_facets"):
            _check_unique(name, arrays.get(name, _NO_SLOTS))
        positions = arrays.get("positions", np.empty((0, 3)))
        corners = arrays.get("facet_vertices", np.empty((0, 3), np.uint32))
        owners = arrays.get("facet_surfaces", np.empty(0, np.int64))
        if positions.shape != (len(vertices), 3) or corners.shape != (len(facets), 3) or owners.shape != facets.shape:
            raise ProtocolError("a surface update has arrays whose lengths do not fit")
        # Vertices that no facet has any more are kept: the server builds on what it has sent.
        self._vertices = base._vertices.patched(_NO_SLOTS, vertices, (positions,))
        self._facets = base._facets.patched(arrays.get("removed_facets", _NO_SLOTS), facets, (corners, owners))
        if (_rows_of(self._vertices.slots, corners) < 0).any():
            raise ProtocolError("a surface update has a facet with a vertex that was never sent")

    @functools.cached_property
    def mesh(self) -> TriangleMesh:
        """Points and triangles; made when it is asked for first."""
        corners, owners = self._facets.columns
        used, rows = np.unique(corners, return_inverse=True)
        points = self._vertices.columns[0][_rows_of(self._vertices.slots, used)]
        return TriangleMesh(points, rows.reshape(-1, 3), owners, used, self._facets.slots)

    def area_m2(self, surface: int | None = None) -> float:
        """Of one surface, or of all."""
        mesh = self.mesh
        triangles = mesh.triangles if surface is None else mesh.triangles[mesh.surface_ids == surface]
        a, b, c = (mesh.points[triangles[:, i]] for i in range(3))
        return float(np.linalg.norm(np.cross(b - a, c - a), axis=1).sum() / 2)


class Field:
    """Values at the vertices of the boundary: of one load case, or of the envelope of several."""

    def __init__(self, update: session.FieldUpdate, arrays: Arrays) -> None:
        self.message = update
        self.arrays = arrays  #: By name: "displacement_m", "von_mises_pa", ...; a row for each of `slots`.
        self.slots: Slots = arrays.get("vertices", _NO_SLOTS)  #: Ascending.
        for name, values in arrays.items():
            if len(values) != len(self.slots):
                raise ProtocolError(f'a field has {len(values)} rows in "{name}" for {len(self.slots)} vertices')

    @property
    def report(self) -> report_pb2.SolveReport | None:
        """Of a load case; an envelope has none."""
        return self.message.report if self.message.HasField("report") else None

    @property
    def envelope(self) -> report_pb2.Envelope | None:
        return self.message.envelope if self.message.HasField("envelope") else None

    @property
    def version_id(self) -> str:
        return self.message.envelope.version_id or self.message.report.version_id

    @property
    def interim(self) -> bool:
        """A first field of a solve that still runs."""
        return self.message.report.interim or self.message.envelope.interim

    def on(self, mesh: TriangleMesh, name: str) -> Array:
        """The array's rows for the points of a mesh of the same version. Raises `KeyError` when there is no such
        array, `ValueError` when the mesh has vertices that the field has not."""
        values: Array = self.arrays[name]
        rows = _rows_of(self.slots, mesh.vertex_slots)
        if (rows < 0).any():
            raise ValueError("the field belongs to another version than the surface")
        return values[rows]
