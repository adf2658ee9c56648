#!/usr/bin/python3
"""From a closed hole to the new stress field: this program beside the conventional way, in one run.

The conventional way closes the hole in the CAD model (a cylinder is united with it), meshes that model again with Gmsh,
and solves with CalculiX on the deck that `tedit export` writes of our edited mesh, which has as many tets. Gmsh runs
with both of its mesh generators, CalculiX with both of its solvers, all on the same cores; the quicker of each counts.
Ours is bench_edit: the edit, the solve that follows it, and the stresses.

    bench/conventional.py --cad ctc01_plate.stp --cylinder="-160,45,-50,0,0,50,12.5" --size 10.757 \\
        --mesh ctc01_plate.medium.msh --load-case load_case.json --fill 1,2 --order 2

Ends with status 1 when a program failed, or when the displacements of both ways differ by more than 1e-4 (--agree).
"""
import argparse
import json
import os
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from peers import calculix, process  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parent.parent
GENERATORS = {"gmsh-delaunay": 1, "gmsh-hxt": 10}
SOLVERS = {"ccx-cholesky": "cholesky", "ccx-spooles": "spooles"}

GEOMETRY = """SetFactory("OpenCASCADE");
Geometry.OCCTargetUnit = "MM";
Merge "{cad}";
Cylinder(100000) = {{{x}, {y}, {z}, {dx}, {dy}, {dz}, {radius}}};
BooleanUnion{{ Volume{{1}}; Delete; }}{{ Volume{{100000}}; Delete; }}
Mesh.MeshSizeMax = {size};
Mesh.MeshSizeMin = {least};
Mesh.MeshSizeFromCurvature = 1;
Mesh.MinimumElementsPerTwoPi = 12;
Mesh.Algorithm = 6;
Mesh.Optimize = 1;
Mesh.SaveAll = 1;
Mesh.Binary = 1;
"""


def numbers(text):
    return [float(word) for word in text.split(",")]


def parse(arguments):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--cad", type=pathlib.Path, required=True, help="STEP file of the part, one volume, mm")
    parser.add_argument("--cylinder", type=numbers, required=True, metavar="X,Y,Z,DX,DY,DZ,R",
                        help="what closes the hole there: base, axis, radius")
    parser.add_argument("--size", type=float, required=True, help="element size for Gmsh, mm; a fifth of it is the least")
    parser.add_argument("--mesh", type=pathlib.Path, required=True)
    parser.add_argument("--load-case", type=pathlib.Path, required=True)
    parser.add_argument("--fill", required=True, metavar="IDS", help="surfaces of the hole in the mesh")
    parser.add_argument("--order", type=int, choices=(1, 2), default=2)
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build/release")
    parser.add_argument("--work", type=pathlib.Path, help="meshes and decks (BUILD/conventional)")
    parser.add_argument("--limit", type=float, default=600, metavar="SECONDS", help="wall time of a run")
    parser.add_argument("--agree", type=float, default=1e-4, help="largest relative difference of displacements")
    options = parser.parse_args(arguments)
    if len(options.cylinder) != 7:
        parser.error("--cylinder takes seven numbers")
    options.work = (options.work or options.build / "conventional").resolve()
    options.programs = options.build.resolve() / "bin"
    return options


def need(done, what):
    """The outcome, if it is one."""
    if done.status != "ok":
        said = (done.errors or done.output.strip() or "it said nothing").splitlines()[-1]
        raise OSError(f"{what} ({done.status}): {said}")
    return done


def ours(options, limits):
    """Seconds of the edit and of what follows it, by bench_edit."""
    command = [options.programs / "bench_edit", options.mesh, options.load_case, "--fill", *options.fill.split(","),
               "--order", options.order]
    told = json.loads(need(process.run(command, limits), "bench_edit").output)
    edit, after = told["edit"]["total_ms"], told["after_edit"]
    return {"tets": told["tets"], "edit_s": edit / 1e3, "first_field_s": (edit + after["first_field_ms"]) / 1e3,
            "first_field_error": after["first_field_error"], "final_field_s": (edit + after["total_ms"]) / 1e3,
            "true_relative_residual": told["true_relative_residual"]}


def edited_mesh(options, limits):
    """Our mesh with the hole closed, and its largest displacement by our own final solve."""
    mesh = options.work / "edited.msh"
    need(process.run([options.programs / "tedit", "edit", options.mesh, "--op", "fill_hole", "--surfaces", options.fill,
                      "--load-case", options.load_case, "-o", mesh], limits), "tedit edit")
    solved = need(process.run([options.programs / "bench_solve", mesh, options.load_case, "--order", options.order],
                              limits), "bench_solve")
    return mesh, json.loads(solved.output)["max_displacement_m"]


def meshing(options, limits):
    """Each generator's wall and CPU seconds, reading the CAD file and closing the hole included."""
    x, y, z, dx, dy, dz, radius = options.cylinder
    geometry = options.work / "closed.geo"
    geometry.write_text(GEOMETRY.format(cad=options.cad.resolve(), x=x, y=y, z=z, dx=dx, dy=dy, dz=dz, radius=radius,
                                        size=options.size, least=options.size / 5), encoding="utf-8")
    result = {}
    for name, generator in GENERATORS.items():
        done = need(process.run(["gmsh", geometry, "-3", "-nt", limits.threads, "-setnumber", "Mesh.Algorithm3D",
                                 generator, "-o", options.work / f"{name}.msh"], limits), name)
        result[name] = {"status": "ok", "wall_s": done.wall_s, "cpu_s": done.cpu_s}
    return result


def solving(options, limits, mesh, tets):
    """Each solver's wall and CPU seconds, or how it failed."""
    result = {}
    for name, way in SOLVERS.items():
        deck = options.work / f"{name}-o{options.order}.inp"
        why = calculix.export_deck(options.programs / "tedit", mesh, options.load_case, options.order, way, deck)
        if why:
            raise OSError(f"tedit export: {why}")
        run = calculix.solve(deck, limits, tets, options.order)
        if run["status"] == "ok":
            run = {"status": "ok", "wall_s": run["wall_s"], "cpu_s": run["program_cpu_s"],
                   "max_displacement_m": run["max_displacement_m"]}
        result[name] = run
    return result


def quickest(runs):
    """The name of the run that ended first; None when none ended well."""
    good = [name for name, run in runs.items() if run["status"] == "ok"]
    return min(good, key=lambda name: runs[name]["wall_s"], default=None)


def compare(told, meshed, solved):
    """Which programs count, the seconds of the conventional way, and how many times ours is quicker."""
    mesher, solver = quickest(meshed), quickest(solved)
    if solver is None:
        raise OSError(f"CalculiX: {json.dumps(solved)}")
    seconds = meshed[mesher]["wall_s"] + solved[solver]["wall_s"]
    return {"mesher": mesher, "solver": solver, "conventional_s": seconds,
            "first_field_ratio": seconds / told["first_field_s"], "final_field_ratio": seconds / told["final_field_s"]}


def report(result):
    rows = [("conventional way", f"{result['mesher']} and {result['solver']}", result["conventional_s"], 1.0),
            ("first field", f"energy error {result['ours']['first_field_error']:.1e}", result["ours"]["first_field_s"],
             result["first_field_ratio"]),
            ("final field", f"residual {result['ours']['true_relative_residual']:.1e}", result["ours"]["final_field_s"],
             result["final_field_ratio"])]
    print("| from a closed hole to | | wall s | times quicker |\n|---|---|---|---|")
    for what, how, seconds, ratio in rows:
        print(f"| {what} | {how} | {seconds:.3f} | {ratio:.0f} |")


def main(arguments):
    options = parse(arguments)
    options.work.mkdir(parents=True, exist_ok=True)
    cores = tuple(sorted(os.sched_getaffinity(0))[:2])
    limits = process.Limits(options.limit, cores=cores, threads=len(cores))
    try:
        mesh, displacement = edited_mesh(options, limits)
        meshed = meshing(options, limits)
        told = ours(options, limits)
        solved = solving(options, limits, mesh, told["tets"])
        result = dict(compare(told, meshed, solved), order=options.order, cores=len(cores), load=os.getloadavg()[0],
                      ours=told, meshing=meshed, solving=solved)
    except OSError as error:
        print(f"conventional.py: {error}", file=sys.stderr)
        return 1
    result["displacement_difference"] = abs(
        displacement / solved[result["solver"]]["max_displacement_m"] - 1)
    name = options.work / f"conventional-o{options.order}.json"
    name.write_text(json.dumps(result, indent=1) + "\n", encoding="utf-8")
    report(result)
    print(f"largest displacements differ by {result['displacement_difference']:.1e}; all figures: {name}")
    return 0 if result["displacement_difference"] <= options.agree else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
