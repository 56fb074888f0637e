# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
"""The attributes of a volume that the plugin computes, several in one call."""

from .display import find_array
from .plugin import load_plugin
from .scoring import _collect_errors

# Name in attributes() -> proxy.
FILTERS = {
    "gradient": "VolumeGradientMagnitude",
    "statistics": "VolumeLocalStatistics",
    "occlusion": "VolumeOcclusion",
    "size": "VolumeFeatureSize",
}


def _association(source, name):
    """POINTS or CELLS: where the source has the array."""
    points = source.GetDataInformation().GetPointDataInformation()
    return "POINTS" if points.GetArrayInformation(name) else "CELLS"


def _check(source, names, which, properties):
    """Raise what is wrong with the arguments of attributes()."""
    unknown = [name for name in list(which) + list(properties) if name not in FILTERS]
    if unknown:
        raise ValueError(f"no attribute {unknown[0]!r}; there are: {', '.join(FILTERS)}")
    unused = [name for name in properties if name not in which]
    if unused:
        raise ValueError(f"properties of {unused[0]!r}, which is not among the attributes wanted")
    source.UpdatePipeline()
    for name in names:
        find_array(source, name)
    if len({_association(source, name) for name in names}) > 1:
        raise ValueError("some arrays are of points and some of cells: call once for each kind")


def attributes(source, array, which=("gradient", "statistics", "occlusion"), **properties):
    """Add attributes of an array to a source, and return the source that has all of them.

    ``array`` is the name of a point or cell array, or a list of names. ``which`` names what to
    compute: ``"gradient"`` (magnitude), ``"statistics"`` (local mean, deviation and radius),
    ``"occlusion"`` and ``"size"``. Properties of the filters follow as dictionaries::

        volume = tfc.attributes(scan, "HU", which=["gradient", "occlusion", "size"],
                                occlusion={"Radius": 20, "Neighborhood": "Sphere"},
                                size={"LargestSize": 12})
        for row in tfc.score(volume, primary="HU", secondary="HU_gradient"):
            print(row)

    The filters stand one after the other in the pipeline, where they can be edited; each passes
    its input on. Raises KeyError for an unknown array and ValueError, with the reason, for an
    unknown attribute or property and when a filter fails; the pipeline is then as it was.
    """
    from paraview import simple

    load_plugin()
    names = [array] if isinstance(array, str) else list(array)
    which = [which] if isinstance(which, str) else list(which)
    if not names:
        raise ValueError("no array was named")
    _check(source, names, which, properties)
    chosen = [_association(source, names[0]), names[0]]
    made = []
    current = source
    try:
        for name in which:
            wanted = properties.get(name, {})
            proxy = getattr(simple, FILTERS[name])(Input=current, InputArray=chosen)
            made.append(proxy)
            if len(names) > 1:
                proxy.MoreArrays = names[1:]
            for key, value in wanted.items():
                if key not in proxy.ListProperties():
                    raise ValueError(
                        f"{FILTERS[name]} has no property {key!r}; there are: "
                        + ", ".join(proxy.ListProperties())
                    )
                setattr(proxy, key, value)
            errors = _collect_errors(proxy)
            proxy.UpdatePipeline()
            if proxy.GetDataInformation().GetNumberOfPoints() == 0:
                reason = " ".join(errors) or "see the server's messages"
                raise ValueError(f"{FILTERS[name]}: {reason}")
            current = proxy
    except Exception:
        for proxy in reversed(made):
            simple.Delete(proxy)
        raise
    return current
