# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
"""C++ is formatted as clang-format 14 does with the project's .clang-format.

Other versions format some constructs differently, so none but version 14 decides.
"""
import os
import re
import shutil
import subprocess

import lint

VERSION = "14"


def find_program():
    """Path of clang-format in the version that decides, or None."""
    for name in ("clang-format-" + VERSION, "clang-format"):
        program = shutil.which(name)
        if program:
            text = subprocess.run([program, "--version"], stdout=subprocess.PIPE).stdout.decode()
            if re.search(r"version %s\." % VERSION, text):
                return program
    return None


program = find_program()
if not program:
    lint.skip("needs clang-format %s (Debian: clang-format-%s)" % (VERSION, VERSION))
paths = lint.files(".h", ".cxx", ".txx")
problems = []
for path in paths:
    result = subprocess.run([program, "--dry-run", path], cwd=lint.ROOT, stderr=subprocess.PIPE)
    found = re.search(r":(\d+):\d+: warning", result.stderr.decode())
    if found or result.returncode:
        problems.append("%s:%s: not formatted: run %s -i %s"
                        % (path, found.group(1) if found else 1, os.path.basename(program), path))
lint.finish(problems, len(paths))
