# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
"""The advice about attributes against NumPy, as ratios of medians measured in one run.

usage: pvpython advice.py PEERS_PROGRAM [--repeats N] [--only ROW;...] [--output FILE]

Six attributes of 256^3 floats. Filter and peer take turns, so that both see the same machine.
"""
import argparse
import os
import sys
import time

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData

import benchmarking
from benchmarking import timed, update
from tfc.vtk import vtkTFCFilters

THREADS = 2
SIZE = 256
NAMES = "abcdef"


def attributes():
    """Six arrays of floats, some of which depend on others, and the image that has them."""
    x = benchmarking.volume(SIZE)[0]
    noise = np.random.default_rng(1)
    gradient = sum(np.gradient(x, axis=axis) ** 2 for axis in range(3)) ** 0.5
    mean = (x + np.roll(x, 1, 0) + np.roll(x, 1, 1) + np.roll(x, 1, 2)) / 4
    arrays = [x, gradient, mean, (x - mean) ** 2, np.cumsum(x, axis=0),
              noise.standard_normal(x.shape)]
    arrays = [np.ascontiguousarray(a, dtype=np.float32).ravel() for a in arrays]
    image = vtkImageData()
    image.SetDimensions(SIZE, SIZE, SIZE)
    for name, values in zip(NAMES, arrays):
        array = numpy_to_vtk(values)
        array.SetName(name)
        image.GetPointData().AddArray(array)
    return arrays, image


def numpy_scores(arrays):
    """What the score needs, in NumPy: correlations, and entropies of 256 bins."""
    np.corrcoef(arrays)
    for values in arrays:
        counts = np.histogram(values, 256)[0]
        p = counts[counts > 0] / values.size
        -(p * np.log2(p)).sum()


def make_scores(image, information):
    scores = vtkTFCFilters.vtkTFCCombinationScore()
    scores.SetInputData(image)
    scores.SetPrimary("a")
    scores.SetSecondary("b")
    scores.SetMeasureInformation(information)
    return scores


def make_joint(image, tertiary):
    joint = vtkTFCFilters.vtkTFCJointHistogram()
    joint.SetInputData(image)
    for axis, name in enumerate("abe" if tertiary else "ab"):
        joint.SetArray(axis, name)
    return joint


ROWS = [  # name, the filter, what it is compared with, the largest ratio
    ("scores, 6 attributes", lambda image: make_scores(image, False),
     "numpy.corrcoef and numpy.histogram", 0.15),
    ("scores and information, 4 tertiaries", lambda image: make_scores(image, True),
     "scores, 6 attributes", 3.0),
    ("joint histogram, 256^3 bins", lambda image: make_joint(image, True),
     "numpy.corrcoef and numpy.histogram", None),
]


def measure_memory(name):
    """Print the peak memory of one update beside the input, in percent of the input."""
    image = attributes()[1]
    filter = next(row[1] for row in ROWS if row[0] == name)(image)
    small = vtkImageData()
    small.SetDimensions(2, 2, 2)
    for n in NAMES:
        array = numpy_to_vtk(np.arange(8, dtype=np.float32), deep=1)
        array.SetName(n)
        small.GetPointData().AddArray(array)
    filter.SetInputData(small)
    filter.Update()  # libraries are loaded, threads have run
    filter.SetInputData(image)
    before = benchmarking._status("VmRSS")
    with open("/proc/self/clear_refs", "w") as control:
        control.write("5")
    filter.Update()
    extra = 1024.0 * (benchmarking._status("VmHWM") - before)
    print("peak %.3f" % (100 * extra / (4.0 * len(NAMES) * SIZE ** 3)))


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("peers")
    parser.add_argument("--repeats", type=int, default=5)
    parser.add_argument("--only", default="")
    parser.add_argument("--output", default="")
    parser.add_argument("--memory", default="")
    options = parser.parse_args()
    os.environ["TFC_NUM_THREADS"] = str(THREADS)
    if options.memory:
        measure_memory(options.memory)
        return
    only = [name for name in options.only.split(";") if name]
    arrays, image = attributes()
    filters = {row[0]: row[1](image) for row in ROWS}
    peer = ROWS[0][2]
    times = {name: [] for name in list(filters) + [peer]}
    for turn in range(options.repeats + 1):
        found = {name: update(filter) for name, filter in filters.items()}
        found[peer] = timed(lambda: numpy_scores(arrays))
        for name, seconds in found.items():
            times[name] += [seconds] if turn else []  # the first one warms up
    lines = [
        "%s, %d threads, 6 attributes of %d^3 floats, median of %d, %s." % (
            benchmarking.processor(), THREADS, SIZE, options.repeats, time.strftime("%Y-%m-%d")),
        benchmarking.versions(options.peers) + ".", "",
        "| filter | ms | compared with | ms | ratio | at most | peak memory, % of the input |",
        "| --- | ---: | --- | ---: | ---: | ---: | ---: |",
    ]
    failed = []
    for name, _, other, limit in ROWS:
        if only and name not in only:
            continue
        mine, theirs = benchmarking.median(times[name]), benchmarking.median(times[other])
        memory = benchmarking.peak_memory(benchmarking.Row(name, SIZE, None, "", "", None, 0))
        lines.append("| %s | %.0f | %s | %.0f | **%.3f** | %s | %s |" % (
            name, 1e3 * mine, other, 1e3 * theirs, mine / theirs, limit or "",
            "%.2f" % memory if memory is not None else ""))
        failed += [name] if limit and mine / theirs > limit else []
    print("\n".join(lines))
    if options.output:
        benchmarking.write_section(options.output, "advice", "\n".join(lines) + "\n")
    for name in failed:
        print("above the limit: " + name)
    sys.exit(1 if failed else 0)


main()
