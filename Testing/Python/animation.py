# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
"""Axes without a range follow the data of each step of time, also when ParaView has kept the step
and does not compute it again.
"""
import builtins

import numpy as np
import pictures
import scripttest

from paraview import simple

import tfc

STEPS = (0, 1, 2)
# At each step the values are larger than before, while the regions stay where they are.
REQUEST_DATA = """
import builtins
import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
info = self.GetOutputInformation(0)
time = info.Get(vtk.vtkStreamingDemandDrivenPipeline.UPDATE_TIME_STEP())
builtins.tfc_steps.append(time)
output = self.GetOutputDataObject(0)
output.SetDimensions(9, 9, 9)
for name, axis in (("a", 0), ("b", 1)):
    index = np.indices((9, 9, 9))[2 - axis]
    array = numpy_to_vtk((index * (1.0 + time) + time).ravel(), deep=1)
    array.SetName(name)
    output.GetPointData().AddArray(array)
"""
REQUEST_INFORMATION = """
info = self.GetOutputInformation(0)
info.Set(vtk.vtkStreamingDemandDrivenPipeline.WHOLE_EXTENT(), (0, 8, 0, 8, 0, 8), 6)
steps = (0, 1, 2)
info.Set(vtk.vtkStreamingDemandDrivenPipeline.TIME_STEPS(), steps, len(steps))
info.Set(vtk.vtkStreamingDemandDrivenPipeline.TIME_RANGE(), (steps[0], steps[-1]), 2)
"""

check = scripttest.check


def play(scene, view):
    """Pictures of all steps."""
    shots = []
    for time in STEPS:
        scene.AnimationTime = time
        shots.append(pictures.capture(view))
    return shots


builtins.tfc_steps = []
source = simple.ProgrammableSource(OutputDataSetType="vtkImageData", Script=REQUEST_DATA,
                                   ScriptRequestInformation=REQUEST_INFORMATION)
view = pictures.make_view()
function = tfc.TransferFunction("a", "b")
# Over all values: with the ranges of another step, some of them would be outside.
function.add_rectangle((13, 13), (14, 14), color=(1, 0.4, 0), opacity=0.5)
state = function.to_json()
display = tfc.show(source, function, view)
display.TransferFunction = state  # show() filled the ranges in
display.LegendVisibility = 1
simple.ResetCamera(view)
scene = simple.GetAnimationScene()
scene.UpdateAnimationUsingDataTimeSteps()

plain = play(scene, view)
for i in (0, 1):
    check(pictures.difference(plain[i], plain[i + 1]) > 1, "steps %d and %d differ" % (i, i + 1))

settings = simple.GetSettingsProxy("GeneralSettings")
settings.CacheGeometryForAnimation = 1
settings.UpdateVTKObjects()
for kept in ("computed", "kept"):
    computed = len(builtins.tfc_steps)
    differences = [pictures.difference(*pair) for pair in zip(plain, play(scene, view))]
    check(not np.any(differences), "the same pictures while steps are %s: %s" % (kept, differences))
check(len(builtins.tfc_steps) == computed, "nothing was computed again")
