# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
"""Colours by name, by ``#rrggbb`` or as three numbers."""

from vtkmodules.vtkCommonColor import vtkNamedColors
from vtkmodules.vtkCommonDataModel import vtkColor3ub


def to_rgb(color):
    """Three floats in [0, 1] from a colour.

    >>> to_rgb((0, 0.5, 1))
    [0.0, 0.5, 1.0]
    >>> to_rgb("#ff8000") == [1.0, 128 / 255, 0.0]
    True
    >>> [round(c, 3) for c in to_rgb("crimson")]
    [0.863, 0.078, 0.235]
    >>> to_rgb("no such colour")
    Traceback (most recent call last):
    ...
    ValueError: unknown colour 'no such colour': use a CSS name, '#rrggbb' or three numbers in [0, 1]
    """
    if isinstance(color, str):
        named = vtkNamedColors()
        if color.startswith("#") and len(color) in (4, 7):
            rgb = vtkColor3ub()
            named.ParseColor(color, rgb)
            return [rgb[i] / 255 for i in range(3)]
        if named.ColorExists(color):
            rgb = named.GetColor3d(color)
            return [rgb[i] for i in range(3)]
        raise ValueError(
            f"unknown colour {color!r}: use a CSS name, '#rrggbb' or three numbers in [0, 1]"
        )
    rgb = [float(c) for c in color]
    if len(rgb) != 3 or not all(0 <= c <= 1 for c in rgb):
        raise ValueError(f"a colour is three numbers in [0, 1], got {color!r}")
    return rgb
