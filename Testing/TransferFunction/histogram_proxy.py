# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
"""The proxy TransferFunctionHistogram on one process and, under mpirun, on several.

Run as: pvpython histogram_proxy.py, or mpirun -np N pvbatch histogram_proxy.py
"""
import numpy as np
from paraview import servermanager
from paraview.simple import *
from vtkmodules.util.numpy_support import vtk_to_numpy

import scripttest

scripttest.load_plugin(globals())
import tfc

tf = tfc.TransferFunction("RTData", "X")
inside = tf.add_ellipse(center=(150, 3), radii=(60, 8))
inside.falloff("constant")
inside.tertiary("Y", [(-10, 0), (10, 1)])
tf.add_rectangle(center=(100, 0), halfsize=(20, 5))

volume = Calculator(Input=Calculator(Input=Wavelet(), ResultArrayName="X", Function="coordsX"),
                    ResultArrayName="Y", Function="coordsY")
proxy = TransferFunctionHistogram(Input=volume)
scripttest.check((proxy.TransferFunction, proxy.NumberOfBins) == ("", 256), "defaults")
proxy.TransferFunction = tf.to_json()
proxy.NumberOfBins = 32
proxy.UpdatePipeline()
plane = servermanager.Fetch(proxy, idx=0)
table = servermanager.Fetch(proxy, idx=1)
scripttest.check(plane.GetDimensions() == (32, 32, 1), "one image of 32 x 32")
counts = vtk_to_numpy(plane.GetPointData().GetArray("count"))
scripttest.check(counts.sum() == 21 ** 3, "%d voxels in the plane" % counts.sum())

names = [table.GetColumnName(c) for c in range(table.GetNumberOfColumns())]
scripttest.check(names == ["region 1 Y", "region 1 count"], "columns: %s" % names)
scripttest.check(table.GetNumberOfRows() == 32, "the rows of one process")
centers = vtk_to_numpy(table.GetColumn(0))
scripttest.check_close(centers, -10 + (np.arange(32) + 0.5) * 20 / 32, 1e-12, "bin centres")
weights = vtk_to_numpy(table.GetColumn(1))
# All of the data are on one process only when there is only one.
data = servermanager.Fetch(volume)
if data.GetNumberOfPoints() == 21 ** 3:
    arrays = [vtk_to_numpy(data.GetPointData().GetArray(n)).astype(float)
              for n in ("RTData", "X", "Y")]
    bins, middle = [], []
    for a in arrays:
        low, high = a.min(), a.max()
        b = np.minimum(31, np.floor((a - low) / (high - low) * 32)).astype(int)
        bins.append(b)
        middle.append(low + (b + 0.5) / 32 * (high - low))
    selected = np.hypot((middle[0] - 150) / 60, (middle[1] - 3) / 8) <= 1
    expected = np.bincount(bins[2][selected], minlength=32)
    scripttest.check_close(weights, expected, 1e-6, "the conditional histogram")
