# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
"""A first transfer function for data that nobody has classified yet."""

from .advice import suggest
from .display import _arrays, _fill_range, find_array
from .model import TransferFunction
from .plugin import load_plugin

BINS = 256


def _histogram(source, tf):
    """The joint histogram of a transfer function's axes, computed where the data are."""
    from paraview import servermanager
    from paraview.modules.vtkRemotingCore import vtkPVSession

    from .vtk.vtkTFCInformation import vtkTFCHistogramInformation

    proxy = servermanager.CreateProxy("internal_filters", "TFCJointHistogram")
    proxy.GetProperty("Input").SetInputConnection(0, source.SMProxy, source.Port)
    for axis, (name, attribute) in enumerate(
        (("Primary", tf.primary), ("Secondary", tf.secondary))
    ):
        number = str(axis)
        array = (number, attribute["array"], str(attribute["component"]))
        span = (number, *map(repr, attribute["range"]))
        for suffix, values in (("", array), ("Range", span)):
            for i, value in enumerate(values):
                proxy.GetProperty(name + suffix).SetElement(i, value)
        proxy.GetProperty(name + "Bins").SetElement(0, axis)
        proxy.GetProperty(name + "Bins").SetElement(1, BINS)
    for i, value in enumerate(("2", "", "0")):
        proxy.GetProperty("Tertiary").SetElement(i, value)
    proxy.UpdateVTKObjects()
    proxy.UpdatePipeline()
    information = vtkTFCHistogramInformation()
    proxy.GatherInformation(information, vtkPVSession.DATA_SERVER)
    return information


def propose(source, primary=None, secondary=None, regions=3):
    """Propose a transfer function: axes and up to ``regions`` regions (1 to 8) from the peaks of
    their joint histogram, without the background.

    Axes that are not named are those of the best pair of :func:`tfc.suggest`; data with a single
    array get it on both axes and no region. What is proposed is marked as such until it is edited
    in the editor; ``help(tfc.vtk.vtkTFCTransferFunction.vtkTFCProposal)`` has the rules. Raises
    KeyError for an unknown array and ValueError when there is none::

        tf = tfc.propose(volume)
        tfc.show(volume, tf)
    """
    from .vtk.vtkTFCTransferFunction import vtkTFCProposal, vtkTFCTransferFunction

    load_plugin()
    source.UpdatePipeline()
    if not (primary and secondary):
        try:
            pairs = [row for row in suggest(source) if not primary or row.primary == primary]
        except ValueError:
            pairs = []  # a single attribute
        if pairs:
            primary, secondary = pairs[0].primary, pairs[0].secondary
        else:
            names = [name for arrays in _arrays(source) for name in arrays]
            if not names:
                raise ValueError("the data have no array to propose a transfer function for")
            primary = primary or names[0]
            secondary = secondary or next((name for name in names if name != primary), primary)
    for name in (primary, secondary):
        find_array(source, name)
    tf = TransferFunction(primary, secondary)
    if primary == secondary:
        return tf
    _fill_range(source, tf.primary)
    _fill_range(source, tf.secondary)
    model = vtkTFCTransferFunction()
    model.SetState(tf.to_json())
    proposal = vtkTFCProposal()
    proposal.SetMaximumNumberOfRegions(regions)
    proposal.ProposeRegions(_histogram(source, tf).GetHistogram(), model)
    return TransferFunction.from_json(model.GetState())
