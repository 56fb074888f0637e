# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
"""Time per mouse event while a region is dragged in the editor, for volumes of several sizes.

    pvpython editor.py PEERS --output RESULTS.md

Plays a drag of 60 events back in ParaView's window. The time is that of everything but drawing: the
edit, its way into the representation's property, and all that the panel computes, with the
histogram of the region's voxels. The peer counts that histogram over the voxels with NumPy, as an
editor without a joint histogram would at every event.
"""
import argparse
import os
import re
import subprocess
import sys
import tempfile
import time

import benchmarking
import numpy as np

from tfc import plugin

SIZES = (64, 128, 256)
EVENTS = 60
PANEL = "pqClientMainWindow/pqTFCPanel"
CHART = PANEL + "/contents/Splitter/ChartPart/Chart"
LIST = PANEL + "/contents/Splitter/ListPart/List"

SESSION = """
from paraview.simple import *
source = MaterialPhantom(Dimensions=[{size}] * 3)
gradient = VolumeGradientMagnitude(Input=source, InputArray=["POINTS", "intensity"])
display = Show(gradient)
display.SetRepresentationType("Combined Volume")
import tfc
tf = tfc.TransferFunction("intensity", "intensity_gradient")
region = tf.add_ellipse((0.45, 0.5), (0.6, 0.3), opacity=0.1)
region.tertiary("material", [(0, 1), (5, 1)])
display.TransferFunction = tf.to_json()
SetActiveSource(gradient)
Render()
"""


def event(target, command, arguments):
    return '  <pqevent object="%s" command="%s" arguments="%s" />' % (target, command, arguments)


def check(name, value):
    return '  <pqcheck object="%s" property="%s" arguments="%s" />' % (PANEL, name, value)


def playback(size):
    """The drag. The first checks fetch the histograms, the last one fails and so prints."""
    lines = [check("voxelsInPlane", size ** 3),
             event(LIST, "setCurrent", "0.0"),
             check("voxelsInPlane", size ** 3),
             event(CHART, "mousePress", "(0.5,0.5,1,1,0)")]
    lines += [event(CHART, "mouseMove", "(%.3f,0.5,0,1,0)" % (0.5 + 0.002 * i))
              for i in range(EVENTS)]
    lines += [event(CHART, "mouseRelease", "(0.62,0.5,1,0,0)"), check("millisecondsPerEvent", "?")]
    return "\n".join(['<?xml version="1.0" ?>', "<pqevents>"] + lines + ["</pqevents>"])


def measure(size, folder):
    """Milliseconds per event."""
    script = os.path.join(folder, "session.py")
    with open(script, "w", encoding="ascii") as file:
        file.write(SESSION.format(size=size))
    events = os.path.join(folder, "events.xml")
    with open(events, "w", encoding="ascii") as file:
        file.write(playback(size))
    library = next(path for path in plugin._candidates() if os.path.exists(path))
    result = subprocess.run(
        ["paraview", "--dr", "--plugin-search-paths=" + os.path.dirname(library),
         "--plugins=TransferFunctionCombinations", "--script=" + script,
         "--test-script=" + events, "--exit"],
        env=dict(os.environ, DASHBOARD_TEST_FROM_CTEST="1"), capture_output=True, text=True,
        timeout=600, check=False)
    output = result.stdout + result.stderr
    found = re.search(r"property value is: ([0-9.e+-]+)\. Expecting: \?", output)
    if not found:
        sys.exit("the drag was not played back:\n" + output[-4000:])
    return float(found.group(1))


def brute_force(size):
    """Milliseconds for the histogram of a region over the voxels, weighted."""
    values, _ = benchmarking.volume(size)
    bins = np.clip(((values - values.min()) / np.ptp(values) * 128).astype(np.int32), 0, 127)
    cells = (bins * 128 + bins[::-1]).ravel()
    tertiary = values.ravel()
    weights = np.linspace(0, 1, 128 * 128)
    return 1e3 * benchmarking.median([
        benchmarking.timed(lambda: np.histogram(tertiary, 64, weights=weights[cells]))
        for _ in range(3)])


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("peers", nargs="?", help="not used here")
    parser.add_argument("--output", default="")
    options, _ = parser.parse_known_args()
    lines = [
        "%s, one drag of %d events per size, mean, without drawing, %s." % (
            benchmarking.processor(), EVENTS, time.strftime("%Y-%m-%d")), "",
        "| voxels | ms per event | histogram by NumPy | ms | ratio |",
        "| --- | ---: | --- | ---: | ---: |",
    ]
    with tempfile.TemporaryDirectory() as folder:
        for size in SIZES:
            mine, theirs = measure(size, folder), brute_force(size)
            lines.append("| %d^3 | %.2f | over all voxels | %.1f | **%.4f** |" % (
                size, mine, theirs, mine / theirs))
    print("\n".join(lines))
    if options.output:
        benchmarking.write_section(options.output, "editor", "\n".join(lines) + "\n")


main()
