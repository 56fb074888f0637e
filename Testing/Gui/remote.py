# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
"""Plays a test of the GUI back against a server: the same edits give the same states and counts.

    python3 remote.py PLUGIN EVENTS.xml PARAVIEW SERVER...

SERVER is the command line of a pvserver, with an MPI launcher before it for several processes.
"""
import os
import socket
import subprocess
import sys
import time

TIMEOUT = 150  # s


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


def main():
    plugin, events, paraview = sys.argv[1:4]
    options = ["--plugin-search-paths=" + os.path.dirname(plugin),
               "--plugins=TransferFunctionCombinations"]
    port = free_port()
    with subprocess.Popen(sys.argv[4:] + options + ["--server-port=%d" % port]) as server:
        try:
            wait_for(port, server)
            result = subprocess.run(
                [paraview, "--dr", "--server-url=cs://localhost:%d" % port,
                 "--test-script=" + events, "--exit"] + options,
                timeout=TIMEOUT, check=False)
        finally:
            server.terminate()
    sys.exit(result.returncode)


main()
