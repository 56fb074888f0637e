# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
"""The examples in the docstrings of the package tfc, and that everything public has a docstring."""
import doctest
import importlib
import inspect
import sys

import scripttest

import tfc

examples = 0
for name in ("advice", "colors", "display", "model", "plugin", "quality", "scoring"):
    module = importlib.import_module("tfc." + name)
    runner = doctest.DocTestRunner(optionflags=doctest.ELLIPSIS)
    for test in doctest.DocTestFinder().find(module):
        runner.run(test, out=sys.stdout.write)
    failed, tried = runner.summarize()
    scripttest.check(failed == 0, "%d examples of tfc.%s" % (tried, name))
    examples += tried
scripttest.check(examples >= 15, "%d examples" % examples)

for name in tfc.__all__:
    thing = getattr(tfc, name)
    scripttest.check(bool(inspect.getdoc(thing)), "tfc.%s has a docstring" % name)
    if inspect.isclass(thing) and not issubclass(thing, tuple):
        for key, member in vars(thing).items():
            if not key.startswith("_"):
                scripttest.check(bool(inspect.getdoc(member)),
                                 "tfc.%s.%s has a docstring" % (name, key))
