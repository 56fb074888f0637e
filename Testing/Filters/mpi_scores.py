# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
"""The scores do not depend on the number of processes or on how the volume is cut.

Run as: mpirun -np N pvbatch --sym mpi_scores.py
"""
import sys

import numpy as np
from paraview.simple import *
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkParallelCore import vtkDummyController, vtkMultiProcessController
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy

import scripttest

from tfc.vtk.vtkTFCFilters import vtkTFCAxisSuggestion, vtkTFCCombinationScore

scripttest.load_plugin(globals())
rank = vtkMultiProcessController.GetGlobalController().GetLocalProcessId()
WHOLE = (-7, 42, 0, 39, 3, 34)
COLUMNS = ("attribute", "correlation", "entropy", "score", "rank", "mutual_information",
           "conditional_mutual_information", "new_information", "separation")


def fill(data, cells):
    """Attributes that depend on the place alone, on points or on the cells above them."""
    x0, x1, y0, y1, z0, z1 = data.GetExtent()
    z, y, x = np.mgrid[z0:z1 + 1, y0:y1 + 1, x0:x1 + 1].astype(float)
    a = 2e6 + 2 * np.sin(12.9898 * x + 78.233 * y + 37.719 * z)
    b = 0.1 * x * x + np.cos(y * z)
    b[(x == 4) & (y > 9)] = np.nan
    c = np.sin(y + z) + (a - 2e6) ** 2
    result = vtkImageData()
    result.SetExtent(*data.GetExtent())
    arrays = result.GetCellData() if cells else result.GetPointData()
    for name, values in (("a", a), ("b", b), ("c", c), ("d", np.where(x == 4, 1e35, x * y))):
        values = values[:-1, :-1, :-1] if cells else values
        array = numpy_to_vtk(np.ascontiguousarray(values.ravel()), deep=1)
        array.SetName(name)
        arrays.AddArray(array)
    return result


def rows(data, alone=False):
    score = vtkTFCCombinationScore()
    if alone:
        score.SetController(vtkDummyController())
    score.SetInputData(data)
    score.SetPrimary("a")
    score.SetSecondary("b")
    score.AddFillValue(1e35)
    score.Update()
    return scripttest.table(score.GetOutputDataObject(0), COLUMNS)


def suggestions(data, alone=False):
    """(texts, numbers) of the proposed axes and their tertiary attributes."""
    filter = vtkTFCAxisSuggestion()
    if alone:
        filter.SetController(vtkDummyController())
    filter.SetInputData(data)
    filter.AddFillValue(1e35)
    filter.Update()
    table = filter.GetOutputDataObject(0)
    values = [[table.GetValueByName(row, name) for row in range(table.GetNumberOfRows())]
              for name in ("primary", "secondary", "tertiary", "pair_score", "score",
                           "new_information")]
    return ([[v.ToString() for v in column] for column in values[:3]],
            [[v.ToDouble() for v in column] for column in values[3:]])


source = Wavelet(WholeExtent=list(WHOLE))
source.UpdatePipeline()
piece = source.GetClientSideObject().GetOutputDataObject(0)
whole = vtkImageData()
whole.SetExtent(*WHOLE)
for cells in (False, True):
    expected = rows(fill(whole, cells), alone=True)
    found = rows(fill(piece, cells))
    scripttest.check([r[0] for r in found] == [r[0] for r in expected] and len(found) == 4, "order")
    scripttest.check_close([r[1:] for r in found], [r[1:] for r in expected], 1e-12,
                           "process %d, %s" % (rank, "cells" if cells else "points"))
    scripttest.check(expected[0][7] > 0.1, "there is information")
    texts, numbers = suggestions(fill(piece, cells))
    expected = suggestions(fill(whole, cells), alone=True)
    scripttest.check(texts == expected[0] and len(texts[0]) == 6, "the same suggestions")
    scripttest.check_close(numbers, expected[1], 1e-12, "with the same numbers")
vtkMultiProcessController.GetGlobalController().Barrier()
sys.stdout.flush()
