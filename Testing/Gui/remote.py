# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
"""Plays a test of the GUI back without a server and against one: the same edits give the same
states and counts, the same pictures, and no messages.

    /usr/bin/python3 remote.py PLUGIN EVENTS.xml PARAVIEW SERVER...

SERVER is the command line of a pvserver, with an MPI launcher before it for several processes.
Pictures are what the events save as PNG files in $PARAVIEW_TEST_ROOT.
"""
import os
import re
import socket
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Python"))
import pictures  # noqa: E402
import playback  # noqa: E402

TIMEOUT = 150  # s
LARGEST_DIFFERENCE = 0.5  # mean over all pixels and channels, of 255
# With --server-url, ParaView 5.11 reads the definitions that the server sends before it loads the
# plugin on its own side, and then does not know the classes of the plugin's domains.
EXPECTED = re.compile(r"vtkSMProperty\.cxx:\d+ +ERR\| \w+ \(0x[0-9a-f]+\): "
                      r"Could not create object of type: vtkSMTFC\w+\. "
                      r"Did you specify wrong xml element\?")


def free_port():
    """A port that nobody listens at."""
    with socket.socket() as test:
        test.bind(("", 0))
        return test.getsockname()[1]


def wait_for(port, server):
    """Until the server listens: nobody else can bind its port then."""
    for _ in range(120):
        if server.poll() is not None:
            sys.exit("the server ended with %d" % server.returncode)
        with socket.socket() as test:
            try:
                test.bind(("", port))
            except OSError:
                return
        time.sleep(0.5)
    sys.exit("the server does not listen")


def compare(local, remote):
    """The pictures in two folders."""
    names = sorted(name for name in os.listdir(local) if name.endswith(".png"))
    if not names:
        sys.exit("the events save no picture")
    for name in names:
        here = pictures.read(os.path.join(local, name))
        there = pictures.read(os.path.join(remote, name))
        if here.shape != there.shape:
            sys.exit("%s: %s pixels here, %s there" % (name, here.shape, there.shape))
        # Most of a picture is background: a volume that is not drawn must not pass.
        shown = abs(here - here[0, 0]).max(axis=2) > 8
        difference = pictures.difference(here[shown], there[shown])
        print("%s: mean difference %.3f/255 over %d pixels" % (name, difference, shown.sum()))
        if shown.sum() < 1000 or difference > LARGEST_DIFFERENCE:
            sys.exit("%s: not the same picture" % name)


def main():
    plugin, events, paraview = sys.argv[1:4]
    options = ["--plugin-search-paths=" + os.path.join(os.path.dirname(plugin), ".."),
               "--plugins=TransferFunctionCombinations"]
    command = [paraview, "--dr", "--test-script=" + events] + options
    port = free_port()
    with tempfile.TemporaryDirectory() as local, tempfile.TemporaryDirectory() as remote, \
            tempfile.TemporaryFile("w+", errors="replace") as log:
        playback.play(command, local, TIMEOUT)
        with subprocess.Popen(sys.argv[4:] + options + ["--server-port=%d" % port], stdout=log,
                              stderr=subprocess.STDOUT) as server:
            try:
                wait_for(port, server)
                playback.play(command + ["--server-url=cs://localhost:%d" % port], remote, TIMEOUT,
                              EXPECTED)
                log.seek(0)
                playback.check_messages(log.read(), EXPECTED)
            finally:
                server.terminate()
        compare(local, remote)


main()
