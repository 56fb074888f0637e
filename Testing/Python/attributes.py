# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
"""tfc.attributes(): several attributes in one call, and its errors."""
import scripttest

from paraview import simple

import tfc

check = scripttest.check
raises = scripttest.raises

tfc.load_plugin()
wavelet = simple.Wavelet(WholeExtent=[0, 19, 0, 17, 0, 15])
source = simple.Calculator(Input=wavelet, ResultArrayName="V", Function="coords")

volume = tfc.attributes(source, "RTData", ["gradient", "occlusion"], occlusion={"Radius": 4})
check(set(volume.PointData.keys()) == {"V", "RTData", "RTData_gradient", "RTData_occlusion"},
      "both attributes beside the arrays: %s" % volume.PointData.keys())
check(volume.Radius == 4 and volume.Input.GetXMLName() == "VolumeGradientMagnitude",
      "a chain of filters that can be edited")

default = tfc.attributes(wavelet, "RTData", occlusion={"Radius": 4})
added = {"RTData_" + suffix for suffix in ("gradient", "mean", "stddev", "radius", "occlusion")}
check(added <= set(default.PointData.keys()), "gradient, statistics and occlusion by default")
every = tfc.attributes(wavelet, "RTData", ["gradient", "statistics", "occlusion", "size"],
                       occlusion={"Radius": 4}, size={"SmallestSize": 2, "LargestSize": 5})
check(added | {"RTData_size"} <= set(every.PointData.keys()), "all of them")

several = tfc.attributes(
    simple.Calculator(Input=wavelet, ResultArrayName="B", Function="RTData*2"), ["RTData", "B"],
    "gradient")
check({"RTData_gradient", "B_gradient"} <= set(several.PointData.keys()), "two arrays in one pass")
cells = simple.PointDatatoCellData(Input=wavelet)
check("RTData_gradient" in tfc.attributes(cells, "RTData", "gradient").CellData.keys(), "cell data")

before = len(simple.GetSources())
raises(KeyError, lambda: tfc.attributes(source, "Pressure"), "Pressure", "RTData")
raises(ValueError, lambda: tfc.attributes(source, "RTData", "curvature"), "curvature", "gradient")
raises(ValueError, lambda: tfc.attributes(source, "RTData", "gradient", occlusion={"Radius": 3}),
       "occlusion")
raises(ValueError, lambda: tfc.attributes(source, "RTData", "occlusion", occlusion={"Sigma": 3}),
       "Sigma", "Radius")
raises(ValueError, lambda: tfc.attributes(source, "RTData", ["gradient", "occlusion"],
                                          occlusion={"Radius": 99}), "longer than the volume")
raises(ValueError, lambda: tfc.attributes(source, []), "no array")
check(len(simple.GetSources()) == before, "the pipeline is as it was after an error")
