# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
"""Plugin/Examples/hurricane.py on the real volume: every region is visible in its colour."""
import os
import sys
import tempfile

import pictures
import scripttest

data = scripttest.data_file("sim_cm1_hurricane.vti")
sys.dont_write_bytecode = True
sys.path.insert(0, os.environ["TFC_EXAMPLES"])
import hurricane

with tempfile.TemporaryDirectory() as folder:
    path = os.path.join(folder, "hurricane.png")
    hurricane.main(data, path, size=(320, 240))
    picture = pictures.read(path)
hues = pictures.count_hues(picture, (0.05, 0.06, 0.09))
scripttest.check(picture.shape == (240, 320, 3), "size of the picture")
for name, fewest in (("red", 200), ("yellow", 200), ("green", 200), ("blue", 200)):
    scripttest.check(hues[name] >= fewest, "%s: %d pixels of at least %d"
                     % (name, hues[name], fewest))
