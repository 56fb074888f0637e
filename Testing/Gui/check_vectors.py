# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
"""For Vectors.xml: the active transfer function, of lengths and components of vectors, classifies
and draws vectors.vti (see write_volumes.py) as the same one of scalars that hold these numbers.
Then the first region is named "same", which the events look for."""
import json
import os
import tempfile
import traceback

import numpy
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

SCALARS = {("u", -1): "length_u", ("v", -1): "length_v", ("v", 1): "v_y", ("w", -1): "length_w"}


def classify(source, state):
    """Colour and opacity of all points."""
    proxy = simple.ClassifyVolume(Input=source, TransferFunction=json.dumps(state))
    data = servermanager.Fetch(proxy)
    simple.Delete(proxy)
    simple.SetActiveSource(source)
    return vtk_to_numpy(data.GetPointData().GetArray("tfc_rgba")).copy()


def draw(display, view, state, folder):
    """The pixels of the view."""
    from vtkmodules.vtkIOImage import vtkPNGReader
    display.TransferFunction = json.dumps(state)
    name = os.path.join(folder, "view.png")
    simple.SaveScreenshot(name, view, ImageResolution=[300, 300])
    reader = vtkPNGReader()
    reader.SetFileName(name)
    reader.Update()
    return vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).astype(int)


def main():
    source, view = simple.GetActiveSource(), simple.GetActiveView()
    display = simple.GetDisplayProperties(source, view)
    text = display.TransferFunction
    vectors, scalars = json.loads(text), json.loads(text)
    region = scalars["regions"][0]
    for axis in (scalars["primary"], scalars["secondary"], region["tertiary"]):
        axis["array"] = SCALARS[axis["array"], axis.get("component", 0)]
        axis["component"] = 0
    first, second = classify(source, vectors), classify(source, scalars)
    assert first[:, 3].max() > 0.1 and numpy.abs(first - second).max() < 1e-6
    with tempfile.TemporaryDirectory() as folder:
        first = draw(display, view, vectors, folder)
        second = draw(display, view, scalars, folder)
    shown = numpy.abs(first - first[0]).max(axis=1) > 8
    assert shown.sum() > 1000 and numpy.abs(first - second).max() <= 1
    vectors["regions"][0]["name"] = "same"
    display.TransferFunction = json.dumps(vectors)


try:
    main()
except Exception:
    # The shell keeps its output to itself.
    os.write(2, traceback.format_exc().encode())
    raise
