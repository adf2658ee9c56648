#!/usr/bin/python3
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Made tests/data/med/*.med, with other programs than ours: the mesh library of Salome (SMESH) that FreeCAD 0.20 has in
it, and meshio.

usage: tests/data/med/make.py FOLDER      (Debian packages: freecad-python3, python3-meshio, python3-h5py)
"""
import pathlib
import sys

import h5py
import meshio
import numpy

sys.path.append("/usr/lib/freecad-python3/lib")
import FreeCAD  # noqa: F401  The library needs it.
import Fem

# Two tets on a common face. SMESH looks at a tet from the other side than we do.
CORNERS = [(0, 0, 0), (2, 0, 0), (0, 2, 0), (0, 0, 2), (2, 2, 2)]
TETS = [(1, 3, 2, 4), (2, 4, 3, 5)]
FACES = [(1, 2, 3), (1, 4, 2), (1, 3, 4), (2, 5, 3), (2, 4, 5), (3, 5, 4)]


def middle(mesh, known, a, b, off):
    key = (min(a, b), max(a, b))
    if key not in known:
        known[key] = len(CORNERS) + len(known) + 1
        x, y, z = ((p + q) / 2 for p, q in zip(CORNERS[a - 1], CORNERS[b - 1]))
        mesh.addNode(x, y, z + (off if key == (1, 2) else 0), known[key])
    return known[key]


def linear():
    mesh = Fem.FemMesh()
    for number, place in enumerate(CORNERS, 1):
        mesh.addNode(*place, number)
    for number, tet in enumerate(TETS, 1):
        mesh.addVolume(list(tet), number)
    for face in FACES:
        mesh.addFace(list(face))
    return mesh


def quadratic(off):
    mesh = Fem.FemMesh()
    known = {}
    for number, place in enumerate(CORNERS, 1):
        mesh.addNode(*place, number)
    for number, (a, b, c, d) in enumerate(TETS, 1):
        edges = [(a, b), (b, c), (c, a), (a, d), (b, d), (c, d)]
        mesh.addVolume([a, b, c, d] + [middle(mesh, known, *edge, off) for edge in edges], number)
    for a, b, c in FACES:
        mesh.addFace([a, b, c] + [middle(mesh, known, *edge, off) for edge in ((a, b), (b, c), (c, a))])
    return mesh


def add_groups(mesh):
    faces = list(mesh.Faces)
    for name, kind, members in (("foot", "Face", faces[:2]), ("back wall", "Face", faces[2:]),
                                ("steel", "Volume", [1]), ("Solid 7", "Volume", [2])):
        mesh.addGroupElements(mesh.addGroup(name, kind), members)


def main():
    folder = pathlib.Path(sys.argv[1])
    for name, mesh in (("salome", linear()), ("salome_quadratic", quadratic(0)), ("salome_bent", quadratic(-0.1))):
        add_groups(mesh)
        mesh.write(str(folder / f"{name}.med"))
    quadrangle = linear()
    quadrangle.addFace([1, 2, 5, 3])
    quadrangle.write(str(folder / "salome_quadrangle.med"))
    # meshio writes MED 3 without checksums: the base of the broken files, and of one with two meshes.
    points = numpy.array([(0, 0, 0), (2, 0, 0), (0, 2, 0), (0, 0, 2), (0, 0, -2)], dtype=float)
    tets = numpy.array([(0, 2, 1, 3), (0, 1, 2, 4)], dtype=numpy.int32)
    faces = numpy.array([(0, 3, 1), (1, 3, 2), (2, 3, 0), (0, 1, 4), (1, 2, 4), (2, 0, 4)], dtype=numpy.int32)
    families = [numpy.array(numbers, dtype=numpy.int32) for numbers in ([-3, -4], [-2, -2, -2, -1, -1, -1])]
    mesh = meshio.Mesh(points, [("tetra", tets), ("triangle", faces)], cell_data={"cell_tags": families})
    mesh.cell_tags = {-1: ["surface 5"], -2: ["surface 12: Bore"], -3: ["region 3: Steel"], -4: ["region 8"]}
    meshio.write(folder / "meshio.med", mesh)
    with h5py.File(folder / "meshio.med") as one, h5py.File(folder / "two_meshes.med", "w", libver="earliest") as two:
        for part in one:
            one.copy(one[part], two, name=part)
        for part in ("ENS_MAA", "FAS"):
            two.copy(two[f"{part}/mesh"], two[part], name="other")


if __name__ == "__main__":
    main()
