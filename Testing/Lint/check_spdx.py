# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
"""Sources and scripts start with their SPDX copyright and license lines."""
import lint

WANTED = ("SPDX-" + "FileCopyrightText: ", "SPDX-" + "License-Identifier: BSD-3-Clause")

paths = [path for path in lint.files()
         if path.endswith((".h", ".cxx", ".txx", ".py", ".sh", ".cmake"))
         or lint.content(path).startswith(b"#!")]
problems = []
for path in paths:
    head = "\n".join(text for _, text in lint.lines(path)[:5])
    # CMake files state the license only, as those of VTK.
    for line in WANTED[1:] if path.endswith(".cmake") else WANTED:
        if line not in head:
            problems.append("%s:1: the first lines lack '%s'" % (path, line.strip()))
lint.finish(problems, len(paths))
