# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
"""The Gaussian variant of the size filter against SciPy's Laplacian of Gaussian, and against the
blobs of scikit-image where it is installed.
"""
import sys

import scripttest

try:
    import numpy as np
    import scipy.ndimage
except ImportError as error:
    scripttest.skip("needs SciPy (Debian: python3-scipy): %s" % error)

from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from tfc.vtk.vtkTFCFilters import vtkTFCFeatureSize

SHAPE = (60, 64, 68)
SMALLEST, LARGEST, SCALES, THRESHOLD = 3.0, 14.0, 10, 0.15
random = np.random.default_rng(11)


def scene():
    """Smooth blobs of several sizes and contrasts, and noise."""
    z, y, x = np.mgrid[:SHAPE[0], :SHAPE[1], :SHAPE[2]].astype(float)
    values = 0.02 * random.normal(size=SHAPE)
    for cx, cy, cz, r, h in ((15, 16, 14, 4, 0.9), (44, 20, 18, 7, 1.0), (22, 46, 38, 10, 0.7),
                             (52, 48, 42, 5.5, 0.8), (50, 50, 12, 4.5, 0.6)):
        distance = np.sqrt((x - cx) ** 2 + (y - cy) ** 2 + (z - cz) ** 2)
        values += h / (1 + np.exp((distance - r) / 0.7))
    return values.astype(np.float32)


def peer(values):
    """Maxima of -sigma^2 LoG over space and scale: voxel, sigma between scales, response."""
    ratio = (LARGEST / SMALLEST) ** (1 / (SCALES - 1))
    sigmas = SMALLEST / np.sqrt(3) * ratio ** np.arange(-1.0, SCALES + 1)
    scaled = (values - values.min()) / np.ptp(values)
    stack = np.array([-s ** 2 * scipy.ndimage.gaussian_laplace(scaled, s, mode="reflect",
                                                               truncate=6) for s in sigmas])
    top = (stack == scipy.ndimage.maximum_filter(stack, 3)) & (stack > THRESHOLD)
    found = []
    for s, z, y, x in np.argwhere(top[1:-1]):
        low, center, high = stack[s:s + 3, z, y, x]
        offset = 0.5 * (high - low) / (2 * center - low - high)
        found.append((x, y, z, sigmas[s + 1] * ratio ** offset,
                      center + 0.25 * (high - low) * offset))
    return np.array(found)


def wendland(q):
    return np.where(q < 1, (1 - q) ** 4 * (4 * q + 1), 0)


values = scene()
expected = peer(values)
image = vtkImageData()
image.SetDimensions(SHAPE[::-1])
array = numpy_to_vtk(values.ravel(), deep=1)
array.SetName("a")
image.GetPointData().AddArray(array)
size = scripttest.make(vtkTFCFeatureSize, ScaleSpace=vtkTFCFeatureSize.GAUSSIAN,
                       SmallestSize=SMALLEST, LargestSize=LARGEST, NumberOfScales=SCALES,
                       Threshold=THRESHOLD)
size.SetInputData(image)
size.SetInputArrayToProcess(0, 0, 0, 0, "a")
size.Update()
blobs = size.GetBlobs()
points = vtk_to_numpy(blobs.GetPoints().GetData())
columns = {name: vtk_to_numpy(blobs.GetPointData().GetArray(name))
           for name in ("size", "scale", "response")}

scripttest.check(len(expected) >= 5, "the peer finds %d blobs" % len(expected))
strong = expected[expected[:, 4] > 1.1 * THRESHOLD]
for x, y, z, sigma, response in strong:
    near = np.argmin(((points - (x, y, z)) ** 2).sum(axis=1))
    where = "blob at %d %d %d" % (x, y, z)
    scripttest.check_close(points[near] - (x, y, z) + 10, [10, 10, 10], 0.1, where + ": place")
    scripttest.check_close(columns["scale"][near], sigma, 0.03, where + ": sigma")
    scripttest.check_close(columns["response"][near], response, 0.03, where + ": response")
weak = columns["response"] > 1.1 * THRESHOLD
scripttest.check(int(weak.sum()) == len(strong),
                 "%d strong blobs, the peer has %d" % (weak.sum(), len(strong)))
scripttest.check_close(columns["size"], np.sqrt(3) * columns["scale"], 1e-6, "radii")

# scikit-image's detector, where it is installed: whole voxels, and no fit between scales.
try:
    from skimage.feature import blob_log
except ImportError as error:
    print("scikit-image (Debian: python3-skimage) is not compared with: %s" % error)
else:
    scaled = ((values - values.min()) / np.ptp(values)).astype(float)
    found = blob_log(scaled, min_sigma=SMALLEST / np.sqrt(3), max_sigma=LARGEST / np.sqrt(3),
                     num_sigma=SCALES, threshold=1.1 * THRESHOLD, log_scale=True, overlap=1)
    step = (LARGEST / SMALLEST) ** (1 / (SCALES - 1))
    scripttest.check(len(found) >= 5, "scikit-image finds %d blobs" % len(found))
    for bz, by, bx, sigma in found:
        near = np.argmin(((points - (bx, by, bz)) ** 2).sum(axis=1))
        where = "scikit-image's blob at %d %d %d" % (bx, by, bz)
        scripttest.check(np.abs(points[near] - (bx, by, bz)).max() <= 1, where + ": place")
        scripttest.check(1 / step <= columns["scale"][near] / sigma <= step, where + ": sigma")
    scripttest.check(int(weak.sum()) == len(found),
                     "%d strong blobs, scikit-image has %d" % (weak.sum(), len(found)))

# Back projection: blobs of distinct scales, so that each is a scale of its own.
z, y, x = np.mgrid[:SHAPE[0], :SHAPE[1], :SHAPE[2]].astype(float)
ratio = (LARGEST / SMALLEST) ** (1 / (SCALES - 1))
level = np.rint(np.log(columns["size"] / SMALLEST) / np.log(ratio))
result = np.zeros(SHAPE)
for which in np.unique(level):
    weighted, weights = np.zeros(SHAPE), np.zeros(SHAPE)
    for (px, py, pz), radius in zip(points[level == which], columns["size"][level == which]):
        q = np.sqrt((x - px) ** 2 + (y - py) ** 2 + (z - pz) ** 2) / radius
        weighted += radius * wendland(q)
        weights += wendland(q)
    with np.errstate(invalid="ignore"):
        result = np.fmax(result, np.where(weights > 0, weighted / weights, 0))
actual = scripttest.volume(size.GetOutput(), "a_size")
agree = np.isclose(actual, result, rtol=1e-4)
# At the very rim of a support rounding decides, and at the middle of two scales the level.
scripttest.check(agree.mean() > 0.995, "sizes agree at %.4f of the voxels" % agree.mean())
sys.stdout.flush()
