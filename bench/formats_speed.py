#!/usr/bin/env python3
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Mesh files in and out, beside Gmsh, meshio and VTK, in one run: seconds, bytes a second, memory.

Each program reads or writes each file in a process of its own, in turns; the median of --repeat counts. Ours is measured twice: as
others read, bytes to arrays, and with all that a part needs (checks, topology, boundary). Gmsh, meshio (python3-gmsh,
python3-meshio) and VTK (python3-vtk9) are left out where they are not installed. The meshes stay in the page cache:
it is processor time that is compared, not the disk.

usage: bench/formats_speed.py MESH.msh [--program build/release/bin/bench_formats] [--repeat 3] [--out FOLDER] [--json FILE]
"""
import argparse
import json
import pathlib
import statistics
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent

PEER = r"""
import json, os, resource, sys, time
kind, do, source, target = sys.argv[1:5]
def clocks(): return time.perf_counter(), time.process_time()
def peak(): return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
if kind == "gmsh":
    import gmsh
    gmsh.initialize(["gmsh", "-nt", "1"])
    gmsh.option.setNumber("General.Terminal", 0)
    gmsh.option.setNumber("Mesh.Binary", 1)
    read = lambda: gmsh.open(source)
    write = lambda _: gmsh.write(target)
elif kind == "meshio":
    import contextlib, io, meshio
    read = lambda: meshio.read(source)
    how = {"msh": dict(file_format="gmsh", binary=True), "vtu": dict(binary=True, compression=None)}
    write = lambda mesh: mesh.write(target, **how.get(target.rsplit(".", 1)[1], {}))
else:
    import vtk
    def read():
        reader = vtk.vtkXMLUnstructuredGridReader()
        reader.SetFileName(source)
        reader.Update()
        return reader.GetOutput()
    def write(mesh):
        writer = vtk.vtkXMLUnstructuredGridWriter()
        writer.SetFileName(target)
        writer.SetInputData(mesh)
        writer.SetDataModeToAppended()
        writer.EncodeAppendedDataOff()
        writer.SetCompressorTypeToNone()
        writer.Write()
start = peak()
a = clocks()
mesh = read()
b = clocks()
result = {"wall_ms": 1e3 * (b[0] - a[0]), "cpu_ms": 1e3 * (b[1] - a[1])}
if do == "write":
    a = clocks()
    write(mesh)
    b = clocks()
    result = {"wall_ms": 1e3 * (b[0] - a[0]), "cpu_ms": 1e3 * (b[1] - a[1])}
result.update(start_mib=start, peak_mib=peak(), file_mib=os.path.getsize(target if do == "write" else source) / 2**20)
os.write(1, (json.dumps(result) + "\n").encode())
os._exit(0)
"""

#: What each peer reads and writes of ours.
PEERS = {"gmsh": ("msh", "msh2", "unv", "bdf"), "meshio": ("msh", "vtu", "inp"), "vtk": ("vtu",)}
OURS = ("msh", "msh2", "vtu", "inp", "bdf", "unv")


def run(command):
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, check=False)
    lines = [line for line in done.stdout.splitlines() if line.startswith("{")]
    if done.returncode != 0 or not lines:
        return {"failed": (done.stderr.strip().splitlines() or ["ended with %d" % done.returncode])[-1][:200]}
    return json.loads(lines[-1])


def ours(program, do, source, target):
    if do == "write":
        return run([program, "write", source, target.suffix[1:], target])
    return run([program, "read", source])


def peer(kind, do, source, target):
    return run([sys.executable, "-c", PEER, kind, do, source, target])


def there(kind):
    module = {"gmsh": "gmsh", "meshio": "meshio", "vtk": "vtk"}[kind]
    return subprocess.run([sys.executable, "-c", "import " + module], capture_output=True, check=False).returncode == 0


def flat(got):
    """Times of one measurement by name."""
    if "failed" in got:
        return {}
    if "wall_ms" in got:
        return {"as others": got}
    if "write" in got:
        return {"as others": {**got["write"], "file_mib": got["file_mib"]}}
    common = {"start_mib": got["start_mib"], "file_mib": got["file_mib"]}
    return {
        "as others": {**got["read"], **common, "peak_mib": got["read_peak_mib"]},
        "as a part": {**got["all"], **common, "peak_mib": got["peak_mib"], "result_mib": got["result_mib"]},
    }


def median(rows):
    return {key: statistics.median(row[key] for row in rows) for key in rows[0]}


def measure(work, repeat, results):
    """`work`: (who, do, format, call). Everybody once, then everybody again."""
    for _ in range(repeat):
        for who, do, form, call in work:
            got = call()
            if "failed" in got:
                results.setdefault((form, do, who), {}).setdefault("failed", got["failed"])
            for how, row in flat(got).items():
                name = who if how == "as others" else who + ", as a part"
                results.setdefault((form, do, name), {}).setdefault("rows", []).append(row)


def line(form, do, who, row):
    if "rows" not in row:
        return f"| .{form} | {do} | {who} | {row['failed']} | | | |"
    best = median(row["rows"])
    rate = best["file_mib"] * 1.048576 / (best["cpu_ms"] / 1e3)
    memory = f"{best['peak_mib'] - best['start_mib']:.0f}" if "peak_mib" in best else ""
    if "result_mib" in best:
        memory += f" ({(best['peak_mib'] - best['start_mib']) / best['result_mib']:.1f} x the part's {best['result_mib']:.0f})"
    return f"| .{form} | {do} | {who} | {best['file_mib']:.0f} | {best['wall_ms'] / 1e3:.2f} | {best['cpu_ms'] / 1e3:.2f} | {rate:.0f} | {memory} |"


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("mesh", type=pathlib.Path)
    parser.add_argument("--program", type=pathlib.Path, default=ROOT / "build/release/bin/bench_formats")
    parser.add_argument("--repeat", type=int, default=3)
    parser.add_argument("--out", type=pathlib.Path)
    parser.add_argument("--json", type=pathlib.Path)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as scratch:
        folder = options.out or pathlib.Path(scratch)
        folder.mkdir(parents=True, exist_ok=True)
        peers = [kind for kind in PEERS if there(kind)]
        print("beside " + (", ".join(peers) or "nobody: no peer is installed"))
        files = {form: folder / f"part.{form}" for form in OURS}
        for form, file in files.items():
            made = ours(options.program, "write", options.mesh, file)
            if "failed" in made:
                sys.exit(f"{form}: {made['failed']}")
        results = {}
        work = []
        for do in ("read", "write"):
            for form, file in files.items():
                source = file if do == "read" else options.mesh
                work.append(("TEdit", do, form, lambda d=do, s=source, f=form: ours(options.program, d, s, folder / f"ours.{f}")))
                for kind in peers:
                    if form in PEERS[kind]:
                        # A peer writes what it read in that format: it need not know others.
                        work.append((kind, do, form, lambda k=kind, d=do, s=file, f=form: peer(k, d, s, folder / f"theirs.{f}")))
        measure(work, options.repeat, results)
    print("| file | | program | MiB | s | CPU s | MB a CPU s | memory, MiB |\n| --- | --- | --- | --- | --- | --- | --- | --- |")
    for (form, do, who), row in sorted(results.items(), key=lambda one: (OURS.index(one[0][0]), one[0][1], not one[0][2].startswith("TEdit"))):
        print(line(form, do, who, row))
    if options.json:
        options.json.write_text(json.dumps([{"file": f, "do": d, "program": w, **r} for (f, d, w), r in results.items()], indent=1))


if __name__ == "__main__":
    main()
