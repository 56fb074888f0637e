# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
"""How well a transfer function finds labelled materials, and how well any could."""

from collections import namedtuple

from .display import find_array
from .plugin import load_plugin
from .scoring import _collect_errors

LabelQuality = namedtuple(
    "LabelQuality",
    "label voxels region region_name precision recall dice leakage axes_dice best_dice "
    "best_attribute limited_by",
)
LabelQuality.__doc__ = """One label and its best region (id; 0 when none has any of it).
``leakage`` is the part of the region that shows other labels. ``axes_dice`` is the Dice coefficient
that the two axes alone could reach with any regions, ``best_dice`` the same with the best of the
tertiary attributes in use, which ``best_attribute`` names; ``limited_by`` says what to improve:
``"regions"``, ``"axes"`` or ``"neither"``."""

_TEXTS = ("region_name", "best_attribute", "limited_by")
_COUNTS = ("label", "voxels", "region")


class Quality:
    """What :func:`quality` measured.

    ``rows`` are the :class:`LabelQuality` of the labels, ascending. ``confusion[label][region]`` is
    a number of voxels; region 0 stands for none.

    >>> measured = Quality([], {0: {0: 90, 1: 10}, 7: {0: 20, 1: 30}})
    >>> measured.of(7, 1)
    (0.75, 0.6, 0.6666666666666666)
    >>> measured.of(7, 2)
    Traceback (most recent call last):
        ...
    KeyError: 'no region 2; there are: 1'
    """

    def __init__(self, rows, confusion):
        self.rows = rows
        self.confusion = confusion

    def row(self, label):
        """The row of a label. Raises KeyError with the labels that there are."""
        for row in self.rows:
            if row.label == label:
                return row
        known = ", ".join(str(row.label) for row in self.rows)
        raise KeyError(f"no label {label!r}; there are: {known}")

    def of(self, label, region):
        """(precision, recall, Dice coefficient) of any region (id) for any label; 0 where nothing
        is.
        """
        if label not in self.confusion:
            known = ", ".join(map(str, self.confusion))
            raise KeyError(f"no label {label!r}; there are: {known}")
        counts = self.confusion[label]
        if region not in counts or region == 0:
            known = ", ".join(str(key) for key in counts if key != 0)
            raise KeyError(f"no region {region!r}; there are: {known or 'none'}")
        both = counts[region]
        total = sum(counts.values())
        size = sum(row[region] for row in self.confusion.values())
        return (
            both / size if size else 0.0,
            both / total if total else 0.0,
            2 * both / (total + size) if total + size else 0.0,
        )

    def __repr__(self):
        lines = ["label   voxels  region  precision  recall    dice    axes    best  limited by"]
        for row in self.rows:
            lines.append(
                f"{row.label:5} {row.voxels:8}  {row.region:6}  {row.precision:9.3f}  "
                f"{row.recall:6.3f}  {row.dice:6.3f}  {row.axes_dice:6.3f}  {row.best_dice:6.3f}  "
                + row.limited_by
            )
        return "\n".join(lines)


def quality(source, tf, labels, bins=64, ignored=()):
    """Compare what the regions of a :class:`tfc.TransferFunction` select with labels.

    ``labels`` is the name of an integer array of the source that says what each voxel is; voxels
    with one of the labels in ``ignored`` are left out. ``bins`` per axis (2 to 1024) is how fine
    the histograms are in which the best possible Dice coefficients are found. Returns a
    :class:`Quality`::

        measured = tfc.quality(volume, tf, "material")
        print(measured)
        for row in measured.rows:
            if row.limited_by == "axes":
                print("label", row.label, "needs other attributes than these")

    Raises KeyError for an unknown array and ValueError, with the reason, when nothing can be
    measured.
    """
    from paraview import servermanager, simple

    load_plugin()
    source.UpdatePipeline()
    find_array(source, labels)
    measure = simple.ClassificationQuality(registrationName="tfc.quality", Input=source)
    try:
        measure.LabelArray = labels
        measure.TransferFunction = tf.to_json()
        measure.NumberOfBins = bins
        if ignored:
            measure.IgnoredLabels = list(ignored)
        errors = _collect_errors(measure)
        measure.UpdatePipeline()
        table = servermanager.Fetch(measure)
        counts = servermanager.Fetch(measure, idx=1)
    finally:
        simple.Delete(measure)
    if not table or table.GetNumberOfRows() == 0:
        reason = " ".join(errors) or "see the server's messages"
        raise ValueError("nothing was measured: " + reason)

    def read(row, name):
        value = table.GetValueByName(row, name)
        if name in _TEXTS:
            return value.ToString()
        return value.ToLongLong() if name in _COUNTS else value.ToDouble()

    rows = [
        LabelQuality(*(read(row, name) for name in LabelQuality._fields))
        for row in range(table.GetNumberOfRows())
    ]
    confusion = {}
    for row in range(counts.GetNumberOfRows()):
        # "label", "none", then "region ID".
        confusion[counts.GetValue(row, 0).ToLongLong()] = {
            int(counts.GetColumnName(c).split()[-1]) if c > 1 else 0:
                counts.GetValue(row, c).ToLongLong()
            for c in range(1, counts.GetNumberOfColumns())
        }
    return Quality(rows, confusion)
