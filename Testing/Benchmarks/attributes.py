# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
"""The attribute filters against peers, as ratios of medians measured in one run.

usage: pvpython attributes.py PEERS_PROGRAM [--repeats N] [--only ROW,...] [--output FILE]

Filter and peer take turns, so that both see the same machine. A filter is timed as a whole: its
Update(), with the pipeline and the allocation of the output.
"""
import argparse
import os
import subprocess
import sys
import tempfile

import numpy as np

import benchmarking
from benchmarking import PEERS, Row, measure_memory, timed, volume
from tfc.vtk import vtkTFCFilters

THREADS = 2


def make(name, **properties):
    """A filter by class name, with Set...() called for each property; None if there is none."""
    if not hasattr(vtkTFCFilters, name):
        return None
    instance = getattr(vtkTFCFilters, name)()
    for key, value in properties.items():
        getattr(instance, "Set" + key)(value)
    return instance


def ball(radius, length):
    """Indicator of a ball of lattice points around the corner of a periodic lattice."""
    axis = np.minimum(np.arange(length), length - np.arange(length)).astype(float) ** 2
    inside = axis[:, None, None] + axis[None, :, None] + axis[None, None, :] <= radius ** 2
    return inside.astype(np.float32)


def fft_sphere(values, radius):
    """Sums over balls by one convolution with real transforms."""
    import scipy.fft

    n = values.shape[0]
    length = scipy.fft.next_fast_len(n + radius, real=True)
    shape = (length,) * 3
    spectrum = scipy.fft.rfftn(values, shape, workers=THREADS)
    spectrum *= scipy.fft.rfftn(ball(radius, length), workers=THREADS)
    return scipy.fft.irfftn(spectrum, shape, workers=THREADS)[:n, :n, :n]


def fft_moments(values, radius):
    """Sums of four powers over balls of all radii up to one, without any test."""
    import scipy.fft

    n = values.shape[0]
    length = scipy.fft.next_fast_len(n + radius, real=True)
    shape = (length,) * 3
    powers = [scipy.fft.rfftn(values ** p, shape, workers=THREADS) for p in (1, 2, 3, 4)]
    for r in range(1, radius + 1):
        kernel = scipy.fft.rfftn(ball(r, length), workers=THREADS)
        sums = [scipy.fft.irfftn(p * kernel, shape, workers=THREADS) for p in powers]
    return sums


def scipy_peer(name):
    """The peer as a callable on an array; raises ImportError when it is not installed."""
    if name == "uniform_filter":
        import scipy.ndimage

        return lambda v: scipy.ndimage.uniform_filter(v, size=81)
    if name == "blob_log":
        import skimage.feature

        return lambda v: skimage.feature.blob_log(v, min_sigma=2.5 / 3 ** 0.5,
                                                  max_sigma=25 / 3 ** 0.5, num_sigma=10,
                                                  threshold=0.35)
    import scipy.fft  # noqa: F401

    return {"fft_sphere": lambda v: fft_sphere(v, 40),
            "fft_moments": lambda v: fft_moments(v, 6)}[name]


def normals(values):
    np.random.default_rng(1).standard_normal(2 * values.size)


STATISTICS = dict(MaximumRadius=6, ConfidenceLevel=0.001)
ROWS = [
    # name, size, filter, peer's name, how to call it (or another filter), largest ratio, bytes
    # moved per voxel (each pass over memory, with the write allocation of what it writes)
    Row("gradient magnitude", 256, make("vtkTFCGradientMagnitude"),
        "ITK GradientMagnitudeImageFilter", "itk:gradient", 0.08, 12),
    Row("occlusion, box, R = 40", 256, make("vtkTFCOcclusion", Radius=40),
        "scipy.ndimage.uniform_filter, size 81, no g_x", "uniform_filter", 0.15, 28),
    Row("occlusion, box, R = 40, against 4", 256, make("vtkTFCOcclusion", Radius=40),
        "the same at R = 4", make("vtkTFCOcclusion", Radius=4), 1.15, 28),
    Row("occlusion, sphere, R = 40", 256, make("vtkTFCOcclusion", Radius=40, Neighborhood=1),
        "scipy.fft convolution, real, 2 threads", "fft_sphere", 0.8, 39),
    Row("occlusion, sphere, R = 40, against 4", 256,
        make("vtkTFCOcclusion", Radius=40, Neighborhood=1),
        "the same at R = 4", make("vtkTFCOcclusion", Radius=4, Neighborhood=1), 1.15, 39),
    Row("statistics, r <= 6", 256, make("vtkTFCLocalStatistics", **STATISTICS),
        "scipy.fft moments alone, r <= 6", "fft_moments", 0.25, 28),
    Row("statistics, r <= 10", 256,
        make("vtkTFCLocalStatistics", **dict(STATISTICS, MaximumRadius=10)),
        "the same at r <= 6", make("vtkTFCLocalStatistics", **STATISTICS), 2.5, 28),
    Row("feature size, up to 25 voxels", 256, make("vtkTFCFeatureSize"),
        "ITK GradientAnisotropicDiffusion, 5 iterations", "itk:diffusion", 0.25, 781),
    Row("feature size, 10 scales", 128, make("vtkTFCFeatureSize", NumberOfScales=10),
        "skimage.feature.blob_log, 10 scales", "blob_log", 0.1, 744),
    Row("phantom", 256, make("vtkTFCMaterialPhantom"),
        "numpy.random.Generator, as many normals", "normals", 0.5, 10),
]


def run_row(row, peers, results, repeats, folder):
    """Fill results[row.name] with the medians of filter and peer."""
    values, image = volume(row.size)
    if row.filter.IsA("vtkTFCMaterialPhantom"):
        row.filter.SetDimensions(row.size, row.size, row.size)
    else:
        row.filter.SetInputData(image)
    peer, missing = None, None
    if not isinstance(row.call, str):
        row.call.SetInputData(image)
        peer = lambda: benchmarking.update(row.call)
    elif row.call.startswith("itk:"):
        path = os.path.join(folder, "volume%d.raw" % row.size)
        if not os.path.exists(path):
            values.tofile(path)
        command = [peers, row.call[4:], path, str(row.size), str(THREADS), "1"]
        if subprocess.run([peers, "version"], capture_output=True).returncode:
            missing = "ITK is not installed"
        else:
            peer = lambda: float(subprocess.run(
                command, capture_output=True, check=True, text=True).stdout) * 1e-3
    elif row.call == "normals":
        peer = lambda: timed(lambda: normals(values))
    else:
        try:
            function = scipy_peer(row.call)
            peer = lambda: timed(lambda: function(values))
        except ImportError as error:
            missing = "%s is not installed" % (error.name or "").split(".")[0]
    benchmarking.compare(row, peer, missing, results, repeats, THREADS)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("peers")
    parser.add_argument("--repeats", type=int, default=5)
    parser.add_argument("--only", default="")
    parser.add_argument("--output", default="")
    parser.add_argument("--memory", default="")
    options = parser.parse_args()
    if options.memory:
        measure_memory(next(row for row in ROWS if row.name == options.memory))
        return
    triad = [float(x) for x in subprocess.run(
        [options.peers, "triad", str(THREADS), str(options.repeats)], capture_output=True,
        check=True, text=True).stdout.split()]
    results = {}
    only = [name for name in options.only.split(";") if name]
    with tempfile.TemporaryDirectory() as folder:
        for row in ROWS:
            if row.filter is None or (only and row.name not in only):
                continue
            run_row(row, options.peers, results, options.repeats, folder)
            print(benchmarking.format_line(row, results[row.name], float(np.median(triad))))
            sys.stdout.flush()
    report = benchmarking.report(ROWS, results, float(np.median(triad)), THREADS, options.repeats,
                                 options.peers)
    if options.output:
        benchmarking.write_section(options.output, "attributes", report)
    failed = benchmarking.too_slow(ROWS, results)
    for name in failed:
        print("above the limit: " + name)
    sys.exit(1 if failed else 0)


main()
