# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of ParaView views as arrays, reported errors as text, and a volume with three arrays."""
import os
import tempfile
from contextlib import contextmanager

import numpy as np

SIZE = (160, 120)


def read(path):
    """A PNG file as float array [row, column, channel] of red, green, blue in 0..255."""
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkIOImage import vtkPNGReader

    reader = vtkPNGReader()
    reader.SetFileName(path)
    reader.Update()
    image = reader.GetOutput()
    width, height, _ = image.GetDimensions()
    pixels = vtk_to_numpy(image.GetPointData().GetScalars())
    return pixels.reshape(height, width, -1)[:, :, :3].astype(float)


def capture(view):
    """What a view shows."""
    from paraview import simple

    handle, path = tempfile.mkstemp(suffix=".png")
    os.close(handle)
    try:
        simple.SaveScreenshot(path, view, ImageResolution=list(SIZE))
        return read(path)
    finally:
        os.remove(path)


def difference(first, second):
    """Mean absolute difference of two pictures, in 0..255."""
    return float(np.abs(first - second).mean())


def highlight(display, region):
    """Let a region stand out. The property is internal: Python has no attribute for it."""
    display.SMProxy.GetProperty("HighlightedRegion").SetElement(0, region)
    display.SMProxy.UpdateVTKObjects()


def make_view():
    """A small view without decoration whose background is black."""
    from paraview import simple

    return clear(simple.CreateRenderView())


def clear(view):
    """Make a view small and black, without decoration."""
    view.ViewSize = list(SIZE)
    view.UseColorPaletteForBackground = 0
    view.Background = [0, 0, 0]
    view.OrientationAxesVisibility = 0
    return view


def make_source():
    """Wavelet with its own RTData and two more point arrays: X (coordinate) and R (distance)."""
    from paraview import simple

    wavelet = simple.Wavelet(WholeExtent=[-10, 10] * 3)
    x = simple.Calculator(Input=wavelet, ResultArrayName="X", Function="coordsX")
    return simple.Calculator(Input=x, ResultArrayName="R", Function="mag(coords)")


def make_transfer_function():
    """Red inside a ball, blue in its upper half: three attributes take part."""
    import tfc

    tf = tfc.TransferFunction("RTData", "R", primary_range=(0, 300), secondary_range=(0, 20))
    tf.add_rectangle((150, 4), (150, 4), name="ball", color=(1, 0, 0), opacity=0.5).tertiary(
        "X", [(-1, 1), (1, 0)], range=(-10, 10))
    tf.add_rectangle((150, 4), (150, 4), name="half", color=(0, 0, 1), opacity=0.5).tertiary(
        "X", [(-1, 0), (1, 1)], range=(-10, 10))
    return tf


@contextmanager
def reported():
    """What VTK and ParaView report meanwhile: yields a function that returns the text."""
    from vtkmodules.vtkCommonCore import vtkOutputWindow, vtkStringOutputWindow

    previous = vtkOutputWindow.GetInstance()
    window = vtkStringOutputWindow()
    vtkOutputWindow.SetInstance(window)
    try:
        yield window.GetOutput
    finally:
        vtkOutputWindow.SetInstance(previous)


def count_hues(picture, background):
    """Numbers of pixels that differ from the background and are red, yellow, green and blue."""
    shown = np.abs(picture - 255 * np.asarray(background)).max(axis=2) > 24
    high = picture.max(axis=2)
    spread = high - picture.min(axis=2)
    shown &= spread > 0.35 * high
    red, green, blue = (picture[:, :, i] for i in range(3))
    scale = np.where(spread > 0, spread, 1)
    sixths = np.where(high == red, (green - blue) / scale % 6,
                      np.where(high == green, (blue - red) / scale + 2, (red - green) / scale + 4))
    bands = {"red": (325, 385), "yellow": (38, 66), "green": (85, 150), "blue": (205, 255)}
    return {name: int((shown & ((60 * sixths - low) % 360 < high - low)).sum())
            for name, (low, high) in bands.items()}
