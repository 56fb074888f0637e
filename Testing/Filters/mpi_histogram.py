# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
"""The joint histogram does not depend on the number of processes.

Run as: mpirun -np N pvbatch --sym mpi_histogram.py
"""
import sys

import numpy as np
from paraview.simple import *
from vtkmodules.vtkCommonDataModel import vtkDataSetAttributes, vtkImageData, vtkMultiBlockDataSet
from vtkmodules.vtkParallelCore import vtkDummyController, vtkMultiProcessController
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy

import scripttest

from tfc.vtk.vtkTFCFilters import vtkTFCJointHistogram

scripttest.load_plugin(globals())
controller = vtkMultiProcessController.GetGlobalController()
rank, ranks = controller.GetLocalProcessId(), controller.GetNumberOfProcesses()
WHOLE = (-7, 32, 0, 29, 3, 24)


def fill(data, blank, name="a"):
    """Attributes that depend on the place alone; the extremes are in one piece only."""
    x0, x1, y0, y1, z0, z1 = data.GetExtent()
    z, y, x = np.mgrid[z0:z1 + 1, y0:y1 + 1, x0:x1 + 1].astype(float)
    a = 2 * np.sin(12.9898 * x + 78.233 * y + 37.719 * z)
    a[(x == 4) & (y > 9)] = np.nan
    b = 0.1 * x * x + np.cos(y * z)
    c = np.where((x == 30) & (y == 28) & (z == 23), 50.0, np.sin(y + z))
    for label, values in ((name, a), ("b", b), ("c", c)):
        array = numpy_to_vtk(np.ascontiguousarray(values.ravel()), deep=1)
        array.SetName(label)
        data.GetPointData().AddArray(array)
    if blank:
        if not data.HasAnyGhostPoints():
            data.AllocatePointGhostArray()
        ghosts = vtk_to_numpy(data.GetPointGhostArray())
        ghosts[((x + y) % 7 == 3).ravel()] |= vtkDataSetAttributes.HIDDENPOINT
    return data


def cells_of(data):
    """The same numbers on cells: those of each cell's first point."""
    result = vtkImageData()
    result.SetExtent(*data.GetExtent())
    nx, ny, nz = data.GetDimensions()
    for name in ("a", "b", "c"):
        values = vtk_to_numpy(data.GetPointData().GetArray(name)).reshape(nz, ny, nx)
        array = numpy_to_vtk(np.ascontiguousarray(values[:-1, :-1, :-1].ravel()), deep=1)
        array.SetName(name)
        result.GetCellData().AddArray(array)
    return result


def count(data, on_all=True, alone=False):
    """(ranges, rows of the table) of the joint histogram of a, b and c."""
    joint = vtkTFCJointHistogram()
    if alone:
        joint.SetController(vtkDummyController())
    joint.SetInputData(data)
    for axis, name in enumerate("abc"):
        joint.SetArray(axis, name)
        joint.SetNumberOfBins(axis, 20 + axis)
    joint.SetTablesOnAllProcesses(on_all)
    joint.Update()
    ranges = []
    for axis in range(3):
        limits = [0.0, 0.0]
        joint.GetHistogram().GetRange(axis, limits)
        ranges.append(tuple(limits))
    table = joint.GetOutputDataObject(0)
    rows = [tuple(table.GetValue(row, c).ToDouble() for c in range(3))
            for row in range(table.GetNumberOfRows())]
    return ranges, rows, joint.GetHistogram().GetTotal()


def piece(ghosts):
    """This process's part of the whole as ParaView divides it, with or without ghost layers."""
    source = Wavelet(WholeExtent=list(WHOLE))
    if ghosts:
        source = GhostCellsGenerator(Input=source, BuildIfRequired=0, MinimumNumberOfGhosts=2)
    source.UpdatePipeline()
    data = vtkImageData()
    data.DeepCopy(source.GetClientSideObject().GetOutputDataObject(0))
    return data


def whole():
    data = vtkImageData()
    data.SetExtent(*WHOLE)
    return data


for blank in (False, True):
    expected = count(fill(whole(), blank), alone=True)
    scripttest.check(len(expected[1]) > 300, "%d entries" % len(expected[1]))
    for ghosts in (False, True):
        scripttest.check(count(fill(piece(ghosts), blank)) == expected,
                         "process %d, blank %d, ghosts %d" % (rank, blank, ghosts))
expected = count(cells_of(fill(whole(), False)), alone=True)
scripttest.check(count(cells_of(fill(piece(False), False))) == expected, "cells")
own = count(fill(piece(False), False), on_all=False)
scripttest.check((len(own[1]) > 300) == (rank == 0) and own[2] > 0, "rows on the first process")

# Four blocks, dealt to the processes in turn.
def blocks(mine):
    tree = vtkMultiBlockDataSet()
    for number in range(4):
        if number in mine:
            block = vtkImageData()
            block.SetExtent(10 * number, 10 * number + 9, 0, 9, 0, 9)
            tree.SetBlock(number, fill(block, False))
    return tree


expected = count(blocks(range(4)), alone=True)
own = count(blocks([n for n in range(4) if n % ranks == rank]))
scripttest.check(own == expected and own[2] > 3000, "blocks on process %d" % rank)

# One process without a piece, and one whose array has another name.
if ranks == 2:
    data = fill(whole(), False) if rank == 1 else vtkImageData()
    scripttest.check(count(data) == count(fill(whole(), False), alone=True), "an empty piece")
other = count(fill(piece(False), False, "a" if rank else "other"))
scripttest.check(other[1] == [], "the same error on all processes")
controller.Barrier()
sys.stdout.flush()
