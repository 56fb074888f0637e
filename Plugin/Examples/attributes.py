# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
"""All attributes of a volume as pictures of one slice, and which of them to combine.

    pvpython attributes.py OUTPUT_DIR VOLUME [ARRAY] [--axis x|y|z] [--at 0.5] [--radius 15]
                           [--sizes 3 25] [--eta 1]

VOLUME is anything that ParaView opens as an image, or a .inv3 file of InVesalius; ARRAY is by
default its first point array. Writes ARRAY_<attribute>.png and prints the ranking for the axes
intensity and gradient magnitude.
"""

import argparse
import os
import sys
import tempfile

from paraview import simple

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


def compute(source, array, radius, eta, sizes):
    """The source with every attribute of the array."""
    return tfc.attributes(
        source, array, ["gradient", "statistics", "occlusion", "size"],
        occlusion={"Radius": radius, "BoundaryParameter": eta},
        size={"SmallestSize": sizes[0], "LargestSize": sizes[1]})


def save_slice(volume, name, palette, axis, at, path, pixels=(480, 400)):
    """Picture of one slice, coloured by an array between its 0.5 and 99.5 percent quantiles."""
    view = simple.CreateView("RenderView")
    view.ViewSize = list(pixels)
    view.OrientationAxesVisibility = 0
    view.Background = [1, 1, 1]
    view.UseColorPaletteForBackground = 0
    view.InteractionMode = "2D"
    display = simple.Show(volume, view)
    display.Representation = "Slice"
    direction = {"x": "YZ Plane", "y": "XZ Plane", "z": "XY Plane"}[axis]
    display.SliceMode = direction
    extent = volume.GetDataInformation().GetExtent()
    low, high = extent["xyz".index(axis) * 2], extent["xyz".index(axis) * 2 + 1]
    display.Slice = int(low + at * (high - low))
    simple.ColorBy(display, ("POINTS", name))
    table = simple.GetColorTransferFunction(name)
    table.ApplyPreset(palette, True)
    bar = simple.GetScalarBar(table, view)
    bar.Title, bar.ComponentTitle = name, ""
    bar.TitleColor = bar.LabelColor = [0, 0, 0]
    display.SetScalarBarVisibility(view, True)
    camera = view.GetActiveCamera()
    simple.ResetCamera(view)
    center = view.CenterOfRotation
    along = {"x": (1, 0, 0), "y": (0, -1, 0), "z": (0, 0, 1)}[axis]
    up = (0, 1, 0) if axis == "z" else (0, 0, 1)
    camera.SetFocalPoint(center)
    camera.SetPosition([c + 1000 * a for c, a in zip(center, along)])
    camera.SetViewUp(up)
    simple.ResetCamera(view)
    camera.SetParallelScale(camera.GetParallelScale() * 0.72)
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
    options = parser.parse_args()
    os.makedirs(options.output, exist_ok=True)
    source = read(options.volume)
    array = options.array or source.PointData.keys()[0]
    volume = compute(source, array, options.radius, options.eta, options.sizes)
    names = {attribute: array + ("_" + attribute if attribute else "") for attribute in MAPS}
    for attribute, name in names.items():
        path = os.path.join(options.output, name + ".png")
        save_slice(volume, name, MAPS[attribute], options.axis, options.at, path)
        print(path)
    for row in tfc.score(volume, array, names["gradient"], arrays=list(names.values())):
        print("%d  %-24s score %7.4f  correlation %7.4f  entropy %6.4f" % (
            row.rank, row.attribute, row.score, row.correlation, row.entropy))


if __name__ == "__main__":
    main()
