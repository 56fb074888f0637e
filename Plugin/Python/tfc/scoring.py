# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
"""Which attribute to combine: the score of the paper's section 3.2."""

from collections import namedtuple
from contextlib import contextmanager

from .display import find_array
from .plugin import load_plugin

Score = namedtuple(
    "Score",
    "attribute correlation entropy score rank mutual_information conditional_mutual_information "
    "new_information separation",
)
Score.__doc__ = """One row of the score table: the correlation is with the primary attribute, the
entropy in bits, rank 1 is best; 0 stands for the axes and for attributes without a score. The
others, in bits: what the attribute shares with both axes; with the primary one, given the secondary
one; what it tells that the axes do not, noise included; and that as a part of its entropy, 0 to
1."""


Interval = namedtuple("Interval", "low high ranking")
Interval.__doc__ = """A range of the balance a with one ranking, a list of names, best first."""


class Stability(list):
    """The :class:`Interval` of every ranking, in order.

    ``summary`` says in a sentence which attributes are first where; ``over_bins`` has, for 1, 2, 4
    and 8 neighbouring bins taken as one, the ranking at the balance that was asked for.
    """

    summary = ""
    over_bins = {}


def _check_attribute(source, text):
    """Raise KeyError unless ``text`` is the name of an array, or that with a component:
    ``velocity:0`` or ``velocity:magnitude``.
    """
    name, colon, component = text.rpartition(":")
    if colon and (component == "magnitude" or component.isdigit()):
        try:
            find_array(source, text)
        except KeyError:
            find_array(source, name, -1 if component == "magnitude" else int(component))
    else:
        find_array(source, text)


def _collect_errors(proxy):
    """A list that will receive the errors of a proxy's filter, where it is in this process."""
    errors = []
    filter_object = proxy.GetClientSideObject()
    if filter_object:

        def collect(_caller, _event, message):
            # "ERROR: In FILE, line N\nCLASS (ADDRESS): TEXT"
            errors.append(message.strip().split("): ", 1)[-1])

        collect.CallDataType = "string0"
        filter_object.AddObserver("ErrorEvent", collect)
    return errors


@contextmanager
def _scored(source, primary, secondary, arrays, balance, bins, fill_values):
    """The filter, updated with these parameters, while the context lasts; and its errors."""
    from paraview import simple

    load_plugin()
    source.UpdatePipeline()
    for name in [primary, secondary] + list(arrays or []):
        if name is not None:
            _check_attribute(source, name)
    scores = simple.CombinationScore(registrationName="tfc.score", Input=source)
    try:
        scores.Primary = primary
        scores.Secondary = secondary or ""
        if arrays is not None:
            wanted = list(arrays)
            wanted += [n for n in (primary, secondary) if n is not None and n not in wanted]
            scores.Arrays = wanted
        scores.Balance = balance
        scores.NumberOfBins = bins
        if fill_values:
            scores.FillValues = list(fill_values)
        errors = _collect_errors(scores)
        scores.UpdatePipeline()
        yield scores, errors
    finally:
        simple.Delete(scores)


def _rows(scores, errors, port=0, what="no scores"):
    """The table of an output port; ValueError, with the reason, when it has no rows."""
    from paraview import servermanager

    table = servermanager.Fetch(scores, idx=port)
    if not table or table.GetNumberOfRows() == 0:
        raise ValueError(f"{what}: " + (" ".join(errors) or "see the server's messages"))
    return table


def _read(table, row, kind, texts, integers):
    """One row of a table as a named tuple whose fields are columns."""

    def value(name):
        cell = table.GetValueByName(row, name)
        if name in texts:
            return cell.ToString()
        return cell.ToInt() if name in integers else cell.ToDouble()

    return kind(*(value(name) for name in kind._fields))


def score(source, primary, secondary=None, arrays=None, balance=0.4, bins=256, fill_values=()):
    """Rank the attributes of a source as tertiary attributes, best first (Eq. 3 of the paper).

    ``arrays`` are the attributes to look at, by default all point arrays with one
    component, or cell arrays if there are none;
    ``"velocity:0"`` and ``"velocity:magnitude"`` stand for one of an array with several.
    ``balance`` is the a of Eq. 3, in [0, 1): larger weighs low correlation with the primary
    attribute more, smaller weighs high entropy more. ``bins`` is for the entropies; 0 means by bit
    depth, one bin per value of integers. ``fill_values`` are numbers that stand for
    missing data; NaN always does. Returns a list of :class:`Score`. The axes follow with rank 0.
    Raises KeyError for an unknown array and ValueError, with the reason, when there is nothing to
    score.
    """
    with _scored(source, primary, secondary, arrays, balance, bins, fill_values) as (scores, why):
        table = _rows(scores, why)
    return [_read(table, row, Score, ("attribute",), ("rank",))
            for row in range(table.GetNumberOfRows())]


def stability(
    source, primary, secondary=None, arrays=None, bins=256, fill_values=(), balance=0.4
):
    """How the ranking of :func:`score` depends on the balance a and on the bins.

    Returns a :class:`Stability`, a list of :class:`Interval` that cover 0 to 1: the attributes,
    best first, while a is between ``low`` and ``high``; with a ``summary`` and the rankings with
    wider bins at ``balance``. Arguments and errors are those of :func:`score`.
    """
    with _scored(source, primary, secondary, arrays, balance, bins, fill_values) as (scores, why):
        _rows(scores, why)
        table = _rows(scores, ["no attribute is a candidate"], port=2)
        over_bins = _rows(scores, why, port=3)
    result = Stability(
        Interval(
            table.GetValueByName(row, "from").ToDouble(),
            table.GetValueByName(row, "to").ToDouble(),
            table.GetValueByName(row, "ranking").ToString().split(", "),
        )
        for row in range(table.GetNumberOfRows())
    )
    result.summary = table.GetFieldData().GetAbstractArray("summary").GetValue(0)
    result.over_bins = {
        over_bins.GetValueByName(row, "merged_bins").ToInt():
            over_bins.GetValueByName(row, "ranking").ToString().split(", ")
        for row in range(over_bins.GetNumberOfRows())
    }
    return result
