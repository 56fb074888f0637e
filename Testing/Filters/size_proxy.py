# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
"""The proxy of the size filter as a script uses it."""
from paraview import servermanager
from paraview.simple import *

import scripttest

scripttest.load_plugin(globals())
from tfc.vtk.vtkTFCFilters import vtkTFCFeatureSize

source = Wavelet(WholeExtent=[0, 59, 0, 49, 0, 39])
source.UpdatePipeline()
size = VolumeFeatureSize(Input=source, InputArray=["POINTS", "RTData"])
defaults = {
    "LengthUnit": "Voxels", "SmallestSize": 2.5, "Polarity": "Bright",
    "Threshold": 0.08, "UseIntensityRange": 0, "ScaleSpace": "Nonlinear", "Conductance": 0.5,
    "NumberOfScales": 12, "Component": 0,
}
native = vtkTFCFeatureSize()
for name, value in defaults.items():
    scripttest.check(size.GetPropertyValue(name) == value, "default of " + name)
    number = getattr(native, "Get" + name)()
    scripttest.check(isinstance(value, str) and number == 0 or number == value,
                     "the same in the class: " + name)
scripttest.check(size.LargestSize == 24 and native.GetLargestSize() == 25,
                 "the largest size fits the volume: %g" % size.LargestSize)
scripttest.check(len(size.MoreArrays) == 0, "no more arrays by default")
data = source.PointData["RTData"].GetRange()
scripttest.check(all(abs(a - b) < 1e-3 for a, b in zip(size.IntensityRange, data)),
                 "the intensity range is that of the array: %s" % list(size.IntensityRange))

size.SmallestSize = 3
size.LargestSize = 15
size.Polarity = "Both"
size.UpdatePipeline()
scripttest.check(size.PointData.keys() == ["RTData", "RTData_size"], "the arrays pass through")
scripttest.check(isinstance(size.GetClientSideObject(), vtkTFCFeatureSize), "wrapped class")
scripttest.check([size.SMProxy.GetOutputPortName(i) for i in (0, 1)] == ["Volume", "Blobs"],
                 "names of the outputs")
blobs = servermanager.Fetch(size, idx=1)
count = blobs.GetNumberOfPoints()
scripttest.check(blobs.IsA("vtkPolyData") and count > 0, "%d blobs" % count)
names = [blobs.GetPointData().GetAbstractArray(i).GetName()
         for i in range(blobs.GetPointData().GetNumberOfArrays())]
scripttest.check(names == ["size", "radius_world", "scale", "response", "array"], str(names))

# The second output alone, of a filter that was not updated yet.
fresh = VolumeFeatureSize(Input=source, InputArray=["POINTS", "RTData"], SmallestSize=3,
                          LargestSize=15, Polarity="Both")
glyphs = Threshold(Input=OutputPort(fresh, 1), Scalars=["POINTS", "response"])
glyphs.UpdatePipeline()
scripttest.check(servermanager.Fetch(fresh, idx=1).GetNumberOfPoints() == count, "blobs alone")

more = Calculator(Input=source, ResultArrayName="inverse", Function="-RTData")
several = VolumeFeatureSize(Input=more, InputArray=["POINTS", "RTData"], MoreArrays=["inverse"],
                            SmallestSize=3, LargestSize=15, Polarity="Both")
several.UpdatePipeline()
scripttest.check("inverse_size" in several.PointData.keys(), "more arrays")
found = servermanager.Fetch(several, idx=1)
column = found.GetPointData().GetAbstractArray("array")
kinds = [column.GetValue(i) for i in range(column.GetNumberOfValues())]
scripttest.check(kinds.count("RTData") == count and kinds.count("inverse") == count,
                 "each array has its blobs, bright and dark ones swapped")

for name in size.ListProperties():
    documentation = size.GetProperty(name).GetDocumentation()
    text = documentation.GetDescription() if documentation else None
    scripttest.check(bool(text and text.strip()), "%s is documented" % name)
