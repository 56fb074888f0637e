# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
"""Every process compares its piece with what one process computes for the whole volume.

Run as: mpirun -np N pvbatch --sym mpi_pieces.py
"""
import sys

import numpy as np
from paraview.simple import *
from vtkmodules.vtkFiltersCore import vtkPointDataToCellData
from vtkmodules.vtkImagingCore import vtkRTAnalyticSource
from vtkmodules.vtkParallelCore import vtkDummyController, vtkMultiProcessController
from vtkmodules.vtkCommonDataModel import vtkDataSetAttributes, vtkImageData
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy

import scripttest
from tfc.vtk.vtkTFCFilters import (
    vtkTFCCombinationScore, vtkTFCGradientMagnitude, vtkTFCOcclusion)

scripttest.load_plugin(globals())
controller = vtkMultiProcessController.GetGlobalController()
rank, ranks = controller.GetLocalProcessId(), controller.GetNumberOfProcesses()

# Pieces of 24 x 20 x 17 points on 2 or 4 processes are thinner than a radius of 17.
WHOLE = (-7, 16, 0, 19, 3, 19)
NAMES = ("RTData", "RTData_gradient", "RTData_occlusion")


def single(extent, radius, spoil):
    """Filters on the whole volume, this process alone."""
    alone = vtkDummyController()
    source = vtkRTAnalyticSource()
    source.SetWholeExtent(*extent)
    source.Update()
    data = vtkImageData()
    data.DeepCopy(source.GetOutput())
    data.SetSpacing(1.0, 0.5, 2.0)
    spoil(data)
    gradient = scripttest.make(vtkTFCGradientMagnitude, Controller=alone)
    gradient.SetInputData(data)
    occlusion = scripttest.make(vtkTFCOcclusion, Controller=alone, Radius=radius)
    occlusion.SetInputConnection(gradient.GetOutputPort())
    for filter in (gradient, occlusion):
        filter.SetInputArrayToProcess(0, 0, 0, 0, "RTData")
    score = scripttest.make(vtkTFCCombinationScore, Controller=alone)
    score.SetInputConnection(occlusion.GetOutputPort())
    score.SetPrimary("RTData")
    score.Update()
    return occlusion.GetOutput(), score.GetOutput()


def hole(data):
    """NaN in a box that lies across the pieces, an infinity, and a few blanked points."""
    values = vtk_to_numpy(data.GetPointData().GetArray("RTData")).copy()
    x0, x1, y0, y1, z0, z1 = data.GetExtent()
    z, y, x = np.mgrid[z0:z1 + 1, y0:y1 + 1, x0:x1 + 1]
    values[((x > 2) & (x < 6) & (y > 5) & (y < 13) & (z > 8) & (z < 13)).ravel()] = np.nan
    values[((x == 4) & (y == 3) & (z == 10)).ravel()] = np.inf
    array = numpy_to_vtk(values, deep=1)
    array.SetName("RTData")
    data.GetPointData().SetScalars(array)
    data.AllocatePointGhostArray()
    ghosts = vtk_to_numpy(data.GetPointGhostArray())
    ghosts[((x == 5) & (y % 7 == 3)).ravel()] |= vtkDataSetAttributes.HIDDENPOINT


class Pieces:
    """The filters as proxies, on the pieces of all processes."""

    def __init__(self, extent, radius, spoil, ghosts):
        source = Wavelet(WholeExtent=list(extent))
        self.source = source
        source.UpdatePipeline()
        if ghosts:
            source = GhostCellsGenerator(Input=source, BuildIfRequired=0, MinimumNumberOfGhosts=2)
            source.UpdatePipeline()
        piece = vtkImageData()
        piece.ShallowCopy(source.GetClientSideObject().GetOutputDataObject(0))
        piece.SetSpacing(1.0, 0.5, 2.0)
        if spoil is not None:
            copy = vtkImageData()
            copy.DeepCopy(piece)
            spoil(copy)
            piece = copy
        self.gradient = vtkTFCGradientMagnitude()
        self.gradient.SetInputData(piece)
        self.occlusion = scripttest.make(vtkTFCOcclusion, Radius=radius)
        self.occlusion.SetInputConnection(self.gradient.GetOutputPort())
        for filter in (self.gradient, self.occlusion):
            filter.SetInputArrayToProcess(0, 0, 0, 0, "RTData")
        self.score = vtkTFCCombinationScore()
        self.score.SetInputConnection(self.occlusion.GetOutputPort())
        self.score.SetPrimary("RTData")
        for filter in (self.gradient, self.occlusion, self.score):
            scripttest.check(filter.GetController() == controller,
                             "global controller is the default")
        self.score.Update()
        self.output = self.occlusion.GetOutput()


def compare(extent, radius, spoil=None, ghosts=False):
    what = "extent %s radius %d%s%s" % (extent, radius, " hole" if spoil else "",
                                        " ghosts" if ghosts else "")
    expected, expected_table = single(extent, radius, spoil or (lambda data: None))
    pieces = Pieces(extent, radius, spoil, ghosts)
    piece = pieces.output
    if piece.GetNumberOfPoints():
        e, w = piece.GetExtent(), expected.GetExtent()
        box = tuple(slice(e[a] - w[a], e[a + 1] - w[a] + 1) for a in (4, 2, 0))
        for name in NAMES:
            scripttest.check_close(scripttest.volume(piece, name),
                                   scripttest.volume(expected, name)[box], 1e-5,
                                   "%s: %s on process %d" % (what, name, rank))
    columns = ("correlation", "entropy", "score", "rank")
    rows = scripttest.table(pieces.score.GetOutput(), ("attribute",) + columns)
    expected_rows = scripttest.table(expected_table, ("attribute",) + columns)
    scripttest.check([r[0] for r in rows] == [r[0] for r in expected_rows], what + ": order")
    # Entropies hang on which bin a value on the edge of two falls into: rounding may move a few.
    scripttest.check_close([r[1:] for r in rows], [r[1:] for r in expected_rows], 1e-5,
                           what + ": scores")
    if ranks > 1 and extent == WHOLE and not ghosts:
        own = piece.GetNumberOfPoints()
        scripttest.check(own < expected.GetNumberOfPoints(), what + ": this is a piece")


def compare_cells(radius):
    """The grid of cells, whose pieces share nothing."""
    results = []
    for alone in (True, False):
        if alone:
            source = vtkRTAnalyticSource()
            source.SetWholeExtent(*WHOLE)
            source.Update()
        else:
            source = Wavelet(WholeExtent=list(WHOLE))
            source.UpdatePipeline()
            source = source.GetClientSideObject()
        cells = vtkPointDataToCellData()
        cells.SetInputData(source.GetOutputDataObject(0))
        gradient = vtkTFCGradientMagnitude()
        occlusion = scripttest.make(vtkTFCOcclusion, Radius=radius)
        gradient.SetInputConnection(cells.GetOutputPort())
        occlusion.SetInputConnection(gradient.GetOutputPort())
        for filter in (gradient, occlusion):
            filter.SetInputArrayToProcess(0, 0, 0, 1, "RTData")
            if alone:
                filter.SetController(vtkDummyController())
        occlusion.Update()
        results.append(occlusion.GetOutput())
    expected, piece = results
    e, w = piece.GetExtent(), expected.GetExtent()
    box = tuple(slice(e[a] - w[a], e[a + 1] - w[a]) for a in (4, 2, 0))

    def values(data, name):
        array = vtk_to_numpy(data.GetCellData().GetArray(name))
        return array.reshape([n - 1 for n in data.GetDimensions()[::-1]])

    for name in NAMES:
        scripttest.check_close(values(piece, name), values(expected, name)[box], 1e-5,
                               "cells radius %d: %s on process %d" % (radius, name, rank))


def compare_proxies(radius):
    """Proxies connected to each other: requests, and parts of the result, go through ParaView."""
    expected, _ = single(WHOLE, radius, lambda data: data.SetSpacing(1.0, 1.0, 1.0))
    source = Wavelet(WholeExtent=list(WHOLE))
    gradient = VolumeGradientMagnitude(Input=source, InputArray=["POINTS", "RTData"])
    occlusion = VolumeOcclusion(Input=gradient, InputArray=["POINTS", "RTData"], Radius=radius)
    subset = ExtractSubset(Input=occlusion, VOI=[-3, 14, 2, 18, 5, 18])
    for proxy in (occlusion, subset):
        proxy.UpdatePipeline()
        piece = proxy.GetClientSideObject().GetOutputDataObject(0)
        if not piece.GetNumberOfPoints():
            continue
        e, w = piece.GetExtent(), expected.GetExtent()
        box = tuple(slice(e[a] - w[a], e[a + 1] - w[a] + 1) for a in (4, 2, 0))
        for name in NAMES:
            scripttest.check_close(scripttest.volume(piece, name),
                                   scripttest.volume(expected, name)[box], 1e-5,
                                   "%s radius %d: %s on process %d"
                                   % (proxy.GetXMLName(), radius, name, rank))


for radius in (2, 17):
    compare_cells(radius)
    compare_proxies(radius)
for radius in (1, 3, 17):
    compare(WHOLE, radius)
    compare(WHOLE, radius, spoil=hole)
compare(WHOLE, 3, ghosts=True)
compare(WHOLE, 17, ghosts=True)
# Fewer slices than processes: some hold nothing.
compare((0, 1, 0, 0, 0, 1), 2)
controller.Barrier()
sys.stdout.flush()
