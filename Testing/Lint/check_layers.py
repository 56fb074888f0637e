# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
"""The layer rule: what the sources of each folder may include (CONTRIBUTING.md has the figure)."""
import os
import re

import lint

INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]')
VTK = re.compile(r"^vtk.*\.h$")
# VTK has classes for threads whose names start with vtkSMP.
PARAVIEW_OR_QT = re.compile(r"^(pq|vtkSM(?!P(Tools|Thread))|vtkPV|vtkSI|Q[A-Z])")
OPENGL = re.compile(r"^(vtkOpenGL|vtk_glew|vtkTextureObject|vtkShader(?!Tables)|GL/)")

# A folder may include its own headers and those of the folders that it names.
LAYERS = {
    "Filters/Kernels": [],
    "Filters": ["Filters/Kernels"],
    "Rendering/TransferFunction": ["Filters"],
    "Rendering/Volume": ["Rendering/TransferFunction", "Filters", "Filters/Kernels"],
    "Rendering/Charts": ["Rendering/TransferFunction", "Filters"],
    "Plugin": ["Rendering/Volume", "Rendering/Charts", "Rendering/TransferFunction", "Filters",
               "Filters/Kernels"],
}


def layer_of(path):
    """The layer that a file is in, the innermost folder that is one; None outside the layers."""
    inside = [layer for layer in LAYERS if path.startswith(layer + "/")]
    return max(inside, key=len, default=None)


def wrong(layer, header, owner):
    """What is wrong with an include in a layer, or None; owner is the header's layer."""
    name = os.path.basename(header)
    if layer == "Filters/Kernels" and VTK.match(name):
        return "kernels include no VTK: pass pointers and sizes"
    if layer != "Plugin" and PARAVIEW_OR_QT.match(name):
        return "only Plugin/ includes ParaView's or Qt's classes"
    if layer != "Rendering/Volume" and OPENGL.match(name):
        return "only Rendering/Volume includes OpenGL classes"
    if owner and owner != layer and owner not in LAYERS[layer]:
        allowed = ", ".join([layer] + LAYERS[layer])
        return "%s is in %s; %s may use: %s" % (name, owner, layer, allowed)
    return None


paths = [path for path in lint.files(".h", ".cxx", ".txx") if layer_of(path)]
owners = {os.path.basename(path): layer_of(path) for path in paths if path.endswith(".h")}
problems = []
for path in paths:
    for number, text in lint.lines(path):
        include = INCLUDE.match(text)
        if include:
            header = include.group(1)
            what = wrong(layer_of(path), header, owners.get(os.path.basename(header)))
            if what:
                problems.append("%s:%d: includes %s: %s" % (path, number, header, what))
lint.finish(problems, len(paths))
