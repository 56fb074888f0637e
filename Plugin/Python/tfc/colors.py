# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
"""Colours by name, by ``#rrggbb`` or as three numbers."""

import re

from vtkmodules.vtkCommonColor import vtkNamedColors


def to_rgb(color):
    """Three floats in [0, 1] from a colour.

    >>> to_rgb((0, 0.5, 1))
    [0.0, 0.5, 1.0]
    >>> to_rgb("#ff8000") == [1.0, 128 / 255, 0.0]
    True
    >>> to_rgb("#f80") == to_rgb("#ff8800")
    True
    >>> [round(c, 3) for c in to_rgb("crimson")]
    [0.863, 0.078, 0.235]
    >>> to_rgb("no such colour")
    Traceback (most recent call last):
    ...
    ValueError: unknown colour 'no such colour': use a CSS name, '#rrggbb' or 3 numbers in [0, 1]
    """
    if isinstance(color, str):
        if re.fullmatch("#(?:[0-9a-fA-F]{3}){1,2}", color):
            digits = (len(color) - 1) // 3
            parts = [color[1 + i * digits : 1 + (i + 1) * digits] for i in range(3)]
            return [int(part, 16) / (16**digits - 1) for part in parts]
        named = vtkNamedColors()
        if named.ColorExists(color):
            rgb = named.GetColor3d(color)
            return [rgb[i] for i in range(3)]
        raise ValueError(
            f"unknown colour {color!r}: use a CSS name, '#rrggbb' or 3 numbers in [0, 1]"
        )
    rgb = [float(c) for c in color]
    if len(rgb) != 3 or not all(0 <= c <= 1 for c in rgb):
        raise ValueError(f"a colour is three numbers in [0, 1], got {color!r}")
    return rgb
