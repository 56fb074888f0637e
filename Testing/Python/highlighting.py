# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
"""HighlightedRegion of a display: the other regions are dimmed, and state files, trace and the
transfer function know nothing of it."""
import os
import tempfile

import pictures
import scripttest

from paraview import simple, smstate, smtrace

import tfc

check = scripttest.check


def strengths(picture):
    """Sums of what is red and of what is blue."""
    return float(picture[:, :, 0].sum()), float(picture[:, :, 2].sum())


tf = pictures.make_transfer_function()
source = pictures.make_source()
view = pictures.make_view()
display = tfc.show(source, tf, view, unit_distance=2, shade=False)
simple.ResetCamera(view)
before = pictures.capture(view)
red, blue = strengths(before)
check(red > 1e5 and blue > 1e5, "both regions are visible")

smtrace.start_trace()
for name, index in (("ball", 0), ("half", 1)):
    pictures.highlight(display, tf.region(name).id)
    dimmed = strengths(pictures.capture(view))
    other = (blue, red)[index]
    check(dimmed[index] >= 0.99 * (red, blue)[index], "%s is as bright as before" % name)
    check(0 < dimmed[1 - index] < 0.3 * other, "the other one is dimmed: %.0f of %.0f" %
          (dimmed[1 - index], other))
trace = smtrace.stop_trace()
check(display.TransferFunction == tf.to_json(), "the transfer function is as it was")
check("HighlightedRegion" not in trace, "nothing in the trace")
check("HighlightedRegion" not in smstate.get_state(), "nothing in a Python state")
with tempfile.TemporaryDirectory() as folder:
    path = os.path.join(folder, "state.pvsm")
    simple.SaveState(path)
    with open(path, encoding="utf-8") as state:
        text = state.read()
check("transfer-function-combination" in text, "the state file has the transfer function")
check("HighlightedRegion" not in text, "but not the highlight")

pictures.highlight(display, 999)
check(pictures.difference(before, pictures.capture(view)) == 0, "a region that is not there: none")
pictures.highlight(display, 0)
after = pictures.capture(view)
check(abs(before - after).max() == 0, "the same pixels again")

# Axes whose ranges come from the data keep them.
automatic = tfc.TransferFunction("RTData", "R")
automatic.add_ellipse((150, 8), (100, 8), color="gold")
low = automatic.add_ellipse((60, 15), (40, 8), color="royalblue")
display.TransferFunction = automatic.to_json()
before = pictures.capture(view)
pictures.highlight(display, low.id)
check(pictures.difference(before, pictures.capture(view)) > 1, "automatic ranges: dimmed")
pictures.highlight(display, 0)
check(abs(before - pictures.capture(view)).max() == 0, "automatic ranges: the same pixels again")
automatic = tfc.TransferFunction("R", "RTData")
automatic.add_ellipse((8, 150), (8, 100), color="gold")
automatic.add_ellipse((15, 60), (8, 40), color="royalblue")
display.TransferFunction = automatic.to_json()
check(pictures.difference(before, pictures.capture(view)) < 0.2,
      "swapped axes have the ranges of the other attributes")
