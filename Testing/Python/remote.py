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
    """The picture and the scores in the current session."""
    source = pictures.make_source()
    view = pictures.make_view()
    tfc.show(source, pictures.make_transfer_function(), view, unit_distance=2, shade=False)
    simple.ResetCamera(view)
    return pictures.capture(view), tfc.score(source, "RTData", arrays=["X", "R"])


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


picture, scores = show()
scripttest.check(float(picture.max()) > 60, "something is visible")
with socket.socket() as free:
    free.bind(("", 0))
    port = free.getsockname()[1]
server = subprocess.Popen([sys.argv[1], "--server-port=%d" % port])
try:
    connect(port, server)
    remote, remote_scores = show()
    difference = pictures.difference(picture, remote)
    scripttest.check(difference <= 0.5, "the same picture: mean difference %.3f/255" % difference)
    scripttest.check(repr(remote_scores) == repr(scores), "the same scores")
finally:
    server.kill()
