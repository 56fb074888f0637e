# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
"""Plugin/Examples/attributes.py on the phantom: a picture per attribute, and the ranking."""
import contextlib
import io
import os
import runpy
import sys
import tempfile

import scripttest

from paraview import simple

import pictures
import tfc

tfc.load_plugin()
with tempfile.TemporaryDirectory() as folder:
    phantom = simple.MaterialPhantom(Dimensions=[40, 36, 33])
    path = os.path.join(folder, "phantom.vti")
    simple.SaveData(path, phantom, DataMode="Binary")
    script = os.path.join(os.environ["TFC_EXAMPLES"], "attributes.py")
    sys.argv = [script, folder, path, "intensity", "--radius", "5", "--sizes", "3", "12",
                "--axis", "y"]
    printed = io.StringIO()
    with contextlib.redirect_stdout(printed):
        runpy.run_path(script, run_name="__main__")
    for suffix in ("", "_gradient", "_mean", "_stddev", "_radius", "_occlusion", "_size"):
        picture = os.path.join(folder, "intensity" + suffix + ".png")
        scripttest.check(os.path.exists(picture), "picture of intensity" + suffix)
        pixels = pictures.read(picture)
        scripttest.check(pixels[:, :300].reshape(-1, 3).std(axis=0).max() > 5,
                         "which is not empty")
    ranked = [line for line in printed.getvalue().splitlines() if line.startswith("1  ")]
    scripttest.check(len(ranked) == 1, "the best attribute: %s" % ranked)
