# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
"""Plays events back in ParaView, which must report nothing."""
import re
import subprocess
import sys

MESSAGES = re.compile(r"ERR\||WARN\||Failed to load|critical:|Traceback")


def check_messages(output, expected=None):
    """Show what a process wrote; ends the test when it reports anything but what is expected."""
    print(output, flush=True)
    for line in output.splitlines():
        if MESSAGES.search(line) and not (expected and expected.search(line)):
            sys.exit("reported: " + line)


def play(command, folder, timeout, expected=None):
    """Play back to the end, for at most `timeout` seconds; `folder` is what the events call
    $PARAVIEW_TEST_ROOT.
    """
    result = subprocess.run(
        command + ["--test-directory=" + folder, "--exit"], timeout=timeout, check=False,
        stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace")
    check_messages(result.stdout, expected)
    if result.returncode:
        sys.exit("the playback ended with %d" % result.returncode)
