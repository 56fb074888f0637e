# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
"""Writes volumes of 8 x 8 x 8 points, or cells, of which everything is known.

    python3 write_volumes.py FOLDER

points.vti: a, b, d = index of the column, the row, the slice. others.vti: b, d and c = a.
cells.vti: the same a, b, d of cells. both.vti: p = index of the column of the 9 x 9 x 9 points, and
a, b of the cells. single.vti: a of the cells. bare.vti: no arrays. counts.vti: a = the smaller one
of column and row, b = the slice, at most 3: 15 - 2 a points have given a and b, five times as many
where b is 3. vectors.vti: u = (3, 4, 0) times the column, v = (5, 12, 0) times the slice, w =
(8, 15, 0) times the row, so that lengths are 5, 13 and 17 times that: length_u, length_v, length_w;
v_y is a component. random.vti: 24^3 points with random numbers: a, b = a + noise, c = b + noise,
not independent so that c differs from region to region.
"""
import os
import random
import sys

SIZE = 8
RANDOM_SIZE = 24


def texts(values):
    """Numbers as XML has them."""
    return " ".join("%.17g" % v for v in values)


def write_volume(path, size, points=None, cells=None):
    """An image of size^3 points with arrays of its points and its cells. A value that is a sequence
    makes a vector."""
    def attributes(tag, arrays):
        text = ""
        for name, values in (arrays or {}).items():
            vectors = isinstance(values[0], (list, tuple))
            flat = [v for vector in values for v in vector] if vectors else values
            text += '<DataArray type="Float64" Name="%s" NumberOfComponents="%d" format="ascii">' \
                    '%s</DataArray>' % (name, len(values[0]) if vectors else 1, texts(flat))
        return "<%s>%s</%s>" % (tag, text, tag)

    extent = "0 %d " % (size - 1) * 3
    with open(path, "w", encoding="ascii") as image:
        image.write('<VTKFile type="ImageData" version="1.0" byte_order="LittleEndian">'
                    '<ImageData WholeExtent="%s" Origin="0 0 0" Spacing="1 1 1">'
                    '<Piece Extent="%s">%s%s</Piece></ImageData></VTKFile>\n' % (
                        extent, extent, attributes("PointData", points),
                        attributes("CellData", cells)))


def indices(size):
    """Column, row and slice of all points, or cells."""
    places = [(i, j, k) for k in range(size) for j in range(size) for i in range(size)]
    return [list(index) for index in zip(*places)]


def main():
    def path(name):
        return os.path.join(sys.argv[1], name)

    column, row, depth = indices(SIZE)
    write_volume(path("points.vti"), SIZE, points={"a": column, "b": row, "d": depth})
    write_volume(path("others.vti"), SIZE, points={"c": column, "b": row, "d": depth})
    write_volume(path("cells.vti"), SIZE + 1, cells={"a": column, "b": row, "d": depth})
    write_volume(path("both.vti"), SIZE + 1, points={"p": indices(SIZE + 1)[0]},
                 cells={"a": column, "b": row})
    write_volume(path("single.vti"), SIZE + 1, cells={"a": column})
    write_volume(path("bare.vti"), SIZE)
    write_volume(path("vectors.vti"), SIZE, points={
        "u": [(3 * i, 4 * i, 0) for i in column], "length_u": [5 * i for i in column],
        "v": [(5 * k, 12 * k, 0) for k in depth], "length_v": [13 * k for k in depth],
        "w": [(8 * j, 15 * j, 0) for j in row], "length_w": [17 * j for j in row],
        "v_y": [12 * k for k in depth]})
    numbers = random.Random(1)
    a = [numbers.gauss(0, 1) for _ in range(RANDOM_SIZE ** 3)]
    b = [v + numbers.gauss(0, 1) for v in a]
    write_volume(path("random.vti"), RANDOM_SIZE, points={
        "a": a, "b": b, "c": [v + numbers.gauss(0, 1) for v in b]})
    write_volume(path("counts.vti"), SIZE, points={
        "a": [min(i, j) for i, j in zip(column, row)], "b": [min(k, 3) for k in depth]})


main()
