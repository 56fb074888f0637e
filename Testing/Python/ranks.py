# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
"""The same pictures on one, two and four processes: blending along rays and on a slice, all ways of
shading, cropping; hard edges in a noisy volume, two regions with tertiary functions.

    pvpython ranks.py MPIRUN PVBATCH

runs itself by pvbatch with the arguments --write FOLDER. Without FXAA, by which ParaView smooths
the edges of a picture of one process only.
"""
import os
import sys
import tempfile

import pictures
import scripttest

RANKS = (1, 2, 4)
MEAN = 0.1  # tolerance of the mean difference, of 255
# A ray is sampled once more where two pieces meet: with hard edges in noise, single pixels see it.
CLOSE, SHARE = 3, 0.995
MODES = {
    "plain": {},
    "shaded": {"Shade": 1},
    "by opacity": {"Shade": 1, "ShadeByOpacity": 1},
    "slice": {"RayBlending": "Slice"},
    "cropped": {"UseCropping": 1, "CroppingOrigin": [10, 8, 5], "CroppingScale": [20, 33, 20]},
}


def write(folder):
    """One picture per mode by this process and those beside it."""
    from paraview import simple

    scripttest.load_plugin(vars(simple))
    import tfc

    phantom = simple.MaterialPhantom(Dimensions=[48, 56, 40])
    source = simple.VolumeGradientMagnitude(Input=phantom, InputArray=["POINTS", "intensity"])
    source = simple.Calculator(Input=source, ResultArrayName="X", Function="coordsX")
    tf = tfc.TransferFunction("intensity", "intensity_gradient", primary_range=(-0.5, 1.5),
                              secondary_range=(0, 0.6))
    tf.add_rectangle((0.75, 0.15), (0.3, 0.12), color="orange", opacity=0.6).tertiary(
        "X", [(0, 1), (30, 1), (30.01, 0)])
    tf.add_ellipse((0.3, 0.25), (0.25, 0.2), color="deepskyblue", opacity=0.3).tertiary(
        "X", [(15, 0), (40, 1)])
    view = pictures.make_view()
    view.UseFXAA = 0
    display = tfc.show(source, tf, view, unit_distance=1.0)
    # Numbers, as bounds that a script reads may be those of its own process.
    camera = view.GetActiveCamera()
    camera.SetFocalPoint(23.5, 27.5, 19.5)
    camera.SetPosition(95, 70, 120)
    camera.SetViewUp(0, 1, 0)
    display.SlicePlane.Origin = [23.5, 27.5, 19.5]
    display.SlicePlane.Normal = [0.2, 0.3, 1]
    for name, settings in MODES.items():
        before = {key: getattr(display, key) for key in settings}
        for key, value in settings.items():
            setattr(display, key, value)
        simple.SaveScreenshot(os.path.join(folder, name + ".png"), view,
                              ImageResolution=list(pictures.SIZE))
        for key, value in before.items():
            setattr(display, key, value)


def main():
    if sys.argv[1] == "--write":
        write(sys.argv[2])
        return
    launcher, program = sys.argv[1:]
    found = {}
    with tempfile.TemporaryDirectory() as parent:
        for ranks in RANKS:
            folder = os.path.join(parent, str(ranks))
            os.mkdir(folder)
            scripttest.run_on_ranks(ranks, launcher, program, __file__, folder)
            found[ranks] = {name: pictures.read(os.path.join(folder, name + ".png"))
                            for name in MODES}
    for name, one in found[1].items():
        scripttest.check((one.max(axis=2) > 30).mean() > 0.02, name + ": something is visible")
        scripttest.check(name == "plain" or pictures.difference(one, found[1]["plain"]) > 0.3,
                         name + " is a picture of its own")
        for ranks in RANKS[1:]:
            mean = pictures.difference(one, found[ranks][name])
            close = float((abs(one - found[ranks][name]).max(axis=2) <= CLOSE).mean())
            scripttest.check(mean <= MEAN and close >= SHARE,
                             "%s, %d processes: mean difference %.3f of 255, %.2f %% within %d"
                             % (name, ranks, mean, 100 * close, CLOSE))


main()
