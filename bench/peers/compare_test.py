"""Tests of what bench/compare.py makes of outputs; run by ctest."""
import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import conventional  # noqa: E402
from peers import calculix, meshes, process, tables  # noqa: E402

HERE = process.Limits(wall_s=20)


def solved(**changes):
    run = {"status": "ok", "tets": 1000, "unknowns": 600, "assembly_cpu_s": 0.5, "setup_cpu_s": 1.0, "solve_cpu_s": 2.0, "wall_s": 3.0,
           "peak_mib": 10.0, "iterations": 7, "true_relative_residual": 1e-7, "compliance_j": 2.0,
           "max_displacement_m": 4.0}
    return dict(run, **changes)


class Conventional(unittest.TestCase):
    def test_the_quickest_that_ended_well_count(self):
        meshed = {"a": {"status": "ok", "wall_s": 6.0}, "b": {"status": "ok", "wall_s": 2.0}}
        solved_by = {"c": {"status": "over_limit", "wall_s": 1.0}, "d": {"status": "ok", "wall_s": 8.0}}
        r = conventional.compare({"first_field_s": 0.1, "final_field_s": 0.5}, meshed, solved_by)
        self.assertEqual((r["mesher"], r["solver"], r["conventional_s"]), ("b", "d", 10.0))
        self.assertEqual((r["first_field_ratio"], r["final_field_ratio"]), (100.0, 20.0))

    def test_without_a_solver_there_is_no_ratio(self):
        with self.assertRaises(OSError):
            conventional.compare({"first_field_s": 1, "final_field_s": 1}, {"a": {"status": "ok", "wall_s": 1.0}},
                                 {"c": {"status": "failed"}})


class Tables(unittest.TestCase):
    def test_a_run_is_reduced_to_medians(self):
        r = tables.reduce_runs([solved(setup_cpu_s=s, peak_mib=p) for s, p in ((9.0, 1.0), (1.0, 5.0), (2.0, 3.0))])
        self.assertEqual((r["setup_cpu_s"], r["cpu_s"], r["peak_mib"], r["runs"]), (2.0, 4.0, 3.0, 3))
        self.assertEqual(r["bytes_per_tet"], 3 * 2**20 / 1000)

    def test_one_failed_run_counts(self):
        r = tables.reduce_runs([solved(), {"status": "over_limit", "run_s": 600}])
        self.assertEqual((r["status"], r["runs"]), ("over_limit", 2))

    def test_the_least_residual_is_the_reference_and_who_is_off_is_marked(self):
        results = {"ours": tables.reduce_runs([solved()]),
                   "direct": tables.reduce_runs([solved(true_relative_residual=1e-13, setup_cpu_s=7.0)]),
                   "petsc": tables.reduce_runs([solved(solve_cpu_s=9.0)]),
                   "wrong": tables.reduce_runs([solved(compliance_j=2.00001)])}
        case = tables.compare(results)
        self.assertEqual(case["reference"], "direct")
        self.assertTrue(results["ours"]["agrees"])
        self.assertFalse(results["wrong"]["agrees"])
        self.assertEqual(results["direct"]["cpu_ratio"], 3)
        self.assertEqual((results["petsc"]["cpu_ratio"], results["petsc"]["cpu_ratio_from_matrix"]), (10 / 3, 4))
        table = tables.markdown([dict(case, mesh="m", order=1)])
        self.assertEqual(table.count("**disagrees**"), 1)

    def test_all_rows_have_as_many_cells_as_the_head(self):
        results = {"ours": tables.reduce_runs([solved()]), "late": {"status": "over_limit", "run_s": 600},
                   "broken": {"status": "failed", "run_s": 0, "why": "one | two\nthree"}}
        for line in tables.markdown([dict(tables.compare(results), mesh="m", order=1)]).strip().split("\n"):
            self.assertEqual(line.count("|"), len(tables.HEAD) + 1)


class CalculiX(unittest.TestCase):
    def test_compliance_and_largest_displacement_of_a_dat_file(self):
        lines = ["", " displacements (vx,vy,vz) for set NALL and time  0.1000000E+01", "",
                 "         1  3.000000E+00  4.000000E+00  0.000000E+00", "         2 -1.0E+00  0.0E+00 -2.0E+00", "",
                 " forces (fx,fy,fz) for set HELD and time  0.1000000E+01", "", "         2  9.0E+00  9.0E+00  9.0E+00"]
        u = calculix.read_displacement(lines)
        self.assertEqual(u, {1: (3, 4, 0), 2: (-1, 0, -2)})
        self.assertEqual(calculix.largest(u), 5)
        self.assertEqual(calculix.compliance({(1, 2): 0.5, (2, 3): -3.0}, u), 8)

    def test_loads_of_a_deck(self):
        with tempfile.NamedTemporaryFile("w", suffix=".inp") as deck:
            deck.write("*NODE\n1, 0, 0, 0\n*CLOAD\n133, 3, -15.25\n7, 1, 2\n*NODE PRINT, NSET=NALL\nU\n")
            deck.flush()
            self.assertEqual(calculix.read_loads(deck.name), {(133, 3): -15.25, (7, 1): 2.0})

    def test_phases_need_all_marks(self):
        lines = [(0.5, "Using up to 1 cpu(s) for setting up the structure of the matrix."),
                 (0.7, "Using up to 1 cpu(s) for the stress calculation."),
                 (1.5, "Factoring the system of equations using the symmetric spooles solver"),
                 (4.0, "Using up to 1 cpu(s) for the stress calculation.")]
        self.assertEqual(calculix.phases(lines), {"setup_cpu_s": 1.0, "solve_cpu_s": 2.5})
        self.assertIsNone(calculix.phases(lines[:3]))


class Process(unittest.TestCase):
    def test_a_run_over_its_limit_is_ended(self):
        done = process.run([sys.executable, "-c", "import time; time.sleep(60)"], process.Limits(wall_s=0.2))
        self.assertEqual(done.status, "over_limit")

    def test_memory_over_its_limit_fails(self):
        done = process.run([sys.executable, "-c", "bytearray(1 << 32)"], process.Limits(20, 1 << 30))
        self.assertEqual(done.status, "failed")
        self.assertIn("MemoryError", done.errors)

    def test_output_and_exit_status_come_back(self):
        done = process.run([sys.executable, "-c", "print('here'); raise SystemExit(3)"], HERE, watch=True)
        self.assertEqual((done.status, done.exit_status, done.output), ("failed", 3, "here\n"))
        self.assertEqual(done.lines[0][1], "here")


class Meshes(unittest.TestCase):
    def test_parts_are_found_plain_before_packed(self):
        with tempfile.TemporaryDirectory() as folder:
            part = pathlib.Path(folder) / "plate"
            part.mkdir()
            for name in ("load_case.json", "plate.coarse.msh", "plate.coarse.v22.msh", "plate.medium.msh.xz",
                         "plate.fine.msh", "plate.fine.msh.xz"):
                (part / name).touch()
            found = meshes.parts(folder)
        self.assertEqual([(m.name, m.source.name) for m in found],
                         [("plate-coarse", "plate.coarse.msh"), ("plate-medium", "plate.medium.msh.xz"),
                          ("plate-fine", "plate.fine.msh")])
        self.assertEqual([m.name for m in meshes.chosen(found, ["e-fine", "other"])], ["plate-fine"])


if __name__ == "__main__":
    unittest.main()
