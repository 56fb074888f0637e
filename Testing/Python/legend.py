# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
"""The legend of a Combined Volume: over the view, where it should be, and kept in states."""
import os
import tempfile

import numpy as np
import pictures
import scripttest

from paraview import simple

import tfc

check = scripttest.check


def changed(first, second):
    """Bounding box (left, right, bottom, top) of what differs, as fractions; None: nothing."""
    rows, columns = np.nonzero(np.abs(first - second).max(axis=2) > 8)
    if not len(rows):
        return None
    height, width = first.shape[:2]
    return (columns.min() / width, (columns.max() + 1) / width, rows.min() / height,
            (rows.max() + 1) / height)


pictures.SIZE = (640, 480)
wavelet = simple.Wavelet(WholeExtent=[-8, 8] * 3)
view = pictures.make_view()
function = tfc.TransferFunction("RTData", "RTData", primary_range=(30, 280),
                                secondary_range=(30, 280))
function.add_ellipse((200, 200), (60, 60), color=(1, 0.4, 0), opacity=0.1, name="crests")
display = tfc.show(wavelet, function, view)
simple.ResetCamera(view)
without = pictures.capture(view)
check(float(without.max()) > 20, "the volume")

display.LegendVisibility = 1
shown = pictures.capture(view)
box = changed(without, shown)
check(box is not None and box[0] > 0.55 and box[3] < 0.45, "lower right corner: %s" % (box,))
display.LegendLocation = "Upper Left Corner"
display.LegendSize = [0.5, 0.45]
box = changed(without, pictures.capture(view))
check(box is not None and box[1] < 0.55 and box[2] > 0.45, "upper left corner: %s" % (box,))
display.LegendLocation = "Any Location"
display.LegendPosition = [0.3, 0.2]
display.LegendSize = [0.4, 0.35]
box = changed(without, pictures.capture(view))
check(box is not None and 0.27 < box[0] < 0.45 and 0.17 < box[2] < 0.3, "anywhere: %s" % (box,))

# It follows edits.
before = pictures.capture(view)
function.regions[0].color = (0, 0.5, 1)
tfc.apply(display, function)
edited = pictures.capture(view)
check(changed(before, edited) is not None, "an edit")

# Only with the representation.
display.Visibility = 0
check(changed(np.zeros_like(before), pictures.capture(view)) is None, "hidden with the volume")
display.Visibility = 1
check(changed(edited, pictures.capture(view)) is None, "and back")
display.SetRepresentationType("Outline")
check(changed(without, pictures.capture(view)) is not None, "another representation")
outline = pictures.capture(view)
display.LegendVisibility = 0
check(changed(outline, pictures.capture(view)) is None, "which has no legend")
display.LegendVisibility = 1
display.SetRepresentationType("Combined Volume")
check(changed(edited, pictures.capture(view)) is None, "and back again")

# Twice as large with twice as large fonts.
path = os.path.join(tempfile.mkdtemp(), "large.png")
simple.SaveScreenshot(path, view, ImageResolution=[1280, 960],
                      FontScaling="Scale fonts proportionally")
large = pictures.read(path)[::2, ::2]
check(float(np.abs(large - edited).mean()) < 2.5, "the same layout in a large picture")

# A state keeps it.
path = os.path.join(tempfile.mkdtemp(), "legend.pvsm")
simple.SaveState(path)
simple.ResetSession()
simple.LoadState(path)
view = simple.GetActiveView()
check(changed(edited, pictures.capture(view)) is None, "from a state file")
