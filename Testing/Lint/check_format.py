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
# One process: to start it takes longer than to check some files.
result = subprocess.run([program, "--dry-run"] + paths, cwd=lint.ROOT, stderr=subprocess.PIPE)
first = {}
for path, line in re.findall(r"^(.*?):(\d+):\d+: warning", result.stderr.decode(), re.MULTILINE):
    first.setdefault(path, line)
problems = ["%s:%s: not formatted: run %s -i %s" % (path, line, os.path.basename(program), path)
            for path, line in sorted(first.items())]
if result.returncode:
    problems.append("%s failed: %s" % (program, result.stderr.decode()[-300:]))
lint.finish(problems, len(paths))
