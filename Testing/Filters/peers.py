# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
"""The filters against NumPy and SciPy."""
import sys

import scripttest

try:
    import numpy as np
    import scipy.ndimage
    import scipy.stats
except ImportError as error:
    scripttest.skip("needs SciPy (Debian: python3-scipy): %s" % error)

from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData
from tfc.vtk.vtkTFCFilters import (
    vtkTFCCombinationScore, vtkTFCGradientMagnitude, vtkTFCOcclusion)

random = np.random.default_rng(7)


def image(values, spacing=(1, 1, 1)):
    """Image with the array `a`, indexed [z, y, x]."""
    data = vtkImageData()
    data.SetDimensions(values.shape[::-1])
    data.SetSpacing(spacing)
    add(data, "a", values)
    return data


def add(data, name, values):
    array = numpy_to_vtk(np.ascontiguousarray(values).ravel(), deep=1)
    array.SetName(name)
    data.GetPointData().AddArray(array)


def run(filter, data, suffix):
    filter.SetInputData(data)
    filter.SetInputArrayToProcess(0, 0, 0, 0, "a")
    filter.Update()
    return scripttest.volume(filter.GetOutput(), "a" + suffix)


def in_volume_mean(values, radius):
    """uniform_filter of the values and of ones, both zero outside of the volume."""
    size = 2 * radius + 1
    mean = scipy.ndimage.uniform_filter(values.astype(float), size, mode="constant")
    part = scipy.ndimage.uniform_filter(np.ones(values.shape), size, mode="constant")
    return mean / part


def gradient(values, spacing):
    """numpy.gradient takes the axes in the order z, y, x; an axis of one sample has slope 0."""
    axes = [a for a in range(3) if values.shape[a] > 1]
    parts = np.gradient(values.astype(float), *[spacing[2 - a] for a in axes], axis=axes)
    return np.sqrt(sum(part ** 2 for part in (parts if len(axes) > 1 else [parts])))


volumes = [
    ((33, 40, 27), np.float32), ((32, 31, 30), np.float64), ((20, 20, 20), np.uint8),
    ((17, 18, 19), np.int16), ((16, 16, 16), np.int64), ((1, 50, 40), np.float32),
    ((40, 1, 30), np.uint16), ((1, 1, 60), np.float32),
]
for shape, dtype in volumes:
    values = scipy.ndimage.gaussian_filter(random.normal(size=shape), 1.5) * 400 + 120
    values = np.clip(values, 0, 255).astype(dtype) if dtype == np.uint8 else values.astype(dtype)
    what = "%s %s" % (shape, np.dtype(dtype).name)
    for spacing in ((1, 1, 1), (0.5, 2.0, 3.25)):
        result = run(vtkTFCGradientMagnitude(), image(values, spacing), "_gradient")
        scripttest.check_close(result, gradient(values, spacing), 1e-6, "gradient " + what)
    span = float(values.max()) - float(values.min())
    normalised = gradient(values, (1, 1, 1)) / span
    for radius in (1, 4, 15):
        for eta in (0.005, 0.05):
            expected = in_volume_mean(values, radius) * eta ** 2 / (normalised ** 2 + eta ** 2)
            occlusion = scripttest.make(vtkTFCOcclusion, Radius=radius, BoundaryParameter=eta)
            result = run(occlusion, image(values), "_occlusion")
            scripttest.check_close(result, expected, 3e-6,
                                   "occlusion %s radius %d eta %g" % (what, radius, eta))

# Scores: three doubles, a float, 12-bit integers and 8-bit ones.
shape = (41, 42, 43)
base = random.normal(size=shape)
attributes = {
    "a": base,
    "b": 0.7 * base + random.normal(size=shape) + 1e6,
    "c": np.exp(base),
    "d": (base ** 2).astype(np.float32),
    "e": random.integers(-1024, 3071, size=shape).astype(np.int16),
    "f": np.clip(128 + 40 * base, 0, 255).astype(np.uint8),
}


def entropy(values, bins=256):
    values = values[~np.isnan(values)] if values.dtype.kind == "f" else values
    low, high = float(values.min()), float(values.max())
    if values.dtype.kind != "f" and high - low + 1 <= bins:
        counts = np.bincount((values.astype(np.int64) - int(low)).ravel())
    else:
        q = np.floor((values.astype(float) - low) * (bins / (high - low))).astype(int)
        counts = np.bincount(np.minimum(q, bins - 1).ravel(), minlength=bins)
    return scipy.stats.entropy(counts, base=2)


def compare_scores(what, attributes, correlations):
    data = image(attributes["a"])
    for name, values in attributes.items():
        add(data, name, values)
    score = scripttest.make(vtkTFCCombinationScore, Primary="b", Balance=0.6)
    score.SetInputData(data)
    score.Update()
    names = list(attributes)
    entropies = [entropy(attributes[name]) for name in names]
    p = names.index("b")
    expected = {
        name: (correlations[p][i], entropies[i],
               -0.6 * abs(correlations[p][i]) + 0.4 * entropies[i] / max(entropies))
        for i, name in enumerate(names)
    }
    rows = scripttest.table(score.GetOutput(), ("attribute", "correlation", "entropy", "score"))
    ranked = [row for row in rows if row[0] != "b"]
    scripttest.check(len(rows) == len(names), what + ": a row per attribute")
    scripttest.check_close([row[1:] for row in ranked], [expected[row[0]] for row in ranked], 1e-9,
                           what + ": correlation, entropy, score")
    best = sorted((name for name in names if name != "b"), key=lambda name: -expected[name][2])
    scripttest.check([row[0] for row in ranked] == best, what + ": order")
    matrix = scripttest.table(score.GetOutputDataObject(1), ["attribute"] + names)
    scripttest.check([row[0] for row in matrix] == names, what + ": names of the matrix")
    scripttest.check_close([row[1:] for row in matrix], correlations, 1e-9, what + ": matrix")


flat = np.array([values.ravel().astype(float) for values in attributes.values()])
compare_scores("complete data", attributes, np.corrcoef(flat))

holes = dict(attributes)
for i, name in enumerate("abcd"):
    holes[name] = np.where(random.random(shape) < 0.1 * i, np.nan, attributes[name])
    holes[name] = holes[name].astype(attributes[name].dtype)
flat = np.array([values.ravel().astype(float) for values in holes.values()])
pairwise = np.ma.corrcoef(np.ma.masked_invalid(flat)).data
# numpy.ma subtracts means of each row alone; the definition is per pair.
for i in range(len(flat)):
    for j in range(len(flat)):
        both = ~np.isnan(flat[i]) & ~np.isnan(flat[j])
        pairwise[i, j] = np.corrcoef(flat[i][both], flat[j][both])[0, 1]
compare_scores("data with holes", holes, pairwise)
sys.stdout.flush()
