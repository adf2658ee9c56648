# SPDX-License-Identifier: AGPL-3.0-or-later
"""Lines that break and servers that die."""
import threading
import time
import unittest
import unittest.mock

from serving import LOADS, MESH, Line, Server

import tedit
from tedit import errors, events
from tedit.v1 import session_pb2 as session


class Reconnecting(unittest.TestCase):
    def setUp(self):
        self.server = Server()
        self.addCleanup(self.server.stop)
        self.line = Line(self.server.port)
        self.addCleanup(self.line.close)

    def connect(self, **options):
        client = tedit.connect(self.line.url, self.server.token, **options)
        self.addCleanup(client.close)
        return client

    def watcher(self):
        """Hears of the document over a line that does not break."""
        other = self.server.connect()
        self.addCleanup(other.close)
        return other.open("part").events(timeout=60)

    def test_an_edit_whose_answer_was_lost_is_made_once(self):
        part = self.connect().open("part")
        part.import_mesh(MESH)
        seen = self.watcher()
        self.line.mute = True
        answers = []
        editor = threading.Thread(target=lambda: answers.append(part.edit("fill_hole", [1, 2])))
        editor.start()
        next(one for one in seen if isinstance(one, session.Committed))  # It was made; its answer was lost.
        self.line.cut()
        editor.join()
        self.assertTrue(answers[0].repeated)
        self.assertEqual(answers[0].head.number, 1)
        self.assertEqual(len(part.history().versions), 2)
        surface = part.wait_surface()
        self.assertEqual((part.head.number, len(surface.mesh.triangles)), (1, answers[0].head.boundary_facets))

    def test_what_others_did_meanwhile_is_seen(self):
        part = self.connect().open("part", fields=False)
        part.import_mesh(MESH)
        heard = part.events(timeout=60)
        self.line.mute = True
        with self.server.connect() as other:
            other.open("part").edit("fill_hole", [92, 93])
        self.line.cut()
        self.assertFalse(next(one for one in heard if isinstance(one, events.Lost)).for_good)
        next(one for one in heard if isinstance(one, events.Reconnected))
        self.assertEqual((part.head.number, part.can_undo), (1, True))
        self.assertEqual(part.wait_surface().version_id, part.head.version_id)

    def test_only_what_has_changed_of_the_surface_comes_again(self):
        part = self.connect().open("part", fields=False)
        part.import_mesh(MESH)
        before = part.wait_surface()
        came = []
        apply = tedit.Surface.apply
        with unittest.mock.patch.object(tedit.Surface, "apply", lambda held, update, arrays: came.append(update) or apply(held, update, arrays)):
            self.line.mute = True
            with self.server.connect() as other:
                other.open("part").edit("fill_hole", [92, 93])
                changed = other.open("part").wait_surface()
                came.clear()  # The other's own.
                self.line.cut()
                self.assertEqual(len(part.history().versions), 2)  # Waits for the line.
                after = part.wait_surface()
        self.assertEqual([(one.base_version_id, one.version_id) for one in came], [(before.version_id, after.version_id)])
        self.assertLess(came[0].stream.bytes, 100_000)
        self.assertEqual(after.version_id, changed.version_id)
        self.assertAlmostEqual(after.area_m2(), changed.area_m2(), delta=1e-15)

    def test_fields_that_are_here_do_not_come_again(self):
        client = self.connect()
        part = client.open("part")
        part.import_mesh(MESH)
        part.set_load_case(LOADS)
        part.solve(element_order=1)
        part.watch_fields(["stress_pa"])
        before = part.wait_field()
        self.assertIn("stress_pa", before.arrays)
        heard = part.events(timeout=60)
        self.line.cut()
        next(one for one in heard if isinstance(one, events.Reconnected))
        client.status()  # What was sent before it is here.
        part.watch_fields([])  # These come: they were asked for.
        arrived = [next(one for one in heard if isinstance(one, events.FieldArrived)).field]
        self.assertEqual([sorted(one.arrays) for one in arrived], [["displacement_m", "vertices", "von_mises_pa"]])
        self.assertEqual(arrived[0].message.solve, before.message.solve)

    def test_a_field_that_was_missed_comes(self):
        client = self.connect()
        part = client.open("part")
        part.import_mesh(MESH)
        part.set_load_case(LOADS)
        first = part.solve(element_order=1).solve
        part.wait_field()
        self.line.mute = True
        with self.server.connect() as other:
            theirs = other.open("part")
            theirs.edit("fill_hole", [92, 93])
            second = theirs.solve(element_order=1).solve
            theirs.wait_field()
        self.assertNotEqual(first, second)
        self.line.cut()
        self.assertEqual(len(part.history().versions), 2)  # Waits for the line.
        self.assertEqual(part.wait_field().message.solve, second)

    def test_calls_say_what_they_are_a_part_of(self):
        said = []
        send = tedit._link.Link._send

        async def listen(link, number, kind, body, traceparent=""):
            said.append((kind, traceparent))
            await send(link, number, kind, body, traceparent)

        with unittest.mock.patch.object(tedit._link.Link, "_send", listen):
            self.connect(traceparent=lambda: "00-4bf92f3577b34da6a3ce929d0e0e4736-00f067aa0ba902b7-01").documents()
        self.assertIn(("list_documents", "00-4bf92f3577b34da6a3ce929d0e0e4736-00f067aa0ba902b7-01"), said)

    def test_a_document_that_was_deleted_meanwhile_is_no_new_one(self):
        client = self.connect(reconnect_s=120)
        part, other_part = client.open("part"), client.open("other")
        part.import_mesh(MESH)
        heard, heard_of_other = part.events(timeout=60), other_part.events(timeout=60)
        self.line.shut = True
        self.line.cut()
        with self.server.connect() as other:
            while "part" in [one.name for one in other.documents()]:
                try:
                    other.delete_document("part")
                except errors.Conflict:  # The server has not seen yet that the line is cut.
                    pass
        self.line.shut = False
        last = [one for one in heard if isinstance(one, events.Lost)][-1]
        self.assertIsInstance(last.reason, errors.NotFound)
        with self.assertRaises(errors.NotFound):
            part.undo()
        next(one for one in heard_of_other if isinstance(one, events.Reconnected))
        # It was opened to see that, and is gone when the server closes what nobody has open; there is no file.
        self.assertEqual([(one.clients, one.bytes, one.versions) for one in client.documents() if one.name == "part"], [(0, 0, 0)])

    def test_a_killed_server_that_comes_back(self):
        part = self.connect(reconnect_s=60).open("part")
        part.import_mesh(MESH)
        part.set_load_case(LOADS)
        part.edit("fill_hole", [1, 2])
        self.server.kill()
        self.line.cut()
        starter = threading.Thread(target=self.server.start, args=(self.server.port,))
        starter.start()
        self.assertEqual(len(part.history().versions), 2)  # Waits for the server.
        starter.join()
        self.assertEqual([one.name for one in part.load_cases], ["ctc01_plate static"])
        self.assertEqual(part.undo().head.number, 0)

    def test_what_would_be_done_twice_is_not_asked_again(self):
        client = self.connect()
        part = client.open("part")
        part.import_mesh(MESH)
        self.line.mute = True
        with self.server.connect() as other:
            cutter = threading.Thread(target=self.cut_when_copied, args=(other,))
            cutter.start()
            with self.assertRaises(errors.ConnectionLost):
                client.copy_document("part", "copy")
            cutter.join()
        self.assertEqual([one.name for one in client.documents()], ["copy", "part"])

    def cut_when_copied(self, other):
        while "copy" not in [one.name for one in other.documents()]:
            pass
        self.line.cut()

    def test_a_client_can_be_closed_while_it_connects_again(self):
        """At any moment of that; whoever waits for an answer is told."""
        for step in range(24):
            client = self.connect()
            part = client.open("part")
            self.line.cut()
            told = []
            asker = threading.Thread(target=lambda: told.append(self.refusal_of(part.history)))
            asker.start()
            time.sleep(0.003 * step)
            closer = threading.Thread(target=client.close, daemon=True)
            closer.start()
            closer.join(timeout=30)
            self.assertFalse(closer.is_alive(), step)
            asker.join()
            self.assertIn(type(told[0]), (errors.ConnectionLost, type(None)), step)  # None: it was answered before.

    def refusal_of(self, call):
        try:
            call()
        except errors.TeditError as problem:
            return problem
        return None

    def test_without_reconnecting_the_loss_is_told(self):
        part = self.connect(reconnect_s=0).open("part")
        heard = part.events(timeout=60)
        self.line.cut()
        self.assertTrue(next(one for one in heard if isinstance(one, events.Lost)).for_good)
        self.assertEqual(list(heard), [])
        with self.assertRaises(errors.ConnectionLost):
            part.undo()


if __name__ == "__main__":
    unittest.main()
