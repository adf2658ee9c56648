#!/usr/bin/python3
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Files for 3D printing and the checks before it, as tables for bench/FIGURES.md.

usage: bench/print.py [--tedit PROGRAM] [--lib3mf] [--thinner-than MM] MESH ...

Of each mesh: seconds and bytes of STL, PLY and 3MF, plain, coloured by surface and, where it is a VTU file with
von_mises_pa, by that; the same again must give the same bytes. Then `tedit check-print`. Seconds are those of the whole
program; "import" is `tedit info`, which all of them begin with. With --lib3mf each 3MF file is read by lib3mf (Debian's
lib3mf1, 1.8.1) in strict mode: triangles, objects, unit, warnings, whether each object is closed and oriented.
"""
import argparse
import ctypes
import hashlib
import json
import pathlib
import resource
import subprocess
import sys
import tempfile
import time
import zipfile


def run(*command):
    """Its JSON, and its wall and CPU seconds."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    start = time.monotonic()
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, timeout=600)
    wall = time.monotonic() - start
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    if done.returncode != 0:
        raise RuntimeError(f"{' '.join(map(str, command))}: {done.stderr.strip() or done.stdout.strip()}")
    return json.loads(done.stdout), wall, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


class Lib3mf:
    """The few calls of lib3mf 1.8 that read a file."""

    def __init__(self):
        self.library = ctypes.CDLL("lib3MF.so.1")

    def call(self, name, *arguments):
        result = getattr(self.library, name)(*arguments)
        if result != 0:
            raise RuntimeError(f"{name}: {result & 0xFFFFFFFF:08x}")

    def read(self, path):
        pointer, number = ctypes.c_void_p, ctypes.c_uint32
        model, reader, objects = pointer(), pointer(), pointer()
        self.call("lib3mf_createmodel", ctypes.byref(model))
        self.call("lib3mf_model_queryreader", model, b"3mf", ctypes.byref(reader))
        self.call("lib3mf_reader_setstrictmodeactive", reader, ctypes.c_int(1))
        start = time.monotonic()
        self.call("lib3mf_reader_readfromfileutf8", reader, str(path).encode())
        seconds = time.monotonic() - start
        warnings, unit = number(), number()
        self.call("lib3mf_reader_getwarningcount", reader, ctypes.byref(warnings))
        self.call("lib3mf_model_getunit", model, ctypes.byref(unit))
        self.call("lib3mf_model_getmeshobjects", model, ctypes.byref(objects))
        found = {"objects": 0, "triangles": 0, "closed": 0, "unit": unit.value, "warnings": warnings.value, "s": seconds}
        more = ctypes.c_int()
        while True:
            self.call("lib3mf_resourceiterator_movenext", objects, ctypes.byref(more))
            if not more.value:
                break
            mesh, triangles, closed = pointer(), number(), ctypes.c_int()
            self.call("lib3mf_resourceiterator_getcurrent", objects, ctypes.byref(mesh))
            self.call("lib3mf_meshobject_gettrianglecount", mesh, ctypes.byref(triangles))
            self.call("lib3mf_meshobject_ismanifoldandoriented", mesh, ctypes.byref(closed))
            found["objects"] += 1
            found["triangles"] += triangles.value
            found["closed"] += closed.value
            self.call("lib3mf_release", mesh)
        for one in (objects, reader, model):
            self.call("lib3mf_release", one)
        return found


def write_all(tedit, mesh, folder, library):
    info, wall, cpu = run(tedit, "info", "--json", mesh)
    print(f"\n### {mesh.name}: {info['tets']} tets, {info['boundary_facets']} facets, {len(info['surfaces'])} surfaces\n")
    print("| file | s | CPU s | bytes | read by lib3mf |\n| --- | --- | --- | --- | --- |")
    print(f"| import alone | {wall:.2f} | {cpu:.2f} | | |")
    rows = [("stl", None), ("ply", None), ("3mf", None), ("ply", "surface"), ("3mf", "surface")]
    if mesh.suffix == ".vtu":
        rows += [("ply", "von_mises_pa"), ("3mf", "von_mises_pa")]
    for suffix, colour in rows:
        file = folder / f"part.{suffix}"
        command = [tedit, "convert", "--json", mesh, "-o", file] + (["--colour", colour] if colour else [])
        _, wall, cpu = run(*command)
        first = hashlib.sha256(file.read_bytes()).hexdigest()
        run(*command)
        if hashlib.sha256(file.read_bytes()).hexdigest() != first:
            raise RuntimeError(f"{file}: other bytes the second time")
        said = ""
        if suffix == "3mf":
            if zipfile.ZipFile(file).testzip() is not None:
                raise RuntimeError(f"{file}: the archive is damaged")
            if library:
                found = library.read(file)
                said = (f"{found['triangles']} triangles, {found['closed']} of {found['objects']} objects closed, "
                        f"unit {found['unit']}, {found['warnings']} warnings, {found['s']:.2f} s")
        print(f"| {suffix}{', ' + colour if colour else ''} | {wall:.2f} | {cpu:.2f} | {file.stat().st_size} | {said} |", flush=True)


def check(tedit, mesh, thinner_than):
    report, wall, cpu = run(tedit, "check-print", "--json", mesh, "--thinner-than", thinner_than)
    print(f"\ncheck-print, walls under {thinner_than} mm: {report['check_ms'] / 1e3:.2f} s ({cpu:.2f} CPU s with the import); watertight "
          f"{report['watertight']}, {report['bodies']} bodies, {report['crossing_facets']} facets cross, "
          f"{len(report['thin'])} thin places of {1e6 * report['thin_area_m2']:.0f} mm2, "
          f"{len(report['overhangs'])} overhangs of {1e6 * report['overhang_area_m2']:.0f} mm2", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("meshes", nargs="+", type=pathlib.Path)
    parser.add_argument("--tedit", type=pathlib.Path, default=pathlib.Path(__file__).resolve().parent.parent / "build/release/bin/tedit")
    parser.add_argument("--lib3mf", action="store_true")
    parser.add_argument("--thinner-than", type=float, default=1.5)
    options = parser.parse_args()
    library = Lib3mf() if options.lib3mf else None
    with tempfile.TemporaryDirectory() as folder:
        for mesh in options.meshes:
            write_all(options.tedit, mesh, pathlib.Path(folder), library)
            check(options.tedit, mesh, options.thinner_than)
    return 0


if __name__ == "__main__":
    sys.exit(main())
