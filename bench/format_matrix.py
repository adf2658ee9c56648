#!/usr/bin/python3
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Round trips of meshes over all formats, as a table for bench/FIGURES.md.

usage: bench/format_matrix.py [--tedit PROGRAM] [--external] PART.msh ...

Of each part: from each format to each other (linear tets), and through decks of quadratic tets. What is compared by
`tedit info`: surfaces (id, name, facets, area), regions (id, name, tets, volume), size. With --external the files are
also opened by other programs that are installed: gmsh, meshio, VTK, and ccx solves the deck.
"""
import argparse
import json
import pathlib
import subprocess
import sys
import tempfile

FORMATS = ["msh", "msh2", "vtu", "inp", "bdf", "unv", "med"]
DECKS = ["inp", "bdf"]
CLAMPED = {"materials": [{"name": "steel", "young_modulus_pa": 2.1e11, "poisson_ratio": 0.3, "density_kg_m3": 7850.0}],
           "loads": [{"gravity": {"m_s2": {"z": -9.81}}}]}


def run(*command):
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, timeout=600)
    if done.returncode != 0:
        raise RuntimeError(f"{' '.join(map(str, command))}: {done.stderr.strip() or done.stdout.strip()}")
    return done.stdout


def close(a, b, relative):
    return abs(a - b) <= relative * max(abs(a), abs(b))


def differences(before, after):
    """What `tedit info` says otherwise of two meshes."""
    found = []
    for rows, count, size in (("surfaces", "facets", "area_m2"), ("regions", "tets", "volume_m3")):
        one = {row["id"]: row for row in before[rows]}
        two = {row["id"]: row for row in after[rows]}
        if one.keys() != two.keys():
            found.append(f"ids of {rows}")
            continue
        for number, row in one.items():
            other = two[number]
            if row["name"] != other["name"]:
                found.append(f"a name of {rows}")
            if row[count] != other[count] or row.get("interface_facets") != other.get("interface_facets"):
                found.append(f"{count} of {rows}")
            if not close(row[size], other[size], 1e-6):
                found.append(f"{size} of {rows}")
    if not close(before["volume_m3"], after["volume_m3"], 1e-8):
        found.append("volume")
    return sorted(set(found))


class Trips:
    def __init__(self, tedit, folder):
        self.tedit = tedit
        self.folder = folder

    def info(self, mesh):
        return json.loads(run(self.tedit, "info", "--json", mesh))

    def convert(self, mesh, name):
        out = self.folder / name
        run(self.tedit, "convert", "--quiet", mesh, "-o", out)
        return out

    def linear(self, part):
        """By pair of formats: what was lost; an empty list where nothing was."""
        start = self.info(part)
        result = {}
        for first in FORMATS:
            one = self.convert(part, f"one.{first}")
            for second in FORMATS:
                try:
                    result[first, second] = differences(start, self.info(self.convert(one, f"two.{second}")))
                except RuntimeError as failure:
                    result[first, second] = [str(failure)]
        return result

    def loads(self, part):
        surface = next(row["id"] for row in self.info(part)["surfaces"] if row["facets"] > 0)
        case = dict(CLAMPED, name="own weight", constraints=[{"surfaces": [surface], "fixed": {}}])
        file = self.folder / "loads.json"
        file.write_text(json.dumps(case))
        return file

    def quadratic(self, part):
        """Decks of quadratic tets, back as a mesh with its load case, then to the other kind and back."""
        start = self.info(part)
        loads = self.loads(part)
        result = {}
        for deck in DECKS:
            out = self.folder / f"deck.{deck}"
            run(self.tedit, "export", "--quiet", part, "--load-case", loads, "-o", out)
            back = self.folder / "back.msh"
            case = self.folder / "back.json"
            run(self.tedit, "convert", "--quiet", out, "-o", back, "--output-unit", "mm", "--load-case", case)
            lost = differences(start, self.info(back))
            run(self.tedit, "export", "--quiet", back, "--load-case", case, "-o", self.folder / f"again.{deck}")
            again = self.folder / "again.json"
            run(self.tedit, "convert", "--quiet", self.folder / f"again.{deck}", "-o", self.folder / "again.msh",
                "--load-case", again)
            if json.loads(case.read_text()) != json.loads(again.read_text()):
                lost.append("load case")
            result[deck] = lost
        return result


def opened_by_gmsh(file, tets):
    said = run("gmsh", file, "-0", "-v", "4", "-save", "-o", file.with_suffix(".by_gmsh.msh"))
    kept = file.with_suffix(".by_gmsh.msh")
    return kept.exists() and kept.stat().st_size > 0 and "Error" not in said and tets


def opened_by_freecad(file, tets):
    """By the mesh library of Salome that it has in it; that wants a mesh of MED to be called like the file."""
    sys.path.append("/usr/lib/freecad-python3/lib")
    import FreeCAD  # noqa: F401  The library needs it.
    import Fem
    if file.suffix == ".med":
        import h5py
        with h5py.File(file) as content:
            named = file.with_name(next(iter(content["ENS_MAA"])) + ".med")
        named.write_bytes(file.read_bytes())
        file = named
    return Fem.read(str(file)).VolumeCount == tets


def opened_by_meshio(file, tets):
    import meshio
    mesh = meshio.read(file)
    return sum(len(block.data) for block in mesh.cells if block.type in ("tetra", "tetra10")) == tets


def opened_by_vtk(file, tets):
    import vtk
    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(file))
    reader.Update()
    return reader.GetOutput().GetNumberOfCells() == tets


def solved_by_ccx(file, _):
    run("ccx", "-i", file.with_suffix(""))
    return file.with_suffix(".dat").stat().st_size > 0


OPENERS = [("gmsh", opened_by_gmsh, ["one.msh", "one.msh2", "one.bdf", "one.unv"]),
           ("meshio", opened_by_meshio, ["one.msh", "one.msh2", "one.vtu", "one.inp", "one.bdf", "one.med"]),
           ("FreeCAD", opened_by_freecad, ["one.med", "one.unv"]),
           ("VTK", opened_by_vtk, ["one.vtu"]),
           ("ccx", solved_by_ccx, ["deck.inp"])]


def external(folder, tets):
    rows = []
    for program, opens, names in OPENERS:
        for name in names:
            file = folder / name
            if name == "one.msh2":  # Not every program knows the suffix.
                file = folder / "msh2.msh"
                file.write_bytes((folder / name).read_bytes())
            try:
                said = "yes" if opens(file, tets) else "NO: another number of tets"
            except ImportError:
                said = "not installed"
            except (RuntimeError, OSError, ValueError) as failure:
                said = f"NO: {failure}"
            except Exception as failure:  # Of meshio: a class of its own for each trouble.
                said = f"NO: {type(failure).__name__} {failure}"
            rows.append((program, name, said.replace("\n", " ")[:160]))
    return rows


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--tedit", default="build/release/bin/tedit")
    parser.add_argument("--external", action="store_true")
    parser.add_argument("parts", nargs="+", type=pathlib.Path)
    options = parser.parse_args()
    losses = 0
    print(f"| part | tets | surfaces | pairs of {len(FORMATS) ** 2} alike | quadratic `.inp` | quadratic `.bdf` |\n| --- | --- | --- | --- | --- | --- |")
    for part in options.parts:
        with tempfile.TemporaryDirectory() as name:
            trips = Trips(options.tedit, pathlib.Path(name))
            facts = trips.info(part)
            pairs = trips.linear(part)
            bad = {pair: lost for pair, lost in pairs.items() if lost}
            try:
                decks = {deck: ", ".join(lost) or "alike" for deck, lost in trips.quadratic(part).items()}
            except RuntimeError as failure:
                decks = dict.fromkeys(DECKS, f"NO: {failure}"[:120].replace("\n", " "))
            tets = sum(row["tets"] for row in facts["regions"])
            print(f"| {part.stem} | {tets} | {len(facts['surfaces'])} | {len(pairs) - len(bad)} | {decks['inp']} | {decks['bdf']} |",
                  flush=True)
            for pair, lost in bad.items():
                print(f"  {pair[0]} to {pair[1]}: {'; '.join(lost)}", file=sys.stderr)
            losses += len(bad) + sum(said != "alike" for said in decks.values())
            if options.external:
                for row in external(trips.folder, tets):
                    print(f"  {row[0]} opens {row[1]}: {row[2]}", file=sys.stderr)
    return 1 if losses else 0


if __name__ == "__main__":
    sys.exit(main())
