# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
"""The example that renders any volume: computed attributes, pictures, and messages."""
import os
import sys
import tempfile

import numpy as np

import scripttest

sys.path.insert(0, sys.argv[1])
import invesalius
import render_volume
import tfc

scripttest.load_plugin(globals())
from paraview import servermanager
from paraview.simple import GetActiveViewOrCreate, GetSources, LoadState, ResetSession

z, y, x = np.mgrid[-1:1:20j, -1:1:24j, -1:1:28j]
ball = (1000 * np.exp(-3 * (x * x + y * y + z * z))).astype(np.float32)


def error_of(*arguments):
    """The message of the problem that an attempt ends with."""
    try:
        render_volume.main(*arguments)
    except render_volume.Problem as problem:
        return str(problem)
    return ""


with tempfile.TemporaryDirectory() as folder:
    path = lambda name: os.path.join(folder, name)
    invesalius.write_vti(path("ball.vti"), ball, (1, 1, 2), "V")
    tf = tfc.TransferFunction("V", "V_gradient")
    tf.add_rectangle((500, 60), (400, 60), color="gold").tertiary("V_occlusion", [(0, 0), (200, 1)])
    tf.save(path("ball.tfc.json"))
    state = path("ball.tfc.json")

    render_volume.main(path("ball.vti"), state, path("new/folder"), radius=4, eta=1,
                       size=(200, 150))
    for name in ("ball.png", "ball.pvsm"):
        scripttest.check(os.path.getsize(path("new/folder/" + name)) > 1000, name + " was written")
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkIOImage import vtkPNGReader

    reader = vtkPNGReader()
    reader.SetFileName(path("new/folder/ball.png"))
    reader.Update()
    image = reader.GetOutput()
    scripttest.check(image.GetDimensions() == (200, 150, 1), "size of the picture")
    pixels = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(150, 200, -1).astype(int)
    gold = (pixels[..., 0] > pixels[..., 2] + 50).mean()
    scripttest.check(0.05 < gold < 0.9, "the ball covers %.0f %% of the picture" % (100 * gold))

    ResetSession()
    scripttest.load_plugin(globals())
    LoadState(path("new/folder/ball.pvsm"))
    displays = [d for d in GetActiveViewOrCreate("RenderView").Representations
                if getattr(d, "Representation", "") == tfc.display.REPRESENTATION]
    scripttest.check(len(displays) == 1 and "V_occlusion" in displays[0].TransferFunction,
                     "the .pvsm state has the display and its transfer function")
    radii = [s.Radius for s in GetSources().values() if hasattr(s, "BoundaryParameter")]
    scripttest.check(radii == [4], "and the radius of the occlusion")

    other = tfc.TransferFunction("V", "T")
    other.add_ellipse((500, 60), (400, 60)).tertiary("U_occlusion", [(0, 0), (200, 1)])
    other.save(path("other.tfc.json"))
    message = error_of(path("ball.vti"), path("other.tfc.json"), folder)
    scripttest.check("T, U_occlusion" in message and "arrays are: V" in message, message)
    message = error_of(path("none.vti"), state, folder)
    scripttest.check("no such file" in message, message)
    message = error_of(path("ball.vti"), path("none.tfc.json"), folder)
    scripttest.check("none.tfc.json" in message, message)
    with open(path("text.unknown"), "w") as file:
        file.write("no volume")
    message = error_of(path("text.unknown"), state, folder)
    scripttest.check("text.unknown" in message, message)
    message = error_of(path("ball.vti"), path("text.unknown"), folder)
    scripttest.check("expected valid JSON" in message, message)
    with open(path("points.csv"), "w") as file:
        file.write("V,V_gradient,V_occlusion\n1,2,3\n4,5,6\n")
    message = error_of(path("points.csv"), state, folder)
    scripttest.check("points.csv" in message and "not an image" in message, message)
