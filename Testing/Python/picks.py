# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
"""tfc.pick(): against the picture and against closed forms."""
import math

import numpy as np
import pictures
import scripttest

from paraview import simple

import tfc

check = scripttest.check
raises = scripttest.raises

source = pictures.make_source()
view = pictures.make_view()
camera = view.GetActiveCamera()
camera.SetPosition(40, 25, 55)
camera.SetFocalPoint(0, 0, 0)

# White fog: the picture is the opacity.
fog = tfc.TransferFunction("RTData", "R", primary_range=(0, 300), secondary_range=(0, 20))
fog.add_rectangle((150, 10), (400, 40), name="fog", color=(1, 1, 1), opacity=0.05,
                  falloff="constant")
display = tfc.show(source, fog, view, unit_distance=2, shade=False)


def compare(display, step=25, tolerance=3):
    """The opacity of pixels in the picture and along their lines; how many reach the threshold."""
    picture = pictures.capture(view)
    seen = 0
    for x in range(5, pictures.SIZE[0], step):
        for y in range(5, pictures.SIZE[1], step):
            found = tfc.pick(view, x, y, display, threshold=0.15)
            brightness = picture[y, x, 0] / 255
            check(abs(brightness - (found.total_opacity if found else 0)) < tolerance / 255,
                  "opacity of pixel %d, %d: %g" % (x, y, brightness))
            if found and found.reached:
                seen += 1
                check(0.15 <= found.opacity < 0.15 + 0.05, "accumulated opacity")
                check(found.regions[0].contribution == 1 and found.regions[0].weight == 1,
                      "the fog alone")
    check(seen > 3, "some pixels reach the threshold: %d" % seen)
    return seen


for parallel in (0, 1):
    camera.SetParallelProjection(parallel)
    camera.SetParallelScale(14)
    everything = compare(display)

# What the display crops away is not found: the inside of a box, then all but its inside.
display.UseCropping = 1
display.CroppingOrigin = [2, 0, -1]
display.CroppingScale = [0.6, 0.8, 1]
check(compare(display, 20) > 3, "the inside of the cropping box")
display.CroppingRegionFlags = 0x7ffffff & ~0x2000
compare(display, 35, 8)  # ends of pieces and not the planes themselves
display.CroppingRegionFlags = 0x2000
display.UseCropping = 0

# Depth along an axis, and the values there.
camera.SetParallelProjection(1)
camera.SetPosition(0, 0, 50)
camera.SetViewUp(0, 1, 0)
found = tfc.pick(view, pictures.SIZE[0] // 2, pictures.SIZE[1] // 2, threshold=0.3)
length = 2 * math.log(0.7) / math.log(0.95)
check(abs(found.position[2] - (10 - length)) < 0.5, "depth %g" % found.position[2])
check(abs(found.distance - (50 - found.position[2])) < 1e-6, "distance")
check(abs(found.values["R"] - np.linalg.norm(found.position)) < 0.05, "value of R")
check(abs(found.values["X"] - found.position[0]) < 1e-6, "value of X")
check(found.axes == (found.values["RTData"], found.values["R"]), "values of the axes")
check(found.voxel == tuple(int(round(p)) for p in found.position), "voxel")

# Contributions, with third attributes.
tf = pictures.make_transfer_function()
tfc.apply(display, tf)
found = tfc.pick(view, pictures.SIZE[0] // 2, pictures.SIZE[1] // 2)
by_name = {region.name: region for region in found.regions}
check(set(by_name) == {"ball", "half"}, "regions")
check(abs(math.fsum(region.contribution for region in found.regions) - 1) < 1e-9, "shares")
x = found.values["X"]
check(abs(by_name["half"].tertiary - np.clip((x + 1) / 2, 0, 1)) < 1e-9, "tertiary factor")
for region in found.regions:
    check(abs(region.opacity - 0.5 * region.weight * region.tertiary) < 1e-9, "opacity")

# A display that is moved and scaled.
display.Position = [3, 0, 0]
display.Scale = [2, 2, 2]
moved = tfc.pick(view, pictures.SIZE[0] // 2, pictures.SIZE[1] // 2)
check(abs(moved.values["X"] - (moved.position[0] - 3) / 2) < 1e-6, "transformed")
display.Position = [0, 0, 0]
display.Scale = [1, 1, 1]

check(tfc.pick(view, 0, 0) is None, "nothing in the corner")
raises(ValueError, lambda: tfc.pick(view, 5000, 3), "outside of the view")
raises(ValueError, lambda: tfc.pick(view, 3, 3, threshold=2), "Threshold")
simple.Hide(source, view)
raises(ValueError, lambda: tfc.pick(view, 3, 3), "0 displays")

# A rectilinear grid with uneven steps of the same field; last, as the script of such a filter
# leaves names behind.
grid = simple.ProgrammableFilter(Input=source, OutputDataSetType="vtkRectilinearGrid")
grid.Script = """
import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
ticks = [np.sign(t) * np.abs(t) ** 1.5 / np.sqrt(10) for t in (np.linspace(-10, 10, 21),) * 3]
output.SetExtent(-10, 10, -10, 10, -10, 10)
for set_ticks, t in zip((output.VTKObject.SetXCoordinates, output.VTKObject.SetYCoordinates,
                         output.VTKObject.SetZCoordinates), ticks):
    set_ticks(numpy_to_vtk(t, deep=1))
for name in ("RTData", "R"):
    output.PointData.append(inputs[0].PointData[name], name)
"""
grid.RequestInformationScript = """
executive = self.GetExecutive()
executive.GetOutputInformation(0).Set(executive.WHOLE_EXTENT(), -10, 10, -10, 10, -10, 10)
"""
check(compare(tfc.show(grid, fog, view, unit_distance=2, shade=False)) > 3, "a rectilinear grid")
