# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
"""The checks find what they are for: each runs on a small tree with known faults."""
import os
import shutil
import subprocess
import sys
import tempfile

import lint

XML = """<ServerManagerConfiguration><ProxyGroup name="filters">
<SourceProxy name="A" class="vtkTFCNone">
<Documentation>Says what the proxy does.</Documentation>
<InputProperty name="Input"><Documentation> </Documentation></InputProperty>
</SourceProxy></ProxyGroup></ServerManagerConfiguration>
"""
HEADER = "#include <vector>\n#include \"%s\"\n"

# Check, file, content, what its findings must have.
FAULTS = (
    ("layers", "Filters/Kernels/A.h", HEADER % "vtkObject.h", ["Kernels/A.h:2", "no VTK"]),
    ("layers", "Filters/A.h", HEADER % "vtkSMProxy.h", ["Filters/A.h:2", "only Plugin/"]),
    ("layers", "Filters/A.h", HEADER % "QWidget", ["Filters/A.h:2", "only Plugin/"]),
    ("layers", "Rendering/TransferFunction/A.h", HEADER % "vtkShader.h", ["A.h:2", "OpenGL"]),
    ("layers", "Rendering/Volume/A.h", HEADER % "pqView.h", ["A.h:2", "only Plugin/"]),
    ("xml", "Filters/A.xml", XML, ["A.xml:2: ", "vtkTFCNone.h", "A.xml:3: ", "short_help",
                                   "A.xml:4: ", "says nothing"]),
    ("ascii", "A.md", "a\nb \n\tcaf\u00e9", ["A.md:2: blanks", "A.md:3: a tab", "not ASCII",
                                             "no newline"]),
    ("spdx", "a.py", "x = 1\n", ["a.py:1: ", "License-Identifier"]),
    ("length", "A.h", "\n" * 501, ["A.h:501: 501 lines"]),
    ("length", "a.py", "#" * 101 + "\n", ["a.py:1: 101 characters"]),
    ("format", "A.h", "int  a;\n", ["A.h:1: not formatted"]),
    ("python", "a.py", '"""Doc."""\nx = (\n', ["a.py:2: "]),
    ("python", "a.py", "x = 1\n", ["a.py:1: no docstring"]),
)

problems = []
for check, path, content, wanted in FAULTS:
    with tempfile.TemporaryDirectory() as root:
        folder = os.path.join(root, "Testing", "Lint")
        os.makedirs(folder)
        for name in ("lint.py", "check_%s.py" % check):
            shutil.copy(os.path.join(lint.ROOT, "Testing", "Lint", name), folder)
        shutil.copy(os.path.join(lint.ROOT, ".clang-format"), root)
        os.makedirs(os.path.dirname(os.path.join(root, path)), exist_ok=True)
        with open(os.path.join(root, path), "w", encoding="utf-8") as file:
            file.write(content)
        script = os.path.join(folder, "check_%s.py" % check)
        result = subprocess.run([sys.executable, "-B", script], stdout=subprocess.PIPE)
        output = result.stdout.decode()
        missing = [words for words in wanted if words not in output]
        if result.returncode != lint.SKIPPED and (result.returncode != 1 or missing):
            problems.append("Testing/Lint/check_%s.py:1: misses %s in %s: it said\n%s"
                            % (check, missing, path, output))
lint.finish(problems, len(FAULTS))
