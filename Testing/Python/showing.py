# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
"""tfc.show() and tfc.apply(), right and wrong, and what a display does with a bad state."""
import json

import numpy as np
import pictures
import scripttest

from paraview import simple

import tfc

check = scripttest.check
raises = scripttest.raises


source = pictures.make_source()
view = pictures.make_view()
tf = pictures.make_transfer_function()
display = tfc.show(source, tf, view, unit_distance=2, shade=False)
check(display.Representation == "Combined Volume", "representation")
check(display.ScalarOpacityUnitDistance == 2 and display.Shade == 0, "options")
check(display.TransferFunction == tf.to_json(), "property")
simple.ResetCamera(view)
shown = pictures.capture(view)
check(int((shown[:, :, 0] > 60).sum()) > 200, "red is visible")
check(int((shown[:, :, 2] > 60).sum()) > 200, "blue is visible")
check(pictures.difference(shown, pictures.capture(view)) == 0, "the same again")

# Edits.
tf.region("ball").visible = False
tfc.apply(display, tf)
blue = pictures.capture(view)
check(int((blue[:, :, 0] > 20).sum()) == 0, "an invisible region is not drawn")
check(int((blue[:, :, 2] > 60).sum()) > 200, "the other region is")
tf.region("ball").visible = True
tfc.apply(display, tf)
check(pictures.difference(shown, pictures.capture(view)) == 0, "edited back")

# A bad state: the error names the field, the picture stays.
for bad, words in (
        ("garbage", "valid JSON"),
        ('{"format": "transfer-function-combination", "version": 9}', "version 9 is newer"),
        (tf.to_json().replace('"rectangle"', '"circle"'), "regions[0].shape.type"),
        ("[" * 10000, "nested")):
    with pictures.reported() as text:
        display.TransferFunction = bad
        picture = pictures.capture(view)
        report = text()
    check(words in report, "reported: " + words)
    check(pictures.difference(shown, picture) == 0, "the previous picture stays")

# A state that is valid but does not fit the data: the report lists what there is, the picture
# stays.
state = json.loads(tf.to_json())
for change, words in ((("primary", "array", "Pressure"), ("Pressure", "RTData")),
                      (("primary", "component", 7), ("RTData", "component"))):
    wrong = json.loads(tf.to_json())
    wrong[change[0]][change[1]] = change[2]
    with pictures.reported() as text:
        display.TransferFunction = json.dumps(wrong)
        picture = pictures.capture(view)
        again = pictures.capture(view)
        report = text()
    check(all(word in report for word in words), "reported: " + ", ".join(words))
    check(report.count(words[0] + "'") <= 2, "reported once, not with every picture")
    check(pictures.difference(shown, picture) == 0, "the previous picture stays")
    check(pictures.difference(shown, again) == 0, "and is drawn again")
display.TransferFunction = tf.to_json()
check(pictures.difference(shown, pictures.capture(view)) == 0, "a good state after bad ones")
display.TransferFunction = ""
check(float(pictures.capture(view).max()) == 0, "an empty state draws nothing")
display.TransferFunction = tf.to_json()

# Ranges that are left open come from the data.
automatic = tfc.TransferFunction("RTData", "R")
automatic.add_ellipse((150, 8), (100, 8)).tertiary("X", [(0, 0), (5, 1)])
tfc.apply(display, automatic)
low, high = source.PointData["RTData"].GetRange()
check(np.allclose(automatic.primary["range"], (low, high)), "primary range from the data")
check(np.allclose(automatic.regions[0].tertiary_state["range"], (-10, 10)),
      "tertiary range from the data")

constant = simple.Calculator(Input=source, ResultArrayName="C", Function="8")
automatic = tfc.TransferFunction("C", "R")
automatic.add_rectangle((8, 5), (4, 5))
tfc.apply(tfc.show(constant, automatic, view), automatic)
check(automatic.primary["range"] == [4, 12], "the range around a constant array")
simple.Hide(constant, view)

# Mistakes are Python exceptions before anything is shown.
raises(KeyError, lambda: tfc.show(source, tfc.TransferFunction("P", "R"), view),
       "'P'", "RTData", "R", "X")
missing = pictures.make_transfer_function()
missing.region("ball").tertiary("QVAPOR", [(0, 1)])
raises(KeyError, lambda: tfc.show(source, missing, view), "QVAPOR", "RTData")
raises(KeyError, lambda: tfc.show(source, tfc.TransferFunction("RTData", "R", primary_component=1),
                                  view), "RTData", "1 component", "no component 1")
raises(TypeError, lambda: tfc.show(simple.Sphere(), tf, view), "vtkPolyData", "Resample To Image")
raises(ValueError, lambda: tfc.show(source, tfc.TransferFunction.from_json(""), view),
       "no primary axis")
