# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
"""No source file is longer than 500 lines, no README of a folder longer than 15, no script line
longer than 100 characters (clang-format sees to C++)."""
import lint

LONGEST_SOURCE = 500
LONGEST_README = 15
LONGEST_LINE = 100

sources = lint.files(".h", ".cxx", ".txx", ".glsl", ".py", ".sh", "CMakeLists.txt", ".cmake")
readmes = [path for path in lint.files("/README.md")]
problems = []
for paths, longest, advice in ((sources, LONGEST_SOURCE, "split it by subject"),
                               (readmes, LONGEST_README, "a folder's README is a summary")):
    for path in paths:
        count = len(lint.lines(path))
        if count > longest:
            problems.append("%s:%d: %d lines, the limit is %d: %s"
                            % (path, longest + 1, count, longest, advice))
for path in sources:
    if path.endswith((".py", ".sh")):
        problems += ["%s:%d: %d characters, the limit is %d"
                     % (path, number, len(text), LONGEST_LINE)
                     for number, text in lint.lines(path) if len(text) > LONGEST_LINE]
lint.finish(problems, len(sources) + len(readmes))
