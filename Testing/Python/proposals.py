# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
"""tfc.propose() and tfc.show() without a transfer function: something sensible is visible."""
import numpy as np
import scripttest

from paraview import servermanager, simple

import tfc

check = scripttest.check
tfc.load_plugin()

phantom = simple.MaterialPhantom(Dimensions=[48, 48, 48])
tf = tfc.propose(phantom, "intensity", "material")
check(1 <= len(tf.regions) <= 3, "%d regions are proposed" % len(tf.regions))
check('"x-proposal": true' in tf.to_json(), "it says that it is a proposal")
check(tfc.propose(phantom, "intensity", "material") == tf, "the same data, the same proposal")
check(len(tfc.propose(phantom, "intensity", "material", regions=1).regions) == 1, "one region")
low, high = tf.primary["range"]
for region in tf.regions:
    x, y = region.shape["center"]
    check(low < x < high and 0 <= y <= 5, "its centre is on the axes")
scripttest.raises(KeyError, lambda: tfc.propose(phantom, "intensity", "nothing"), "nothing")

# The background, most of the voxels, is left out.
display = tfc.show(phantom, tf)
classified = simple.ClassifyVolume(Input=phantom, TransferFunction=tf.to_json())
regions = scripttest.volume(servermanager.Fetch(classified), "tfc_region").ravel()
material = scripttest.volume(servermanager.Fetch(phantom), "material").ravel()
check(0.005 < np.mean(regions > 0) < 0.6, "%.3f of the voxels are selected" % np.mean(regions > 0))
check(np.mean(regions[material == 0] > 0) < 0.05, "hardly any background is")

# One array: both axes, no region, no error.
wavelet = simple.Wavelet()
single = tfc.propose(wavelet)
check(single.primary["array"] == single.secondary["array"] == "RTData", "a single array")
check(not single.regions, "has no plane to propose regions in")

display = tfc.show(tfc.attributes(wavelet, "RTData", ["gradient"]))
check("RTData_gradient" in display.TransferFunction, "without a transfer function: a proposal")
check(display.Representation == "Combined Volume", "and it is shown")
