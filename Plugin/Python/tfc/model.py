# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
"""The combined transfer function as Python objects.

The objects hold the JSON state (format ``transfer-function-combination``, version 1) and nothing
else; the plugin's own reader checks every edit, so a script, a state file and the GUI agree on what
is valid. An edit that is refused raises ValueError and changes nothing.
"""

import json
import math

from .colors import to_rgb
from .vtk.vtkTFCTransferFunction import vtkTFCTransferFunction

FORMAT = "transfer-function-combination"
VERSION = 1
FALLOFFS = ("constant", "linear", "smooth", "gaussian")


def _number(value, what):
    number = float(value)
    if not math.isfinite(number):
        raise ValueError(f"{what}: expected a finite number, got {number}")
    return number


def _numbers(values, count, what):
    numbers = [_number(value, what) for value in values]
    if len(numbers) != count:
        raise ValueError(f"{what}: expected {count} numbers, got {len(numbers)}")
    return numbers


def _attribute(array, component, value_range):
    attribute = {"array": array, "component": int(component)}
    if value_range is not None:
        attribute["range"] = _numbers(value_range, 2, "range")
    return attribute


def _falloff(kind, width):
    if kind not in FALLOFFS:
        raise ValueError(f"unknown fall-off {kind!r}: one of {', '.join(FALLOFFS)}")
    return {"type": kind, "width": 0.25 if width is None else _number(width, "width")}


class Region:
    """One region of a combined transfer function. Made by the ``add_...`` methods of
    :class:`TransferFunction`; change it through its attributes and :meth:`tertiary`.
    """

    def __init__(self, state, owner):
        self._state = state
        self._owner = owner

    def _change(self, **values):
        """Change the state; put it back when the reader refuses it."""
        previous = dict(self._state)
        self._state.update(values)
        try:
            self._owner._check()
        except ValueError:
            self._state.clear()
            self._state.update(previous)
            raise

    @property
    def id(self):
        """Number that identifies the region in the state and in ``tfc_region``; never reused."""
        return self._state["id"]

    @property
    def name(self):
        """Text for people."""
        return self._state["name"]

    @name.setter
    def name(self, name):
        self._change(name=str(name))

    @property
    def visible(self):
        """Whether the region takes part in the classification."""
        return self._state["visible"]

    @visible.setter
    def visible(self, visible):
        self._change(visible=bool(visible))

    @property
    def color(self):
        """Red, green and blue in [0, 1]; set from numbers, a CSS name or ``#rrggbb``."""
        return tuple(self._state["color"])

    @color.setter
    def color(self, color):
        self._change(color=to_rgb(color))

    @property
    def opacity(self):
        """Largest opacity of the region, per unit distance, in [0, 1]."""
        return self._state["opacity"]

    @opacity.setter
    def opacity(self, opacity):
        self._change(opacity=_number(opacity, "opacity"))

    @property
    def shape(self):
        """The 2D outline as in the state, e.g. ``{"type": "ellipse", "center": ..., ...}``."""
        return self._state["shape"]

    def falloff(self, kind, width=None):
        """How the weight falls from the middle of the shape to its border: ``"constant"``,
        ``"linear"``, ``"smooth"`` or ``"gaussian"``, with a width in (0, 1]. Returns the region.

        >>> tf = TransferFunction("P", "TC")
        >>> tf.add_ellipse((930, 20), (12, 4)).falloff("gaussian", 2)
        Traceback (most recent call last):
        ...
        ValueError: regions[0].falloff.width: expected a number in (0, 1], got 2.0
        """
        self._change(falloff=_falloff(kind, width))
        return self

    def tertiary(self, array, opacity=None, color=None, component=0, range=None):
        """Multiply the region's opacity by a piecewise linear function of a third attribute.

        ``opacity`` is a list of (value, factor) with increasing values in data units and factors in
        [0, 1]; beyond the ends the end factors hold. Two points at one value make a step.
        ``color``, a list of (value, colour), replaces the region's colour by one that follows the
        attribute.
        ``component`` -1 is the magnitude of a vector. ``range`` is the extent of the axis in an
        editor; left out, it is taken from the data when shown. ``tertiary(None)`` removes it.
        Returns the region.

        >>> tf = TransferFunction("P", "TC")
        >>> eye = tf.add_ellipse(center=(930, 20), radii=(12, 4))
        >>> eye.tertiary("QVAPOR", [(0, 0), (8, 0), (10, 1)]).tertiary_state["opacity"]
        [[0.0, 0.0], [8.0, 0.0], [10.0, 1.0]]
        """
        if array is None:
            self._change(tertiary=None)
            return self
        if not opacity:
            raise ValueError("a tertiary function needs at least one (value, factor) point")
        tertiary = _attribute(array, component, range)
        what = "point of a tertiary function"
        tertiary["opacity"] = [_numbers(point, 2, what) for point in opacity]
        if color is not None:
            tertiary["color"] = [[_number(value, what)] + to_rgb(rgb) for value, rgb in color]
        self._change(tertiary=tertiary)
        return self

    @property
    def tertiary_state(self):
        """The tertiary function as in the state, or None."""
        return self._state.get("tertiary")

    def __repr__(self):
        shape = self._state["shape"]["type"]
        tertiary = self.tertiary_state
        text = f" with {tertiary['array']}" if tertiary else ""
        return f"<Region {self.id} {self.name!r}: {shape}{text}>"


class TransferFunction:
    """A combined transfer function over two axes.

    ``primary`` and ``secondary`` name point or cell arrays; ``range`` arguments are the extent of
    an axis in data units and are taken from the data when left out. Voxels outside an axis's range
    are in no region. ``blend`` is ``"mix"`` (order does not matter) or ``"over"`` (the first region
    is in front).

    >>> tf = TransferFunction("P", "TC", primary_range=(900, 1010), secondary_range=(-80, 30))
    >>> eye = tf.add_ellipse(center=(930, 20), radii=(12, 4), color="crimson", opacity=.6)
    >>> eye.tertiary("QVAPOR", [(0, 0), (8, 0), (10, 1), (20, 1)])
    <Region 1 'region 1': ellipse with QVAPOR>
    >>> tf
    <TransferFunction P x TC, mix: 1 region>
    """

    def __init__(
        self,
        primary,
        secondary,
        primary_range=None,
        secondary_range=None,
        blend="mix",
        primary_component=0,
        secondary_component=0,
    ):
        self._state = {
            "format": FORMAT,
            "version": VERSION,
            "primary": _attribute(primary, primary_component, primary_range),
            "secondary": _attribute(secondary, secondary_component, secondary_range),
            "blend": blend,
            "regions": [],
        }
        self._last_id = 0
        self._check()

    @classmethod
    def from_json(cls, text):
        """Read a state. Raises ValueError with the field that is wrong.

        >>> TransferFunction.from_json('{"format": "something else"}')
        Traceback (most recent call last):
        ...
        ValueError: format: ...
        """
        model = vtkTFCTransferFunction()
        tf = cls.__new__(cls)
        tf._state = json.loads(_canonical(model, text))
        tf._last_id = max((region["id"] for region in tf._state["regions"]), default=0)
        return tf

    @property
    def primary(self):
        """The primary axis as in the state."""
        return self._state["primary"]

    @property
    def secondary(self):
        """The secondary axis as in the state."""
        return self._state["secondary"]

    @property
    def blend(self):
        """``"mix"`` or ``"over"``."""
        return self._state["blend"]

    @blend.setter
    def blend(self, blend):
        previous = self._state["blend"]
        self._state["blend"] = blend
        try:
            self._check()
        except ValueError:
            self._state["blend"] = previous
            raise

    @property
    def regions(self):
        """The regions in list order."""
        return [Region(state, self) for state in self._state["regions"]]

    def region(self, key):
        """The region with this id or name."""
        for region in self.regions:
            if key in (region.id, region.name):
                return region
        names = ", ".join(f"{r.id} {r.name!r}" for r in self.regions) or "none"
        raise KeyError(f"no region {key!r}; there are: {names}")

    def remove(self, region):
        """Remove a region, given itself, its id or its name."""
        found = self.region(region.id if isinstance(region, Region) else region)
        self._state["regions"] = [r for r in self._state["regions"] if r["id"] != found.id]

    def add_ellipse(self, center, radii, angle=0, **options):
        """Add an ellipse. ``center`` and ``radii`` are in data units along the two axes before the
        rotation by ``angle`` degrees, counter-clockwise in the square that the axis ranges map to.

        All ``add_...`` methods take ``name``, ``color`` (numbers, CSS name or ``#rrggbb``),
        ``opacity`` (per unit distance, in [0, 1]; 1 by default), ``falloff`` (``"smooth"`` by
        default) and its ``width`` (0.25), and ``visible``; they return the new :class:`Region`.
        """
        shape = {
            "type": "ellipse",
            "center": _numbers(center, 2, "center"),
            "radii": _numbers(radii, 2, "radii"),
            "angle": _number(angle, "angle"),
        }
        return self._add(shape, **options)

    def add_rectangle(self, center, halfsize, angle=0, **options):
        """Add a rectangle; ``halfsize`` as the radii of :meth:`add_ellipse`."""
        shape = {
            "type": "rectangle",
            "center": _numbers(center, 2, "center"),
            "halfsize": _numbers(halfsize, 2, "halfsize"),
            "angle": _number(angle, "angle"),
        }
        return self._add(shape, **options)

    def add_triangle(self, points, **options):
        """Add a triangle from three points."""
        shape = {"type": "triangle", "points": [_numbers(p, 2, "point") for p in points]}
        return self._add(shape, **options)

    def add_polygon(self, points, **options):
        """Add a closed polygon from at least three points (even-odd rule)."""
        shape = {"type": "polygon", "points": [_numbers(p, 2, "point") for p in points]}
        return self._add(shape, **options)

    def _add(
        self,
        shape,
        name=None,
        color=(1, 1, 1),
        opacity=1,
        falloff="smooth",
        width=None,
        visible=True,
    ):
        # Ids are never reused, not even that of a removed region.
        new_id = self._last_id + 1
        region = {
            "id": new_id,
            "name": name or f"region {new_id}",
            "visible": bool(visible),
            "shape": shape,
            "falloff": _falloff(falloff, width),
            "color": to_rgb(color),
            "opacity": _number(opacity, "opacity"),
            "tertiary": None,
        }
        self._state["regions"].append(region)
        try:
            self._check()
        except ValueError:
            self._state["regions"].pop()
            raise
        self._last_id = new_id
        return Region(region, self)

    def _check(self):
        _canonical(vtkTFCTransferFunction(), json.dumps(self._state))

    def to_json(self):
        """The state as JSON, checked: raises ValueError with the field that is wrong."""
        return _canonical(vtkTFCTransferFunction(), json.dumps(self._state))

    def save(self, path):
        """Write the state to a file, by custom ``NAME.tfc.json``."""
        text = self.to_json()
        with open(path, "w", encoding="utf-8") as file:
            file.write(text.rstrip("\n") + "\n")

    def __eq__(self, other):
        return isinstance(other, TransferFunction) and self.to_json() == other.to_json()

    __hash__ = None

    def __repr__(self):
        count = len(self._state["regions"])
        axes = " x ".join(axis["array"] if axis else "?" for axis in (self.primary, self.secondary))
        return f"<TransferFunction {axes}, {self.blend}: {count} region{'' if count == 1 else 's'}>"


def _canonical(model, text):
    """The state as the plugin writes it, or ValueError with what the plugin finds wrong."""
    # The message is raised as an exception; VTK's own report of it would only repeat it.
    model.AddObserver("ErrorEvent", lambda *_: None)
    if not model.SetState(text):
        raise ValueError(model.GetLastError())
    return model.GetState()


def load(path):
    """Read a transfer function that :meth:`TransferFunction.save` or the plugin has written."""
    with open(path, encoding="utf-8") as file:
        text = file.read()
    try:
        return TransferFunction.from_json(text)
    except ValueError as error:
        raise ValueError(f"{path}: {error}") from None
