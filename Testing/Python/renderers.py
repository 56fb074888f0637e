# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
"""The properties Renderer (the same state gives the same picture on the GPU and on the CPU),
RayBlending, ShadingArray and UseJittering.
"""
import pictures
import scripttest

from paraview import simple

import tfc

check = scripttest.check

wavelet = simple.Wavelet(WholeExtent=[-24, 24] * 3, StandardDeviation=0.5)
source = simple.Calculator(Input=wavelet, ResultArrayName="R", Function="mag(coords)")
view = pictures.make_view()
tf = tfc.TransferFunction("RTData", "R", primary_range=(0, 300), secondary_range=(0, 42))
tf.add_ellipse((150, 12), (120, 12), name="core", color=(1, 0.5, 0.1), opacity=0.2,
               falloff="smooth", width=1).tertiary("R", [(0, 1), (20, 0.2)], range=(0, 40))
tf.add_ellipse((120, 26), (140, 12), name="shell", color=(0.2, 0.4, 1), opacity=0.05,
               falloff="smooth", width=1)
display = tfc.show(source, tf, view, shade=False)
check(display.Renderer == "Auto", "the default")
check(list(display.GetProperty("Renderer").Available) == ["Auto", "GPU", "CPU"], "the choices")
simple.ResetCamera(view)

with pictures.reported() as text:
    automatic = pictures.capture(view)
    display.Renderer = "GPU"
    gpu = pictures.capture(view)
    display.Renderer = "CPU"
    cpu = pictures.capture(view)
    check(text() == "", "no messages: " + text())
check(pictures.difference(automatic, gpu) == 0, "Auto is the GPU here")
check(float(gpu.max()) > 100, "something is visible")
mean = pictures.difference(gpu, cpu)
print("CPU against GPU: mean difference %.3f of 255, largest %d" % (mean, abs(gpu - cpu).max()))
check(mean > 0, "another renderer drew")
check(mean <= 2, "the same picture: %g" % mean)

# Edits are seen, and a state file keeps the choice.
tf.region("shell").visible = False
tfc.apply(display, tf)
edited = pictures.capture(view)
check(pictures.difference(edited, cpu) > 0.5, "an edit on the CPU")
display.Renderer = "GPU"
check(pictures.difference(edited, pictures.capture(view)) <= 2, "the same edit on the GPU")

# Blend modes: all different, a message for those that there are not.
check(list(display.GetProperty("RayBlending").Available) ==
      ["Composite", "Maximum", "Average", "Additive", "Slice"], "the blend modes")
# Not checked inside: what this script prints is reported, too.
modes = ("Composite", "Maximum", "Average", "Additive", "Slice")
display.SlicePlane.Origin = [2, 3, 4]
display.SlicePlane.Normal = [0.3, 0.2, 1]
seen = []
with pictures.reported() as text:
    for mode in modes:
        display.RayBlending = mode
        seen.append(pictures.capture(view))
    report = text()
check(report == "", "no messages: " + report)
for i, picture in enumerate(seen):
    check(float(picture.max()) > 5, modes[i] + " shows something")
    for j in range(i):
        check(pictures.difference(picture, seen[j]) > 0.05, modes[i] + " is not " + modes[j])
with pictures.reported() as text:
    display.RayBlending = "Composite"
    display.BlendMode = "Isosurface"
    refused = pictures.capture(view)
    report = text()
check(float(refused.max()) == 0, "no isosurfaces")
check("composite, maximum, average, additive or slice" in report, "reported: " + report)
display.BlendMode = "Slice"
check(pictures.difference(seen[4], pictures.capture(view)) == 0, "ParaView's blend mode")
display.SlicePlane.Origin = [-15, 3, 14]
check(pictures.difference(seen[4], pictures.capture(view)) > 0.05, "moved")
display.BlendMode = "Composite"
check(pictures.difference(seen[0], pictures.capture(view)) == 0, "and back")

# What is under a pixel, for ParaView's selection.
check(view.SMProxy.Pick(view.ViewSize[0] // 2, view.ViewSize[1] // 2) is not None, "the volume")
check(view.SMProxy.Pick(1, 1) is None, "nothing in the corner")

# Shading by another array, and jittering.
display.Shade = 1
primary = pictures.capture(view)
display.ShadingArray = "R"
check(pictures.difference(primary, pictures.capture(view)) > 0.2, "another array's normals")
display.ShadingArray = ""
check(pictures.difference(primary, pictures.capture(view)) == 0, "the primary attribute again")
display.ShadeByOpacity = 1
check(pictures.difference(primary, pictures.capture(view)) > 0.2, "by the classified opacity")
display.ShadeByOpacity = 0
check(pictures.difference(primary, pictures.capture(view)) == 0, "the primary attribute's again")
display.UseJittering = 1
check(0 < pictures.difference(primary, pictures.capture(view)) < 3, "jittered samples")
