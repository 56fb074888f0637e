# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
"""Any volume with any transfer function state.

    pvpython render_volume.py VOLUME STATE.tfc.json OUTPUT_DIR [--radius N] [--eta X]

Renders VOLUME, an image in any format that ParaView opens, into OUTPUT_DIR/<its name>.png and
leaves a .pvsm state beside it. Arrays of the state that are called <array>_gradient or
<array>_occlusion and are not in the file are computed from <array>; --radius (in voxels, 40 by
default) and --eta (0.005) are the parameters of the occlusion, which must be those that the state
was made for.
"""

import argparse
import os
import sys

import tfc
from tfc.display import find_array


class Problem(Exception):
    """Something that the user can put right."""


def attributes(tf):
    """Names of the arrays that a transfer function uses, without repetition."""
    used = [tf.primary, tf.secondary]
    used += [region.tertiary_state for region in tf.regions if region.tertiary_state]
    return list(dict.fromkeys(attribute["array"] for attribute in used))


def has_array(source, name):
    try:
        find_array(source, name)
    except KeyError:
        return False
    return True


def add_computed(source, names, radius, eta):
    """A pipeline that ends with all named arrays. Raises Problem with those that remain missing."""
    from paraview import simple

    source.UpdatePipeline()
    missing = [name for name in names if not has_array(source, name)]
    unknown = []
    end = source
    for name in missing:
        base, _, kind = name.rpartition("_")
        if kind not in ("gradient", "occlusion") or not has_array(source, base):
            unknown.append(name)
            continue
        in_cells = source.CellData.GetArray(base) and not source.PointData.GetArray(base)
        choice = ["CELLS" if in_cells else "POINTS", base]
        if kind == "gradient":
            print(f"-- computing {name}", flush=True)
            end = simple.VolumeGradientMagnitude(Input=end, InputArray=choice)
        else:
            print(f"-- computing {name} with radius {radius} and eta {eta:g}", flush=True)
            end = simple.VolumeOcclusion(
                Input=end, InputArray=choice, Radius=radius, BoundaryParameter=eta)
    if unknown:
        there = list(source.PointData.keys()) + list(source.CellData.keys())
        raise Problem(
            f"the state uses {', '.join(unknown)}, which the volume does not have; "
            f"its arrays are: {', '.join(there) or 'none'}")
    end.UpdatePipeline()
    return end


def open_volume(path):
    """A reader for a volume. Raises Problem when there is none or it reads something else."""
    from paraview import simple

    if not os.path.isfile(path):
        raise Problem(f"{path}: no such file")
    # Not only an absent reader raises: some fail while they look at the file.
    try:
        source = simple.OpenDataFile(os.path.abspath(path))
    except Exception as error:
        raise Problem(f"{path}: ParaView cannot open it: {error}") from None
    if source is None:
        raise Problem(f"{path}: ParaView has no reader for it")
    simple.RenameSource(os.path.basename(path), source)
    source.UpdatePipeline()
    kind = source.GetDataInformation().GetDataSetTypeAsString()
    if kind not in ("vtkImageData", "vtkUniformGrid", "vtkStructuredPoints"):
        raise Problem(
            f"{path}: this is a {kind}, not an image; the filter Resample To Image makes one")
    return source


def main(volume, state, folder, radius=40, eta=0.005, size=(1000, 900)):
    from paraview import simple

    tfc.load_plugin()
    try:
        tf = tfc.load(state)
    except (OSError, ValueError) as error:
        raise Problem(str(error)) from None
    print(f"-- reading {volume}", flush=True)
    source = add_computed(open_volume(volume), attributes(tf), radius, eta)

    view = simple.CreateRenderView(ViewSize=list(size))
    # The GUI shows what is in a layout when it loads the state.
    simple.AssignViewToLayout(view, simple.CreateLayout("Layout"))
    view.UseColorPaletteForBackground = 0
    view.Background = [0.06, 0.07, 0.09]
    view.OrientationAxesVisibility = 0
    try:
        display = tfc.show(source, tf, view, shade=True)
    except KeyError as error:
        raise Problem(f"{volume}: {error.args[0]}") from None
    display.Ambient = 0.25
    display.Diffuse = 0.85
    view.CameraPosition = [1, 1.2, 0.8]
    view.CameraFocalPoint = [0, 0, 0]
    view.CameraViewUp = [0, 0, 1]
    view.ResetCamera(True)

    os.makedirs(folder, exist_ok=True)
    stem = os.path.splitext(os.path.basename(volume))[0]
    picture = os.path.join(os.path.abspath(folder), stem + ".png")
    print(f"-- rendering {picture}", flush=True)
    simple.SaveScreenshot(picture, view, ImageResolution=list(size))
    simple.SaveState(os.path.join(os.path.abspath(folder), stem + ".pvsm"))


def parse(arguments):
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("volume", metavar="VOLUME")
    parser.add_argument("state", metavar="STATE.tfc.json")
    parser.add_argument("folder", metavar="OUTPUT_DIR")
    parser.add_argument("--radius", type=int, default=40)
    parser.add_argument("--eta", type=float, default=0.005)
    return parser.parse_args(arguments)


if __name__ == "__main__":
    try:
        main(**vars(parse(sys.argv[1:])))
    except Problem as problem:
        sys.exit(f"render_volume.py: {problem}")
