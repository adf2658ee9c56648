"""worst_ratio.py FILE.vtu: adds the point field worst_q, the smallest radius ratio of the tets around each vertex."""

import sys

import numpy
import vtk
from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy


def radius_ratios(p):
    """3 r_in / R_circ of tets, given their corners as an n x 4 x 3 array."""
    a, b, c = (p[:, i] - p[:, 0] for i in (1, 2, 3))
    volume = numpy.abs(numpy.einsum("ij,ij->i", a, numpy.cross(b, c))) / 6
    faces = [(1, 2, 3), (0, 3, 2), (0, 1, 3), (0, 2, 1)]
    area = sum(numpy.linalg.norm(numpy.cross(p[:, j] - p[:, i], p[:, k] - p[:, i]), axis=1) / 2 for i, j, k in faces)
    inner = 3 * volume / area
    squares = [numpy.einsum("ij,ij->i", v, v)[:, None] for v in (a, b, c)]
    middle = squares[0] * numpy.cross(b, c) + squares[1] * numpy.cross(c, a) + squares[2] * numpy.cross(a, b)
    outer = numpy.linalg.norm(middle, axis=1) / (12 * volume)
    return 3 * inner / outer


def main():
    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.SetFileName(sys.argv[1])
    reader.Update()
    grid = reader.GetOutput()
    points = vtk_to_numpy(grid.GetPoints().GetData())
    tets = vtk_to_numpy(grid.GetCells().GetConnectivityArray()).reshape(grid.GetNumberOfCells(), -1)[:, :4]
    worst = numpy.ones(len(points))
    numpy.minimum.at(worst, tets.ravel(), numpy.repeat(radius_ratios(points[tets]), 4))
    field = numpy_to_vtk(worst, deep=True)
    field.SetName("worst_q")
    grid.GetPointData().AddArray(field)
    writer = vtk.vtkXMLUnstructuredGridWriter()
    writer.SetFileName(sys.argv[1])
    writer.SetInputData(grid)
    writer.Write()


if __name__ == "__main__":
    main()
