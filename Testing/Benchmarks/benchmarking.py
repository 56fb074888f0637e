# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
"""What the benchmarks share: timing in turns, peak memory, the report."""
import os
import platform
import re
import subprocess
import sys
import time

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData

from tfc.vtk import vtkTFCFilters

PEERS = ("numpy", "scipy", "skimage")


class Row:
    """One line of the table: a filter, its peer, and the largest ratio of their times."""

    def __init__(self, name, size, filter, peer, call, limit, bytes_moved):
        self.name, self.size, self.filter = name, size, filter
        self.peer, self.call, self.limit, self.bytes = peer, call, limit, bytes_moved


def timed(action):
    """Seconds that an action takes."""
    start = time.perf_counter()
    action()
    return time.perf_counter() - start


_volumes = {}


def volume(size):
    """The material phantom as (array, image)."""
    if size not in _volumes:
        phantom = vtkTFCFilters.vtkTFCMaterialPhantom()
        phantom.SetDimensions(size, size, size)
        phantom.Update()
        array = phantom.GetOutput().GetPointData().GetArray("intensity")
        values = vtk_to_numpy(array).reshape((size,) * 3).copy()
        image = vtkImageData()
        image.SetDimensions(size, size, size)
        copy = numpy_to_vtk(values.ravel())
        copy.SetName("intensity")
        image.GetPointData().SetScalars(copy)
        _volumes[size] = (values, image)
    return _volumes[size]


def update(filter):
    """Seconds of an update with a new output."""
    filter.Modified()
    # The previous output is not part of this update.
    filter.GetOutputDataObject(0).Initialize()
    return timed(filter.Update)


def median(values):
    return float(np.median(values))


def compare(row, peer, missing, results, repeats, threads):
    """Time a row's filter and its peer in turns; a filter also with one thread, and its memory.

    Short ones are repeated for some seconds: what else the machine does weighs more on them.
    """
    os.environ["TFC_NUM_THREADS"] = str(threads)
    update(row.filter)
    mine, other = [], []
    while len(mine) < repeats or (sum(mine) + sum(other) < 4. and len(mine) < 41):
        mine.append(update(row.filter))
        if peer:
            other.append(peer())
    os.environ["TFC_NUM_THREADS"] = "1"
    single = [update(row.filter) for _ in range(max(1, repeats // 2))]
    os.environ["TFC_NUM_THREADS"] = str(threads)
    results[row.name] = {
        "mine": median(mine), "peer": median(other) if other else None, "missing": missing,
        "single": median(single), "memory": peak_memory(row),
    }


def peak_memory(row):
    """Peak bytes per voxel above those of the input, in a process of its own."""
    run = subprocess.run([sys.executable if "pvpython" in sys.executable else "pvpython",
                          sys.argv[0], sys.argv[1], "--memory", row.name],
                         capture_output=True, text=True, check=False)
    match = re.search(r"peak (\S+)", run.stdout)
    return float(match.group(1)) if match else None


def measure_memory(row):
    """Print the peak memory of one update, in bytes per voxel, without that of the input."""
    os.environ["TFC_NUM_THREADS"] = "2"
    small = volume(16)[1]
    is_source = row.filter.IsA("vtkTFCMaterialPhantom")
    set_up = (lambda n, image: row.filter.SetDimensions(n, n, n)) if is_source else (
        lambda n, image: row.filter.SetInputData(image))
    if not is_source and "occlusion" not in row.name and "size" not in row.name:
        set_up(16, small)
        row.filter.Update()  # libraries are loaded, tables are made
    image = None if is_source else volume(row.size)[1]
    set_up(row.size, image)
    row.filter.Modified()
    before = _status("VmRSS")
    with open("/proc/self/clear_refs", "w") as control:
        control.write("5")
    row.filter.Update()
    print("peak %.1f" % ((_status("VmHWM") - before) * 1024.0 / row.size ** 3))


def _status(key):
    """A value of /proc/self/status in KiB."""
    with open("/proc/self/status") as status:
        return int(re.search(key + r":\s+(\d+)", status.read()).group(1))


def format_line(row, result, triad):
    """A line of the table in Markdown."""
    ratio = result["mine"] / result["peer"] if result["peer"] else None
    bandwidth = ""
    if row.bytes:
        bandwidth = "%.0f %%" % (100.0 * row.bytes * row.size ** 3 / result["mine"] / 1e9 / triad)
    return "| %s | %.0f | %s | %s | %s | %s | %.2f | %s | %s |" % (
        "%s, %d^3" % (row.name, row.size), 1e3 * result["mine"],
        row.peer if result["peer"] else "%s: %s" % (row.peer, result["missing"]),
        "%.0f" % (1e3 * result["peer"]) if result["peer"] else "",
        "**%.3f**" % ratio if ratio else "", row.limit or "",
        result["single"] / result["mine"], bandwidth,
        "%.1f" % result["memory"] if result["memory"] is not None else "")


def too_slow(rows, results):
    """Names of the rows whose ratio is above the limit."""
    return [row.name for row in rows if row.limit and results.get(row.name, {}).get("peer")
            and results[row.name]["mine"] / results[row.name]["peer"] > row.limit]


def versions(peers):
    """What took part, in one line."""
    parts = ["Python " + platform.python_version()]
    for name in PEERS:
        try:
            parts.append("%s %s" % (name, __import__(name).__version__))
        except ImportError:
            parts.append(name + " missing")
    itk = subprocess.run([peers, "version"], capture_output=True, text=True, check=False)
    parts.append("ITK " + (itk.stdout.strip() if itk.returncode == 0 else "missing"))
    return ", ".join(parts)


def processor():
    with open("/proc/cpuinfo") as info:
        text = info.read()
    name = re.search(r"model name\s*: (.*)", text)
    level = next((f for f in ("avx512f", "avx2") if f in text), "baseline")
    return "%s (%s)" % (name.group(1) if name else platform.machine(), level)


def report(rows, results, triad, threads, repeats, peers):
    """The section of RESULTS.md."""
    lines = [
        "%s, %d threads, median of %d or more, %s. Triad: %.0f GB/s." % (
            processor(), threads, repeats, time.strftime("%Y-%m-%d"), triad),
        versions(peers) + ".", "",
        "| filter | ms | peer | ms | ratio | at most | 1 / 2 threads | of the triad | B/voxel |",
        "| --- | ---: | --- | ---: | ---: | ---: | ---: | ---: | ---: |",
    ]
    lines += [format_line(row, results[row.name], triad) for row in rows if row.name in results]
    return "\n".join(lines) + "\n"


def write_section(path, name, text):
    """Replace the section of one benchmark in RESULTS.md, between its markers."""
    begin, end = "<!-- begin %s -->\n" % name, "<!-- end %s -->\n" % name
    with open(path) as old:
        content = old.read()
    if begin not in content:
        content += "\n## %s\n\n%s%s" % (name.capitalize(), begin, end)
    head, rest = content.split(begin)
    tail = rest.split(end)[1]
    with open(path, "w") as new:
        new.write(head + begin + text + end + tail)
