# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
"""Sizes and blobs do not depend on the number of processes.

Run as: mpirun -np N pvbatch --sym mpi_size.py
"""
import sys

import numpy as np
from paraview.simple import *
from vtkmodules.vtkFiltersCore import vtkPointDataToCellData
from vtkmodules.vtkImagingCore import vtkRTAnalyticSource
from vtkmodules.vtkParallelCore import vtkDummyController, vtkMultiProcessController
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy

import scripttest

try:
    from mpi4py import MPI
except ImportError as error:
    scripttest.skip("needs mpi4py (Debian: python3-mpi4py): %s" % error)

from tfc.vtk.vtkTFCFilters import vtkTFCFeatureSize

scripttest.load_plugin(globals())
controller = vtkMultiProcessController.GetGlobalController()
rank, ranks = controller.GetLocalProcessId(), controller.GetNumberOfProcesses()

# Long enough that a piece and its halo are a part of the volume only.
LONG = (-5, 214, 0, 23, 3, 25)
COMPACT = (-7, 40, 0, 39, 3, 38)


def scene(extent, holes):
    """Balls all over the volume, some across pieces, and noise that depends on the place alone."""
    x0, x1, y0, y1, z0, z1 = extent
    z, y, x = np.mgrid[z0:z1 + 1, y0:y1 + 1, x0:x1 + 1].astype(float)
    values = 0.1 * np.sin(12.9898 * x + 78.233 * y + 37.719 * z + 0.1 * x * y)
    # Along x the pieces' shared samples are among the centres.
    for i, cx in enumerate(range(0, 215, 13)):
        cy, cz, r = 6 + 3 * (i % 4), 9 + 4 * (i % 3), 3 + i % 3
        values += (x - cx) ** 2 + (y - cy) ** 2 + (z - cz) ** 2 <= r * r
    if holes:
        values[(np.abs(x - 17) < 3) & (y < 14)] = np.nan
    return values.astype(np.float32)


def image(extent, holes):
    data = vtkImageData()
    data.SetExtent(*extent)
    data.SetSpacing(1.0, 0.5, 2.0)
    data.SetOrigin(3.0, 4.0, 5.0)
    array = numpy_to_vtk(scene(extent, holes).ravel(), deep=1)
    array.SetName("a")
    data.GetPointData().SetScalars(array)
    return data


def make(largest, **properties):
    return scripttest.make(vtkTFCFeatureSize, LargestSize=largest, SmallestSize=2.5,
                           NumberOfScales=6, Polarity=vtkTFCFeatureSize.BOTH, **properties)


def run(filter, data, association=0):
    filter.SetInputData(data)
    filter.SetInputArrayToProcess(0, 0, 0, association, "a")
    filter.Update()
    return filter.GetOutput(), blobs(filter.GetBlobs())


def blobs(data):
    """A row per blob: place, size, scale and response."""
    rows = [vtk_to_numpy(data.GetPointData().GetArray(name)).reshape(-1, 1)
            for name in ("size", "scale", "response")]
    points = data.GetPoints()
    places = vtk_to_numpy(points.GetData()) if points.GetNumberOfPoints() else np.zeros((0, 3))
    return np.hstack([places] + rows)


def compare(what, expected, piece, association):
    """The piece of the sizes, and all processes' blobs together."""
    expected, expected_blobs = expected
    piece, own_blobs = piece
    e, w = piece.GetExtent(), expected.GetExtent()
    cells = 1 if association else 0
    if piece.GetNumberOfPoints():
        box = tuple(slice(e[a] - w[a], e[a + 1] - w[a] + 1 - cells) for a in (4, 2, 0))

        def values(data):
            array = data.GetAttributes(association).GetArray("a_size")
            return vtk_to_numpy(array).reshape([max(1, n - cells)
                                                for n in data.GetDimensions()[::-1]])

        scripttest.check_close(values(piece), values(expected)[box], 1e-5,
                               "%s: sizes on process %d" % (what, rank))
    gathered = np.vstack(MPI.COMM_WORLD.allgather(own_blobs))

    def ordered(rows):
        return rows[np.lexsort(np.round(rows[:, 2::-1], 3).T)]

    scripttest.check(len(gathered) == len(expected_blobs),
                     "%s: %d blobs, expected %d" % (what, len(gathered), len(expected_blobs)))
    scripttest.check_close(ordered(gathered), ordered(expected_blobs), 1e-5, what + ": blobs")
    return len(gathered)


def piece_of(extent):
    """This process's extent as ParaView divides the whole."""
    source = Wavelet(WholeExtent=list(extent))
    source.UpdatePipeline()
    return source.GetClientSideObject().GetOutputDataObject(0).GetExtent()


def cells_of(data):
    convert = vtkPointDataToCellData()
    convert.SetInputData(data)
    convert.Update()
    return convert.GetOutput()


def compare_all(extent, largest, holes=False, **properties):
    what = "extent %s largest %g%s %s" % (extent, largest, " holes" if holes else "", properties)
    alone = make(largest, Controller=vtkDummyController(), **properties)
    expected = run(alone, image(extent, holes))
    own = piece_of(extent)
    part = image(own, holes)
    several = make(largest, **properties)
    count = compare(what, expected, run(several, part), 0)
    scripttest.check(count > 3, "%s: %d blobs" % (what, count))
    if not holes:
        alone = make(largest, Controller=vtkDummyController(), **properties)
        expected = run(alone, cells_of(image(extent, False)), 1)
        several = make(largest, **properties)
        compare("cells " + what, expected, run(several, cells_of(part), 1), 1)


# Small sizes: halos of some 30 samples, so that pieces of the long volume are real ones.
compare_all(LONG, 5.0)
compare_all(LONG, 5.0, ScaleSpace=vtkTFCFeatureSize.GAUSSIAN)
compare_all(LONG, 5.0, holes=True)
compare_all(LONG, 6.0, LengthUnit=vtkTFCFeatureSize.WORLD)
compare_all(COMPACT, 15.0)
compare_all(COMPACT, 15.0, holes=True)

# Proxies: only the second output is asked for, and each process owns a part of the blobs.
wavelet = Wavelet(WholeExtent=[0, 59, 0, 49, 0, 39])
size = VolumeFeatureSize(Input=wavelet, InputArray=["POINTS", "RTData"], SmallestSize=2.5,
                         LargestSize=15, Polarity="Both", Threshold=0.02)
twice = Calculator(Input=OutputPort(size, 1), ResultArrayName="twice", Function="2*size")
twice.UpdatePipeline()
native = size.GetClientSideObject()
scripttest.check(native.GetController() == controller, "global controller is the default")
own = blobs(native.GetBlobs())
ghosts = GhostCellsGenerator(Input=wavelet, BuildIfRequired=0, MinimumNumberOfGhosts=3)
layers = VolumeFeatureSize(Input=ghosts, InputArray=["POINTS", "RTData"], SmallestSize=2.5,
                           LargestSize=15, Polarity="Both", Threshold=0.02)
layers.UpdatePipeline()
from_ghosts = blobs(layers.GetClientSideObject().GetBlobs())
reference = make(15, Controller=vtkDummyController(), Threshold=0.02)
reference.SetNumberOfScales(12)
serial = vtkRTAnalyticSource()
serial.SetWholeExtent(0, 59, 0, 49, 0, 39)
serial.Update()
reference.SetInputData(serial.GetOutput())
reference.SetInputArrayToProcess(0, 0, 0, 0, "RTData")
reference.Update()
count = reference.GetBlobs().GetNumberOfPoints()
for what, rows in (("blobs alone", own), ("ghost layers", from_ghosts)):
    number = len(np.vstack(MPI.COMM_WORLD.allgather(rows)))
    scripttest.check(number == count, "%s: %d blobs, expected %d" % (what, number, count))
controller.Barrier()
sys.stdout.flush()
