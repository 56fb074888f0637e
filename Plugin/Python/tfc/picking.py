# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
"""What is visible at a pixel of a view, and why."""

from collections import namedtuple

from .display import REPRESENTATION
from .plugin import load_plugin
from .scoring import _collect_errors

RegionShare = namedtuple("RegionShare", "id name weight tertiary opacity contribution")
RegionShare.__doc__ = """What one region makes of a sample: ``weight`` of its shape and fall-off,
factor of its ``tertiary`` function, ``opacity`` per unit distance (the product of both and the
region's own), and its share in the colour, ``contribution``, 0 to 1."""

Pick = namedtuple(
    "Pick", "position voxel block distance reached opacity total_opacity color axes values regions"
)
Pick.__doc__ = """A place on a line of sight.

``position`` in world coordinates, ``voxel`` (i, j, k) in ``block`` (0 for a single image),
``distance`` from the eye; ``opacity`` accumulated there and ``total_opacity`` of the whole line;
``reached``: whether the threshold was. ``color`` (red, green, blue, alpha per unit distance) is
that of the sample, ``axes`` its primary and secondary value, ``values`` a dictionary of all arrays
there, ``regions`` the :class:`RegionShare` of each visible region, in list order."""

# Properties that the display and the probe share.
CROPPING = ("UseCropping", "CroppingOrigin", "CroppingScale", "CroppingRegionFlags")


def _find_display(view):
    shown = [
        display
        for display in view.Representations
        if getattr(display, "Visibility", 0)
        and getattr(display, "Representation", None) == REPRESENTATION
    ]
    if len(shown) != 1:
        raise ValueError(
            f"the view shows {len(shown)} displays of the type {REPRESENTATION!r}; "
            "say which one as display=..."
        )
    return shown[0]


def _line_of_sight(view, x, y):
    """(eye, far end) of a pixel in world coordinates; x and y count from the lower left corner."""
    from vtkmodules.vtkCommonMath import vtkMatrix4x4

    width, height = view.ViewSize
    if not (0 <= x < width and 0 <= y < height):
        raise ValueError(f"({x}, {y}) is outside of the view, which has {width} x {height} pixels")
    camera = view.GetActiveCamera()
    near, far = camera.GetClippingRange()
    matrix = vtkMatrix4x4()
    vtkMatrix4x4.Invert(camera.GetCompositeProjectionTransformMatrix(width / height, -1, 1), matrix)

    def unproject(depth):
        place = (2 * (x + 0.5) / width - 1, 2 * (y + 0.5) / height - 1, depth, 1)
        point = matrix.MultiplyPoint(place)
        return [c / point[3] for c in point[:3]]

    front, back = unproject(-1), unproject(1)
    # The eye: distance 0 from its plane, where both clipping planes are known distances away.
    eye = [f - (b - f) * near / (far - near) for f, b in zip(front, back)]
    return eye, back


def _transform(display):
    """The matrix of a display's translation, orientation and scale, by rows."""
    from vtkmodules.vtkRenderingCore import vtkActor

    actor = vtkActor()
    actor.SetPosition(*display.Position)
    actor.SetOrientation(*display.Orientation)
    actor.SetScale(*display.Scale)
    actor.SetOrigin(*display.Origin)
    matrix = actor.GetMatrix()
    return [matrix.GetElement(i, j) for i in range(4) for j in range(4)]


def _read(table, row=0):
    names = [table.GetColumnName(c) for c in range(table.GetNumberOfColumns())]
    return {name: table.GetValueByName(row, name) for name in names}


def pick(view, x, y, display=None, threshold=0.5):
    """What the "Combined Volume" of a view shows at a pixel, as a :class:`Pick`, or None where
    nothing of it is visible.

    ``x`` and ``y`` are pixels of ``view.ViewSize`` from the lower left corner. The place is the
    first one along the line of sight where the accumulated opacity reaches ``threshold`` or, where
    it never does, the one that contributes most. Other objects in front of the volume play no
    part. Without ``display`` the view must show one combined volume. ::

        found = tfc.pick(view, 320, 240)
        for region in found.regions:
            print(region.name, region.contribution)

    Raises ValueError for a pixel outside of the view, and with the reason when the volume cannot be
    probed.
    """
    from paraview import servermanager, simple

    load_plugin()
    display = display or _find_display(view)
    eye, end = _line_of_sight(view, x, y)
    probe = simple.RayProbe(registrationName="tfc.pick", Input=display.Input)
    try:
        probe.TransferFunction = display.TransferFunction
        probe.StartPoint = eye
        probe.EndPoint = end
        probe.Threshold = threshold
        probe.UnitDistance = display.ScalarOpacityUnitDistance
        probe.SampleDistance = display.SampleDistance
        probe.Transform = _transform(display)
        for name in CROPPING:
            setattr(probe, name, getattr(display, name))
        errors = _collect_errors(probe)
        probe.UpdatePipeline()
        location = servermanager.Fetch(probe)
        shares = servermanager.Fetch(probe, idx=1)
    finally:
        simple.Delete(probe)
    if errors:
        raise ValueError("nothing was picked: " + " ".join(errors))
    if not location or location.GetNumberOfRows() == 0:
        return None
    values = {name: value.ToDouble() for name, value in _read(location).items()}
    fixed = {name: values.pop(name) for name in (
        "x", "y", "z", "distance", "i", "j", "k", "block", "reached", "opacity", "total_opacity",
        "red", "green", "blue", "alpha", "primary", "secondary")}
    regions = []
    for row in range(shares.GetNumberOfRows()):
        cells = _read(shares, row)
        regions.append(RegionShare(
            cells.pop("id").ToInt(), cells.pop("name").ToString(),
            *(cells[name].ToDouble() for name in RegionShare._fields[2:])))
    return Pick(
        position=tuple(fixed[c] for c in "xyz"), voxel=tuple(int(fixed[c]) for c in "ijk"),
        block=int(fixed["block"]), distance=fixed["distance"], reached=bool(fixed["reached"]),
        opacity=fixed["opacity"], total_opacity=fixed["total_opacity"],
        color=tuple(fixed[c] for c in ("red", "green", "blue", "alpha")),
        axes=(fixed["primary"], fixed["secondary"]), values=values,
        regions=regions)
