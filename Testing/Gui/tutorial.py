# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
"""Plays the tutorial of Plugin/Documentation/editor.md back, on the CT head that it is about: what
it says is in the states and pictures.

    /usr/bin/python3 tutorial.py EXAMPLES PARAVIEW ARGUMENTS...

EXAMPLES is the folder of invesalius.py; the rest is the command line without the folder of the
test.
"""
import json
import os
import sys
import tempfile

import numpy

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Python"))
sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
sys.path.insert(0, sys.argv[1])
import invesalius  # noqa: E402
import pictures  # noqa: E402
import playback  # noqa: E402
import scripttest  # noqa: E402
from scripttest import check  # noqa: E402

TIMEOUT = 280  # s


def write_data(path):
    """The volume of the tutorial, from Debian's package or the folder of real volumes."""
    if os.path.exists(invesalius.CT_HEAD):
        invesalius.write_vti(path, *invesalius.read(invesalius.CT_HEAD), "HU")
        return
    copy = os.path.join(os.environ.get("TFC_DATA_ROOT", ""), "ct_head_invesalius.vti")
    if not os.path.exists(copy):
        scripttest.skip("install Debian's package invesalius-examples, or set TFC_DATA_ROOT to a "
                        "folder with ct_head_invesalius.vti")
    os.symlink(os.path.abspath(copy), path)


def main():
    with tempfile.TemporaryDirectory() as folder:
        def state(name):
            with open(os.path.join(folder, name + ".json"), encoding="utf-8") as file:
                return json.load(file)

        def share(name):
            """The part of the view that is not background, and its mean colour."""
            picture = pictures.read(os.path.join(folder, name + ".png"))
            shown = abs(picture - picture[0, 0]).max(axis=2) > 16
            print("%s: %.3f of the view shown, mean %s" % (
                name, shown.mean(), picture[shown].mean(axis=0).round()), flush=True)
            return shown.mean()

        write_data(os.path.join(folder, "ct_head.vti"))
        playback.play(sys.argv[2:], folder, TIMEOUT)

        proposal = state("proposal")
        check([proposal[axis]["array"] for axis in ("primary", "secondary")] ==
              ["HU", "HU_gradient"], "step 1: axes of the proposal")
        check(len(proposal["regions"]) >= 2, "step 1: two regions or more")
        check(share("proposal") > 0.05, "step 1: something is visible")

        soft = state("soft")
        region = soft["regions"][0]
        check([soft["primary"]["range"], soft["secondary"]["range"]] == [[-300, 300], [0, 300]],
              "step 3: ranges")
        check(region["shape"] == {"type": "rectangle", "center": [28, 60], "halfsize": [75, 55],
                                  "angle": 0}, "step 3: the rectangle")
        check(region["tertiary"]["array"] == "HU_occlusion" and
              all(node[1] == 1 for node in region["tertiary"]["opacity"]),
              "step 4: a new attribute hides nothing")
        values, counts = numpy.loadtxt(os.path.join(folder, "histogram.txt")).reshape(-1, 2).T
        hump = counts[values < -200].max()
        valley = counts[(values > -200) & (values < -100)].min()
        right = counts[values > 0].max()
        print("largest counts %.0f left and %.0f right of the valley, %.0f in it" % (
            hump, right, valley), flush=True)
        check(valley < 0.9 * hump and hump < 0.5 * right, "step 4: two parts, the right one taller")

        brain = state("brain")
        check(brain["regions"][0]["tertiary"]["opacity"] == [[-110, 0], [-70, 1]],
              "step 5: the points")
        for other in (soft, brain):
            other["regions"][0]["tertiary"].pop("opacity")
        check(brain == soft, "step 5: nothing else is changed")
        parts = {name: share(name) for name in ("soft", "brain", "scalp")}
        check(0.02 < parts["brain"] < 0.9 * parts["soft"],
              "step 5: the brain is smaller than the head")

        first, second = state("scalp")["regions"]
        check((first["opacity"], first["tertiary"]["opacity"]) ==
              (region["opacity"], [[-110, 0], [-70, 1]]), "step 6: the brain stays")
        check((second["opacity"], second["tertiary"]["opacity"]) ==
              (0.1, [[-110, 1], [-70, 0]]), "step 6: the copy")
        # Numbers that look the same as what is typed stay as they are, to the last digit.
        same = all(abs(a - b) < 1e-9 for key in ("center", "halfsize")
                   for a, b in zip(first["shape"][key], second["shape"][key]))
        check(same and first["color"] != second["color"],
              "step 6: the same shape, another colour")
        check(parts["scalp"] > 1.05 * parts["brain"], "step 6: the scalp around the brain")


main()
