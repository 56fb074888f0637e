# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
"""tfc.suggest() and tfc.split(): on the phantom, on several variables, and their errors."""
import scripttest

from paraview import servermanager, simple

import tfc

check = scripttest.check
raises = scripttest.raises

tfc.load_plugin()
phantom = simple.MaterialPhantom(Dimensions=[64, 64, 64])
volume = tfc.attributes(phantom, "intensity", which=["gradient", "statistics", "occlusion"],
                        statistics={"MaximumRadius": 5},
                        occlusion={"Radius": 10, "Metric": "Occlusion spectrum"})
NAMES = ["intensity"] + ["intensity_" + s for s in ("gradient", "mean", "stddev", "occlusion")]
rows = tfc.suggest(volume, arrays=NAMES)
pairs = {(r.primary, r.secondary): r.kind for r in rows}
check(pairs == {("intensity", "intensity_gradient"): "value and gradient",
                ("intensity_mean", "intensity_stddev"): "mean and deviation"}, "pairs: %s" % pairs)
check([r.rank for r in rows] == [1, 2, 3] * 2 and [r.pair for r in rows] == [1] * 3 + [2] * 3,
      "three tertiary attributes for each pair, best first")
for row in rows:
    scored = {s.attribute: s for s in tfc.score(volume, row.primary, row.secondary, arrays=NAMES)}
    same = scored[row.tertiary]
    check((same.score, same.rank, same.new_information) ==
          (row.score, row.rank, row.new_information), "%s as scored" % (row,))

# Several variables: the pair by entropy and independence; a constant one is never proposed.
wavelet = simple.Wavelet()
several = wavelet
for name, function in (("X", "coordsX"), ("copy", "RTData*2+coordsX*0.01"), ("flat", "coordsX*0"),
                       ("step", "coordsY>9")):
    several = simple.Calculator(Input=several, ResultArrayName=name, Function=function)
rows = tfc.suggest(several, pairs=2)
check({r.pair for r in rows} == {1, 2} and rows[0].kind == "multivariate", "two pairs")
check("flat" not in {r.primary for r in rows} | {r.secondary for r in rows}, "no constant axis")
check("flat" not in {r.tertiary for r in rows}, "no constant tertiary attribute")
check({rows[0].primary, rows[0].secondary} != {"RTData", "copy"}, "not twice the same: %s"
      % (rows[0],))
proxy = simple.AxisSuggestion(Input=several)
table = servermanager.Fetch(proxy)
summary = table.GetFieldData().GetAbstractArray("summary").GetValue(0)
check(summary == "Use %s and %s as the axes and %s as the tertiary attribute"
      % (rows[0].primary, rows[0].secondary, rows[0].tertiary), summary)
raises(ValueError, lambda: tfc.suggest(several, arrays=["X"]), "No two attributes vary")
raises(ValueError, lambda: tfc.suggest(several, balance=1), "Balance")
raises(KeyError, lambda: tfc.suggest(several, arrays=["nobody"]), "nobody")
check(not simple.FindSource("tfc.suggest"), "nothing stays in the pipeline")

# The balls B and C have the same mean and deviation: occlusion tells them apart.
B, C = 4, 5
tf = tfc.TransferFunction("intensity_mean", "intensity_stddev")
region = tf.add_rectangle(center=(.8, .13), halfsize=(.08, .06), name="B and C")
rows = tfc.split(volume, tf, arrays=NAMES)
for row in rows:
    print(row)
check([r.rank for r in rows] == [1, 2, 3] and {r.region for r in rows} == {region.id}, "ranks")
check(rows[0].power >= rows[1].power >= rows[2].power, "best first")
check(rows[0].attribute == "intensity_occlusion", "the best attribute")
before = [tfc.quality(volume, tf, "material").of(label, region.id) for label in (B, C)]
check(tfc.split(volume, tf, region=region, arrays=NAMES) == rows, "of one region; the same again")
region.tertiary(**rows[0].keep_above)
check(region.tertiary_state["array"] == rows[0].attribute, "the cut is a tertiary function")
after = [tfc.quality(volume, tf, "material").of(label, region.id) for label in (B, C)]
print("precision, recall, Dice of B and C:", before, "->", after)
check(after[0][0] > before[0][0] and after[0][1] > 0.9 * before[0][1], "B is cleaner")
check(after[1][1] < 0.2 * before[1][1], "C is gone")

raises(KeyError, lambda: tfc.split(volume, tf, region=77), "no visible region 77")
raises(KeyError, lambda: tfc.split(volume, tf, arrays=["nobody"]), "nobody")
raises(ValueError, lambda: tfc.split(volume, tf, bins=2), "NumberOfBins")
raises(ValueError, lambda: tfc.split(volume, tfc.TransferFunction("intensity", "intensity_mean")),
       "no region")
check(not simple.FindSource("tfc.split"), "nothing stays in the pipeline")
for proxy in (proxy, simple.RegionSplit(Input=volume),
              simple.TransferFunctionHistogram(Input=volume)):
    for name in proxy.ListProperties():
        text = proxy.GetProperty(name).GetDocumentation()
        check(bool(text and text.GetDescription().strip()),
              "%s.%s is documented" % (proxy.GetXMLName(), name))
