# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
"""Skull, skin and brain of a CT head: a 2D transfer function and the combination with occlusion.

    pvpython ct_head.py OUTPUT_DIR [VOLUME.inv3]

In a CT, skin, muscle and brain have nearly the same intensity and gradient magnitude, so that no
region of the 2D domain separates them. What surrounds them differs: air around the skin, bone
around the brain. That is what the occlusion metric measures, and as tertiary attribute it tells
them apart inside the same 2D region. Without VOLUME the CT head of Debian's package
invesalius-examples is read.
"""

import os
import sys

import tfc

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import invesalius  # noqa: E402

# Radius: scalp and skull are 5 to 20 mm thick. 15 voxels (14 mm within a slice, 22 mm across) reach
# from the scalp into the air, but not far from the brain through the skull. The paper's 40 would
# reach from most of the brain out of the head: of the radii from 8 to 40, 15 separates scalp and
# brain best.
RADIUS = 15
# The boundary factor pulls the mean towards 0 where the gradient is large. That presumes that 0 is
# empty, but 0 HU is water: with the default of 0.005 the surface of the skin would get about the
# occlusion of the brain, and the noise of the scan would show. 1 leaves the plain mean.
BOUNDARY_PARAMETER = 1.0

HU_RANGE = (-1024, 3000)
GRADIENT_RANGE = (0, 1400)

SKULL = (0.94, 0.91, 0.82)
SKIN = (0.87, 0.55, 0.38)
BRAIN = (0.78, 0.18, 0.24)


def add_skull(tf):
    """Bone, and its boundary, where partial volumes lower the intensity."""
    return tf.add_polygon(
        [(230, 0), (3000, 0), (3000, 1400), (600, 1400), (150, 300), (150, 130)],
        name="skull", color=SKULL, opacity=0.9, falloff="smooth", width=0.05)


def add_skin_surface(tf):
    """Between air and soft tissue."""
    return tf.add_polygon(
        [(-400, 120), (-400, 700), (-100, 700), (-20, 120)],
        name="skin surface", color=SKIN, opacity=0.25, falloff="smooth", width=0.2)


def add_brain(tf):
    """Soft tissue with a small gradient, up to the noise of the scan."""
    return tf.add_rectangle((28, 32), (42, 40),
                            name="brain", color=BRAIN, opacity=0.6, falloff="smooth", width=0.5)


def transfer_function_2d():
    """The best that the two axes allow: the arch between air and tissue for the skin, soft tissue
    with a small gradient for the brain. Muscle and scalp count as brain, every cavity as skin, and
    the head holder as skull.
    """
    tf = tfc.TransferFunction("HU", "HU_gradient", HU_RANGE, GRADIENT_RANGE)
    add_skull(tf)
    add_skin_surface(tf)
    add_brain(tf)
    return tf


def transfer_function_combined():
    """The same 2D regions, each with a function of the occlusion, in HU, as tertiary attribute.
    With it the skin can have all of its tissue, in a 2D region that covers the brain's.
    """
    tf = tfc.TransferFunction("HU", "HU_gradient", HU_RANGE, GRADIENT_RANGE)
    # The head holder is as dense as bone, its padding as the skin, but there is only air around.
    add_skull(tf).tertiary("HU_occlusion", [(-480, 0), (-400, 1)], range=HU_RANGE)
    add_skin_surface(tf).tertiary("HU_occlusion", [(-650, 0), (-600, 1)], range=HU_RANGE)
    skin = tf.add_polygon([(-150, 0), (-150, 500), (150, 300), (150, 0)],
                          name="skin", color=SKIN, opacity=0.25, falloff="smooth", width=0.1)
    skin.tertiary("HU_occlusion", [(-650, 0), (-600, 1), (-110, 1), (-70, 0)], range=HU_RANGE)
    add_brain(tf).tertiary("HU_occlusion", [(-70, 0), (-40, 1)], range=HU_RANGE)
    return tf


def print_scores(rows):
    """The score table, aligned."""
    width = max(len("attribute"), *(len(row.attribute) for row in rows))
    print(f"{'rank':>4}  {'attribute':<{width}}  {'correlation':>11}  {'entropy':>7}  {'score':>7}")
    for row in rows:
        if row.rank:
            values = f"{row.correlation:11.4f}  {row.entropy:7.3f}  {row.score:7.4f}"
        else:
            values = f"{'':11}  {row.entropy:7.3f}"
        print(f"{row.rank or '-':>4}  {row.attribute:<{width}}  {values}".rstrip())


def make_pipeline(path):
    """Reader, gradient magnitude and occlusion of a volume with the point array HU."""
    from paraview import simple

    tfc.load_plugin()
    reader = simple.OpenDataFile(path)
    simple.RenameSource("CT head", reader)
    gradient = simple.VolumeGradientMagnitude(
        registrationName="Gradient", Input=reader, InputArray=["POINTS", "HU"])
    return simple.VolumeOcclusion(
        registrationName="Occlusion", Input=gradient, InputArray=["POINTS", "HU"],
        Radius=RADIUS, BoundaryParameter=BOUNDARY_PARAMETER)


def make_view(size):
    """The head from its front left and above."""
    from paraview import simple

    view = simple.CreateRenderView(ViewSize=list(size))
    # The GUI shows what is in a layout when it loads the state.
    simple.AssignViewToLayout(view, simple.CreateLayout("Layout"))
    view.UseColorPaletteForBackground = 0
    view.Background = [0.06, 0.07, 0.09]
    view.OrientationAxesVisibility = 0
    view.CameraFocalPoint = [122, 112, 72]
    view.CameraPosition = [122 + 330, 112 + 400, 72 + 270]
    view.CameraViewUp = [0, 0, 1]
    view.CameraViewAngle = 25
    return view


def cut_away(display):
    """Remove the octant that faces the camera: above the orbits, in front, on one side."""
    box = (122.0, 244.0, 108.0, 244.0, 80.0, 161.0)
    bounds = display.Input.GetDataInformation().GetBounds()
    display.UseCropping = 1
    # Cropping is a box relative to that of the data: scale about its corner, then shift.
    display.CroppingOrigin = [box[2 * i] - bounds[2 * i] for i in range(3)]
    display.CroppingScale = [
        (box[2 * i + 1] - box[2 * i]) / (bounds[2 * i + 1] - bounds[2 * i]) for i in range(3)]
    # Of the 27 parts around the box, all but its inside, which is bit 13.
    display.CroppingRegionFlags = 2**27 - 1 - 2**13


def main(folder, volume=invesalius.CT_HEAD, size=(1000, 900)):
    from paraview import simple

    os.makedirs(folder, exist_ok=True)
    file = lambda name: os.path.join(os.path.abspath(folder), name)
    print(f"-- reading {volume}", flush=True)
    voxels, spacing = invesalius.read(volume)
    invesalius.write_vti(file("ct_head.vti"), voxels, spacing, "HU")

    source = make_pipeline(file("ct_head.vti"))
    size_text = " x ".join(str(n) for n in voxels.shape[::-1])
    print(f"-- computing gradient magnitude and occlusion of {size_text} voxels", flush=True)
    source.UpdatePipeline()
    print("-- which attribute to combine with HU (rank 1 is best):", flush=True)
    print_scores(tfc.score(source, primary="HU"))

    view = make_view(size)
    for name, tf in (("ct_head_2d", transfer_function_2d()),
                     ("ct_head_combined", transfer_function_combined())):
        print(f"-- rendering {file(name + '.png')}", flush=True)
        tf.save(file(name + ".tfc.json"))
        display = tfc.show(source, tf, view, unit_distance=1.0, shade=True)
        display.Ambient = 0.25
        display.Diffuse = 0.85
        cut_away(display)
        simple.SaveScreenshot(file(name + ".png"), view, ImageResolution=list(size))
    simple.SaveState(file("ct_head.pvsm"))


if __name__ == "__main__":
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    main(*sys.argv[1:])
