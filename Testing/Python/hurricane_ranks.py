# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
"""The hurricane on two processes against one: picture, scores and occlusion.

    pvpython hurricane_ranks.py MPIRUN PVBATCH

runs itself by pvbatch on one and on two processes with the arguments --write FOLDER, and compares
what they leave in the folders.
"""
import json
import os
import sys
import tempfile

import pictures
import scripttest

from vtkmodules.vtkIOXML import vtkXMLPImageDataReader

SIZE = (320, 240)
PICTURE_TOLERANCE = 0.5  # mean difference, of 255
VALUE_TOLERANCE = 1e-5


def write(folder, data):
    """Picture, scores and occlusion by this process and those beside it."""
    sys.dont_write_bytecode = True
    sys.path.insert(0, os.environ["TFC_EXAMPLES"])
    import hurricane
    from paraview import servermanager, simple

    import tfc

    hurricane.main(data, os.path.join(folder, "picture.png"), size=SIZE)
    source = simple.OpenDataFile(data)
    with open(os.path.join(folder, "scores.json"), "w") as file:
        json.dump(tfc.score(source, primary="P", secondary="TC"), file)
    occlusion = simple.VolumeOcclusion(Input=source, InputArray=["POINTS", "QVAPOR"])
    # A file of pieces: Fetch() does not join the pieces of an image.
    simple.SaveData(os.path.join(folder, "occlusion.pvti"), occlusion, DataMode="Binary",
                    ChooseArraysToWrite=1, PointDataArrays=["QVAPOR_occlusion"])
    processes = servermanager.ActiveConnection.GetNumberOfDataPartitions()
    with open(os.path.join(folder, "processes"), "w") as file:
        file.write(str(processes))


def read(folder):
    """What write() left: picture, rows of scores by attribute, occlusion, number of processes."""
    with open(os.path.join(folder, "scores.json")) as file:
        rows = {row[0]: row[1:] for row in json.load(file)}
    with open(os.path.join(folder, "processes")) as file:
        processes = int(file.read())
    reader = vtkXMLPImageDataReader()
    reader.SetFileName(os.path.join(folder, "occlusion.pvti"))
    reader.Update()
    occlusion = scripttest.volume(reader.GetOutput(), "QVAPOR_occlusion")
    return pictures.read(os.path.join(folder, "picture.png")), rows, occlusion, processes


def compare(one, two):
    """The three results of one process and of two."""
    check = scripttest.check
    check(one[3] == 1 and two[3] == 2, "one and two processes")
    check(one[1].keys() == two[1].keys() and len(one[1]) >= 3, "the same attributes are scored")
    for name, row in one[1].items():
        scripttest.check_close(two[1][name], row, VALUE_TOLERANCE, "score of " + name)
    scripttest.check_close(two[2], one[2], VALUE_TOLERANCE, "occlusion")
    check(float(one[0].max()) > 100, "something is visible")
    difference = pictures.difference(one[0], two[0])
    check(difference <= PICTURE_TOLERANCE, "picture: mean difference %.3f/255 <= %.1f/255"
          % (difference, PICTURE_TOLERANCE))


def main():
    data = scripttest.data_file("sim_cm1_hurricane.vti")
    if sys.argv[1] == "--write":
        write(sys.argv[2], data)
        return
    launcher, program = sys.argv[1:]
    results = []
    with tempfile.TemporaryDirectory() as parent:
        for ranks in (1, 2):
            folder = os.path.join(parent, str(ranks))
            os.mkdir(folder)
            scripttest.run_on_ranks(ranks, launcher, program, __file__, folder)
            results.append(read(folder))
        compare(*results)


main()
