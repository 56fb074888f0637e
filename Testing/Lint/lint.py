# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
"""What the lint checks share: the project's files, and how findings are reported."""
import os
import subprocess
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
SKIPPED = 77


def files(*endings):
    """Paths, relative to the root, of the project's files whose name ends so; all without endings.

    The files that git knows or would add; outside a checkout, everything but build folders.
    """
    if os.path.exists(os.path.join(ROOT, ".git")):
        listed = subprocess.run(
            ["git", "-c", "safe.directory=*", "-C", ROOT, "ls-files", "-z", "--cached", "--others",
             "--exclude-standard"], check=True, stdout=subprocess.PIPE).stdout
        paths = [os.fsdecode(path) for path in listed.split(b"\0") if path]
    else:
        paths = []
        for folder, subfolders, names in os.walk(ROOT):
            subfolders[:] = [s for s in subfolders if not s.startswith(("build", "__pycache__"))]
            paths += [os.path.relpath(os.path.join(folder, name), ROOT) for name in names]
    return sorted({path for path in paths
                   if (not endings or path.endswith(endings))
                   and os.path.isfile(os.path.join(ROOT, path))})


def content(path):
    """Bytes of a file of the project."""
    with open(os.path.join(ROOT, path), "rb") as file:
        return file.read()


def lines(path):
    """(number, text) of each line of a file of the project."""
    text = content(path).decode("utf-8", errors="replace")
    return list(enumerate(text.splitlines(), start=1))


def is_text(path):
    """Whether a file is text: pictures and other binary files have a zero byte early."""
    return b"\0" not in content(path)[:8192]


def finish(problems, looked_at):
    """Print the findings, each "file:line: what to do", and end the script."""
    for problem in problems:
        print(problem)
    print("%d files, %d problems" % (looked_at, len(problems)))
    if not looked_at:
        print("no files were found below %s: the check itself is broken" % ROOT)
    sys.exit(1 if problems or not looked_at else 0)


def skip(why):
    """End the script; ctest reports the test as skipped."""
    print("SKIPPED: " + why)
    sys.exit(SKIPPED)
