# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
"""A second editor of the transfer function of the active display, for SeveralViews.xml: doubles the
opacity of the first region."""
import json

from paraview import simple

display = simple.GetDisplayProperties()
state = json.loads(display.TransferFunction)
state["regions"][0]["opacity"] *= 2
display.TransferFunction = json.dumps(state)
simple.Render()
