# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
"""Combined transfer functions in ParaView's Python.

A combined transfer function classifies a volume by a 2D transfer function whose every region
carries its own 1D transfer function over a third attribute (Zhou, Schott, Hansen, "Transfer
Function Combinations", Computers & Graphics 36(6), 2012)::

    import tfc
    tf = tfc.TransferFunction("P", "TC")
    eye = tf.add_ellipse(center=(930, 20), radii=(12, 4), color="crimson", opacity=.6)
    eye.tertiary("QVAPOR", [(0, 0), (8, 0), (10, 1), (20, 1)])
    display = tfc.show(source, tf, view)
    for row in tfc.score(source, primary="P", secondary="TC"):
        print(row)

Everything is in data units. ``help(tfc.TransferFunction)`` has the details, ``tfc.show`` renders,
``tfc.attributes`` computes attributes of a volume, ``tfc.score`` ranks them, ``tfc.suggest``
proposes axes, ``tfc.propose`` a first transfer function, ``tfc.split`` says what to do in a region,
``tfc.quality`` compares a transfer function with labels, ``tfc.pick`` says why a pixel looks as it
does. The plugin is loaded when it is first needed.
"""

from .advice import Split, Suggestion, split, suggest
from .attributes import attributes
from .display import apply, show
from .model import Region, TransferFunction, load
from .picking import Pick, RegionShare, pick
from .plugin import load_plugin
from .proposal import propose
from .quality import LabelQuality, Quality, quality
from .scoring import Interval, Score, Stability, score, stability

__all__ = [
    "Interval",
    "LabelQuality",
    "Pick",
    "Quality",
    "Region",
    "RegionShare",
    "Score",
    "Split",
    "Stability",
    "Suggestion",
    "TransferFunction",
    "apply",
    "attributes",
    "load",
    "load_plugin",
    "pick",
    "propose",
    "quality",
    "score",
    "show",
    "split",
    "stability",
    "suggest",
]
