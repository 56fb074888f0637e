# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
"""Growing spheres on pieces have the bits of the whole volume.

Run as: mpirun -np N pvbatch --sym mpi_statistics.py
"""
import sys

import numpy as np
from paraview.simple import *
from vtkmodules.vtkParallelCore import vtkDummyController, vtkMultiProcessController
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy

import scripttest
from tfc.vtk.vtkTFCFilters import vtkTFCLocalStatistics

scripttest.load_plugin(globals())
controller = vtkMultiProcessController.GetGlobalController()
rank, ranks = controller.GetLocalProcessId(), controller.GetNumberOfProcesses()

SUFFIXES = ("_radius", "_mean", "_stddev", "_skewness", "_kurtosis")


def values(extent, holes):
    """Noise on two levels, the same on every process, as array of the whole volume."""
    x0, x1, y0, y1, z0, z1 = extent
    random = np.random.default_rng(4)
    result = random.normal(size=(z1 - z0 + 1, y1 - y0 + 1, x1 - x0 + 1)).astype(np.float32)
    result[:, (y1 - y0) // 3:] += 5
    if holes:
        result[random.random(result.shape) < 0.05] = np.nan
    return result


def add(data, whole, extent):
    """The part of `whole` that `data` covers, as point array `a`."""
    e = data.GetExtent()
    box = tuple(slice(e[a] - extent[a], e[a + 1] - extent[a] + 1) for a in (4, 2, 0))
    array = numpy_to_vtk(np.ascontiguousarray(whole[box]).ravel(), deep=1)
    array.SetName("a")
    data.GetPointData().SetScalars(array)
    data.SetSpacing(1.0, 0.5, 2.0)


def run(data, **properties):
    filter = scripttest.make(vtkTFCLocalStatistics, ConfidenceLevel=0.01, Moments=True,
                             **properties)
    filter.SetInputData(data)
    filter.SetInputArrayToProcess(0, 0, 0, 0, "a")
    filter.Update()
    return filter.GetOutput()


def compare(extent, holes=False, **properties):
    what = "extent %s%s %s" % (extent, " holes" if holes else "", properties)
    whole = values(extent, holes)
    data = vtkImageData()
    data.SetExtent(*extent)
    add(data, whole, extent)
    expected = run(data, Controller=vtkDummyController(), **properties)
    source = Wavelet(WholeExtent=list(extent))
    source.UpdatePipeline()
    piece = vtkImageData()
    piece.CopyStructure(source.GetClientSideObject().GetOutputDataObject(0))
    if piece.GetNumberOfPoints():
        add(piece, whole, extent)
    result = run(piece, **properties)
    if not piece.GetNumberOfPoints():
        return
    e = result.GetExtent()
    box = tuple(slice(e[a] - extent[a], e[a + 1] - extent[a] + 1) for a in (4, 2, 0))
    for suffix in SUFFIXES:
        scripttest.check_close(scripttest.volume(result, "a" + suffix),
                               scripttest.volume(expected, "a" + suffix)[box],
                               0, "%s: %s on process %d" % (what, suffix, rank))
    if ranks > 1 and whole.size > 1000:
        scripttest.check(result.GetNumberOfPoints() < whole.size, what + ": this is a piece")


def compare_proxies():
    """Proxies connected to each other: requests go through ParaView."""
    source = Wavelet(WholeExtent=[-7, 16, 0, 19, 3, 19])
    statistics = VolumeLocalStatistics(Input=source, InputArray=["POINTS", "RTData"])
    subset = ExtractSubset(Input=statistics, VOI=[-3, 14, 2, 18, 5, 18])
    for proxy in (statistics, subset):
        proxy.UpdatePipeline()
        low, high = proxy.PointData["RTData_radius"].GetRange()
        scripttest.check(1 <= low <= high <= 6, "%s: radii %g to %g" % (proxy, low, high))


WHOLE = (-7, 30, 0, 19, 3, 19)
for radius in (1, 3, 9, 13):
    compare(WHOLE, MaximumRadius=radius)
    compare(WHOLE, holes=True, MaximumRadius=radius)
compare(WHOLE, MaximumRadius=5, LengthUnit=1)
# Fewer slices than processes: some hold nothing.
compare((0, 1, 0, 0, 0, 1), MaximumRadius=2)
compare_proxies()
controller.Barrier()
sys.stdout.flush()
