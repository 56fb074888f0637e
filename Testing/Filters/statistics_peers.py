# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
"""Growing spheres against a reference in double precision with SciPy's distributions."""
import math
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
from tfc.vtk.vtkTFCFilters import vtkTFCLocalStatistics, vtkTFCMaterialPhantom

random = np.random.default_rng(11)
SUFFIXES = ("_mean", "_stddev", "_radius", "_skewness", "_kurtosis")


def offsets(shape, spacing, radius):
    """The shells: arrays of offsets (z, y, x), and the step of growth."""
    step = min(s for s, n in zip(spacing, shape) if n > 1)
    last = int(math.floor(radius / step * (1 + 1e-9)))
    reach = [min(n - 1, int(last * step / s * (1 + 1e-9))) for s, n in zip(spacing, shape)]
    points = np.stack(np.meshgrid(*[np.arange(-r, r + 1) for r in reach], indexing="ij"), -1)
    points = points.reshape(-1, 3)
    length = np.sqrt(((points * spacing) ** 2).sum(1)) / step
    shell = np.maximum(np.ceil(length / (1 + 1e-9)).astype(int), 1)
    return [points[shell == k] for k in range(1, last + 1)], step


def k_squared(n, m2, m3, m4):
    """D'Agostino's K^2 of arrays. Not scipy.stats.normaltest, which changes symmetric samples."""
    with np.errstate(all="ignore"):
        y = m3 / m2 ** 1.5 * np.sqrt((n + 1) * (n + 3) / (6 * (n - 2)))
        beta2 = (3 * (n * n + 27 * n - 70) * (n + 1) * (n + 3)
                 / ((n - 2) * (n + 5) * (n + 7) * (n + 9)))
        w2 = -1 + np.sqrt(2 * (beta2 - 1))
        z1 = np.arcsinh(y / np.sqrt(2 / (w2 - 1))) / np.sqrt(0.5 * np.log(w2))
        mean = 3 * (n - 1) / (n + 1)
        variance = 24 * n * (n - 2) * (n - 3) / ((n + 1) ** 2 * (n + 3) * (n + 5))
        x = (m4 / m2 ** 2 - mean) / np.sqrt(variance)
        b = (6 * (n * n - 5 * n + 2) / ((n + 7) * (n + 9))
             * np.sqrt(6 * (n + 3) * (n + 5) / (n * (n - 2) * (n - 3))))
        a = 6 + 8 / b * (2 / b + np.sqrt(1 + 4 / b ** 2))
        z2 = ((1 - 2 / (9 * a) - np.cbrt((1 - 2 / a) / (1 + x * np.sqrt(2 / (a - 4)))))
              / np.sqrt(2 / (9 * a)))
    return np.where(m2 > 0, z1 ** 2 + z2 ** 2, 0)


def central(n, sums):
    """Mean and central moments from sums of powers about the voxel's value."""
    e1, e2, e3, e4 = (s / n for s in sums)
    m2 = np.maximum(e2 - e1 ** 2, 0)
    m3 = e3 - 3 * e1 * e2 + 2 * e1 ** 3
    m4 = e4 - 4 * e1 * e3 + 6 * e1 ** 2 * e2 - 3 * e1 ** 4
    return e1, np.where(m2 > 1e-14 * e2, m2, 0), m3, m4


def similar(inner, shell, alpha):
    """Welch's test with SciPy's quantiles; a sample of one borrows the variance of the other."""
    (n1, s1), (n2, s2) = inner, shell
    with np.errstate(all="ignore"):
        mean1, m1 = central(n1, s1)[:2]
        mean2, m2 = central(n2, s2)[:2]
        v1, v2 = m1 * n1 / (n1 - 1), m2 * n2 / (n2 - 1)
        single = (n1 < 2) | (n2 < 2)
        v1, v2 = np.where(n1 < 2, np.where(n2 < 2, 0, v2), v1), np.where(
            n2 < 2, np.where(n1 < 2, 0, v1), v2)
        u, w = v1 / n1, v2 / n2
        freedom = np.where(single, np.maximum(n1 + n2 - 2, 1),
                           (u + w) ** 2 / (u ** 2 / (n1 - 1) + w ** 2 / (n2 - 1)))
        quantile = scipy.stats.t.isf(alpha / 2, np.where(np.isfinite(freedom), freedom, 1))
        close = np.abs(mean1 - mean2) <= quantile * np.sqrt(u + w)
    return np.where(n2 > 0, np.where(u + w > 0, close, mean1 == mean2), True)


def reference(values, spacing, radius, alpha):
    """All voxels at once: what a voxel has stopped with is kept."""
    shells, step = offsets(values.shape, spacing, radius)
    reach = np.max([np.abs(shell).max(0) for shell in shells if len(shell)], axis=0)
    padded = np.pad(values.astype(float), [(r, r) for r in reach], constant_values=np.nan)
    critical = scipy.stats.chi2.isf(alpha, 2)
    count, sums = np.zeros(values.shape), np.zeros((4,) + values.shape)
    radii, alive = np.zeros(values.shape), ~np.isnan(values)
    for k, shell in enumerate(shells, 1):
        n, s = np.zeros(values.shape), np.zeros((4,) + values.shape)
        for offset in shell:
            part = padded[tuple(slice(r + o, r + o + size) for r, o, size
                                in zip(reach, offset, values.shape))] - values
            valid = ~np.isnan(part)
            part = np.where(valid, part, 0)
            n += valid
            for power in range(4):
                s[power] += part ** (power + 1)
        if k > 1:
            with np.errstate(all="ignore"):
                normal = k_squared(count + n, *central(count + n, sums + s)[1:]) < critical
            alive &= (normal | (count + n < 8)) & similar((count, sums), (n, s), alpha)
        count = np.where(alive, count + n, count)
        sums = np.where(alive, sums + s, sums)
        radii = np.where(alive, k, radii)
    with np.errstate(all="ignore"):
        mean, m2, m3, m4 = central(count, sums)
        deviation = np.where(count > 1, np.sqrt(m2 * count / (count - 1)), 0)
        skewness = np.where(m2 > 0, m3 / m2 ** 1.5, 0)
        kurtosis = np.where(m2 > 0, m4 / m2 ** 2, 3)
    results = [mean + values, deviation, radii * step, skewness, kurtosis]
    return [np.where(np.isnan(values), np.nan, result) for result in results]


def compare(what, values, spacing=(1, 1, 1), radius=6, alpha=0.001, world=False):
    """Spacing in the order z, y, x, as the values."""
    values = values.astype(np.float32) if values.dtype.kind == "f" else values
    data = vtkImageData()
    data.SetDimensions(values.shape[::-1])
    data.SetSpacing(spacing[::-1])
    array = numpy_to_vtk(np.ascontiguousarray(values).ravel(), deep=1)
    array.SetName("a")
    data.GetPointData().AddArray(array)
    filter = scripttest.make(vtkTFCLocalStatistics, MaximumRadius=radius, ConfidenceLevel=alpha,
                             LengthUnit=int(world), Moments=True)
    filter.SetInputData(data)
    filter.SetInputArrayToProcess(0, 0, 0, 0, "a")
    filter.Update()
    results = [scripttest.volume(filter.GetOutput(), "a" + suffix) for suffix in SUFFIXES]
    expected = reference(values.astype(float), spacing if world else (1, 1, 1), radius, alpha)
    what = "%s %s radius %g alpha %g" % (what, values.shape, radius, alpha)
    valid = ~np.isnan(expected[2])
    same = np.abs(results[2] - expected[2]) < 1e-5 * radius
    scripttest.check(bool((np.isnan(results[2]) == ~valid).all()), what + ": NaN")
    share = same[valid].mean()
    mean_radius = expected[2][valid].mean()
    scripttest.check(share >= 0.999, "%s: %.4f %% of %d radii (mean %.2f)"
                     % (what, 100 * share, valid.sum(), mean_radius))
    low, high = float(np.nanmin(values)), float(np.nanmax(values))
    for result, truth, suffix in zip(results, expected, SUFFIXES):
        scale = high - low if suffix in ("_mean", "_stddev") else np.nanmax(np.abs(truth[same]))
        allowed = 1e-5 if suffix in ("_mean", "_stddev", "_radius") else 1e-3
        if suffix == "_mean" and scale:
            # Float holds values that are large next to their range to 6e-8 of themselves.
            allowed += 6e-8 * max(abs(low), abs(high)) / scale
        error = np.nanmax(np.abs(result[same] - truth[same])) / (scale or 1)
        scripttest.check(bool(error <= allowed), "%s: %s error %.1e" % (what, suffix, error))


phantom = scripttest.make(vtkTFCMaterialPhantom, Dimensions=(40, 40, 40))
phantom.Update()
phantom = scripttest.volume(phantom.GetOutput(), "intensity")
for alpha in (0.001, 0.1):
    compare("phantom", phantom, alpha=alpha)
compare("phantom, large spheres", phantom[:21, :23, :30], radius=10)
normal = random.normal(size=(20, 27, 50)).astype(np.float32)
compare("normal", normal)
compare("offset", normal * 2 + 1000, alpha=0.01)
compare("tiny", normal * 1e-8)
compare("uniform", random.uniform(size=(18, 31, 35)), alpha=0.01)
compare("smooth", scipy.ndimage.gaussian_filter(normal, 2), alpha=0.01)
compare("integers", np.round(40 * normal).astype(np.int16) + 100, alpha=0.01)
steps = (np.arange(20)[:, None, None] // 9 + np.arange(34)[None, :, None] // 13
         + np.zeros((20, 34, 30))).astype(np.uint8)
compare("constant regions", steps)
holes = np.where(random.random(normal.shape) < 0.15, np.nan, normal)
holes[5:15, 6:20, 8:30] = np.nan
compare("holes", holes, alpha=0.01)
compare("sparse", np.where(random.random(normal.shape) < 0.95, np.nan, normal), alpha=0.01)
# Beyond the third sphere voxels of a column share sums: up to the second and third batch of them.
for radius, shape in ((10, (16, 17, 36)), (14, (12, 13, 34))):
    box = tuple(slice(n) for n in shape)
    compare("normal", normal[box], radius=radius)
    compare("holes", holes[box], radius=radius, alpha=0.01)
    compare("world, holes", holes[box], spacing=(0.6, 1, 0.8), radius=0.6 * radius, alpha=0.01,
            world=True)
    for shape in ((1, 30, 40), (30, 1, 40), (40, 30, 1), (1, 1, 500), (500, 1, 1), (100, 3, 2)):
        compare("thin", random.normal(size=shape), radius=radius)
compare("sparse", np.where(random.random(normal.shape) < 0.8, np.nan, normal)[box], radius=10)
compare("world", normal[box], spacing=(1.3, 1, 1.7), radius=10, world=True)
levels = 4 * (np.arange(box[1].stop) > 6)[:, None]
compare("two levels", normal[box] + levels, radius=10)
for height in (0, 0.1):
    compare("300 K, deviation 0.01", 300 + 0.01 * normal[box] + height * levels, radius=10)
for shape in ((1, 60, 50), (50, 1, 60), (60, 50, 1), (1, 1, 900), (900, 1, 1), (2, 3, 200)):
    compare("thin", random.normal(size=shape), alpha=0.05)
compare("world", normal, spacing=(2.5, 1, 0.8), radius=6, world=True)
compare("world", normal, spacing=(0.3, 0.7, 0.3), radius=2, alpha=0.01, world=True)
compare("world, thin", normal[:1], spacing=(0.001, 1, 0.8), radius=5, world=True)
compare("world, holes", holes, spacing=(1, 2, 1.5), radius=5, alpha=0.01, world=True)
sys.stdout.flush()
