# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
"""Runs a command on an X server of its own, with the pointer where no window is.

    /usr/bin/python3 own_display.py COMMAND...

On a server that is shared, windows that other tests open and close move under the pointer: the
enter, leave and focus events that follow are real and arrive in the middle of a playback. Without
Xvfb the command runs on $DISPLAY.
"""
import ctypes
import os
import shutil
import signal
import subprocess
import sys

SIZE = (1600, 1200)
PR_SET_PDEATHSIG = 1  # <linux/prctl.h>


def end_with_parent():
    """ctest kills this script when the time is up: let the server go with it."""
    ctypes.CDLL(None).prctl(PR_SET_PDEATHSIG, signal.SIGTERM)


def start_server():
    """Start a server that chooses a free display, and return it and the display once it listens."""
    reading, writing = os.pipe()
    server = subprocess.Popen(
        ["Xvfb", "-displayfd", str(writing), "-screen", "0", "%dx%dx24" % SIZE, "-noreset",
         "-nolisten", "tcp"],
        pass_fds=[writing], preexec_fn=end_with_parent, stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL)
    os.close(writing)
    with os.fdopen(reading) as pipe:
        number = pipe.readline().strip()
    if not number:
        sys.exit("Xvfb did not start; it ended with %s" % server.wait())
    return server, ":" + number


def move_pointer(display):
    """Into the last corner: windows are smaller than the screen and start in the first."""
    xlib = ctypes.CDLL("libX11.so.6")
    xlib.XOpenDisplay.restype = ctypes.c_void_p
    connection = ctypes.c_void_p(xlib.XOpenDisplay(display.encode()))
    if not connection:
        sys.exit("no connection to display " + display)
    xlib.XDefaultRootWindow.restype = ctypes.c_ulong
    root = ctypes.c_ulong(xlib.XDefaultRootWindow(connection))
    xlib.XWarpPointer(connection, ctypes.c_ulong(0), root, 0, 0, 0, 0, SIZE[0] - 1, SIZE[1] - 1)
    xlib.XCloseDisplay(connection)


def main():
    if not shutil.which("Xvfb"):
        sys.exit(subprocess.call(sys.argv[1:]))
    server, display = start_server()
    try:
        move_pointer(display)
        sys.exit(subprocess.call(sys.argv[1:], env=dict(os.environ, DISPLAY=display)))
    finally:
        server.terminate()
        server.wait()


main()
