# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
"""For TertiaryFunction.xml: the histogram that the panel shows for the selected ellipse, saved as
histogram.txt beside the data, is that of its voxels with the weights of its fall-off.

The panel weighs the cells of a joint histogram at their middles, so the weight of a voxel may be
that of any place up to half a cell away: the sums of the smallest and of the largest weights there
are bounds for each bin. Then the region is named "same", which the events look for."""
import json
import os
import traceback

import numpy
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

CELLS = 128  # of each axis
OFFSETS = numpy.linspace(-0.5, 0.5, 5) / CELLS


def falloff_weights(region, x, y):
    """The weight of an ellipse at places in axis units, by the definition of the format."""
    shape, falloff = region["shape"], region["falloff"]
    assert shape["type"] == "ellipse"
    angle = numpy.radians(shape["angle"])
    dx, dy = x - shape["center"][0], y - shape["center"][1]
    d = numpy.hypot((dx * numpy.cos(angle) + dy * numpy.sin(angle)) / shape["radii"][0],
                    (dy * numpy.cos(angle) - dx * numpy.sin(angle)) / shape["radii"][1])
    width = falloff["width"]
    t = numpy.clip((1 - d) / width, 0, 1)
    weight = {"constant": numpy.ones_like(d), "linear": t, "smooth": t * t * (3 - 2 * t),
              "gaussian": numpy.exp(-d * d / (2 * width * width))}[falloff["type"]]
    return numpy.where(d <= 1, weight, 0)


def main():
    source, view = simple.FindSource("random.vti"), simple.GetActiveView()
    display = simple.GetDisplayProperties(source, view)
    state = json.loads(display.TransferFunction)
    region = state["regions"][0]
    arrays = servermanager.Fetch(source).GetPointData()
    a, b, c = (vtk_to_numpy(arrays.GetArray(name)) for name in "abc")
    # Axis units: the ranges are those of the data.
    sizes = [numpy.ptp(a), numpy.ptp(b)]
    x, y = (a - a.min()) / sizes[0], (b - b.min()) / sizes[1]
    shape = region["shape"]
    shape["center"] = [(shape["center"][0] - a.min()) / sizes[0],
                       (shape["center"][1] - b.min()) / sizes[1]]
    shape["radii"] = [radius / size for radius, size in zip(shape["radii"], sizes)]

    path = os.path.join(os.path.dirname(source.FileName[0]), "histogram.txt")
    shown = numpy.loadtxt(path).reshape(-1, 2)
    bins = len(shown)
    edges = numpy.linspace(c.min(), c.max(), bins + 1)
    assert numpy.allclose(shown[:, 0], (edges[:-1] + edges[1:]) / 2)

    def count(weight):
        return numpy.histogram(c, edges, weights=weight)[0]

    exact = count(falloff_weights(region, x, y))
    near = [falloff_weights(region, x + i, y + j) for i in OFFSETS for j in OFFSETS]
    low, high = count(numpy.min(near, axis=0)), count(numpy.max(near, axis=0))
    report = "%s %s: %.1f voxels shown, %.1f by brute force, bounds %.1f and %.1f, largest " \
        "difference in a bin %.2f of %.1f" % (
            region["falloff"]["type"], bins, shown[:, 1].sum(), exact.sum(), low.sum(), high.sum(),
            numpy.abs(shown[:, 1] - exact).max(), exact.max())
    os.write(1, (report + "\n").encode())
    assert exact.sum() > 300, "the region is nearly empty"
    assert (shown[:, 1] >= low - 1e-6).all() and (shown[:, 1] <= high + 1e-6).all(), "bounds"
    assert abs(shown[:, 1].sum() - exact.sum()) < 0.01 * exact.sum(), "sum"
    assert numpy.abs(shown[:, 1] - exact).sum() < 0.05 * exact.sum(), "bins"
    state = json.loads(display.TransferFunction)
    state["regions"][0]["name"] = "same"
    display.TransferFunction = json.dumps(state)


try:
    main()
except Exception:
    # The shell keeps its output to itself.
    os.write(2, traceback.format_exc().encode())
    raise
