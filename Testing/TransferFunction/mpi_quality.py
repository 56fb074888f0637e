# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
"""The tables of the quality filter do not depend on the number of processes.

Run as: mpirun -np N pvbatch --sym mpi_quality.py
"""
import sys

import numpy as np
from paraview.simple import *
from vtkmodules.vtkCommonDataModel import vtkDataSetAttributes, vtkImageData
from vtkmodules.vtkParallelCore import vtkDummyController, vtkMultiProcessController
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy

import scripttest

from tfc.vtk.vtkTFCTransferFunction import vtkTFCClassificationQuality

scripttest.load_plugin(globals())
import tfc

controller = vtkMultiProcessController.GetGlobalController()
rank, ranks = controller.GetLocalProcessId(), controller.GetNumberOfProcesses()
WHOLE = (-7, 32, 0, 29, 3, 24)

tf = tfc.TransferFunction("a", "b")
for y in (-1.0, 0.8):
    region = tf.add_ellipse(center=(1, y), radii=(1.5, 0.9))
    region.tertiary("c", [(0, 0), (3, 1)])


def fill(data, blank, labels="truth"):
    """Attributes and labels that depend on the place alone."""
    x0, x1, y0, y1, z0, z1 = data.GetExtent()
    z, y, x = np.mgrid[z0:z1 + 1, y0:y1 + 1, x0:x1 + 1].astype(float)
    a = 2 * np.sin(12.9898 * x + 78.233 * y + 37.719 * z)
    b = 2 * np.cos(0.3 * x + 0.2 * y * z)
    c = 0.1 * x * x + np.sin(y * z)
    a[(x == 4) & (y > 9)] = np.nan
    truth = (a + b > 1) + 2 * (c > 20) + np.where(x > 28, 900000, 0)
    for name, values in (("a", a), ("b", b), ("c", c), (labels, truth.astype(np.int32))):
        array = numpy_to_vtk(np.ascontiguousarray(values.ravel()), deep=1)
        array.SetName(name)
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
    for name in ("a", "b", "c", "truth"):
        values = vtk_to_numpy(data.GetPointData().GetArray(name)).reshape(nz, ny, nx)
        array = numpy_to_vtk(np.ascontiguousarray(values[:-1, :-1, :-1].ravel()), deep=1)
        array.SetName(name)
        result.GetCellData().AddArray(array)
    return result


def tables(data, on_all=True, alone=False, labels="truth"):
    quality = vtkTFCClassificationQuality()
    if alone:
        quality.SetController(vtkDummyController())
    quality.SetInputData(data)
    quality.SetLabelArray(labels)
    quality.SetTransferFunction(tf.to_json())
    quality.SetNumberOfBins(32)
    quality.SetTablesOnAllProcesses(on_all)
    quality.Update()
    return [
        [tuple(str(table.GetValue(row, c)) for c in range(table.GetNumberOfColumns()))
         for row in range(table.GetNumberOfRows())]
        for table in (quality.GetOutputDataObject(0), quality.GetOutputDataObject(1))
    ]


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
    expected = tables(fill(whole(), blank), alone=True)
    scripttest.check(len(expected[0]) > 4, "%d labels" % len(expected[0]))
    for ghosts in (False, True):
        own = tables(fill(piece(ghosts), blank))
        scripttest.check(own == expected, "process %d, blank %d, ghosts %d: %s"
                         % (rank, blank, ghosts, own[0][0]))
expected = tables(cells_of(fill(whole(), False)), alone=True)
scripttest.check(tables(cells_of(fill(piece(False), False))) == expected, "cells")

rows = tables(fill(piece(False), False), on_all=False)
scripttest.check((len(rows[0]) > 4) == (rank == 0), "rows on the first process only")
# One process without a piece, and one whose labels have another name.
if ranks == 2:
    data = fill(whole(), False) if rank == 1 else vtkImageData()
    scripttest.check(tables(data) == tables(fill(whole(), False), alone=True), "an empty piece")
other = tables(fill(piece(False), False, "truth" if rank else "other"))
scripttest.check(other == [[], []], "the same error on all processes")
controller.Barrier()
sys.stdout.flush()
