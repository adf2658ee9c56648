"""The solvers of the comparison, and how each is run once on a mesh."""
import json
import pathlib
import struct
from dataclasses import dataclass, replace

from peers import calculix, process


@dataclass
class Bench:
    """Where programs and files are, and what a run may take."""

    programs: pathlib.Path
    work: pathlib.Path
    limits: process.Limits
    cores: tuple  # one core, or two
    tolerance: float = 1e-6


@dataclass
class Case:
    """A mesh with an element order."""

    name: str
    mesh: pathlib.Path
    load_case: pathlib.Path
    order: int

    def __str__(self):
        return f"{self.name}-o{self.order}"


def on_one_core(bench):
    return replace(bench.limits, cores=bench.cores[:1])


def answer(done):
    """The figures of a program that prints one JSON object, or why there are none."""
    result = {"status": done.status, "run_s": done.wall_s}
    if done.status == "over_limit":
        return result
    if done.status != "ok":
        return dict(result, why=(done.errors or f"exit status {done.exit_status}").split("\n")[-1][:200])
    return dict(json.loads(done.output), **result)


def solve_ours(bench, case, cores, device="cpu"):
    """bench_solve in a process of its own: set-up here has the assembly in it."""
    done = process.run([bench.programs / "bench_solve", case.mesh, case.load_case, "--order", case.order, "--tolerance",
                        bench.tolerance, "--repeat", 1, "--device", device], replace(bench.limits, cores=cores))
    r = answer(done)
    if r["status"] == "ok":
        r["assembly_cpu_s"] = r["cpu_assembly_s"]
        r["setup_cpu_s"] = r["cpu_setup_s"]
        r["solve_cpu_s"] = r["cpu_before_recovery_s"] - r["cpu_setup_s"]
        r["wall_s"] = (r["assembly_ms"] + r["setup_ms"] + r["solve_ms"]) / 1000
        r["unknowns"] = r["dofs"]
    return r


def system_of(bench, case):
    """The file with the case's equations; written when it is missing or older than the program or the mesh."""
    path = bench.work / "systems" / f"{case}.tes"
    writer = bench.programs / "bench_solve"
    if process.is_newer(path, writer, case.mesh, case.load_case):
        return path
    path.parent.mkdir(parents=True, exist_ok=True)
    done = process.run([writer, case.mesh, case.load_case, "--order", case.order, "--write-system", path],
                       process.Limits())
    if done.status != "ok":
        raise OSError(done.errors or "bench_solve could not write the equations")
    return path


def peer(program, *words, most_unknowns=0):
    """A program that reads the equations."""

    def solve(bench, case):
        path = system_of(bench, case)
        unknowns = 3 * head_of(path)["nodes"]
        if most_unknowns and unknowns > most_unknowns:
            return {"status": "skipped", "run_s": 0, "why": f"{unknowns:,} unknowns, over {most_unknowns:,}"}
        return answer(process.run([bench.programs / program, path, *words], on_one_core(bench)))

    solve.program = program
    return solve


def head_of(system):
    """The numbers at the head of a system file (peers/system.hpp)."""
    with open(system, "rb") as file:
        _, order, tets, nodes, blocks = struct.unpack("<5Q", file.read(40))
    return {"order": order, "tets": tets, "nodes": nodes, "blocks": blocks}


def ccx(way):
    """CalculiX, by the deck of `tedit export`."""

    def solve(bench, case):
        deck = bench.work / "decks" / f"{case}-{way}.inp"
        why = calculix.export_deck(bench.programs / "tedit", case.mesh, case.load_case, case.order, way, deck)
        if why:
            return {"status": "failed", "run_s": 0, "why": why}
        return calculix.solve(deck, on_one_core(bench), head_of(system_of(bench, case))["tets"], case.order)

    return solve


# By name. `ours-two-cores` is for the wall time alone; `ours-lavapipe` runs only when asked for.
SOLVERS = {
    "ours": lambda bench, case: solve_ours(bench, case, bench.cores[:1]),
    "ours-two-cores": lambda bench, case: solve_ours(bench, case, bench.cores),
    "ours-lavapipe": lambda bench, case: solve_ours(bench, case, bench.cores, "lavapipe"),
    "petsc": peer("peer_petsc"),
    "cholmod": peer("peer_cholmod"),
    "eigen-cg": peer("peer_eigen", "cg"),
    "eigen-ldlt": peer("peer_eigen", "ldlt", most_unknowns=120000),
    "ccx-cholesky": ccx("cholesky"),
    "ccx-spooles": ccx("spooles"),
}
DEFAULT = tuple(name for name in SOLVERS if name != "ours-lavapipe")
