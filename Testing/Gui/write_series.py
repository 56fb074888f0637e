# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
"""Writes a time series for the tests of the GUI: series.pvd with three steps of 8 x 8 x 8 points.

    python3 write_series.py FOLDER

At every step: a = index of the column, 0 to 7, plus the step; b = index of the row. So in each step
64 points have a given value of a, and the range of a moves by 1.
"""
import os
import sys

SIZE = 8
STEPS = 3


def array(name, values):
    """A point array as XML."""
    return '<DataArray type="Float64" Name="%s" format="ascii">%s</DataArray>' % (
        name, " ".join(str(v) for v in values))


def main():
    folder = sys.argv[1]
    extent = "0 %d " % (SIZE - 1) * 3
    points = [(i, j) for _ in range(SIZE) for j in range(SIZE) for i in range(SIZE)]
    files = ""
    for step in range(STEPS):
        name = "series_%d.vti" % step
        files += '<DataSet timestep="%d" part="0" file="%s"/>' % (step, name)
        with open(os.path.join(folder, name), "w", encoding="ascii") as image:
            image.write('<VTKFile type="ImageData" version="1.0" byte_order="LittleEndian">'
                        '<ImageData WholeExtent="%s" Origin="0 0 0" Spacing="1 1 1">'
                        '<Piece Extent="%s"><PointData>%s%s</PointData><CellData/></Piece>'
                        '</ImageData></VTKFile>\n' % (
                            extent, extent, array("a", (i + step for i, _ in points)),
                            array("b", (j for _, j in points))))
    with open(os.path.join(folder, "series.pvd"), "w", encoding="ascii") as collection:
        collection.write('<VTKFile type="Collection" version="0.1" byte_order="LittleEndian">'
                         '<Collection>%s</Collection></VTKFile>\n' % files)


main()
