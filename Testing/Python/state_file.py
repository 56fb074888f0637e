# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
"""ParaView's state files and Python trace keep the transfer function, and with it the picture."""
import os
import tempfile

import pictures
import scripttest

from paraview import servermanager, simple, smtrace

import tfc

check = scripttest.check


def only(group, kind):
    """The one proxy of this kind that the session has."""
    proxies = servermanager.ProxyManager().GetProxiesInGroup(group).values()
    found = [proxy for proxy in proxies if proxy.GetXMLName() == kind]
    check(len(found) == 1, "one %s" % kind)
    return found[0]


def the_display():
    return only("representations", "UniformGridRepresentation")


tf = pictures.make_transfer_function()
view = pictures.make_view()
source = pictures.make_source()
display = tfc.show(source, tf, view, unit_distance=2, shade=True)
display.SampleDistance = 0.4
simple.ResetCamera(view)
before = pictures.capture(view)
check(float(before.max()) > 60, "something is visible")

with tempfile.TemporaryDirectory() as folder:
    path = os.path.join(folder, "state.pvsm")
    simple.SaveState(path)
    simple.ResetSession()
    tfc.load_plugin()
    simple.LoadState(path)

view = simple.GetActiveViewOrCreate("RenderView")
view.ViewSize = list(pictures.SIZE)
display = the_display()
check(display.TransferFunction == tf.to_json(), "TransferFunction from the state file")
check(display.Representation == "Combined Volume", "representation from the state file")
check(display.SampleDistance == 0.4 and display.ScalarOpacityUnitDistance == 2, "other properties")
check(pictures.difference(before, pictures.capture(view)) == 0, "the same picture")

# Trace: what is done after start_trace() becomes a script that does it again.
simple.ResetSession()
tfc.load_plugin()
smtrace.start_trace()
view = pictures.make_view()
source = simple.Wavelet()
flat = tfc.TransferFunction("RTData", "RTData", primary_range=(0, 300), secondary_range=(0, 300))
flat.add_rectangle((150, 150), (100, 100), color="gold", opacity=0.2)
display = tfc.show(source, flat, view)
flat.regions[0].color = "royalblue"
tfc.apply(display, flat)
simple.ResetCamera(view)
simple.Render(view)
trace = smtrace.stop_trace()
before = pictures.capture(view)
check(trace.count("Display.TransferFunction = ") >= 2, "each edit is in the trace")
check("transfer-function-combination" in trace, "the state is in the trace")

simple.ResetSession()
tfc.load_plugin()
exec(compile(trace, "trace", "exec"), {"__name__": "__main__"})
check(the_display().TransferFunction == flat.to_json(), "TransferFunction from the trace")
# ParaView's trace does not record the view's background.
view = pictures.clear(simple.GetActiveViewOrCreate("RenderView"))
check(pictures.difference(before, pictures.capture(view)) == 0, "the same picture from the trace")
