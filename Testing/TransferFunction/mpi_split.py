# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
"""What splits a region does not depend on the number of processes.

Run as: mpirun -np N pvbatch --sym mpi_split.py
"""
import sys

import numpy as np
from paraview.simple import *
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkMultiBlockDataSet
from vtkmodules.vtkParallelCore import vtkDummyController, vtkMultiProcessController
from vtkmodules.util.numpy_support import numpy_to_vtk

import scripttest

from tfc.vtk.vtkTFCTransferFunction import vtkTFCRegionSplit

scripttest.load_plugin(globals())
import tfc

controller = vtkMultiProcessController.GetGlobalController()
rank, ranks = controller.GetLocalProcessId(), controller.GetNumberOfProcesses()
WHOLE = (-7, 32, 0, 29, 3, 24)

tf = tfc.TransferFunction("a", "b")
tf.add_ellipse(center=(0, 0.5), radii=(1.5, 0.9))
tf.add_rectangle(center=(1, -0.5), halfsize=(1, 0.5))


def fill(data, name="c"):
    """Attributes that depend on the place alone."""
    result = vtkImageData()
    result.CopyStructure(data)
    x0, x1, y0, y1, z0, z1 = data.GetExtent()
    z, y, x = np.mgrid[z0:z1 + 1, y0:y1 + 1, x0:x1 + 1].astype(float)
    noise = np.sin(12.9898 * x + 78.233 * y + 37.719 * z)
    for label, values in (("a", 2 * noise), ("b", np.cos(0.3 * x + 0.2 * y * z)),
                          (name, np.sign(np.sin(x * y)) * 10 + np.cos(z * x)), ("d", x + y)):
        array = numpy_to_vtk(np.ascontiguousarray(values.ravel()), deep=1)
        array.SetName(label)
        result.GetPointData().AddArray(array)
    return result


def table(data, alone=False, on_all=True):
    split = vtkTFCRegionSplit()
    if alone:
        split.SetController(vtkDummyController())
    split.SetInputData(data)
    split.SetNumberOfBins(64)
    split.SetTransferFunction(tf.to_json())
    split.SetTablesOnAllProcesses(on_all)
    split.Update()
    found = split.GetOutputDataObject(0)
    return [tuple(str(found.GetValue(row, c)) for c in range(found.GetNumberOfColumns()))
            for row in range(found.GetNumberOfRows())]


source = Wavelet(WholeExtent=list(WHOLE))
source.UpdatePipeline()
piece = source.GetClientSideObject().GetOutputDataObject(0)
whole = vtkImageData()
whole.SetExtent(*WHOLE)
expected = table(fill(whole), alone=True)
best = expected[0]
scripttest.check(len(expected) == 4 and best[2] == '"c"', "c splits best: %s" % (best,))
scripttest.check(table(fill(piece)) == expected, "process %d" % rank)
scripttest.check(len(table(fill(piece), on_all=False)) == (0 if rank else 4), "rows once")


def blocks(mine):
    tree = vtkMultiBlockDataSet()
    for number in range(4):
        if number in mine:
            block = vtkImageData()
            block.SetExtent(10 * number, 10 * number + 9, 0, 9, 0, 9)
            tree.SetBlock(number, fill(block))
    return tree


# With two processes or four, the last one or two may hold no block at first.
expected = table(blocks(range(4)), alone=True)
scripttest.check(table(blocks(range(4) if rank == 0 else [])) == expected, "all blocks on one")
scripttest.check(table(blocks([n for n in range(4) if n % ranks == rank])) == expected, "dealt")
scripttest.check(table(fill(piece, "c" if rank else "other")) == [], "the same error everywhere")
controller.Barrier()
sys.stdout.flush()
