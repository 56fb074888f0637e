# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
"""Frames of the volume mapper against VTK's own GPU mapper, as ratios of medians.

usage: pvpython volume.py PEERS_PROGRAM [--repeats N] [--only "A;B"] [--output FILE]

The peer draws the same volume with a 2D transfer function over the same two attributes that covers
the same voxels, in the same window, with the same camera and step; it knows no tertiary attribute.
Both go once around the volume, a frame of one after a frame of the other. 512 x 512 pixels, one
voxel between samples, no jittering. The last rows compare frames after an edit with plain frames.
What an edit costs beside its frame is measured in a small window on 512^3 voxels: bricks found
anew, tables and bricks uploaded. That takes about 10 GB of memory.
"""
import argparse
import json
import sys
import time

import numpy as np
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
import vtkmodules.vtkRenderingVolumeOpenGL2  # noqa: F401
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkRenderingCore import vtkRenderer, vtkRenderWindow, vtkVolume
from vtkmodules.vtkRenderingVolume import vtkGPUVolumeRayCastMapper

from benchmarking import median, processor, timed, write_section
from tfc.vtk.vtkTFCTransferFunction import vtkTFCClassify, vtkTFCTransferFunction
from tfc.vtk.vtkTFCVolume import vtkTFCVolumeMapper


def attributes(size):
    """An image with four smooth float attributes a, b, c, d in [0, 1]."""
    z, y, x = np.mgrid[0:size, 0:size, 0:size].astype(np.float32) / size
    fields = {"a": np.sin(7 * x + 3 * y) + z, "b": np.cos(5 * y - 4 * z) + x,
              "c": x + y + z, "d": np.sin(9 * z * x)}
    image = vtkImageData()
    image.SetDimensions(size, size, size)
    for name, field in fields.items():
        values = (field - field.min()) / (field.max() - field.min())
        array = numpy_to_vtk(values.astype(np.float32).ravel(), deep=1)
        array.SetName(name)
        image.GetPointData().AddArray(array)
    image.GetPointData().SetActiveScalars("a")
    return image


def state(regions):
    """JSON of a transfer function over a and b."""
    axes = {name: {"array": array, "range": [0, 1]}
            for name, array in (("primary", "a"), ("secondary", "b"))}
    return json.dumps({"format": "transfer-function-combination", "version": 1,
                       "regions": regions, **axes})


def ellipse(number, center, radii, opacity, tertiary=None, function=None):
    region = {"id": number, "opacity": opacity,
              "shape": {"type": "ellipse", "center": center, "radii": radii}}
    if tertiary:
        region["tertiary"] = {"array": tertiary, "opacity": function}
    return region


ONE = [{"id": 1, "opacity": 0.01,
        "shape": {"type": "rectangle", "center": [0.5, 0.5], "halfsize": [0.35, 0.35]}}]
EIGHT = [ellipse(i + 1, [0.2 + 0.2 * (i % 4), 0.3 + 0.4 * (i // 4)], [0.15, 0.25], 0.01,
                 "cd"[i % 2], [[0.1, 0], [0.3, 1], [0.9, 1]]) for i in range(8)]
SPARSE = [ellipse(i + 1, [0.2 + 0.2 * (i % 4), 0.3 + 0.4 * (i // 4)], [0.02, 0.05], 0.05,
                  "cd"[i % 2], [[0.4, 0], [0.5, 1], [0.7, 1], [0.75, 0]]) for i in range(8)]
OVERLAPPING = [ellipse(i + 1, [0.5 + 0.01 * (i % 8), 0.5 + 0.01 * (i // 8)], [0.3, 0.3], 0.001)
               for i in range(32)]
MIXED = [dict(region) for region in EIGHT]
MIXED[0] = dict(EIGHT[0], shape={"type": "polygon", "points": [
    [0.1, 0.1], [0.3, 0.05], [0.35, 0.4], [0.22, 0.3], [0.12, 0.5]]})

# name, regions, shaded, largest ratio to the peer
FRAMES = [
    ("one region", ONE, False, 0.6),
    ("8 regions, 2 tertiaries", EIGHT, False, 1.0),
    ("8 regions, sparse", SPARSE, False, 0.25),
    ("32 overlapping regions", OVERLAPPING, False, 1.6),
    ("8 regions, shaded", EIGHT, True, 1.0),
    ("8 regions, one a polygon", MIXED, False, None),
]


def dragged(step):
    """EIGHT with its first region moved."""
    center = [0.2 + 0.002 * (step + 1), 0.3]
    return [dict(EIGHT[0], shape={"type": "ellipse", "center": center, "radii": [0.15, 0.25]})
            ] + EIGHT[1:]


def switched(step):
    """EIGHT with the tertiary attribute of its first region exchanged."""
    return [dict(EIGHT[0], tertiary=dict(EIGHT[0]["tertiary"], array="dc"[step % 2]))] + EIGHT[1:]


EDITS = [("region dragged", dragged, 1.15), ("tertiary switched", switched, 1.15)]


class Bench:
    """Our mapper and the peer's in one window, one of them visible."""

    def __init__(self, size, pixels):
        self.image = attributes(size)
        self.window = vtkRenderWindow()
        self.window.SetOffScreenRendering(1)
        self.window.SetSize(pixels, pixels)
        self.window.SetMultiSamples(0)
        self.renderer = vtkRenderer()
        self.window.AddRenderer(self.renderer)
        self.model = vtkTFCTransferFunction()
        self.mapper = vtkTFCVolumeMapper()
        self.mapper.SetTransferFunction(self.model)
        self.mapper.SetSampleDistance(1.0)
        self.peer = vtkGPUVolumeRayCastMapper()
        self.peer.SetTransfer2DYAxisArray("b")
        self.peer.AutoAdjustSampleDistancesOff()
        self.peer.SetSampleDistance(1.0)
        self.peer.UseJitteringOff()
        self.volumes = []
        for mapper in (self.mapper, self.peer):
            mapper.SetInputData(self.image)
            volume = vtkVolume()
            volume.SetMapper(mapper)
            volume.GetProperty().SetInterpolationTypeToLinear()
            self.volumes.append(volume)
            self.renderer.AddVolume(volume)
        self.volumes[1].GetProperty().SetTransferFunctionMode(1)
        self.renderer.ResetCamera()

    def set_regions(self, regions):
        if not self.model.SetState(state(regions)):
            sys.exit(self.model.GetLastError())

    def set_peer(self, regions):
        """Give the peer the regions without their tertiary functions, in 512 x 512 texels."""
        plane = vtkImageData()
        plane.SetDimensions(512, 512, 1)
        y, x = np.mgrid[0:512, 0:512].astype(np.float32) / 511
        for name, values in (("a", x), ("b", y)):
            array = numpy_to_vtk(values.ravel(), deep=1)
            array.SetName(name)
            plane.GetPointData().AddArray(array)
        classify = vtkTFCClassify()
        classify.SetInputData(plane)
        classify.SetTransferFunction(state([{k: v for k, v in r.items() if k != "tertiary"}
                                            for r in regions]))
        classify.Update()
        rgba = vtk_to_numpy(classify.GetOutput().GetPointData().GetArray("tfc_rgba"))
        colors = vtkImageData()
        colors.SetDimensions(512, 512, 1)
        texels = rgba.astype(np.float32) / (255 if rgba.dtype == np.uint8 else 1)
        colors.GetPointData().SetScalars(numpy_to_vtk(texels, deep=1))
        self.volumes[1].GetProperty().SetTransferFunction2D(colors)

    def visible(self):
        """Share of the voxels that the model shows."""
        classify = vtkTFCClassify()
        classify.SetInputData(self.image)
        classify.SetTransferFunction(self.model.GetState())
        classify.Update()
        opacity = vtk_to_numpy(classify.GetOutput().GetPointData().GetArray("tfc_opacity"))
        return np.count_nonzero(opacity) / opacity.size

    def frame(self, which):
        """Seconds for a frame of our volume (0) or the peer's (1)."""
        for index, volume in enumerate(self.volumes):
            volume.SetVisibility(index == which)
        return timed(self.render)

    def render(self):
        self.window.Render()
        self.window.WaitForCompletion()

    def turn(self, repeats):
        self.renderer.GetActiveCamera().Azimuth(360 / repeats)
        self.renderer.ResetCameraClippingRange()


def measure_frames(bench, regions, shaded, repeats):
    """Medians of our frames and of the peer's, in turns around the volume."""
    bench.set_regions(regions)
    bench.set_peer(regions)
    for which, volume in enumerate(bench.volumes):
        volume.GetProperty().SetShade(shaded)
        bench.frame(which)
    mine, other = [], []
    for _ in range(repeats):
        bench.turn(repeats)
        mine.append(bench.frame(0))
        other.append(bench.frame(1))
    return median(mine), median(other)


def measure_edits(bench, edit, repeats):
    """Medians of frames after an edit, new state to finished picture, and of plain frames."""
    bench.volumes[0].GetProperty().SetShade(False)
    bench.set_regions(edit(0))
    bench.frame(0)
    uploads = bench.mapper.GetNumberOfVolumeUploads()
    edited, plain = [], []
    for step in range(repeats):
        bench.turn(repeats)
        plain.append(bench.frame(0))
        edited.append(timed(lambda: bench.set_regions(edit(step + 1))) + bench.frame(0))
    if bench.mapper.GetNumberOfVolumeUploads() != uploads:
        sys.exit("an edit uploaded the volume")
    return median(edited), median(plain)


def measure_large_edit(size, repeats):
    """Seconds that an edit adds to a frame: the median difference of short ones in turns."""
    bench = Bench(size, 32)
    bench.set_regions(dragged(0))
    bench.frame(0)
    differences = []
    for step in range(5 * repeats):
        plain = bench.frame(0)
        edited = timed(lambda: bench.set_regions(dragged(step % 20 + 1))) + bench.frame(0)
        differences.append(edited - plain)
    return median(differences)


def format_line(name, result, limit):
    mine, other, visible = result
    return "| %s | %s | %.0f | %.0f | **%.2f** | %s |" % (
        name, "%.1f %%" % (100 * visible) if visible is not None else "", 1e3 * mine, 1e3 * other,
        mine / other, limit or "")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("peers")
    parser.add_argument("--repeats", type=int, default=9)
    parser.add_argument("--only", default="")
    parser.add_argument("--output", default="")
    parser.add_argument("--size", type=int, default=256)
    parser.add_argument("--large", type=int, default=512)
    parser.add_argument("--pixels", type=int, default=512)
    options = parser.parse_args()
    only = [name for name in options.only.split(";") if name]
    bench = Bench(options.size, options.pixels)
    lines = [
        "%d^3, %d x %d pixels, median of %d frames, %s, %s." % (
            options.size, options.pixels, options.pixels, options.repeats, processor(),
            time.strftime("%Y-%m-%d")), "",
        "| case | voxels visible | ms | peer, or plain frame, ms | ratio | at most |",
        "| --- | ---: | ---: | ---: | ---: | ---: |"]
    failed = []
    for name, regions, shaded, limit in FRAMES:
        if not only or name in only:
            result = measure_frames(bench, regions, shaded, options.repeats)
            visible = bench.visible() if not only else None
            lines.append(format_line(name, (*result, visible), limit))
            print(lines[-1], flush=True)
            failed += [name] if limit and result[0] > limit * result[1] else []
    for name, edit, limit in EDITS:
        if not only or name in only:
            result = measure_edits(bench, edit, options.repeats)
            lines.append(format_line(name, (*result, None), limit))
            print(lines[-1], flush=True)
            failed += [name] if result[0] > limit * result[1] else []
    bench.set_regions(ONE)
    bench.frame(0)  # a window that has drawn nothing knows no driver
    lines.insert(1, bench.window.ReportCapabilities().split("OpenGL renderer string:")[1]
                 .split("\n")[0].strip() + ".")
    del bench
    if options.large and (not only or "large edit" in only):
        seconds = measure_large_edit(options.large, options.repeats)
        lines += ["", "A region dragged on %d^3: %.1f ms beside the frame." % (
            options.large, 1e3 * seconds)]
        print(lines[-1], flush=True)
    if options.output:
        write_section(options.output, "volume", "\n".join(lines) + "\n")
    for name in failed:
        print("above the limit: " + name)
    sys.exit(1 if failed else 0)


main()
