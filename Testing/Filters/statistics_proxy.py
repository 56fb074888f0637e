# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
"""The proxy of the local statistics as a script uses it."""
from paraview import servermanager
from paraview.simple import *

import scripttest

scripttest.load_plugin(globals())
from tfc.vtk.vtkTFCFilters import vtkTFCLocalStatistics

source = Wavelet(WholeExtent=[0, 31, 0, 25, 0, 17])
gradient = VolumeGradientMagnitude(Input=source, InputArray=["POINTS", "RTData"])
statistics = VolumeLocalStatistics(Input=gradient, InputArray=["POINTS", "RTData"])
scripttest.check(
    (statistics.MaximumRadius, statistics.ConfidenceLevel, statistics.LengthUnit,
     statistics.Moments, statistics.Component) == (6.0, 0.001, "Voxels", 0, 0), "defaults")
scripttest.check(len(statistics.MoreArrays) == 0, "no more arrays by default")
statistics.UpdatePipeline()
scripttest.check(statistics.PointData.keys() ==
                 ["RTData", "RTData_gradient", "RTData_mean", "RTData_radius", "RTData_stddev"],
                 "arrays: %s" % statistics.PointData.keys())
scripttest.check(isinstance(statistics.GetClientSideObject(), vtkTFCLocalStatistics),
                 "wrapped class")

statistics.MoreArrays = ["RTData_gradient"]
statistics.Moments = 1
statistics.LengthUnit = "World units"
statistics.MaximumRadius = 3
statistics.UpdatePipeline()
for name in ("RTData", "RTData_gradient"):
    for suffix in ("_mean", "_stddev", "_radius", "_skewness", "_kurtosis"):
        scripttest.check(name + suffix in statistics.PointData.keys(), name + suffix)
scripttest.check(statistics.PointData["RTData_radius"].GetRange()[1] <= 3, "radii")
statistics.MoreArrays = []
statistics.UpdatePipeline()
scripttest.check("RTData_gradient_mean" not in statistics.PointData.keys(), "cleared")

# A part of the volume has the values of the whole.
whole = servermanager.Fetch(statistics)
part = servermanager.Fetch(ExtractSubset(Input=statistics, VOI=[3, 9, 4, 8, 5, 6]))
scripttest.check_close(scripttest.volume(part, "RTData_mean"),
                       scripttest.volume(whole, "RTData_mean")[5:7, 4:9, 3:10], 0,
                       "a subset of the result")

for name in statistics.ListProperties():
    documentation = statistics.GetProperty(name).GetDocumentation()
    text = documentation.GetDescription() if documentation else None
    scripttest.check(bool(text and text.strip()), name + " is documented")
