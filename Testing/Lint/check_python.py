# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
"""Python files compile without a warning, and modules and scripts say what they are for."""
import ast
import warnings

import lint

warnings.simplefilter("error")
paths = lint.files(".py")
problems = []
for path in paths:
    try:
        tree = compile(lint.content(path), path, "exec", ast.PyCF_ONLY_AST)
        compile(tree, path, "exec")
    except (SyntaxError, SyntaxWarning, DeprecationWarning) as error:
        problems.append("%s:%s: %s" % (path, getattr(error, "lineno", None) or 1, error))
        continue
    if not ast.get_docstring(tree):
        problems.append("%s:1: no docstring that says what the file is for" % path)
lint.finish(problems, len(paths))
