# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
"""Plugin/Examples/advice_phantom.py on a small phantom, advice.py on the hurricane."""
import contextlib
import io
import os
import runpy
import sys
import tempfile

import pictures
import scripttest

examples = os.environ["TFC_EXAMPLES"]


def run(name, *arguments):
    """What an example prints."""
    sys.argv = [os.path.join(examples, name)] + list(arguments)
    printed = io.StringIO()
    with contextlib.redirect_stdout(printed):
        runpy.run_path(sys.argv[0], run_name="__main__")
    return printed.getvalue()


rows = [[cell.strip() for cell in line.split("|")[1:-1]]
        for line in run("advice_phantom.py", "--sizes", "48", "--seeds", "1").splitlines()]
dice = {row[0]: [float(cell.split()[0]) for cell in row[1:]] for row in rows
        if len(row) == 7 and row[1].count("(")}
scripttest.check(len(dice) == 5, "five sets of attributes: %s" % dice)
scripttest.check(all(a >= b for a, b in zip(dice["mean, stddev, occlusion"],
                                            dice["mean, stddev"])), "a third one never hurts")
scripttest.check(dice["mean, stddev"][2] > dice["x, gradient"][2] + 0.2, "the filling is found")

data = scripttest.data_file("sim_cm1_hurricane.vti")
with tempfile.TemporaryDirectory() as folder:
    text = run("advice.py", folder, "hurricane", data)
    best = text.split("part below\n")[1].splitlines()[0]
    scripttest.check(best.startswith("DBZ |"), "radar reflectivity splits best: " + best)
    before, after = (pictures.read(os.path.join(folder, "advice_hurricane_%s.png" % when))
                     for when in ("before", "after"))
    bright = [(picture.reshape(-1, picture.shape[-1])[:, 0] > 120).mean()
              for picture in (before, after)]
    scripttest.check(bright[0] > 0.5 > bright[1] > 0.1, "the storm is cut out: %s" % bright)
