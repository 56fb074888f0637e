# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
"""Combined Volume of groups of images, of a rectilinear grid, and within a memory limit."""
import numpy as np
import pictures
import scripttest

from paraview import simple

import tfc

check = scripttest.check

source = pictures.make_source()
view = pictures.make_view()
tf = pictures.make_transfer_function()
display = tfc.show(source, tf, view, shade=True)
simple.ResetCamera(view)
display.SampleDistance = 0.5
camera = view.GetActiveCamera()
camera.Azimuth(30)
camera.Elevation(20)
whole = pictures.capture(view)
check(whole.max() > 100, "something is visible")

display.MemoryLimit = 1
limited = pictures.capture(view)
check(np.abs(limited - whole).max() <= 2, "a memory limit changes nothing: %g"
      % np.abs(limited - whole).max())
display.MemoryLimit = 0
simple.Hide(source, view)

# Two halves that share a layer of points, with axes over the range of both. Light differs there, as
# gradients know one side only.
extent = source.GetDataInformation().GetExtent()
middle = (extent[0] + extent[1]) // 2
halves = [simple.ExtractSubset(Input=source, VOI=[*ends, *extent[2:]])
          for ends in ((extent[0], middle), (middle, extent[1]))]
group = simple.GroupDatasets(Input=halves)
display = tfc.show(group, tf, view, shade=True)
display.SampleDistance = 0.5
grouped = pictures.capture(view)
check(pictures.difference(grouped, whole) < 0.5, "two blocks look like the whole: %g"
      % pictures.difference(grouped, whole))
simple.Hide(group, view)

# The same points as a rectilinear grid.
grid = simple.ProgrammableFilter(Input=source, OutputDataSetType="vtkRectilinearGrid")
grid.Script = """
from vtkmodules.vtkCommonCore import vtkDoubleArray
image = self.GetInputDataObject(0, 0)
output.VTKObject.SetExtent(image.GetExtent())
for axis, name in enumerate("XYZ"):
    values = vtkDoubleArray()
    for i in range(image.GetExtent()[2 * axis], image.GetExtent()[2 * axis + 1] + 1):
        values.InsertNextValue(image.GetOrigin()[axis] + i * image.GetSpacing()[axis])
    getattr(output.VTKObject, "Set%sCoordinates" % name)(values)
output.VTKObject.GetPointData().ShallowCopy(image.GetPointData())
"""
grid.RequestUpdateExtentScript = ""
grid.RequestInformationScript = """
from paraview import util
image = self.GetInputDataObject(0, 0)
util.SetOutputWholeExtent(self, image.GetExtent())
"""
display = tfc.show(grid, tf, view, shade=True)
display.SampleDistance = 0.5
resampled = pictures.capture(view)
check(pictures.difference(resampled, whole) < 0.1, "a rectilinear grid looks like the image: %g"
      % pictures.difference(resampled, whole))
