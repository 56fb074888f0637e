# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
"""Occlusion's modes and the phantom: every process compares its piece with the whole.

Run as: mpirun -np N pvbatch --sym mpi_modes.py
"""
import sys

from paraview.simple import *
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkParallelCore import vtkDummyController, vtkMultiProcessController
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy

import numpy as np
import scripttest
from tfc.vtk.vtkTFCFilters import vtkTFCMaterialPhantom, vtkTFCOcclusion

scripttest.load_plugin(globals())
controller = vtkMultiProcessController.GetGlobalController()
rank = controller.GetLocalProcessId()
SIZE = [26, 22, 19]


def part_of(whole, piece, name):
    """The values that the whole volume has where the piece is."""
    e, w = piece.GetExtent(), whole.GetExtent()
    box = tuple(slice(e[a] - w[a], e[a + 1] - w[a] + 1) for a in (4, 2, 0))
    return scripttest.volume(whole, name)[box]


def spoil(data):
    """Anisotropic voxels, and NaN in a slab that only some processes hold."""
    result = vtkImageData()
    result.DeepCopy(data)
    result.SetSpacing(1.0, 0.5, 2.0)
    values = vtk_to_numpy(result.GetPointData().GetArray("intensity")).copy()
    x0, x1, y0, y1, z0, z1 = result.GetExtent()
    z, y, x = np.mgrid[z0:z1 + 1, y0:y1 + 1, x0:x1 + 1]
    values[((x == 4) & (y > 3) & (y < 15)).ravel()] = np.nan
    array = numpy_to_vtk(values, deep=1)
    array.SetName("intensity")
    result.GetPointData().SetScalars(array)
    return result


phantom = vtkTFCMaterialPhantom()
phantom.SetDimensions(SIZE)
phantom.Update()
whole = phantom.GetOutput()
source = MaterialPhantom(Dimensions=SIZE)
source.UpdatePipeline()
piece = source.GetClientSideObject().GetOutputDataObject(0)
for name in ("intensity", "material"):
    same = np.array_equal(scripttest.volume(piece, name), part_of(whole, piece, name))
    scripttest.check(same, "phantom: %s on process %d, bit for bit" % (name, rank))

MODES = [
    dict(Neighborhood=1, Radius=5),
    dict(Neighborhood=1, Radius=17, BoundaryParameter=0.5),
    dict(Neighborhood=1, Metric=1, DistanceWeight=2, Radius=6),
    dict(Metric=1, Mapping=1, MappingRange=(0.3, 0.7), Radius=4),
    dict(Neighborhood=1, LengthUnit=1, Radius=4.5),
    dict(LengthUnit=1, Radius=4.5),
    dict(AutoRadius=True, AutoRadiusRange=(2, 12), BoundaryParameter=0.5),
    dict(AutoRadius=True, AutoRadiusRange=(1.0, 9.0), LengthUnit=1, Neighborhood=1),
]
for mode in MODES:
    for change in (lambda data: data, spoil):
        alone = scripttest.make(vtkTFCOcclusion, Controller=vtkDummyController(), **mode)
        together = scripttest.make(vtkTFCOcclusion, **mode)
        for filter, data in ((alone, whole), (together, piece)):
            filter.SetInputData(change(data))
            filter.SetInputArrayToProcess(0, 0, 0, 0, "intensity")
            filter.Update()
        what = "%s%s on process %d" % (mode, " spoilt" if change is spoil else "", rank)
        scripttest.check_close(
            scripttest.volume(together.GetOutput(), "intensity_occlusion"),
            part_of(alone.GetOutput(), together.GetOutput(), "intensity_occlusion"), 1e-5, what)
        scripttest.check(alone.GetUsedRadius() == together.GetUsedRadius(), what + ": same radius")
controller.Barrier()
sys.stdout.flush()
