# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
"""Rendering a combined transfer function in a ParaView view."""

from contextlib import contextmanager

from .plugin import load_plugin

REPRESENTATION = "Combined Volume"
RENDERED = ("vtkImageData", "vtkUniformGrid", "vtkStructuredPoints", "vtkRectilinearGrid")


def _arrays(source):
    """(name -> array information, association) of the point arrays, then of the cell arrays."""
    information = source.GetDataInformation()
    for attributes in (information.GetPointDataInformation(), information.GetCellDataInformation()):
        yield {
            attributes.GetArrayInformation(i).GetName(): attributes.GetArrayInformation(i)
            for i in range(attributes.GetNumberOfArrays())
        }


def find_array(source, name, component=0):
    """Information about a point or cell array of a source's output. Raises KeyError with the arrays
    that there are.
    """
    known = []
    for arrays in _arrays(source):
        if name in arrays:
            count = arrays[name].GetNumberOfComponents()
            if not -1 <= component < count:
                raise KeyError(
                    f"array {name!r} has {count} component{'' if count == 1 else 's'}; "
                    f"there is no component {component}"
                )
            return arrays[name]
        known += list(arrays)
    raise KeyError(f"no array {name!r}; there are: {', '.join(known) or 'none'}")


def _fill_range(source, attribute):
    """Give an attribute without a range that of the data, over all ranks."""
    array = find_array(source, attribute["array"], attribute["component"])
    if attribute.get("range") is None:
        low, high = array.GetComponentFiniteRange(attribute["component"])
        # As vtkTFCTransferFunction::ResolveRanges() does.
        if low == high:
            half = max(0.5, abs(low) / 2)
            low, high = low - half, high + half
        elif not low < high:
            low, high = 0.0, 1.0
        attribute["range"] = [low, high]


def _dataset_types(source):
    """Class names of what a source makes, for a composite dataset those of its blocks."""
    from vtkmodules.vtkCommonDataModel import vtkDataObjectTypes

    information = source.GetDataInformation()
    if not information.DataInformation.IsCompositeDataSet():
        return [information.GetDataSetTypeAsString()]
    types = information.DataInformation.GetUniqueBlockTypes()
    return [vtkDataObjectTypes.GetClassNameFromTypeId(number) for number in types]


def _prepare(source, tf):
    """Check a transfer function against the data and fill in the ranges it leaves open."""
    source.UpdatePipeline()
    wrong = [kind for kind in _dataset_types(source) if kind not in RENDERED]
    if wrong:
        raise TypeError(
            "a combined transfer function renders a vtkImageData, a vtkRectilinearGrid or a "
            f"composite of them, not a {wrong[0]}; the filter 'Resample To Image' makes one"
        )
    for name, axis in (("primary", tf.primary), ("secondary", tf.secondary)):
        if not axis:
            raise ValueError(f"{name}: the transfer function has no {name} axis; name an array")
        _fill_range(source, axis)
    for region in tf.regions:
        if region.tertiary_state:
            _fill_range(source, region.tertiary_state)
    return tf.to_json()


@contextmanager
def _traced(display):
    """Put the properties of a display that change meanwhile into ParaView's Python trace, when one
    is recorded. ParaView itself records the edits of its GUI only.
    """
    from paraview import servermanager, smtrace

    item = None
    if servermanager.vtkSMTrace.GetActiveTracer():
        try:
            item = smtrace.PropertiesModified(display)
        except smtrace.Untraceable:
            pass  # a display that was made before the recording began
    yield
    if item:
        item.finalize()


def show(source, tf=None, view=None, unit_distance=None, shade=None):
    """Show a source as "Combined Volume" with a transfer function and return the display. Without
    one it is that of :func:`tfc.propose`.

    ``unit_distance`` is the length, in world units, over which the opacities of the regions hold
    (ParaView's choice by default: about one cell); ``shade`` switches lighting by the gradient of
    the primary attribute. Ranges that the transfer function leaves open are taken from the data.
    Raises KeyError for an unknown array or component, TypeError when the source is neither an image
    nor a rectilinear grid nor a composite of them,
    ValueError when an axis is missing.
    """
    from paraview import simple

    load_plugin()
    view = view or simple.GetActiveViewOrCreate("RenderView")
    if tf is None:
        from .proposal import propose  # it needs this module

        tf = propose(source)
    state = _prepare(source, tf)
    display = simple.Show(source, view)
    available = list(display.GetProperty("Representation").GetAvailable())
    if REPRESENTATION not in available:
        raise RuntimeError(
            f"the server does not offer the representation {REPRESENTATION!r}: the plugin "
            "TransferFunctionCombinations must be loaded there too"
        )
    display.SetRepresentationType(REPRESENTATION)
    with _traced(display):
        display.TransferFunction = state
        if unit_distance is not None:
            display.ScalarOpacityUnitDistance = unit_distance
        if shade is not None:
            display.Shade = 1 if shade else 0
    return display


def apply(display, tf):
    """Give a display that :func:`show` returned an edited transfer function. The view is not
    rendered.
    """
    state = _prepare(display.Input, tf)
    with _traced(display):
        display.TransferFunction = state
