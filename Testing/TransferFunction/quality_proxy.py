# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
"""The proxy of the quality filter, and tfc.quality() on the phantom, where the paper's story is
known: intensity and gradient cannot tell the balls from what is around them, the local statistics
with occlusion can."""
from paraview import servermanager
from paraview.simple import *

import scripttest

scripttest.load_plugin(globals())
import tfc
from tfc.vtk.vtkTFCTransferFunction import vtkTFCClassificationQuality

check, raises = scripttest.check, scripttest.raises
LABELS = {"environment": 0, "hull": 1, "filling": 2, "A": 3, "B": 4, "C": 5}


def everything(primary, secondary, tertiary=None):
    """A transfer function over these attributes whose only region is the whole plane."""
    tf = tfc.TransferFunction(primary, secondary)
    region = tf.add_rectangle(center=(0, 0), halfsize=(100, 100))
    if tertiary:
        region.tertiary(tertiary, [(-100, 0.5), (100, 0.5)])
    return tf


def best(volume, *attributes):
    measured = tfc.quality(volume, everything(*attributes), "material")
    found = {name: measured.row(label).best_dice for name, label in LABELS.items()}
    print(attributes, found)
    check(measured.row(0).recall > 0.99, "the region is everywhere")
    return found


phantom = MaterialPhantom(Dimensions=[64, 64, 64])
volume = tfc.attributes(phantom, "intensity", which=["gradient", "statistics", "occlusion"],
                        statistics={"MaximumRadius": 5},
                        occlusion={"Radius": 10, "Metric": "Occlusion spectrum"})
plain = best(volume, "intensity", "intensity_gradient")
occluded = best(volume, "intensity", "intensity_gradient", "intensity_occlusion")
local = best(volume, "intensity_mean", "intensity_stddev")
combined = best(volume, "intensity_mean", "intensity_stddev", "intensity_occlusion")
check(plain["A"] < 0.1 and plain["C"] < 0.2, "intensity and gradient: A and C are not found")
check(local["A"] < 0.5 and local["B"] > plain["B"], "the local statistics find B, not A")
check(all(combined[name] > plain[name] for name in LABELS), "the combination is better for all")
check(combined["A"] > 0.45 and combined["C"] > 0.75, "and much better for A and C")
check(combined["filling"] > 0.95 and plain["filling"] < 0.5, "and for the filling")
check(all(occluded[name] >= plain[name] for name in LABELS), "a third attribute never hurts")

# A transfer function that misses what its axes could do, and one that their limit stops.
tf = tfc.TransferFunction("intensity_mean", "intensity_stddev")
good = tf.add_rectangle(center=(.2, .15), halfsize=(.1, .1), name="outside")
tf.add_rectangle(center=(.4, .5), halfsize=(.05, .05), name="nothing")
measured = tfc.quality(volume, tf, "material")
row = measured.row(0)
check(row.region == good.id and row.region_name == "outside", "the region of the environment")
check(row.dice > 0.9 and measured.of(0, good.id)[2] == row.dice, "its quality: %s" % (row,))
check(row.limited_by == "neither", "nothing better is possible")
check(measured.row(3).limited_by == "axes", "other regions would not find A")
check(measured.row(4).limited_by == "regions" and measured.row(4).best_dice > 0.9,
      "but B: %s" % (measured.row(4),))
check(sum(sum(counts.values()) for counts in measured.confusion.values()) == 64 ** 3,
      "every voxel is in the confusion table")
print(measured)

less = tfc.quality(volume, tf, "material", bins=16, ignored=[0, 5])
check([row.label for row in less.rows] == [1, 2, 3, 4], "ignored labels")
check(not FindSource("tfc.quality"), "nothing stays in the pipeline")
raises(KeyError, lambda: tfc.quality(volume, tf, "nobody"), "nobody")
raises(KeyError, lambda: measured.row(9), "no label 9")
raises(KeyError, lambda: measured.of(0, 77), "no region 77")
raises(ValueError, lambda: tfc.quality(volume, tf, "intensity"), "not integers")
raises(ValueError, lambda: tfc.quality(phantom, tf, "material"), "intensity_mean")
check(not FindSource("tfc.quality"), "nothing stays in the pipeline after errors")

proxy = ClassificationQuality(Input=volume)
check((proxy.LabelArray, proxy.TransferFunction, proxy.NumberOfBins) == ("None", "", 64),
      "defaults: %s" % [proxy.LabelArray, proxy.TransferFunction, proxy.NumberOfBins])
check(len(proxy.IgnoredLabels) == 0, "no ignored labels by default")
check(isinstance(proxy.GetClientSideObject(), vtkTFCClassificationQuality), "wrapped class")
check([proxy.SMProxy.GetOutputPortName(i) for i in (0, 1)] == ["Quality", "Confusion"],
      "names of the outputs")
proxy.LabelArray = "material"
proxy.TransferFunction = tf.to_json()
proxy.IgnoredLabels = [5]
check(servermanager.Fetch(proxy).GetNumberOfRows() == 5, "rows")
confusion = servermanager.Fetch(proxy, idx=1)
check([confusion.GetColumnName(c) for c in range(4)] == ["label", "none", "region 1", "region 2"],
      "columns of the confusion table")
for name in proxy.ListProperties():
    documentation = proxy.GetProperty(name).GetDocumentation()
    text = documentation.GetDescription() if documentation else None
    check(bool(text and text.strip()), "%s is documented" % name)
