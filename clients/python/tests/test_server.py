# SPDX-License-Identifier: AGPL-3.0-or-later
"""The package against a real server and a real part."""
import json
import pathlib
import queue
import subprocess
import tempfile
import threading
import unittest

import numpy as np
from serving import LOAD_CASE, LOADS, MESH, PROGRAM, SOURCE, Server

import tedit
from tedit import errors
from tedit.v1 import library_pb2 as library
from tedit.v1 import session_pb2 as session


def setUpModule():
    global server, client
    server = Server()
    client = server.connect()


def tearDownModule():
    client.close()
    server.stop()


def told_area(surface):
    """m2, as the server says it."""
    return sum(info.area_m2 for info in surface.surfaces.values())


class Connecting(unittest.TestCase):
    def test_a_wrong_token_is_said(self):
        with self.assertRaisesRegex(errors.InvalidArgument, "the token is wrong"):
            tedit.connect(server.url, "0" * 64)

    def test_no_server_is_said_with_what_to_do(self):
        with self.assertRaisesRegex(errors.ConnectionLost, "tedit serve"):
            tedit.connect("ws://127.0.0.1:9/v1", server.token, timeout=5)

    def test_what_the_server_offers(self):
        self.assertRegex(client.welcome.server, "^tedit ")
        self.assertIn("fill_hole", [one.id for one in client.operations().operations])
        self.assertIn("msh", [one.name for one in client.welcome.formats])
        self.assertGreaterEqual(client.status().connections, 1)

    def test_a_closed_client_says_so(self):
        other = server.connect()
        part = other.open()
        waiting = threading.Thread(target=self.wait_for_nothing, args=(part,))
        waiting.start()
        other.close()
        other.close()
        waiting.join()
        self.assertEqual(list(part.events()), [])
        with self.assertRaises(errors.ConnectionLost):
            other.documents()


    def wait_for_nothing(self, part):
        with self.assertRaises(errors.ConnectionLost):
            part.wait_surface()


CAD_EDITOR = pathlib.Path(PROGRAM).parent / "tedit-cad-editor"


@unittest.skipUnless(CAD_EDITOR.exists(), "this build has no OpenCASCADE")
class FromCad(unittest.TestCase):
    def test_each_version_says_how_it_stands_on_the_cad_model(self):
        with tempfile.TemporaryDirectory() as folder:
            document = pathlib.Path(folder) / "block.tedit"
            step = SOURCE / "tests/data/cad/inch_block.stp"
            subprocess.run([PROGRAM, "import", str(step), "--size", "coarse", "-o", str(document)], check=True, stdout=subprocess.DEVNULL)
            part = client.open(client.add_document(document, "from_cad"))
        states = session.CadState
        self.assertEqual(part.head.cad.status, states.SAME)
        events = part.events(timeout=60)
        self.assertEqual(part.edit("fill_hole", [8, 9]).head.cad.status, states.PENDING)
        told = next(one for one in events if isinstance(one, session.CadStateChanged))
        self.assertEqual((told.version.number, told.version.cad.status), (1, states.SAME))
        self.assertLess(told.version.cad.deviation_m, 1e-9)
        self.assertEqual(part.head.cad, told.version.cad)
        part.edit("deform", [3], {"distance": 1e-3})
        told = next(one for one in events if isinstance(one, session.CadStateChanged))
        self.assertEqual(told.version.cad.status, states.MESH_ONLY)
        self.assertIn("deform", told.version.cad.reason)
        self.assertEqual([one.cad.status for one in part.history().versions], [states.SAME, states.SAME, states.MESH_ONLY])


    def test_the_server_meshes_a_cad_file(self):
        step = SOURCE / "tests/data/cad/inch_block.stp"
        stages = []
        made = client.import_part(step, "block", fineness="coarse", progress=lambda _, stage: stages.append(stage))
        self.assertEqual((made.document, made.warnings), ("block", ()))
        part = client.open("block")
        self.assertEqual(part.head.cad.status, session.CadState.SAME)
        self.assertEqual(part.head.made_by, "tedit-python")
        self.assertTrue(any("reading" in stage for stage in stages), stages)
        finer = client.import_part(step, "block", fineness="coarse", local_sizes={9: 5e-4}, or_next_free=True)
        self.assertEqual(finer.document, "block-2")
        self.assertGreater(client.open("block-2").head.tets, part.head.tets)

    def test_a_file_that_is_no_part_is_refused_by_its_name(self):
        for given, problem in ((b"no part at all", errors.TeditError), (SOURCE / "README.md", errors.TeditError)):
            with self.assertRaises(problem) as refused:
                client.import_part(given, "nothing")
            self.assertNotIn("/tmp", str(refused.exception))
        with self.assertRaises(errors.InvalidArgument):
            client.import_part(SOURCE / "tests/data/cad/box.step", "nothing", fineness="very fine")
        with self.assertRaises(errors.InvalidArgument):
            client.import_part(SOURCE / "tests/data/cad/box.step", "nothing", local_sizes={1: float("nan")})
        self.assertNotIn("nothing", [one.name for one in client.documents()])


class Editing(unittest.TestCase):
    def setUp(self):
        self.part = client.open()
        self.part.import_mesh(MESH)

    def test_the_surface_follows_every_head(self):
        first = self.part.wait_surface()
        self.assertEqual((first.mesh.triangles.shape, len(first.surfaces)), ((8398, 3), 117))
        self.assertAlmostEqual(first.area_m2(), told_area(first))
        done = self.part.edit("fill_hole", [1, 2])
        self.assertEqual((done.head.number, self.part.head.number, self.part.can_undo), (1, 1, True))
        filled = self.part.wait_surface()
        self.assertEqual(len(filled.mesh.triangles), done.head.boundary_facets)
        self.assertAlmostEqual(filled.area_m2(), told_area(filled))
        self.assertNotIn(1, filled.surfaces)
        self.part.undo()
        back = self.part.wait_surface()
        np.testing.assert_array_equal(back.mesh.triangles, first.mesh.triangles)
        np.testing.assert_array_equal(back.mesh.points, first.mesh.points)
        self.part.redo()
        again = self.part.surface_of(1)  # Sent whole: what differences made is the same.
        held = self.part.wait_surface(again.version_id)
        np.testing.assert_array_equal(held.mesh.points, again.mesh.points)
        np.testing.assert_array_equal(held.mesh.facet_slots, again.mesh.facet_slots)
        np.testing.assert_array_equal(held.mesh.surface_ids, again.mesh.surface_ids)

    def test_a_preview_is_what_the_edit_makes(self):
        head = self.part.wait_surface()
        shown = self.part.preview("fill_hole", [92, 93])
        self.assertEqual(self.part.head.number, 0)
        done = self.part.edit("fill_hole", [92, 93])
        np.testing.assert_array_equal(shown.surface(head).mesh.points, self.part.wait_surface().mesh.points)
        self.assertEqual(shown.report.volume_change_m3, done.report.volume_change_m3)

    def test_a_path_is_sent_as_what_is_in_its_file(self):
        knob = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory())) / "knob.stl"
        corners = ((-20, -20, 40), (20, -20, 40), (0, 30, 40), (0, 0, 80))  # mm; it stands on and in the plate.
        faces = ((0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3))
        lines = ["facet normal 0 0 0\nouter loop\n" + "".join("vertex %g %g %g\n" % corners[i] for i in face) + "endloop\nendfacet\n" for face in faces]
        knob.write_text("solid knob\n" + "".join(lines) + "endsolid knob\n")
        before = self.part.head
        self.part.edit("combine", [], {"file": knob})
        self.assertGreater(self.part.head.tets, before.tets)
        with self.assertRaises(errors.InvalidParameter) as refused:
            self.part.edit("combine", [], {"file": str(knob)})  # A text is a text.
        self.assertIn("not the content of a file", str(refused.exception))

    def test_stress_arrives_and_follows(self):
        self.part.set_load_case(LOADS)
        solved = self.part.solve()
        field = self.part.wait_field(solve=solved.solve)
        mesh = self.part.wait_surface().mesh
        stress = field.on(mesh, "von_mises_pa")
        self.assertAlmostEqual(float(stress.max()), solved.report.max_von_mises_pa, delta=1)
        self.assertAlmostEqual(solved.report.max_von_mises_pa, 13.447e6, delta=5e3)
        self.assertEqual(field.on(mesh, "displacement_m").shape, (len(mesh.points), 3))
        self.part.edit("fill_hole", [1, 2])
        self.assertEqual(self.part.wait_field().report.version_id, self.part.head.version_id)
        self.assertEqual(self.part.watch_fields(["stress_pa"]), "")
        self.assertEqual(self.part.wait_field().arrays["stress_pa"].shape[1], 6)
        self.part.watch_fields(["safety_factor"])
        self.assertEqual(set(self.part.wait_field().arrays), {"vertices", "displacement_m", "von_mises_pa", "safety_factor"})
        self.part.solve(element_order=1)
        self.assertEqual(self.part.wait_field().report.element_order, 1)
        with self.assertRaisesRegex(errors.InvalidArgument, "stress_pa"):
            self.part.watch_fields(["beauty"])

    def test_several_load_cases_have_an_envelope(self):
        for name, newtons in (("down", -20000), ("up", 10000)):
            loads = dict(json.loads(LOADS.read_text()), name=name)
            loads["loads"][0]["force"]["total_n"]["z"] = newtons
            self.part.set_load_case(loads)
        self.assertEqual([one.name for one in self.part.load_cases], ["down", "up"])
        solved = self.part.solve(all_load_cases=True, element_order=1)
        fields = self.part.wait_fields(solve=solved.solve)
        self.assertEqual([one.report.load_case for one in fields[:2]], ["down", "up"])
        self.assertEqual(list(fields[2].envelope.load_cases), ["down", "up"])
        worst = np.maximum(fields[0].arrays["von_mises_pa"], fields[1].arrays["von_mises_pa"])
        np.testing.assert_allclose(fields[2].arrays["von_mises_pa"], worst, rtol=1e-6)

    def test_questions(self):
        self.assertEqual(list(self.part.select("hole", [92])[0].surfaces), [92, 93])
        self.assertEqual([round(one.diameter_m, 6) for one in self.part.select("holes", min_diameter_m=0.022, max_diameter_m=0.03)], [0.025] * 4)
        cut = self.part.section((0.4, 0.2, 0), (1, 0, 0))
        self.assertLess(abs(cut.arrays["positions"][:, 0] - 0.4).max(), 1e-6)
        self.part.edit("fill_hole", [1, 2])
        differences = self.part.compare(0, 1)
        self.assertEqual(differences.arrays, {})
        self.assertIn(1, [one.id for one in differences.message.surfaces if one.where == differences.message.ONLY_BEFORE])
        self.part.annotate(1, "one hole less", "in two\nlines")
        history = self.part.history(reports=True)
        self.assertEqual((history.head, [one.name for one in history.versions]), (1, ["", "one hole less"]))
        self.assertEqual(history.versions[1].report.operation, "fill_hole")
        self.assertEqual(self.part.go_to(0).cause, "goto")

    def test_what_hinders_printing(self):
        """The plate lies on its lowest side with z up: what overhangs is above the plate and looks down."""
        stages = []
        found = self.part.check_print(thinner_than_m=5e-3, progress=lambda _, stage: stages.append(stage))
        self.assertTrue(found.watertight)
        self.assertEqual((found.message.version_id, found.message.bodies), (self.part.head.version_id, 1))
        self.assertAlmostEqual(found.message.volume_m3, self.part.compare(0, 0).message.size_after.volume_m3, delta=1e-12)
        self.assertTrue(set(found.arrays["facets"].tolist()) <= set(self.part.wait_surface().mesh.facet_slots.tolist()))
        self.assertEqual(len(found.arrays["marks"]), len(found.arrays["facets"]))
        ceilings = self.part.check_print(overhang_rad=1.57, direction=(0, 0, -1), version=0).message
        self.assertEqual((ceilings.version, ceilings.overhang_rad, ceilings.direction.z), (0, 1.57, -1))
        with self.assertRaisesRegex(errors.InvalidArgument, "overhang_rad"):
            self.part.check_print(overhang_rad=2)
        with self.assertRaises(errors.NotFound):
            self.part.check_print(version=7)

    def test_the_difference_of_fields(self):
        self.part.set_load_case(LOADS)
        self.part.solve(element_order=1)
        self.part.edit("fill_hole", [1, 2])
        self.part.wait_field()
        differences = self.part.compare(0, 1, load_case=LOAD_CASE)
        rows = len(differences.arrays["vertices"])
        self.assertEqual(differences.arrays["difference_mark"].dtype, np.uint8)
        self.assertEqual(differences.arrays["displacement_m_difference"].shape, (rows, 3))
        self.assertEqual(differences.message.fields[0].load_case, LOAD_CASE)

    def test_files(self):
        with tempfile.TemporaryDirectory() as folder:
            out = pathlib.Path(folder) / "part.msh"
            self.part.export_to(out)
            other = client.open()
            again = other.import_mesh(out.read_bytes(), file_name="again.msh")
            self.assertEqual((again.head.tets, again.head.boundary_facets), (self.part.head.tets, 8398))
            with self.assertRaises(errors.InvalidArgument):
                self.part.export_to(pathlib.Path(folder) / "part.docx")
            self.assertEqual([one.name for one in pathlib.Path(folder).iterdir()], ["part.msh"])

    def test_refusals_are_typed(self):
        for wanted, call in (
            (errors.NotAHole, lambda: self.part.edit("fill_hole", [98])),
            (errors.SurfaceNotFound, lambda: self.part.edit("fill_hole", [123456])),
            (errors.OperationNotFound, lambda: self.part.edit("fold", [1])),
            (errors.InvalidParameter, lambda: self.part.edit("fill_hole", [1, 2], {"no_such": 1.5})),
            (errors.NotFound, lambda: self.part.go_to(7)),
            (errors.InvalidArgument, lambda: client.open("../elsewhere")),
            (errors.UnsupportedFormat, lambda: client.open().import_mesh(b"$MeshFormat\nnothing", file_name="a.msh")),
        ):
            with self.assertRaises(wanted) as raised:
                call()
            self.assertTrue(raised.exception.message)

    def test_a_conflict_names_the_rival(self):
        with server.connect(name="bench") as other:
            seen = self.part.head.version_id
            other.open(self.part.name).edit("fill_hole", [1, 2])
            with self.assertRaises(errors.Conflict) as raised:
                self.part.edit("fill_hole", [92, 93], expected_version=seen)
            self.assertEqual((raised.exception.rival.client, raised.exception.rival.operation), ("bench", "fill_hole"))

    def test_an_edit_elsewhere_is_carried_over(self):
        with server.connect(name="bench") as other:
            seen = self.part.head.version_id
            theirs = other.open(self.part.name)
            self.assertEqual([one.client for one in theirs.participants][-1], "bench")
            self.assertEqual(theirs.participants[-1].id, theirs.participant)
            theirs.edit("fill_hole", [1, 2])
            made = self.part.edit("fill_hole", [92, 93], expected_version=seen, carry_over=True)
            self.assertIn("carried over", " ".join(made.report.notices))
            self.assertEqual(self.part.history().versions[1].made_by, "bench")
            with self.assertRaisesRegex(errors.NotAHole, "was made for version") as raised:
                self.part.edit("fill_hole", [98], expected_version=seen, carry_over=True)
            self.assertTrue(raised.exception.message)

    def test_who_comes_and_goes_is_told(self):
        came = queue.Queue()
        self.addCleanup(self.part.subscribe(lambda event: came.put(event) if isinstance(event, library.ParticipantChanged) else None))
        with server.connect(name="visitor") as other:
            other.open(self.part.name)
            self.assertEqual(came.get(timeout=30).participant.client, "visitor")
            self.assertIn("visitor", [one.client for one in self.part.participants])
        self.assertTrue(came.get(timeout=30).gone)
        self.assertNotIn("visitor", [one.client for one in self.part.participants])

    def test_an_edit_that_is_asked_twice_is_made_once(self):
        first = self.part.edit("fill_hole", [1, 2], edit_id="the-edit")
        second = self.part.edit("fill_hole", [1, 2], edit_id="the-edit")
        self.assertEqual((first.repeated, second.repeated, second.head.version_id), (False, True, first.head.version_id))
        self.assertEqual(len(self.part.history().versions), 2)
        with self.assertRaises(errors.Conflict):
            self.part.edit("fill_hole", [92, 93], edit_id="the-edit")

    def test_a_cancelled_call_ends_here_and_there(self):
        self.part.set_load_case(LOADS)
        token = tedit.CancelToken()
        events = self.part.events(timeout=60)

        def cancel_when_begun():
            for event in events:
                if isinstance(event, session.SolveStatus) and event.phase == session.SolveStatus.STARTED:
                    return token.cancel()

        watcher = threading.Thread(target=cancel_when_begun)
        watcher.start()
        with self.assertRaises(errors.Cancelled):
            self.part.solve(tolerance=1e-12, cancel=token)
        watcher.join()
        with self.assertRaises(errors.Cancelled):  # At once: nothing is asked.
            self.part.solve(cancel=token)
        self.assertEqual(self.part.solve(element_order=1).report.element_order, 1)

    def test_progress_comes_and_may_not_block(self):
        said = []

        def hear(fraction, stage):
            said.append((fraction, stage))
            with self.assertRaisesRegex(RuntimeError, "wait for itself"):
                client.status()

        self.part.set_load_case(LOADS)
        self.part.solve(progress=hear)
        self.assertTrue(said)
        with self.assertLogs("asyncio", "ERROR") as logged:  # Its faults are its own.
            self.part.solve(element_order=1, progress=lambda fraction, stage: 1 / 0)
        self.assertIn("ZeroDivisionError", logged.output[0])
        self.assertEqual(self.part.head.number, self.part.history().head)
        self.assertTrue(all(0 <= fraction <= 1 for fraction, _ in said))


class Events(unittest.TestCase):
    def test_others_changes_and_ones_own(self):
        mine = client.open("shared", fields=False)
        events = mine.events(timeout=60)
        heard = threading.Event()
        names = []

        def hear(event):
            if isinstance(event, session.DocumentRenamed):
                names.append((event.document, len(mine.history().versions)))  # A callback may ask.
                heard.set()

        stop = mine.subscribe(hear)
        with server.connect() as other:
            theirs = other.open("shared", surface=False, fields=False)
            theirs.import_mesh(MESH)
            committed = next(one for one in events if isinstance(one, session.Committed))
            self.assertEqual((committed.cause, mine.head.number), ("import", 0))
            arrived = next(one for one in events if isinstance(one, tedit.events.SurfaceChanged))
            self.assertEqual(arrived.surface.version_id, committed.head.version_id)
            theirs.set_load_case(LOADS)
            changed = next(one for one in events if isinstance(one, session.LoadCasesChanged))
            self.assertEqual(changed.load_cases[0].name, LOAD_CASE)
            theirs.rename("ours")
            self.assertTrue(heard.wait(60))
            mine.remove_load_case(LOAD_CASE)  # By the new name.
        self.assertEqual((mine.name, names), ("ours", [("ours", 1)]))
        stop()
        mine.close()
        self.assertIsInstance(next(one for one in events if isinstance(one, tedit.events.Lost)).reason, errors.Cancelled)
        with self.assertRaises(errors.Cancelled):
            mine.undo()


class Documents(unittest.TestCase):
    def test_copied_listed_written_added_and_deleted(self):
        part = client.open("library")
        part.import_mesh(MESH)
        client.copy_document("library", "library-copy")
        with self.assertRaises(errors.Conflict):
            client.copy_document("library", "library-copy")
        self.assertLessEqual({"library", "library-copy"}, {one.name for one in client.documents()})
        whole = part.export("tedit")
        self.assertEqual(client.add_document(whole, "library", or_next_free=True), "library-2")
        self.assertEqual(client.open("library-2").head.version_id, part.head.version_id)
        for name in ("library", "library-copy", "library-2"):
            client.delete_document(name)
        self.assertFalse([one.name for one in client.documents() if one.name.startswith("library")])


if __name__ == "__main__":
    unittest.main()
