# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
"""Text files are ASCII without tabs and trailing blanks, and end with a newline."""
import lint

# The fuzzer's inputs are what they are.
paths = [path for path in lint.files() if lint.is_text(path) and "/Corpus/" not in path]
problems = []
for path in paths:
    data = lint.content(path)
    for number, line in enumerate(data.split(b"\n"), start=1):
        if not line.isascii():
            column = next(i for i, byte in enumerate(line) if byte > 127) + 1
            problems.append("%s:%d: column %d is not ASCII" % (path, number, column))
        if b"\t" in line:
            problems.append("%s:%d: a tab: use blanks" % (path, number))
        if line.endswith((b" ", b"\r")):
            problems.append("%s:%d: blanks or a carriage return at the end" % (path, number))
    if data and not data.endswith(b"\n"):
        problems.append("%s:%d: no newline at the end of the file" % (path, data.count(b"\n") + 1))
lint.finish(problems, len(paths))
