# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
"""The proxies as a script uses them."""
import numpy as np
from paraview import servermanager
from paraview.simple import *

import scripttest

scripttest.load_plugin(globals())
from tfc.vtk.vtkTFCFilters import vtkTFCOcclusion

source = Wavelet(WholeExtent=[0, 31, 0, 25, 0, 17])
unknown = VolumeOcclusion(Input=source)
scripttest.check(unknown.Radius == 40, "default radius while the volume is not known")
gradient = VolumeGradientMagnitude(Input=source, InputArray=["POINTS", "RTData"])
gradient.UpdatePipeline()
occlusion = VolumeOcclusion(Input=gradient, InputArray=["POINTS", "RTData"])
scripttest.check(occlusion.Radius == 5 and occlusion.BoundaryParameter == 0.005, "defaults")
wide = Wavelet(WholeExtent=[0, 299, 0, 3, 0, 3])
wide.UpdatePipeline()
large = VolumeOcclusion(Input=wide)
scripttest.check(large.Radius == 40, "default radius in a large volume")
domain = large.GetProperty("Radius").GetDomain("range")
scripttest.check((domain.GetMinimum(0), domain.GetMaximum(0)) == (0, 300), "range of the radius")
scripttest.check(list(large.MoreArrays) == [], "no further arrays by default")
scripttest.check(list(occlusion.InputArray) == ["POINTS", "RTData"], "array selection")
occlusion.UpdatePipeline()
scripttest.check(occlusion.PointData.keys() == ["RTData", "RTData_gradient", "RTData_occlusion"],
                 "the arrays pass through")
scripttest.check(isinstance(occlusion.GetClientSideObject(), vtkTFCOcclusion), "wrapped class")

# Without a choice: the active scalars.
default = VolumeGradientMagnitude(Input=source)
default.UpdatePipeline()
scripttest.check("RTData_gradient" in default.PointData.keys(), "active scalars")

# Cell data.
cells = PointDatatoCellData(Input=source)
ofcells = VolumeOcclusion(Input=cells, InputArray=["CELLS", "RTData"], Radius=3)
ofcells.UpdatePipeline()
scripttest.check("RTData_occlusion" in ofcells.CellData.keys(), "cell data")

# A part of the volume has the values of the whole.
whole = servermanager.Fetch(occlusion)
subset = ExtractSubset(Input=occlusion, VOI=[3, 9, 4, 8, 5, 6])
part = servermanager.Fetch(subset)
scripttest.check_close(scripttest.volume(part, "RTData_occlusion"),
                       scripttest.volume(whole, "RTData_occlusion")[5:7, 4:9, 3:10], 0,
                       "a subset of the result")

score = CombinationScore(Input=occlusion, Arrays=["RTData_gradient", "RTData_occlusion"],
                         Primary="RTData")
scripttest.check((score.Balance, score.NumberOfBins, score.Secondary) == (0.4, 256, "None"),
                 "defaults of the score")
rows = scripttest.table(servermanager.Fetch(score), ("attribute", "score", "rank"))
scripttest.check([row[0] for row in rows] == ["RTData_gradient", "RTData_occlusion", "RTData"],
                 "best first")
scripttest.check([row[2] for row in rows] == [1, 2, 0] and np.isnan(rows[2][1]), "ranks")
score.Secondary = "RTData_gradient"
score.FillValues = [1e35, -9999]
rows = scripttest.table(servermanager.Fetch(score), ("attribute", "rank"))
scripttest.check(rows == [("RTData_occlusion", 1), ("RTData", 0), ("RTData_gradient", 0)],
                 "the secondary attribute is no candidate")
matrix = servermanager.Fetch(score, idx=1)
scripttest.check(matrix.GetNumberOfRows() == 3 and matrix.GetNumberOfColumns() == 4, "matrix")
stability = servermanager.Fetch(score, idx=2)
scripttest.check(stability.GetNumberOfRows() == 1 and
                 stability.GetValueByName(0, "ranking").ToString() == "RTData_occlusion",
                 "one candidate has one ranking")
summary = stability.GetFieldData().GetAbstractArray("summary").GetValue(0)
scripttest.check(summary.startswith("RTData_occlusion is first for every balance; "), summary)
everything = CombinationScore(Input=occlusion)
scripttest.check(servermanager.Fetch(everything).GetNumberOfRows() == 3, "all arrays by default")

# The default of Arrays is what can be scored as it is.
vectors = Calculator(Input=occlusion, Function="iHat*RTData+jHat*RTData_gradient",
                     ResultArrayName="V")
components = CombinationScore(Input=vectors)
scripttest.check("V" not in list(components.Arrays), "no array with several components by default")
scripttest.check(servermanager.Fetch(components).GetNumberOfRows() == 3, "single components")
components.Arrays = ["RTData", "V:1", "V:magnitude"]
rows = scripttest.table(servermanager.Fetch(components), ("attribute",))
scripttest.check(sorted(rows) == [("RTData",), ("V:1",), ("V:magnitude",)], "components by name")

for proxy in (gradient, occlusion, score):
    for name in proxy.ListProperties():
        documentation = proxy.GetProperty(name).GetDocumentation()
        text = documentation.GetDescription() if documentation else None
        scripttest.check(bool(text and text.strip()),
                         "%s.%s is documented" % (proxy.GetXMLName(), name))
