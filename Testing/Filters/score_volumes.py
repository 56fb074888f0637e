# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
"""Correlations and entropies of real volumes against numpy.corrcoef and scipy.stats.entropy."""
import numpy as np
from paraview.simple import *
from vtkmodules.util.numpy_support import vtk_to_numpy

import scripttest

try:
    import scipy.stats
except ImportError:
    scripttest.skip("SciPy is missing: install python3-scipy")

from tfc.vtk.vtkTFCFilters import vtkTFCCombinationScore

scripttest.load_plugin(globals())
FILES = ["ct_chest_lidc0314.vti", "mri_stroke_t1_t2_flair.vti", "sim_cm1_hurricane.vti"]


def entropy(values, bins):
    """As the rule says: a bin per value of integers that fit, else equal bins from end to end."""
    low, high = float(values.min()), float(values.max())
    integers = values.dtype.kind in "iu"
    if bins == 0:
        bins = 65536 if integers else 256
    if integers and high - low + 1 <= bins:
        counts = np.bincount((values.astype(np.int64) - int(low)).ravel())
    else:
        q = np.floor((values.astype(float) - low) * (bins / (high - low))).astype(int)
        counts = np.bincount(np.minimum(q, bins - 1), minlength=bins)
    return scipy.stats.entropy(counts, base=2)


for name in FILES:
    reader = XMLImageDataReader(FileName=[scripttest.data_file(name)])
    gradient = VolumeGradientMagnitude(Input=reader)
    gradient.UpdatePipeline()
    data = gradient.GetClientSideObject().GetOutputDataObject(0)
    points = data.GetPointData()
    arrays = {points.GetArrayName(i): vtk_to_numpy(points.GetArray(i))
              for i in range(points.GetNumberOfArrays())
              if points.GetArray(i).GetNumberOfComponents() == 1}
    names = sorted(arrays)[:6]
    scripttest.check(len(names) >= 2, "%s: %s" % (name, names))
    valid = {n: np.isfinite(arrays[n]) for n in names}
    for bins in (256, 0, 100):
        score = scripttest.make(vtkTFCCombinationScore, Primary=names[0], NumberOfBins=bins,
                                MeasureInformation=False)
        for n in names:
            score.AddArray(n)
        score.SetInputData(data)
        score.Update()
        rows = scripttest.table(score.GetOutputDataObject(0),
                                ("attribute", "correlation", "entropy"))
        expected = []
        for row in rows:
            both = valid[names[0]] & valid[row[0]]
            pair = np.array([arrays[names[0]][both], arrays[row[0]][both]], dtype=float)
            expected.append((np.corrcoef(pair)[0, 1],
                             entropy(arrays[row[0]][valid[row[0]]], bins)))
        scripttest.check_close([r[1:] for r in rows], expected, 1e-9,
                               "%s, %d bins: correlation, entropy" % (name, bins))
