# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
"""The package with a server: the plugin is loaded there too, picture and scores are the same as in
one process.

    pvpython remote.py PVSERVER
"""
import socket
import subprocess
import sys
import time

import pictures
import scripttest

from paraview import simple

import tfc


def show():
    """Pictures, plain, with a highlighted region and with the legend, and the scores in the current
    session.
    """
    source = pictures.make_source()
    view = pictures.make_view()
    tf = pictures.make_transfer_function()
    display = tfc.show(source, tf, view, unit_distance=2, shade=False)
    simple.ResetCamera(view)
    plain = pictures.capture(view)
    pictures.highlight(display, tf.region("half").id)
    highlighted = pictures.capture(view)
    pictures.highlight(display, 0)
    scripttest.check(pictures.difference(plain, pictures.capture(view)) == 0,
                     "nothing stays of the highlight")
    display.LegendVisibility = 1
    display.LegendSize = [0.6, 0.6]
    legends = [pictures.capture(view)]
    scores = tfc.score(source, "RTData", arrays=["X", "R"])
    # Ranges that only the server can know, and other ones after an edit of the model or the data.
    view.Background = [0, 0, 0]
    for axis in ("RTData", "X"):
        automatic = tfc.TransferFunction("RTData", axis)
        automatic.add_rectangle((500, 500), (10, 1), color=(1, 0, 0), opacity=0.5)
        display.TransferFunction = automatic.to_json()
        legends.append(pictures.capture(view))
    simple.FindSource("Wavelet1").Maximum = 470
    legends.append(pictures.capture(view))
    return plain, highlighted, legends, scores


def connect(port, server):
    """Connect when the server is ready."""
    for _ in range(60):
        if server.poll() is not None:
            break
        with socket.socket() as test:
            # Bound while free: the server listens when this fails.
            try:
                test.bind(("", port))
            except OSError:
                break
        time.sleep(0.5)
    scripttest.check(server.poll() is None, "the server runs")
    simple.Connect("localhost", port)


pictures.SIZE = (480, 360)
picture, highlighted, legends, scores = show()
scripttest.check(float(picture.max()) > 60, "something is visible")
difference = pictures.difference(picture, highlighted)
scripttest.check(difference > 1, "the highlight is visible: %.1f/255" % difference)
difference = pictures.difference(picture, legends[0])
scripttest.check(difference > 1, "the legend is visible: %.1f/255" % difference)
for first, second in zip(legends, legends[1:]):
    difference = pictures.difference(first, second)
    scripttest.check(difference > 0.02, "the legend's numbers change: %.3f/255" % difference)
with socket.socket() as free:
    free.bind(("", 0))
    port = free.getsockname()[1]
server = subprocess.Popen([sys.argv[1], "--server-port=%d" % port])
try:
    connect(port, server)
    remote, remote_highlighted, remote_legends, remote_scores = show()
    for here, there in ((picture, remote), (highlighted, remote_highlighted),
                        (legends[0], remote_legends[0])):
        difference = pictures.difference(here, there)
        scripttest.check(difference <= 0.5,
                         "the same picture: mean difference %.3f/255" % difference)
    for here, there in zip(legends[1:], remote_legends[1:]):
        difference = pictures.difference(here, there)
        scripttest.check(difference <= 0.005,
                         "the same numbers: mean difference %.4f/255" % difference)
    scripttest.check(repr(remote_scores) == repr(scores), "the same scores")
finally:
    server.kill()
