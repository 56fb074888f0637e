# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
"""All attributes of a volume as pictures of one slice, and which of them to combine.

    pvpython attributes.py OUTPUT_DIR VOLUME [ARRAY] [--axis x|y|z] [--at 0.5] [--radius 15]
                           [--eta 1] [--sizes 3 25] [--range 150 1500]

VOLUME is anything that ParaView opens as an image, or a .inv3 file of InVesalius; ARRAY is by
default its first point array. --range is the intensity range of the objects whose size is measured,
by default all intensities. Writes ARRAY_<attribute>.png and prints the ranking for the axes
intensity and gradient magnitude.
"""

import argparse
import os
import sys
import tempfile

import numpy as np
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

import tfc

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import invesalius  # noqa: E402

# Attribute -> colour map: grey for intensities, where one knows what to expect, else perceptual.
MAPS = {
    "": "Grayscale", "gradient": "Viridis (matplotlib)", "mean": "Grayscale",
    "stddev": "Viridis (matplotlib)", "radius": "Viridis (matplotlib)", "occlusion": "Grayscale",
    "size": "Inferno (matplotlib)",
}


def read(path):
    """A source for a volume file."""
    if path.endswith(".inv3"):
        voxels, spacing = invesalius.read(path)
        copy = os.path.join(tempfile.mkdtemp(), "volume.vti")
        invesalius.write_vti(copy, voxels, spacing, "HU")
        path = copy
    source = simple.OpenDataFile(path)
    source.UpdatePipeline()
    return source


def compute(source, array, radius, eta, sizes, interval):
    """The source with every attribute of the array."""
    size = {"SmallestSize": sizes[0], "LargestSize": sizes[1]}
    if interval:
        size.update(UseIntensityRange=1, IntensityRange=interval)
    return tfc.attributes(
        source, array, ["gradient", "statistics", "occlusion", "size"],
        occlusion={"Radius": radius, "BoundaryParameter": eta},
        size=size)


def slice_range(volume, name, axis, index):
    """0.5 and 99.5 percent quantiles of an array on one slice."""
    extent = list(volume.GetDataInformation().GetExtent())
    extent[2 * axis:2 * axis + 2] = [index, index]
    subset = simple.ExtractSubset(Input=volume, VOI=extent)
    values = vtk_to_numpy(servermanager.Fetch(subset).GetPointData().GetArray(name)).astype(float)
    simple.Delete(subset)
    low, high = np.percentile(values[np.isfinite(values)], [0.5, 99.5])
    return (low, high) if low < high else (low - 0.5, low + 0.5)


def save_slice(volume, name, palette, axis, at, path, pixels=(360, 300)):
    """Picture of one slice, coloured by an array between two quantiles, with a scalar bar."""
    view = simple.CreateView("RenderView")
    view.ViewSize = list(pixels)
    view.OrientationAxesVisibility = 0
    view.UseColorPaletteForBackground = 0
    view.Background = [1, 1, 1]
    display = simple.Show(volume, view)
    display.Representation = "Slice"
    display.SliceMode = ("YZ Plane", "XZ Plane", "XY Plane")[axis]
    information = volume.GetDataInformation()
    low, high = information.GetExtent()[2 * axis:2 * axis + 2]
    index = int(low + at * (high - low))
    display.Slice = index - low
    simple.ColorBy(display, ("POINTS", name))
    table = simple.GetColorTransferFunction(name)
    table.ApplyPreset(palette, True)
    table.RescaleTransferFunction(*slice_range(volume, name, axis, index))
    bar = simple.GetScalarBar(table, view)
    bar.Title, bar.ComponentTitle = "", ""
    bar.LabelColor = [0, 0, 0]
    bar.LabelFontSize = 12
    bar.RangeLabelFormat = bar.LabelFormat = "%.4g"
    bar.AutomaticLabelFormat = 0
    bar.WindowLocation = "Any Location"
    bar.Position = [1 - 50 / pixels[0], 0.1]
    bar.ScalarBarLength = 0.8
    bar.ScalarBarThickness = 8
    display.SetScalarBarVisibility(view, True)

    # The first rendering resets the camera.
    simple.Render(view)
    # The slice fills the height; the bar stands to its right.
    bounds = information.GetBounds()
    center = [(bounds[2 * a] + bounds[2 * a + 1]) / 2 for a in range(3)]
    right, up = ((1, 2), (0, 2), (0, 1))[axis]
    scale = max((bounds[2 * up + 1] - bounds[2 * up]) / 2,
                (bounds[2 * right + 1] - bounds[2 * right]) / 2 * pixels[1] / (pixels[0] - 60))
    center[right] += 30 * 2 * scale / pixels[1]
    toward = (1, -1, 1)[axis]
    view.CameraParallelProjection = 1
    view.CameraFocalPoint = center
    view.CameraPosition = [c + toward * 1000 * (a == axis) for a, c in enumerate(center)]
    view.CameraViewUp = [float(a == up) for a in range(3)]
    view.CameraParallelScale = scale
    simple.Render(view)
    simple.SaveScreenshot(path, view)
    simple.Delete(view)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("output")
    parser.add_argument("volume")
    parser.add_argument("array", nargs="?")
    parser.add_argument("--axis", choices="xyz", default="z")
    parser.add_argument("--at", type=float, default=0.5)
    parser.add_argument("--radius", type=float, default=15)
    parser.add_argument("--eta", type=float, default=1)
    parser.add_argument("--sizes", type=float, nargs=2, default=(3, 25))
    parser.add_argument("--range", type=float, nargs=2)
    options = parser.parse_args()
    os.makedirs(options.output, exist_ok=True)
    source = read(options.volume)
    array = options.array or source.PointData.keys()[0]
    volume = compute(source, array, options.radius, options.eta, options.sizes, options.range)
    names = {attribute: array + ("_" + attribute if attribute else "") for attribute in MAPS}
    for attribute, name in names.items():
        path = os.path.join(options.output, name + ".png")
        save_slice(volume, name, MAPS[attribute], "xyz".index(options.axis), options.at, path)
        print(path)
    for row in tfc.score(volume, array, names["gradient"], arrays=list(names.values())):
        print("%d  %-24s score %7.4f  correlation %7.4f  entropy %6.4f" % (
            row.rank, row.attribute, row.score, row.correlation, row.entropy))


if __name__ == "__main__":
    main()
