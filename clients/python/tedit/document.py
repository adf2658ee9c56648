# SPDX-License-Identifier: AGPL-3.0-or-later
"""A document: its versions, its loads, its surface and its fields."""
from __future__ import annotations

import collections
import os
import pathlib
import queue
import threading
import time
import typing

from . import errors
from .answers import Comparison, Preview, PrintCheck, Section
from .events import Event, FieldArrived, Listener, Lost, SurfaceChanged
from .streams import Arrays
from .surface import Field, Surface
from .v1 import comparison_pb2 as comparison
from .v1 import library_pb2 as library
from .v1 import load_case_pb2 as load_case
from .v1 import print_pb2
from .v1 import session_pb2 as session
from .values import FileLike, LoadCaseLike, PolicyLike, Value, contents, make_edit_id, parameter, policy
from .values import load_case as to_load_case

if typing.TYPE_CHECKING:
    from ._link import Answer, Progress
    from .client import CancelToken, Client

#: Solves whose fields are kept.
KEPT_SOLVES = 4

Parameters = typing.Mapping[str, Value]


class Document:
    """Made by `Client.open`. `head`, `load_cases`, `surface` and `fields` follow what anybody does with the document.

    Changes take `expected_version` (refused with `Conflict` unless that is the head; empty: any head) and `edit_id`
    (made here unless it is given): asked again with the same id, a change is not made twice.
    """

    def __init__(self, client: Client, name: str, *, surface: bool, fields: bool) -> None:
        self._client = client
        self._changed = threading.Condition()
        self._listeners: list[Listener] = []
        self._gone: errors.TeditError | None = None
        self._fields: collections.deque[list[Field]] = collections.deque(maxlen=KEPT_SOLVES)
        self._begun: list[Field] = []  # Of a solve whose others still come.
        self._surface_fault: errors.TeditError | None = None
        self.name = name  #: Follows when somebody renames the document.
        self.wants_surface = surface
        self.wants_fields = fields
        self.watched: list[str] = []  #: What `watch_fields` asked for.
        self.head: session.VersionInfo | None = None  #: None before the first import.
        self.can_undo = False
        self.can_redo = False
        self.load_cases: list[load_case.LoadCase] = []  #: Of the head.
        self.participants: list[library.Participant] = []  #: All who have the document open, this client too.
        self.participant = 0  #: Which of them this client is: `Participant.id`.
        self.surface = Surface()  #: Whole, of `surface.version_id`: the head's, or on its way there.

    # -- changes

    def import_mesh(
        self,
        file: FileLike,
        *,
        unit: str = "mm",
        file_name: str = "",
        expected_version: str = "",
        edit_id: str = "",
        progress: Progress | None = None,
        cancel: CancelToken | None = None,
    ) -> session.Committed:
        """Uploads a mesh file and makes it the new head. `unit` is the file's length unit."""
        data, name = contents(file)
        body = session.ImportMesh(file_name=file_name or name, length_unit=unit)
        return self._change("import_mesh", body, expected_version, edit_id, file=data, progress=progress, cancel=cancel).body

    def set_load_case(self, loads: LoadCaseLike, *, expected_version: str = "", edit_id: str = "") -> None:
        """Replaces the load case of this name at the head, or adds it."""
        self._change("set_load_case", session.SetLoadCase(load_case=to_load_case(loads)), expected_version, edit_id)

    def remove_load_case(self, name: str, *, expected_version: str = "", edit_id: str = "") -> None:
        self._change("remove_load_case", session.RemoveLoadCase(load_case=name), expected_version, edit_id)

    def edit(
        self,
        operation: str,
        surfaces: typing.Iterable[int],
        parameters: Parameters | None = None,
        *,
        loads: PolicyLike = "drop",
        expected_version: str = "",
        carry_over: bool = False,
        edit_id: str = "",
        progress: Progress | None = None,
        cancel: CancelToken | None = None,
    ) -> session.Committed:
        """Applies an operation (`Client.operations`) to the head; returns once the new version is durable. Parameters
        are in SI units. `loads` says what becomes of loads and supports whose surface goes: "drop", "move", "refuse".
        With `carry_over` an edit for an `expected_version` that is not the head any more is made on the head all the
        same where it touches nothing that was changed since; else it is refused with `Conflict`."""
        body = self._edit_body(operation, surfaces, parameters, loads)
        body.carry_over = carry_over
        return self._change("apply_edit", body, expected_version, edit_id, progress=progress, cancel=cancel).body

    def undo(self, *, expected_version: str = "", edit_id: str = "") -> session.Committed:
        return self._change("undo", session.Undo(), expected_version, edit_id).body

    def redo(self, *, expected_version: str = "", edit_id: str = "") -> session.Committed:
        return self._change("redo", session.Redo(), expected_version, edit_id).body

    def go_to(self, number: int, *, expected_version: str = "", edit_id: str = "") -> session.Committed:
        """Makes any version the head."""
        return self._change("go_to_version", session.GoToVersion(number=number), expected_version, edit_id).body

    def annotate(self, number: int, name: str, note: str = "", *, edit_id: str = "") -> None:
        """Gives a version a name and a note instead of those it had."""
        body = session.AnnotateVersion(document=self.name, number=number, name=name, note=note, edit_id=edit_id or make_edit_id())
        self._ask("annotate_version", body)

    def rename(self, name: str) -> None:
        """Gives the document another name; all who have it open hear of it."""
        self._ask("rename_document", session.RenameDocument(document=self.name, name=name))

    # -- questions

    def preview(
        self,
        operation: str,
        surfaces: typing.Iterable[int],
        parameters: Parameters | None = None,
        *,
        loads: PolicyLike = "drop",
        find_most: bool = False,
        draft: bool = False,
        expected_version: str = "",
        cancel: CancelToken | None = None,
    ) -> Preview:
        """What such an edit would make of the head; nothing is changed. Raises `Superseded` when the document is
        changed, or another preview is asked for, meanwhile. A `draft` has the surface, the loads and the change of volume alone,
        several times sooner; the edit may be refused all the same."""
        body = self._edit_body(operation, surfaces, parameters, loads)
        body.expected_version = expected_version
        answer = self._ask("preview_edit", session.PreviewEdit(edit=body, find_most=find_most, draft=draft), cancel=cancel, quick=False)
        return Preview(answer.body, answer.arrays)

    def select(
        self,
        kind: str,
        surfaces: typing.Iterable[int] = (),
        *,
        angle_rad: float | None = None,
        min_diameter_m: float | None = None,
        max_diameter_m: float | None = None,
    ) -> list[session.Feature]:
        """Surfaces of the head that belong together: "hole" and "protrusion" (of one picked surface), "holes" (all, of
        a diameter), "smooth" and "neighbours" (over edges of a small angle)."""
        body = session.SelectSurfaces(document=self.name, kind=session.SelectSurfaces.Kind.Value(kind.upper()), surfaces=surfaces)
        for name, value in (("angle_rad", angle_rad), ("min_diameter_m", min_diameter_m), ("max_diameter_m", max_diameter_m)):
            if value is not None:
                setattr(body, name, value)
        return list(self._ask("select_surfaces", body, quick=False).body.features)

    def history(self, *, reports: bool = False) -> session.History:
        """All versions; with `reports` what their edits reported."""
        return self._ask("get_history", session.GetHistory(document=self.name, reports=reports)).body

    def surface_of(self, number: int) -> Surface:
        """The surface of any version; the head stays where it is."""
        answer = self._ask("get_surface", session.GetSurface(document=self.name, number=number), quick=False)
        return Surface().apply(answer.body.surface, answer.arrays)

    def section(self, point_m: typing.Sequence[float], normal: typing.Sequence[float], *, load_case: str = "") -> Section:
        """Cuts the head with a plane, with the field of a load case (empty: the only one, or the envelope)."""
        body = session.CutSection(document=self.name, load_case=load_case)
        body.point_m.x, body.point_m.y, body.point_m.z = point_m
        body.normal.x, body.normal.y, body.normal.z = normal
        answer = self._ask("cut_section", body, quick=False)
        return Section(answer.body, answer.arrays)

    def compare(self, before: int, after: int, *, load_case: str = "", cancel: CancelToken | None = None) -> Comparison:
        """What two versions differ in; with a load case also the difference of its fields."""
        body = comparison.CompareVersions(document=self.name, before=before, after=after, load_case=load_case)
        answer = self._ask("compare_versions", body, cancel=cancel, quick=False)
        return Comparison(answer.body, answer.arrays)

    def check_print(
        self,
        *,
        thinner_than_m: float = 0,
        overhang_rad: float | None = None,
        direction: typing.Sequence[float] = (0, 0, 1),
        version: int | None = None,
        progress: Progress | None = None,
        cancel: CancelToken | None = None,
    ) -> PrintCheck:
        """What hinders printing a version (None: the head) in 3D: whether it is watertight, walls thinner than that (0:
        not looked for), what leans further than an angle (None: 45 degrees) from the build direction, volume and box."""
        body = print_pb2.CheckPrint(document=self.name, version=version, thinner_than_m=thinner_than_m, overhang_rad=overhang_rad)
        body.direction.x, body.direction.y, body.direction.z = direction
        answer = self._ask("check_print", body, progress=progress, cancel=cancel, quick=False)
        return PrintCheck(answer.body, answer.arrays)

    def export(
        self,
        format: str,
        *,
        version_id: str = "",
        unit: str = "",
        load_case: str = "",
        progress: Progress | None = None,
        cancel: CancelToken | None = None,
    ) -> bytes:
        """A version as a file's bytes; `format` is a name of `Client.welcome.formats`, or "tedit": the whole document. With
        a load case "inp" and "bdf" are decks that CalculiX and Nastran run."""
        body = session.ExportFile(document=self.name, version_id=version_id, format=format, length_unit=unit, load_case=load_case)
        return self._ask("export_file", body, progress=progress, cancel=cancel, quick=False).data("file")

    def export_to(self, path: str | os.PathLike[str], *, version_id: str = "", unit: str = "", load_case: str = "", cancel: CancelToken | None = None) -> None:
        """The same into a file, in the format of its suffix; it is there whole or not at all."""
        target = pathlib.Path(path)
        data = self.export(target.suffix[1:], version_id=version_id, unit=unit, load_case=load_case, cancel=cancel)
        draft = target.with_name(target.name + ".part")
        draft.write_bytes(data)
        draft.replace(target)

    # -- solving

    def solve(
        self,
        load_case: str = "",
        *,
        load_cases: typing.Iterable[str] = (),
        all_load_cases: bool = False,
        tolerance: float = 0,
        energy_tolerance: float = 0,
        element_order: int = 0,
        device: str = "",
        progress: Progress | None = None,
        cancel: CancelToken | None = None,
    ) -> session.Solved:
        """Solves one load case (empty: the first) or several on the head; later heads are solved with the same
        settings by themselves. `wait_field` has what comes of it on the surface; fields of before are forgotten."""
        body = session.Solve(
            document=self.name,
            load_case=load_case,
            load_cases=load_cases,
            all_load_cases=all_load_cases,
            tolerance=tolerance,
            energy_tolerance=energy_tolerance,
            element_order=element_order,
            device=device,
        )
        return self._ask("solve", body, progress=progress, cancel=cancel, quick=False, arrived=self._forget_fields).body

    def cancel_solve(self) -> None:
        """Ends the solve that runs, whoever asked for it."""
        self._ask("cancel_solve", session.CancelSolve(document=self.name))

    def watch_fields(self, quantities: typing.Iterable[str]) -> str:
        """What every field and section has from now on beside the usual: names of `Client.welcome.results` that are
        sent on request. The head's field comes again, and `wait_field` waits for that one; when it cannot come, the
        result says why."""
        wanted = list(quantities)
        body = session.WatchFields(document=self.name, quantities=wanted)
        note = self._ask("watch_fields", body, arrived=self._forget_fields).body.note
        self.watched = wanted
        return note

    # -- what is kept current

    def wait_surface(self, version_id: str = "", *, timeout: float = 60) -> Surface:
        """The surface of the head, or of a version while that is the head, once it is here. Raises `Timeout`."""

        def arrived() -> Surface | None:
            if self._surface_fault:
                raise self._surface_fault
            wanted = version_id or (self.head.version_id if self.head else "")
            return self.surface if wanted and self.surface.version_id == wanted else None

        return self._wait(arrived, "the surface", timeout)

    def wait_fields(self, version_id: str = "", *, solve: int = 0, timeout: float = 60) -> list[Field]:
        """The final fields of a version (empty: the head), once all are here: of the load case, or of several in their
        order and last of their envelope. `solve`: of that solve (`Solved.solve`) alone. Raises `Timeout`."""

        def arrived() -> list[Field] | None:
            wanted = version_id or (self.head.version_id if self.head else "")
            for fields in reversed(self._fields):
                if fields[-1].version_id == wanted and solve in (0, fields[-1].message.solve):
                    return fields
            return None

        return self._wait(arrived, "the fields", timeout)

    def wait_field(self, version_id: str = "", *, solve: int = 0, timeout: float = 60) -> Field:
        """The last of them: the load case's, or the envelope's of several."""
        return self.wait_fields(version_id, solve=solve, timeout=timeout)[-1]

    # -- events

    def events(self, *, timeout: float | None = None) -> typing.Iterator[Event]:
        """What happens from this call on, one's own changes included (`tedit.events`). Ends when nothing happened for
        `timeout` seconds, or with a last `Lost(for_good=True)` event."""
        listener = Listener()
        with self._changed:
            self._listeners.append(listener)
            if self._gone:
                listener.put(None)
        return self._iterate(listener, timeout)

    def _iterate(self, listener: Listener, timeout: float | None) -> typing.Iterator[Event]:
        try:
            while (event := listener.get(timeout)) is not None:
                yield event
        except queue.Empty:
            pass
        finally:
            with self._changed:
                if listener in self._listeners:
                    self._listeners.remove(listener)

    def subscribe(self, callback: typing.Callable[[Event], None]) -> typing.Callable[[], None]:
        """Calls `callback` with each event, on a thread of its own: it may make calls. Returns what ends that."""
        listener = Listener()
        with self._changed:
            self._listeners.append(listener)

        def work() -> None:
            for event in self._iterate(listener, None):
                callback(event)

        threading.Thread(target=work, name="tedit-events", daemon=True).start()
        return lambda: listener.put(None)

    def close(self) -> None:
        """Stops the document's events; it stays on the server."""
        self._ask("close_document", session.CloseDocument(document=self.name))
        self._client._loop.call_soon_threadsafe(self._client._drop, self)
        self._take_loss(errors.Cancelled("the document was closed"), for_good=True)

    # -- how

    def _request(self) -> session.OpenDocument:
        held = "" if self._surface_fault else self.surface.version_id  # From an earlier connection.
        return session.OpenDocument(
            name=self.name, watch_surface=self.wants_surface, watch_fields=self.wants_fields, held_version_id=held
        )

    def _watch_again(self) -> session.WatchFields:
        """What was watched before the connection was lost; fields that are here are named, so that they do not come again."""
        body = session.WatchFields(document=self.name, quantities=self.watched)
        last = self._fields[-1] if self._fields else []
        if self.head and last and last[-1].version_id == self.head.version_id:
            cases = [field for field in last if field.report]
            if all(name in field.arrays for field in cases for name in self.watched):
                body.held_solve = last[-1].message.solve
        return body

    def _ask(self, kind: str, body: typing.Any, **how: typing.Any) -> Answer:
        if self._gone:
            raise self._gone
        return self._client._ask(kind, body, **how)

    def _change(self, kind: str, body: typing.Any, expected_version: str, edit_id: str, **how: typing.Any) -> Answer:
        body.document = self.name
        body.expected_version = expected_version
        body.edit_id = edit_id or make_edit_id()
        return self._ask(kind, body, quick=False, **how)

    def _edit_body(
        self, operation: str, surfaces: typing.Iterable[int], parameters: Parameters | None, loads: PolicyLike
    ) -> session.ApplyEdit:
        body = session.ApplyEdit(document=self.name, operation=operation, surfaces=surfaces, loads=policy(loads))
        for name, value in (parameters or {}).items():
            body.parameters[name].CopyFrom(parameter(value))
        return body

    def _wait(self, arrived: typing.Callable[[], typing.Any], what: str, timeout: float) -> typing.Any:
        until = time.monotonic() + timeout
        with self._changed:
            while True:
                found = arrived()
                if found is not None:
                    return found
                if self._gone:
                    raise self._gone
                left = until - time.monotonic()
                if left <= 0:
                    raise errors.Timeout(f"{what} did not arrive within {timeout:g} s")
                self._changed.wait(left)

    # -- in the connection's loop

    def _forget_fields(self, _: typing.Any) -> None:
        """Those that are meant come after the answer."""
        with self._changed:
            self._fields.clear()
            self._begun = []

    def _take_state(self, state: session.DocumentState) -> None:
        with self._changed:
            self.name = state.document
            self.head = state.head if state.HasField("head") else None
            self.can_undo, self.can_redo = state.can_undo, state.can_redo
            if list(state.load_cases) != self.load_cases:
                self._fields.clear()  # Of other loads.
            self.load_cases = list(state.load_cases)
            self.participants = list(state.participants)
            self.participant = state.participant
            self._surface_fault = None
            self._begun = []
            self._changed.notify_all()

    def _take(self, kind: str, body: typing.Any, arrays: Arrays | None) -> None:
        with self._changed:
            event = self._note(kind, body, arrays)
            self._changed.notify_all()
        if event is not None:
            self._tell(event)

    def _note(self, kind: str, body: typing.Any, arrays: Arrays | None) -> Event | None:
        """Takes over what a message says; what others are told of it."""
        if kind == "surface_update":
            return self._take_surface(body, arrays or {})
        if kind == "field_update":
            return self._take_field(Field(body, arrays or {}))
        if kind == "committed" and body.repeated:
            return None  # It was told when it was made; others may have gone on since.
        if kind == "committed":
            self._take_head(body)
        elif kind == "load_cases_changed":
            self.load_cases = list(body.load_cases)
        elif kind == "cad_state_changed":
            if self.head and self.head.number == body.version.number:
                self.head.cad.CopyFrom(body.version.cad)
        elif kind == "participant_changed":
            others = [one for one in self.participants if one.id != body.participant.id]
            self.participants = others if body.gone else [*others, body.participant]
        elif kind == "document_renamed":
            self.name = body.document
        return body

    def _take_head(self, moved: session.Committed) -> None:
        self.head = moved.head
        self.can_undo, self.can_redo = moved.can_undo, moved.can_redo
        self.load_cases = list(moved.load_cases)
        # A version that becomes the head again may have other loads than when its fields came.
        kept = [fields for fields in self._fields if fields[-1].version_id != moved.head.version_id]
        self._fields = collections.deque(kept, maxlen=KEPT_SOLVES)
        self._begun = []

    def _take_surface(self, update: session.SurfaceUpdate, arrays: Arrays) -> Event | None:
        try:
            self.surface = self.surface.apply(update, arrays)
        except errors.ProtocolError as problem:
            self._surface_fault = problem
            return None
        self._surface_fault = None
        return SurfaceChanged(self.surface)

    def _take_field(self, field: Field) -> Event:
        if not field.interim:  # Who waits for a field waits for the final one.
            last = self._begun[-1] if self._begun else None
            if last and (last.message.solve != field.message.solve or last.message.remaining != field.message.remaining + 1):
                self._begun = []  # A newer solve came before all of the last one had.
            self._begun.append(field)
            if field.message.remaining == 0:
                self._fields.append(self._begun)
                self._begun = []
        return FieldArrived(field)

    def _tell(self, event: Event) -> None:
        with self._changed:
            for listener in self._listeners:
                listener.put(event)

    def _take_loss(self, reason: errors.TeditError, *, for_good: bool) -> None:
        with self._changed:
            if for_good:
                self._gone = reason
            self._changed.notify_all()
            for listener in self._listeners:
                listener.put(Lost(reason, for_good))
                if for_good:
                    listener.put(None)
