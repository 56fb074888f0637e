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
    legend = pictures.capture(view)
    return plain, highlighted, legend, tfc.score(source, "RTData", arrays=["X", "R"])


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


picture, highlighted, legend, scores = show()
scripttest.check(float(picture.max()) > 60, "something is visible")
difference = pictures.difference(picture, highlighted)
scripttest.check(difference > 1, "the highlight is visible: %.1f/255" % difference)
difference = pictures.difference(picture, legend)
scripttest.check(difference > 1, "the legend is visible: %.1f/255" % difference)
with socket.socket() as free:
    free.bind(("", 0))
    port = free.getsockname()[1]
server = subprocess.Popen([sys.argv[1], "--server-port=%d" % port])
try:
    connect(port, server)
    remote, remote_highlighted, remote_legend, remote_scores = show()
    for here, there in ((picture, remote), (highlighted, remote_highlighted),
                        (legend, remote_legend)):
        difference = pictures.difference(here, there)
        scripttest.check(difference <= 0.5,
                         "the same picture: mean difference %.3f/255" % difference)
    scripttest.check(repr(remote_scores) == repr(scores), "the same scores")
finally:
    server.kill()
