#!/usr/bin/python3
"""Cold solves of the same equations by this project's solver and by others, side by side.

Every run is a process of its own on one core with one thread, to a true residual of 1e-6 where the solver has such a
goal. What is compared, with which settings, and what must be installed: bench/README.md.

    bench/compare.py --parts examples --only cantilever-44k,plate-coarse --solvers ours,petsc --order 1

Results of each solver on each mesh are kept in WORK/results, so that a comparison that was interrupted goes on where
it was; what is older than its program or its mesh is measured again. Ends with status 1 when our own answer fails or
disagrees, or when a mesh could not be made; with 2 when --only and --order leave none.
"""
import argparse
import json
import os
import pathlib
import platform
import shutil
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from peers import meshes, process, solvers, tables  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parent.parent


def names(text):
    return [name for name in text.split(",") if name]


def parse(arguments):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build/release", help="build with TEDIT_BENCH_PEERS")
    parser.add_argument("--work", type=pathlib.Path, help="meshes, equations, decks, results (BUILD/peers)")
    parser.add_argument("--parts", action="append", default=[], metavar="DIR", help="parts besides the cantilevers")
    parser.add_argument("--only", type=names, default=[], metavar="A,B", help="meshes whose name holds A or B")
    parser.add_argument("--solvers", type=names, default=list(solvers.DEFAULT), metavar="A,B",
                        help="of " + ", ".join(solvers.SOLVERS))
    parser.add_argument("--order", type=names, default=["1", "2"], metavar="1,2", help="element orders")
    parser.add_argument("--repeat", type=int, default=5, help="runs for a median; one for what takes over a minute")
    parser.add_argument("--limit", type=float, default=600, metavar="SECONDS", help="wall time of a run")
    parser.add_argument("--memory", type=float, default=0, metavar="GIB", help="of a run (85 %% of what is free)")
    parser.add_argument("--cores", type=names, default=[], metavar="0,1", help="cores to run on (the first two)")
    parser.add_argument("--fresh", action="store_true", help="measure again what was measured")
    parser.add_argument("--list", action="store_true", help="only say what would be run")
    options = parser.parse_args(arguments)
    for name in options.solvers:
        if name not in solvers.SOLVERS:
            parser.error(f"there is no solver {name}; there are {', '.join(solvers.SOLVERS)}")
    if not set(options.order) <= {"1", "2"} or options.repeat < 1:
        parser.error("--order takes 1, 2 or both, --repeat a positive number")
    options.work = (options.work or options.build / "peers").resolve()
    return options


def make_bench(options):
    allowed = sorted(os.sched_getaffinity(0))
    cores = tuple(int(core) for core in options.cores) or tuple(allowed[:2])
    memory = int(options.memory * 2**30) or int(0.85 * process.available_bytes())
    return solvers.Bench(options.build.resolve() / "bin", options.work, process.Limits(options.limit, memory), cores)


def needs(name, bench):
    """The program that a solver needs and that is missing; None when all is there."""
    program = getattr(solvers.SOLVERS[name], "program", None)
    if program and not (bench.programs / program).exists():
        return program
    if name.startswith("ccx") and not (shutil.which("ccx") and (bench.programs / "tedit").exists()):
        return "ccx or tedit"
    return None


def is_current(path, bench, case, name):
    """A kept result counts when neither program nor mesh is newer."""
    program = getattr(solvers.SOLVERS[name], "program", "tedit" if name.startswith("ccx") else "bench_solve")
    return process.is_newer(path, bench.programs / program, case.mesh, case.load_case)


def run_once(bench, case, name):
    """One run; without an input to run on, a failed one."""
    try:
        return solvers.SOLVERS[name](bench, case)
    except OSError as error:
        return {"status": "failed", "run_s": 0, "why": str(error)}


def is_last(run):
    """Another run would say nothing new, or take too long."""
    return run["status"] != "ok" or run["run_s"] > 60


def measure(bench, case, name, options):
    """The reduced result of a solver on a case, kept or new."""
    kept = options.work / "results" / f"{case}-{name}.json"
    if not options.fresh and is_current(kept, bench, case, name):
        result = json.loads(kept.read_text(encoding="utf-8"))
        if result["status"] != "failed" and (result["runs"] >= options.repeat or is_last(result)):
            return result
    runs = []
    while len(runs) < options.repeat:
        runs.append(run_once(bench, case, name))
        if is_last(runs[-1]):
            break
    result = dict(tables.reduce_runs(runs), load=os.getloadavg()[0])
    kept.parent.mkdir(parents=True, exist_ok=True)
    draft = kept.with_suffix(".draft")
    draft.write_text(json.dumps(result, indent=1) + "\n", encoding="utf-8")
    draft.rename(kept)
    return result


def compare_case(bench, case, options):
    results = {}
    for name in options.solvers:
        missing = needs(name, bench)
        if missing:
            result = {"status": "skipped", "run_s": 0, "why": f"{missing} is not there"}
        elif name == "ours-two-cores" and len(bench.cores) < 2:
            result = {"status": "skipped", "run_s": 0, "why": "there is one core"}
        else:
            result = measure(bench, case, name, options)
        results[name] = result
        say = "%.2f CPU s" % result["cpu_s"] if result["status"] == "ok" else f"{result['status']} {result.get('why', '')}"
        print(f"{case} {name}: {say} (load {os.getloadavg()[0]:.1f})", file=sys.stderr, flush=True)
    return dict({"mesh": case.name, "order": case.order}, **tables.compare(results))


def write_all(options, bench, cases):
    whole = {"machine": platform.platform(), "cores": list(bench.cores), "load": os.getloadavg()[0],
             "repeat": options.repeat, "limit_s": options.limit, "cases": cases}
    options.work.mkdir(parents=True, exist_ok=True)
    (options.work / "comparison.json").write_text(json.dumps(whole, indent=1) + "\n", encoding="utf-8")
    (options.work / "comparison.md").write_text(tables.markdown(cases), encoding="utf-8")


def main(arguments):
    options = parse(arguments)
    bench = make_bench(options)
    listed = meshes.cantilevers()
    for folder in options.parts:
        listed += [m for m in meshes.parts(folder) if m.name not in {known.name for known in listed}]
    chosen = [(m, int(o)) for m in meshes.chosen(listed, options.only) for o in options.order if int(o) in m.orders]
    if not chosen:
        known = ", ".join(f"{m.name} ({' and '.join(map(str, m.orders))})" for m in listed)
        print(f"no mesh is left by --only and --order; there are, with their orders: {known}", file=sys.stderr)
        return 2
    if options.list:
        for mesh, order in chosen:
            print(f"{mesh.name} order {order}: {', '.join(options.solvers)}")
        return 0
    cases = []
    missing = False
    for mesh, order in chosen:
        try:
            file = meshes.prepare(mesh, options.work / "meshes")
        except OSError as error:
            print(f"{mesh.name}: {error}", file=sys.stderr)
            missing = True
            continue
        cases.append(compare_case(bench, solvers.Case(mesh.name, file, mesh.load_case, order), options))
        write_all(options, bench, cases)
    print(tables.markdown(cases), end="")
    ours = [case["solvers"]["ours"] for case in cases if "ours" in case["solvers"]]
    return 0 if not missing and all(r["status"] == "ok" and r.get("agrees", True) for r in ours) else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
