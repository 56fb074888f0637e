# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
"""tfc.score() against the filter that it drives, and its errors."""
import math

import pictures
import scripttest

from paraview import servermanager, simple

import tfc

check = scripttest.check
raises = scripttest.raises


def same(rows, table):
    """Whether rows are those of the table, in its order."""
    names = tfc.Score._fields
    return len(rows) == len(table) and all(
        a == b or (math.isnan(a) and math.isnan(b)) for row, other in zip(rows, table)
        for a, b in zip(row, other)) and names[0] == "attribute"


tfc.load_plugin()
source = simple.Calculator(Input=pictures.make_source(), ResultArrayName="V", Function="coords")
rows = tfc.score(source, primary="RTData", secondary="R")
filtered = simple.CombinationScore(Input=source, Primary="RTData", Secondary="R")
table = scripttest.table(servermanager.Fetch(filtered), tfc.Score._fields)
check(same(rows, table), "the rows of the filter: %s" % (rows,))
check(rows[0].rank == 1 and rows[0].attribute == "X", "best first")
check({r.attribute for r in rows if r.rank == 0} == {"RTData", "R"}, "the axes are not ranked")

chosen = tfc.score(source, "RTData", arrays=["V:0", "V:magnitude"], balance=0.25, bins=64)
filtered.Secondary = "None"
filtered.Arrays = ["V:0", "V:magnitude", "RTData"]
filtered.Balance = 0.25
filtered.NumberOfBins = 64
table = scripttest.table(servermanager.Fetch(filtered), tfc.Score._fields)
check(same(chosen, table), "components and options: %s" % (chosen,))

before = tfc.score(source, "RTData", arrays=["X"])
check(tfc.score(source, "RTData", arrays=["X"], fill_values=[10]) != before, "fill values")
check(not simple.FindSource("tfc.score"), "nothing stays in the pipeline")

raises(KeyError, lambda: tfc.score(source, "Pressure"), "Pressure", "RTData", "X")
raises(KeyError, lambda: tfc.score(source, "RTData", arrays=["V:3"]), "3 components")
raises(KeyError, lambda: tfc.score(source, "RTData", secondary="W:0"), "'W'")
raises(ValueError, lambda: tfc.score(source, "RTData", balance=2), "Balance")
raises(ValueError, lambda: tfc.score(source, "V"), "'V:0'", "magnitude")
cells = simple.PointDatatoCellData(Input=source)
check([r.attribute for r in tfc.score(cells, "RTData", arrays=["R"])] == ["R", "RTData"], "cells")
check(not simple.FindSource("tfc.score"), "nothing stays in the pipeline after errors")

intervals = tfc.stability(source, "RTData", "R")
check(intervals[0].low == 0 and intervals[-1].high == 1, "intervals of the whole range")
check(all(a.high == b.low for a, b in zip(intervals, intervals[1:])), "without gaps")
for interval in intervals:
    middle = (interval.low + interval.high) / 2
    ranked = [r.attribute for r in tfc.score(source, "RTData", "R", balance=middle) if r.rank]
    check(ranked == interval.ranking, "the ranking at %.3f: %s" % (middle, ranked))
raises(ValueError, lambda: tfc.stability(source, "RTData", arrays=["RTData"]), "candidate")
check(not simple.FindSource("tfc.score"), "and nothing stays in the pipeline")
check("is first for" in intervals.summary and "a = 0.4" in intervals.summary, intervals.summary)
check(sorted(intervals.over_bins) == [1, 2, 4, 8], "wider bins: %s" % intervals.over_bins)
ranked = [r.attribute for r in tfc.score(source, "RTData", "R") if r.rank]
check(intervals.over_bins[1] == ranked, "unmerged bins rank as the score does")
