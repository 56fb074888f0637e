# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
"""Hurricane Isabel by pressure and temperature, with water vapour as tertiary attribute.

    pvpython isabel.py FOLDER isabel.png
    mpirun -np 2 pvbatch isabel.py FOLDER isabel.png

The paper's Figure 6 from the files of the IEEE Visualization 2004 contest
(http://vis.computer.org/vis2004contest/data.html): FOLDER holds Pf30.bin, TCf30.bin and
QVAPORf30.bin, or the same gzip'd as the contest distributes them (Pf30.bin.gz, ...). Each is
500 x 500 x 100 big-endian 4-byte floats, x fastest, in which 1e35 stands for no data (land).

The contest's ranges: P, the pressure perturbation, -5471 to 3226 Pa; TC, -83 to 31 degrees
Celsius; QVAPOR, 0 to 0.024 kg/kg. The grid covers x from -83 to -62 degrees of longitude and y
from 23.7 to 41.7 degrees of latitude, about 2139 km x 2004 km, and z from 0.035 to 19.835 km.
Coordinates of the picture are in kilometres, z exaggerated 20 times (--z-scale).

The regions were set from these ranges and from how pressure, temperature and vapour relate in a
hurricane; the state is also in isabel.tfc.json, to be edited and given with --state.
"""

import argparse
import gzip
import os
import sys

import numpy as np

import tfc

VARIABLES = ("P", "TC", "QVAPOR")
DIMENSIONS = (500, 500, 100)
EXTENT_KM = (2139.0, 2004.0, 19.8)
NO_DATA = 1e35

# What ParaView runs in each process of its server: the grid, then this process's part of it.
INFORMATION_SCRIPT = """
import runpy
runpy.run_path({script!r})["announce"](self, {dimensions!r}, {z_scale!r})
"""
DATA_SCRIPT = """
import runpy
runpy.run_path({script!r})["produce"](self, {paths!r}, {dimensions!r}, {z_scale!r})
"""


def make_transfer_function():
    """Eye red, outer bands blue, spiral bands yellow and green: all in Pa, degC and kg/kg."""
    tf = tfc.TransferFunction("P", "TC", primary_range=(-5500, 3300), secondary_range=(-85, 32))

    # The warm core: pressure far below its surroundings, from the sea to the middle levels.
    eye = tf.add_polygon(
        [(-5480, 12), (-5480, 31), (-1500, 31), (-1100, 14), (-1100, -4), (-1800, -4)],
        name="eye", color="crimson", opacity=0.5, falloff="smooth", width=0.3)
    eye.tertiary("QVAPOR", [(0.003, 0), (0.005, 1), (0.024, 1)], range=(0, 0.0245))

    # Low levels around it: warm, and only where the air is nearly saturated.
    inner = tf.add_polygon(
        [(-1900, 19), (-1900, 31), (-350, 31), (-350, 17)],
        name="inner spiral bands", color="gold", opacity=0.6, falloff="smooth", width=0.5)
    inner.tertiary("QVAPOR", [(0.0155, 0), (0.018, 1), (0.024, 1)], range=(0, 0.0245))

    outer = tf.add_polygon(
        [(-350, 16), (-350, 31), (500, 31), (500, 16)],
        name="outer spiral bands", color="limegreen", opacity=0.4, falloff="smooth", width=0.5)
    outer.tertiary("QVAPOR", [(0.0165, 0), (0.019, 1), (0.024, 1)], range=(0, 0.0245))

    # Middle levels, colder: the moist air of the bands stands out from the dry air between them.
    bands = tf.add_polygon(
        [(-1100, -14), (-1100, 10), (300, 10), (300, -14)],
        name="outer bands", color="royalblue", opacity=0.25, falloff="smooth", width=0.5)
    bands.tertiary("QVAPOR", [(0.0035, 0), (0.0055, 1), (0.011, 1)], range=(0, 0.0245))
    return tf


def find_file(folder, variable, time):
    """Path of a variable's file in the folder, plain or gzip'd."""
    name = "%sf%02d.bin" % (variable, time)
    for path in (os.path.join(folder, name), os.path.join(folder, name + ".gz")):
        if os.path.isfile(path):
            return os.path.abspath(path)
    raise FileNotFoundError(
        "%s has neither %s nor %s.gz; get them from "
        "http://vis.computer.org/vis2004contest/data.html" % (folder, name, name))


def read_part(path, dimensions, extent):
    """The values of a file within an extent (inclusive, x y z), flat with x fastest; NaN where
    there is no data. A plain file is mapped, so that only the extent is read.
    """
    count = int(np.prod(dimensions))
    if path.endswith(".gz"):
        with gzip.open(path, "rb") as file:
            stored = np.frombuffer(file.read(4 * count + 1), ">u1")
    else:
        stored = np.memmap(path, ">u1", "r")
    if stored.size != 4 * count:
        size = "more" if path.endswith(".gz") and stored.size > 4 * count else stored.size
        raise ValueError("%s: expected %d bytes for %d x %d x %d floats, found %s; "
                         "give the grid with --dims" % ((path, 4 * count) + dimensions + (size,)))
    grid = stored.view(">f4").reshape(dimensions[::-1])
    x0, x1, y0, y1, z0, z1 = extent
    values = grid[z0:z1 + 1, y0:y1 + 1, x0:x1 + 1].astype(np.float32).ravel()
    values[values >= np.float32(NO_DATA)] = np.nan
    return values


def grid_spacing(dimensions, z_scale):
    """Kilometres between points, z exaggerated."""
    lengths = (EXTENT_KM[0], EXTENT_KM[1], EXTENT_KM[2] * z_scale)
    return [length / (n - 1) for length, n in zip(lengths, dimensions)]


def announce(algorithm, dimensions, z_scale):
    """Tell the pipeline about the grid."""
    from vtkmodules.vtkCommonDataModel import vtkDataObject
    from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm, vtkStreamingDemandDrivenPipeline

    info = algorithm.GetOutputInformation(0)
    whole = [0, dimensions[0] - 1, 0, dimensions[1] - 1, 0, dimensions[2] - 1]
    info.Set(vtkStreamingDemandDrivenPipeline.WHOLE_EXTENT(), whole, 6)
    info.Set(vtkDataObject.SPACING(), grid_spacing(dimensions, z_scale), 3)
    info.Set(vtkDataObject.ORIGIN(), [0.0, 0.0, 0.0], 3)
    info.Set(vtkAlgorithm.CAN_PRODUCE_SUB_EXTENT(), 1)


def produce(algorithm, paths, dimensions, z_scale):
    """Give the pipeline the extent that it asks this process for."""
    from vtkmodules.util.numpy_support import numpy_to_vtk
    from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline

    info = algorithm.GetOutputInformation(0)
    extent = [info.Get(vtkStreamingDemandDrivenPipeline.UPDATE_EXTENT(), i) for i in range(6)]
    output = algorithm.GetImageDataOutput()
    output.SetExtent(extent)
    output.SetSpacing(grid_spacing(dimensions, z_scale))
    for variable, path in zip(VARIABLES, paths):
        # VTK keeps a reference to the NumPy array: no second copy.
        array = numpy_to_vtk(read_part(path, dimensions, extent))
        array.SetName(variable)
        output.GetPointData().AddArray(array)


def make_source(folder, dimensions=DIMENSIONS, time=30, z_scale=20.0):
    """A ParaView source with the three variables as point arrays; each process of a parallel run
    reads its own part. With a remote server, this script and the files must be on its machine.
    """
    from paraview import simple

    values = {
        "script": os.path.abspath(__file__),
        "dimensions": tuple(dimensions),
        "z_scale": float(z_scale),
        "paths": [find_file(folder, variable, time) for variable in VARIABLES],
    }
    source = simple.ProgrammableSource(registrationName="Isabel", OutputDataSetType="vtkImageData")
    source.ScriptRequestInformation = INFORMATION_SCRIPT.format(**values)
    source.Script = DATA_SCRIPT.format(**values)
    return source


def make_view(size, z_scale):
    """A view of the whole storm from the south."""
    from paraview import simple

    view = simple.CreateRenderView(ViewSize=list(size))
    view.UseColorPaletteForBackground = 0
    view.Background = [0.05, 0.06, 0.09]
    view.OrientationAxesVisibility = 0
    # Antialiasing of edges works on each rank's picture before they are composited.
    view.UseFXAA = 0
    height = EXTENT_KM[2] * z_scale
    view.CameraFocalPoint = [1070, 1000, 0.4 * height]
    view.CameraPosition = [1070, -1100, 2000 + 0.4 * height]
    view.CameraViewUp = [0, 0.6, 0.8]
    view.CameraViewAngle = 40
    return view


def main(arguments):
    """Make the picture that the command line asks for."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", help="where the contest's files are")
    parser.add_argument("picture", help="PNG file to write")
    parser.add_argument("--dims", nargs=3, type=int, default=DIMENSIONS, metavar="N",
                        help="points along x, y and z (500 500 100)")
    parser.add_argument("--time", type=int, default=30, help="time step, 1 to 48 (30)")
    parser.add_argument("--z-scale", type=float, default=20.0, help="exaggeration of z (20)")
    parser.add_argument("--size", nargs=2, type=int, default=(1000, 750), metavar="N",
                        help="pixels of the picture (1000 750)")
    parser.add_argument("--state", help="transfer function to use instead, a .tfc.json file")
    options = parser.parse_args(arguments)

    from paraview import simple

    tfc.load_plugin()
    source = make_source(options.folder, options.dims, options.time, options.z_scale)
    view = make_view(options.size, options.z_scale)
    tf = tfc.load(options.state) if options.state else make_transfer_function()
    tfc.show(source, tf, view, unit_distance=12.0, shade=True)
    simple.SaveScreenshot(options.picture, view, ImageResolution=list(options.size))


if __name__ == "__main__":
    main(sys.argv[1:])
