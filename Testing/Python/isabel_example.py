# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
"""Plugin/Examples/isabel.py on a synthetic storm in the contest's file format."""
import gzip
import importlib
import os
import sys
import tempfile

import numpy as np
import pictures
import scripttest

from paraview import servermanager, simple

import tfc

sys.dont_write_bytecode = True
sys.path.insert(0, os.environ["TFC_EXAMPLES"])
import isabel

check = scripttest.check
DIMENSIONS = (64, 60, 40)
LAND = (slice(0, 12), slice(0, 25), slice(0, 20))  # z, y, x


def make_storm():
    """Variables [z, y, x] in the units of the contest, 1e35 on "land"."""
    x, y, z = (np.linspace(0, length, n) for length, n in zip(isabel.EXTENT_KM, DIMENSIONS))
    z, y, x = np.meshgrid(z, y - 1000, x - 1200, indexing="ij")
    r = np.hypot(x, y)
    pressure = -5400 * np.exp(-r / 150) * np.exp(-(z / 9) ** 2) + 300 * (1 - np.exp(-r / 600))
    temperature = 29 - 6.3 * z + 6 * np.exp(-(r / 100) ** 2)
    spiral = 0.5 + 0.5 * np.cos(3 * np.arctan2(y, x) + r / 90)
    vapour = 0.022 * np.exp(-z / 2.8) * (0.65 + 0.4 * spiral)
    storm = dict(zip(isabel.VARIABLES, (pressure, temperature, vapour)))
    for values in storm.values():
        values[LAND] = 1e35
    return {name: values.astype(np.float32) for name, values in storm.items()}


def write(folder, storm, compressed):
    """The storm as the contest's files."""
    for name, values in storm.items():
        path = os.path.join(folder, name + "f30.bin")
        data = values.astype(">f4").tobytes()
        with gzip.open(path + ".gz", "wb", 1) if compressed else open(path, "wb") as file:
            file.write(data)


def load_storm(folder):
    """Arrays [z, y, x] that the example's source gives."""
    data = servermanager.Fetch(isabel.make_source(folder, DIMENSIONS))
    check(data.GetDimensions() == DIMENSIONS, "dimensions")
    return {name: scripttest.volume(data, name) for name in isabel.VARIABLES}, data


def fails(folder, words, dimensions=DIMENSIONS):
    """Expect an error that has the words, as an exception or in what ParaView reports."""
    try:
        isabel.read_part(isabel.find_file(folder, "P", 30), dimensions, [0, 1, 0, 1, 0, 1])
    except (OSError, ValueError) as error:
        check(all(word in str(error) for word in words), "error: %s" % error)
    else:
        check(False, "expected an error with %s" % (words,))


def run():
    """The test."""
    storm = make_storm()
    with tempfile.TemporaryDirectory() as folder:
        plain = os.path.join(folder, "plain")
        compressed = os.path.join(folder, "compressed")
        empty = os.path.join(folder, "empty")
        for path in (plain, compressed, empty):
            os.mkdir(path)
        write(plain, storm, compressed=False)
        write(compressed, storm, compressed=True)

        for path in (plain, compressed):
            loaded, data = load_storm(path)
            for name, values in storm.items():
                expected = np.where(values > 1e34, np.nan, values)
                check(np.array_equal(loaded[name], expected, equal_nan=True), name + " as written")
            check(np.allclose(data.GetSpacing(), [2139 / 63, 2004 / 59, 19.8 * 20 / 39]), "spacing")
        check(int(np.isnan(loaded["P"]).sum()) == 12 * 25 * 20, "land is NaN")
        fails(empty, ("Pf30.bin", "vis2004contest"))
        fails(plain, ("629760 bytes", "found 614400", "--dims"),
              (64, 60, 41))
        fails(compressed, ("found more", "--dims"), (64, 60, 39))

        # The whole script.
        tfc.load_plugin()
        path = os.path.join(folder, "isabel.png")
        options = ["--dims", *map(str, DIMENSIONS), "--size", "240", "180"]
        isabel.main([plain, path, *options])
        picture = pictures.read(path)
        hues = pictures.count_hues(picture, (0.05, 0.06, 0.09))
        print(hues)
        check(picture.shape == (180, 240, 3), "size of the picture")
        check(min(hues.values()) >= 100, "eye, inner, outer and blue bands are visible: %s" % hues)
        state = os.path.join(os.environ["TFC_EXAMPLES"], "isabel.tfc.json")
        again = os.path.join(folder, "again.png")
        isabel.main([compressed, again, *options, "--state", state])
        check(pictures.difference(picture, pictures.read(again)) == 0,
              "the state file and the compressed files give the same picture")

        # From above with land through the whole height: nothing is drawn there.
        for values in storm.values():
            values[:, LAND[1], LAND[2]] = 1e35
        write(plain, storm, compressed=False)
        view = pictures.make_view()
        source = isabel.make_source(plain, DIMENSIONS)
        tf = tfc.TransferFunction(
            "P", "TC", primary_range=(-6000, 6000), secondary_range=(-120, 60))
        tf.add_rectangle((0, -30), (6000, 90), falloff="constant")
        tfc.show(source, tf, view, unit_distance=5.0, shade=False)
        view.CameraParallelProjection = 1
        view.CameraFocalPoint = [1069.5, 1002, 0]
        view.CameraPosition = [1069.5, 1002, 3000]
        view.CameraViewUp = [0, 1, 0]
        view.CameraParallelScale = 1002
        picture = pictures.capture(view).max(axis=2)  # rows from the bottom, 16.7 km a pixel
        left = (pictures.SIZE[0] - 2139 / 2004 * pictures.SIZE[1]) / 2
        scale = pictures.SIZE[1] / 2004
        columns = [int(left + scale * 2139 / 63 * i) for i in (0, 19, 21, 63)]
        rows = [int(scale * 2004 / 59 * i) for i in (0, 24, 26, 59)]
        land = picture[:rows[1], columns[0]:columns[1]]
        check(float(land.max()) == 0, "nothing is drawn over land")
        north = picture[rows[2] + 1:rows[3], columns[0] + 2:columns[3]]
        check(float(north.min()) > 200, "everything is drawn north of it")
        east = picture[2:rows[3], columns[2] + 1:columns[3]]
        check(float(east.min()) > 200, "everything is drawn east of it")


if __name__ == "__main__":
    # ParaView runs a programmable source's script in __main__ and puts NumPy's names there: be
    # another module.
    importlib.import_module("isabel_example").run()
