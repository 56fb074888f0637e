# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
"""Which attributes to take as axes, and which ones split what a region selects."""

import json
from collections import namedtuple

from .display import find_array
from .plugin import load_plugin
from .scoring import _check_attribute, _collect_errors, _read, _rows

Suggestion = namedtuple(
    "Suggestion",
    "pair kind primary secondary pair_score tertiary score rank new_information separation",
)
Suggestion.__doc__ = """A pair of axes (``pair`` 1 is the best) with one of its tertiary attributes
(``rank`` 1 is the best). ``kind`` says why the two are a pair: ``"value and gradient"``,
``"mean and deviation"`` or ``"multivariate"``. The last two fields are as in :class:`tfc.Score`."""

Split = namedtuple(
    "Split",
    "region region_name attribute rank power separability valley threshold cut below voxels "
    "keep_above keep_below",
)
Split.__doc__ = """How well an attribute splits the voxels of a region (id): ``power``, 0 to 1, is
``separability`` (between-class variance over total variance at the best threshold) times ``valley``
(depth of the gap at the cut). ``threshold`` and ``cut`` are in data units, ``below`` is the part of
the voxels under the cut. ``keep_above`` and ``keep_below`` are keyword arguments for
:meth:`tfc.Region.tertiary`; None for an attribute that is constant in the region (rank 0)."""


def suggest(source, arrays=None, balance=0.4, bins=256, pairs=3, fill_values=()):
    """Propose axes for a transfer function, and ranked tertiary attributes for each pair.

    Returns a list of :class:`Suggestion`, best pair first and in each the best tertiary attribute
    first: a value with its gradient, a mean with its deviation, and the ``pairs`` best ones of
    different variables. The other arguments and the errors are those of :func:`tfc.score`::

        best = tfc.suggest(volume)[0]
        tf = tfc.TransferFunction(best.primary, best.secondary)
    """
    from paraview import servermanager, simple

    load_plugin()
    source.UpdatePipeline()
    for name in arrays or []:
        _check_attribute(source, name)
    proxy = simple.AxisSuggestion(registrationName="tfc.suggest", Input=source)
    try:
        if arrays is not None:
            proxy.Arrays = list(arrays)
        proxy.Balance = balance
        proxy.NumberOfBins = bins
        proxy.NumberOfPairs = pairs
        if fill_values:
            proxy.FillValues = list(fill_values)
        errors = _collect_errors(proxy)
        proxy.UpdatePipeline()
        summary = servermanager.Fetch(proxy).GetFieldData().GetAbstractArray("summary")
        errors += [summary.GetValue(0)] if summary else []
        table = _rows(proxy, errors, what="nothing is suggested")
    finally:
        simple.Delete(proxy)
    texts = ("kind", "primary", "secondary", "tertiary")
    return [_read(table, row, Suggestion, texts, ("pair", "rank"))
            for row in range(table.GetNumberOfRows())]


def split(source, tf, region=None, arrays=None, bins=256):
    """Which attributes split the voxels that the regions of a transfer function select.

    ``region`` is a region or its id, by default all visible ones. ``arrays`` are the attributes to
    try, by default all with one component but the axes. Returns a list of :class:`Split`, region by
    region, best attribute first::

        best = tfc.split(volume, tf, region=bone)[0]
        bone.tertiary(**best.keep_above)

    Raises KeyError for an unknown array or region and ValueError, with the reason, when there is
    nothing to try.
    """
    from paraview import simple

    load_plugin()
    source.UpdatePipeline()
    for name in arrays or []:
        _check_attribute(source, name)
    for axis in (tf.primary, tf.secondary):
        if axis:
            find_array(source, axis["array"], axis["component"])
    wanted = getattr(region, "id", region)
    known = [r.id for r in tf.regions if r.visible]
    if wanted is not None and wanted not in known:
        raise KeyError(f"no visible region {wanted!r}; there are: "
                       + (", ".join(map(str, known)) or "none"))
    proxy = simple.RegionSplit(registrationName="tfc.split", Input=source)
    try:
        proxy.TransferFunction = tf.to_json()
        if arrays is not None:
            proxy.Arrays = list(arrays)
        proxy.NumberOfBins = bins
        errors = _collect_errors(proxy)
        proxy.UpdatePipeline()
        table = _rows(proxy, errors or ["no region is visible"], what="no advice")
    finally:
        simple.Delete(proxy)
    texts = ("region_name", "attribute", "keep_above", "keep_below")
    rows = [_read(table, row, Split, texts, ("region", "rank"))
            for row in range(table.GetNumberOfRows())]
    return [
        row._replace(keep_above=_arguments(row.keep_above), keep_below=_arguments(row.keep_below))
        for row in rows if wanted is None or row.region == wanted
    ]


def _arguments(text):
    """The arguments of Region.tertiary() from the value of "tertiary" in the state.

    >>> _arguments('{"array": "T", "component": 0, "range": [0, 9], "opacity": [[4, 0], [5, 1]]}')
    {'array': 'T', 'component': 0, 'range': [0, 9], 'opacity': [[4, 0], [5, 1]]}
    >>> _arguments("") is None
    True
    """
    return json.loads(text) if text else None
