# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
"""A simulated hurricane by pressure and temperature, refined by water vapour in each region.

    pvpython hurricane.py sim_cm1_hurricane.vti hurricane.png
    mpirun -np 2 pvbatch hurricane.py sim_cm1_hurricane.vti hurricane.png

This is the multivariate example of the paper (section 5.5, Figure 6): pressure and temperature span
the 2D domain, where the undisturbed air lies on one curve and the warm core beside it; each region
has a different function of QVAPOR. The input is a vtkImageData with the point arrays P (hPa),
TC (degC) and QVAPOR (g/kg). The state is also in hurricane.tfc.json.
"""

import sys

import tfc


def make_transfer_function():
    tf = tfc.TransferFunction("P", "TC", primary_range=(100, 1000), secondary_range=(-80, 30))

    # At a given pressure the core is 3 to 5 degrees warmer than the air around the storm. Its
    # drier, sinking part is the eye; the moist part of the same region is the eyewall.
    eye = tf.add_polygon(
        [(325, -22.6), (400, -11.8), (480, -3.9), (540, 0.4), (620, 6.2), (690, 11.0), (770, 15.7),
         (770, 19.0), (690, 15.0), (620, 10.5), (540, 5.0), (480, 1.0), (400, -7.0), (325, -17.0)],
        name="warm core", color="crimson", opacity=0.5, falloff="smooth", width=0.5)
    eye.tertiary("QVAPOR", [(0.6, 0), (1.0, 1), (9.5, 1), (13.0, 0)], range=(0, 23))

    # Middle levels on the curve of the surrounding air: there only what is moist belongs to the
    # storm.
    upper = tf.add_polygon(
        [(380, -21), (460, -12), (560, -3), (560, 1.0), (460, -5.6), (380, -13.6)],
        name="upper spiral bands", color="gold", opacity=0.5, falloff="smooth", width=0.6)
    upper.tertiary("QVAPOR", [(3.9, 0), (5.0, 1), (10, 1)], range=(0, 23))

    lower = tf.add_polygon(
        [(560, -3), (640, 3), (720, 8.5), (720, 11.6), (640, 6.8), (560, 1.0)],
        name="lower spiral bands", color="limegreen", opacity=0.5, falloff="smooth", width=0.6)
    lower.tertiary("QVAPOR", [(8.2, 0), (9.2, 1), (14, 1)], range=(0, 23))

    # The moist layer below, far from the core.
    outer = tf.add_polygon(
        [(750, 11), (900, 18.5), (900, 21.6), (750, 14.0)],
        name="outer bands", color="dodgerblue", opacity=0.15, falloff="smooth", width=0.6)
    outer.tertiary("QVAPOR", [(12.5, 0), (14.5, 1), (17.5, 1), (18.5, 0)], range=(0, 23))
    return tf


def main(data, picture, size=(1000, 750)):
    from paraview import simple

    tfc.load_plugin()
    source = simple.OpenDataFile(data)
    view = simple.CreateRenderView(ViewSize=list(size))
    view.UseColorPaletteForBackground = 0
    view.Background = [0.05, 0.06, 0.09]
    view.OrientationAxesVisibility = 0
    # Antialiasing of edges works on each rank's picture before they are composited.
    view.UseFXAA = 0
    display = tfc.show(source, make_transfer_function(), view, unit_distance=6.0, shade=True)
    display.SampleDistance = 0.8  # a quarter of a voxel: the moist layer is thin at this angle
    view.CameraFocalPoint = [245, 228, 30]
    view.CameraPosition = [245, -245, 475]
    view.CameraViewUp = [0, 0.6, 0.8]
    view.CameraViewAngle = 30
    simple.SaveScreenshot(picture, view, ImageResolution=list(size))


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(sys.argv[1], sys.argv[2])
