# SPDX-License-Identifier: AGPL-3.0-or-later
"""Streams, surfaces and errors without a server, with numbers to check by hand."""
import re
import struct
import unittest

import numpy as np
from serving import SOURCE

import tedit
from tedit.streams import IncomingStream
from tedit.surface import Field
from tedit.v1 import envelope_pb2, session_pb2 as session


def announce(*arrays, size=None):
    header = session.Stream(stream=7, arrays=[session.ArrayInfo(**array) for array in arrays])
    header.bytes = size
    return header


def u32(name, items, offset=None, components=1):
    info = dict(name=name, type=session.ArrayInfo.UINT32, components=components, items=items)
    return info if offset is None else dict(info, offset=offset)


class Streams(unittest.TestCase):
    def test_arrays_stand_where_they_are_said_to(self):
        slots = u32("slots", 3, offset=0)
        values = dict(name="values", type=session.ArrayInfo.FLOAT64, components=3, items=1, offset=16)
        stream = IncomingStream(announce(slots, values, size=40))
        data = struct.pack("<3I4x3d", 5, 6, 7, 1.5, -2, 1e300)
        for at in range(0, 40, 7):  # Pieces need not end where arrays do.
            self.assertFalse(stream.complete)
            stream.append(session.Chunk(stream=7, offset=at, data=data[at : at + 7]))
        self.assertTrue(stream.complete)
        arrays = stream.arrays()
        self.assertEqual(arrays["slots"].tolist(), [5, 6, 7])
        self.assertEqual(arrays["values"].tolist(), [[1.5, -2, 1e300]])
        with self.assertRaises(ValueError):
            arrays["slots"][0] = 1

    def test_without_offsets_each_begins_where_the_one_before_ends(self):
        stream = IncomingStream(announce(u32("a", 1), u32("none", 0), u32("b", 1), size=8))
        stream.append(session.Chunk(stream=7, data=struct.pack("<2I", 1, 2)))
        self.assertEqual([array.tolist() for array in stream.arrays().values()], [[1], [], [2]])

    def test_what_does_not_add_up_is_refused(self):
        for header in (
            announce(u32("a", 2), size=9),
            announce(u32("a", 2), u32("b", 1, offset=4), size=8),
            announce(u32("a", 2, components=0), size=8),
            announce(dict(name="a", components=1, items=1), size=4),
            announce(u32("a", 1 << 31), size=1 << 33),
        ):
            with self.assertRaises(tedit.errors.ProtocolError):
                IncomingStream(header)
        for piece in (dict(offset=4, data=b"abcd"), dict(data=b"123456789")):
            with self.assertRaises(tedit.errors.ProtocolError):
                IncomingStream(announce(u32("a", 2), size=8)).append(session.Chunk(**piece))


def tet_surface():
    """The boundary of a tet with corners in slots 10, 20, 30 and 40; facets in slots 1 to 4, surface 1, the slanted 9."""
    return dict(
        vertices=np.array([10, 20, 30, 40], np.uint32),
        positions=np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], float),
        facets=np.array([1, 2, 3, 4], np.uint32),
        facet_vertices=np.array([[10, 30, 20], [10, 20, 40], [10, 40, 30], [20, 30, 40]], np.uint32),
        facet_surfaces=np.array([1, 1, 1, 9]),
    )


def whole():
    update = session.SurfaceUpdate(version_id="first", surfaces=[dict(id=1, name="legs"), dict(id=9)])
    return tedit.Surface().apply(update, tet_surface())


class Surfaces(unittest.TestCase):
    def test_the_whole_one(self):
        surface = whole()
        self.assertEqual(surface.mesh.triangles.tolist(), [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])
        self.assertAlmostEqual(surface.area_m2(1), 1.5)
        self.assertAlmostEqual(surface.area_m2(9), 3**0.5 / 2)

    def test_a_difference_replaces_what_its_slots_held(self):
        first = whole()
        update = session.SurfaceUpdate(version_id="second", base_version_id="first", surfaces=[dict(id=2)], removed=[9])
        second = first.apply(update, dict(
            removed_facets=np.array([4, 1], np.uint32),
            vertices=np.array([40, 15], np.uint32),
            positions=np.array([[0, 0, 2], [1, 1, 0]], float),
            facets=np.array([7, 1], np.uint32),
            facet_vertices=np.array([[20, 15, 40], [10, 30, 15]], np.uint32),
            facet_surfaces=np.array([2, 2])))
        mesh = second.mesh
        self.assertEqual(mesh.facet_slots.tolist(), [1, 2, 3, 7])
        self.assertEqual(mesh.vertex_slots.tolist(), [10, 15, 20, 30, 40])
        self.assertEqual(mesh.points[4].tolist(), [0, 0, 2])
        self.assertEqual(mesh.triangles.tolist(), [[0, 3, 1], [0, 2, 4], [0, 4, 3], [2, 1, 4]])
        self.assertEqual(mesh.surface_ids.tolist(), [2, 1, 1, 2])
        self.assertEqual(sorted(second.surfaces), [1, 2])
        self.assertEqual(first.mesh.points[3].tolist(), [0, 0, 1])  # The one before has its values.
        self.assertEqual(sorted(first.surfaces), [1, 9])

    def test_a_vertex_that_no_facet_has_is_still_there_for_later_ones(self):
        removed = whole().apply(session.SurfaceUpdate(version_id="second", base_version_id="first"), dict(
            removed_facets=np.array([2, 3, 4], np.uint32)))
        self.assertEqual(removed.mesh.vertex_slots.tolist(), [10, 20, 30])
        again = removed.apply(session.SurfaceUpdate(version_id="third", base_version_id="second"), dict(
            facets=np.array([2], np.uint32), facet_vertices=np.array([[10, 20, 40]], np.uint32), facet_surfaces=np.array([1])))
        self.assertEqual(again.mesh.points[-1].tolist(), [0, 0, 1])

    def test_what_does_not_fit_is_refused(self):
        other_base = session.SurfaceUpdate(version_id="x", base_version_id="other")
        with self.assertRaisesRegex(tedit.errors.ProtocolError, "other, but this client holds first"):
            whole().apply(other_base, {})
        fitting = session.SurfaceUpdate(version_id="x", base_version_id="first")
        facet = dict(facets=np.array([2], np.uint32), facet_surfaces=np.array([1]))
        for arrays in (
            dict(facet, facet_vertices=np.array([[10, 20, 99]], np.uint32)),
            dict(facet),
            dict(vertices=np.array([10, 10], np.uint32), positions=np.zeros((2, 3))),
        ):
            with self.assertRaises(tedit.errors.ProtocolError):
                whole().apply(fitting, arrays)

    def test_a_field_is_looked_up_by_slots(self):
        field = Field(session.FieldUpdate(), dict(vertices=np.array([10, 20, 30, 35, 40], np.uint32), von_mises_pa=np.arange(5.0)))
        self.assertEqual(field.on(whole().mesh, "von_mises_pa").tolist(), [0, 1, 2, 4])
        with self.assertRaises(ValueError):
            Field(session.FieldUpdate(), dict(vertices=np.array([10], np.uint32), von_mises_pa=np.ones(1))).on(whole().mesh, "von_mises_pa")


class Values(unittest.TestCase):
    def test_points_and_lists_are_sent_as_texts_of_numbers(self):
        for given, text in (
            ([0, 0.01, -1e-7], "0.0, 0.01, -1e-07"),
            (np.array([1.5, 2]), "1.5, 2.0"),
            ([(0, 0, 0), (0, 0, 1)], "0.0, 0.0, 0.0; 0.0, 0.0, 1.0"),
            (np.eye(3)[:2], "1.0, 0.0, 0.0; 0.0, 1.0, 0.0"),
        ):
            self.assertEqual(tedit.values.parameter(given).text, text)
        self.assertEqual(tedit.values.parameter(np.float64(0.5)).real, 0.5)


class Errors(unittest.TestCase):
    def test_each_code_of_the_protocol_has_a_class(self):
        body = (SOURCE / "base/error.hpp").read_text().split("enum class ec {")[1].split("};")[0]
        told = dict(re.findall(r"^\s*(\w+),\s*///< (.*)$", body, flags=re.MULTILINE))
        self.assertEqual(sorted(told), sorted(tedit.errors.BY_CODE))
        for code, text in told.items():
            self.assertTrue(tedit.errors.BY_CODE[code].__doc__.startswith(text.rstrip(".")), code)

    def test_all_that_the_server_says_is_there(self):
        message = envelope_pb2.Error(code="conflict", message="m", remedy="r", where="w")
        message.conflict.client = "bench"
        message.most_that_works.parameter = "depth"
        message.most_that_works.value = 0.25
        error = tedit.errors.from_message(message)
        self.assertIsInstance(error, tedit.errors.Conflict)
        self.assertEqual(str(error), "m (w). r")
        self.assertEqual((error.rival.client, error.most_that_works.parameter, error.most_that_works.value), ("bench", "depth", 0.25))

    def test_a_code_of_a_newer_server_keeps_its_name(self):
        error = tedit.errors.from_message(envelope_pb2.Error(code="too_hot", message="m"))
        self.assertEqual((type(error), error.code), (tedit.TeditError, "too_hot"))


class Version(unittest.TestCase):
    def test_hello_says_the_servers_version(self):
        from tedit.v1 import protocol_version

        said = dict(re.findall(r"(\w+)_version = (\d+);", (SOURCE / "protocol/version.hpp").read_text()))
        self.assertEqual((protocol_version.MAJOR, protocol_version.MINOR), (int(said["major"]), int(said["minor"])))
