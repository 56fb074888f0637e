# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
"""The state file beside each example is what the example's make_transfer_function() gives."""
import importlib
import os
import sys

import scripttest

import tfc

examples = os.environ["TFC_EXAMPLES"]
sys.dont_write_bytecode = True
sys.path.insert(0, examples)
for name in ("hurricane", "isabel"):
    path = os.path.join(examples, name + ".tfc.json")
    made = importlib.import_module(name).make_transfer_function()
    scripttest.check(tfc.load(path) == made,
                     "%s is the state of %s.py; else write it with tf.save()" % (path, name))
