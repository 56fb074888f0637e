# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
"""Writes what the tests of presets and advice need: volumes of 8 x 8 x 8 points and files.

    python3 write_presets.py FOLDER

one.vti: a, b, d = index of the column, the row, the slice. square.vti: c = square of the column,
and b and d. wide.vti: a = 10 times the column + 5, and b and d. plain.tfc.json: made for x, y and z
of one.vti's values, without quantiles; its region holds 3 columns, 3 rows and all slices.
empty.tfc.json: nothing; comma.tfc.json: a comma too many in line 2, field.tfc.json: a radius below
0, picture.tfc.json: bytes that are no text. advice.vti: see below. In FOLDER/home is a user's
folder of settings with one preset, of a version to come.
"""
import json
import os
import shutil
import sys

SIZE = 8
POINTS = [(i, j, k) for k in range(SIZE) for j in range(SIZE) for i in range(SIZE)]
PLAIN = {
    "format": "transfer-function-combination", "version": 1,
    "primary": {"array": "x", "range": [0, 7]}, "secondary": {"array": "y", "range": [0, 7]},
    "regions": [{
        "id": 1, "name": "middle", "color": [1, 0.5, 0],
        "shape": {"type": "rectangle", "center": [3, 3], "halfsize": [1.5, 1.5]},
        "falloff": {"type": "constant"},
        "tertiary": {"array": "z", "range": [0, 7], "opacity": [[0, 0.5], [7, 1]]}}]}


def write_volume(path, **arrays):
    """An image with point arrays."""
    extent = "0 %d " % (SIZE - 1) * 3
    data = "".join('<DataArray type="Float64" Name="%s" format="ascii">%s</DataArray>' % (
        name, " ".join(str(v) for v in values)) for name, values in arrays.items())
    with open(path, "w", encoding="ascii") as image:
        image.write('<VTKFile type="ImageData" version="1.0" byte_order="LittleEndian">'
                    '<ImageData WholeExtent="%s" Origin="0 0 0" Spacing="1 1 1">'
                    '<Piece Extent="%s"><PointData>%s</PointData><CellData/></Piece>'
                    '</ImageData></VTKFile>\n' % (extent, extent, data))


def main():
    folder = sys.argv[1]
    column, row, depth = ([p[axis] for p in POINTS] for axis in range(3))
    write_volume(os.path.join(folder, "one.vti"), a=column, b=row, d=depth)
    write_volume(os.path.join(folder, "square.vti"), c=[i * i for i in column], b=row, d=depth)
    write_volume(os.path.join(folder, "wide.vti"), a=[10 * i + 5 for i in column], b=row, d=depth)
    # Two attributes that belong together, one that has two separate parts, one that is as varied as
    # can be and independent of the columns, and the columns once more.
    write_volume(os.path.join(folder, "advice.vti"), p=column, q=row,
                 halves=[100 * (k >= 4) + k % 2 for k in depth],
                 varied=[8 * j + k for j, k in zip(row, depth)], again=[3 * i for i in column])
    with open(os.path.join(folder, "plain.tfc.json"), "w", encoding="ascii") as file:
        json.dump(PLAIN, file)
    open(os.path.join(folder, "empty.tfc.json"), "w", encoding="ascii").close()
    with open(os.path.join(folder, "comma.tfc.json"), "w", encoding="ascii") as file:
        file.write('{"format": "transfer-function-combination",\n "version": 1,,\n'
                   ' "regions": []}\n')
    region = dict(PLAIN["regions"][0], shape={"type": "ellipse", "center": [3, 3],
                                              "radii": [1, -1]})
    with open(os.path.join(folder, "field.tfc.json"), "w", encoding="ascii") as file:
        json.dump(dict(PLAIN, regions=[region]), file)
    with open(os.path.join(folder, "picture.tfc.json"), "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n\x00\x00\xff\xfe")
    home = os.path.join(folder, "home")
    shutil.rmtree(home, ignore_errors=True)
    presets = os.path.join(home, ".config", "ParaView", "CombinedTransferFunctions")
    os.makedirs(presets)
    with open(os.path.join(presets, "broken.tfc.json"), "w", encoding="ascii") as file:
        json.dump(dict(PLAIN, version=2), file)


main()
