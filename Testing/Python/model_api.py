# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
"""The transfer function as Python objects: what scripts do with it, and what they do wrong."""
import json
import os
import tempfile

import scripttest

import tfc

check = scripttest.check
raises = scripttest.raises


def make():
    return tfc.TransferFunction("P", "TC", primary_range=(900, 1010), secondary_range=(-80, 30))


# Everything that can be added, and what the state then holds.
tf = make()
ellipse = tf.add_ellipse(center=(930, 20), radii=(12, 4), angle=30, color="crimson", opacity=0.6)
rectangle = tf.add_rectangle((950, 0), (10, 5), angle=-10, name="box", falloff="constant")
triangle = tf.add_triangle([(900, 0), (910, 0), (905, 9)], falloff="gaussian", width=0.5)
polygon = tf.add_polygon([(900, 0), (910, 0), (910, 9), (905, 2)], visible=False, color="#00ff00")
check([r.id for r in tf.regions] == [1, 2, 3, 4], "ids count from 1")
check([r.shape["type"] for r in tf.regions] == ["ellipse", "rectangle", "triangle", "polygon"],
      "shapes in order")
check(ellipse.shape == {"type": "ellipse", "center": [930, 20], "radii": [12, 4], "angle": 30},
      "ellipse")
check(rectangle.name == "box" and ellipse.name == "region 1", "names")
check(not polygon.visible and polygon.color == (0, 1, 0), "visible and colour")
state = json.loads(tf.to_json())
check(state["regions"][0]["falloff"] == {"type": "smooth", "width": 0.25}, "default fall-off")
check(state["regions"][2]["falloff"] == {"type": "gaussian", "width": 0.5}, "fall-off")
check(state["regions"][0]["tertiary"] is None, "no tertiary function by default")

# Tertiary functions, with colours; edits through any object of the region are the same edit.
ellipse.tertiary("QVAPOR", [(0, 0), (8, 0), (8, 1)], color=[(0, "white"), (8, (1, 0, 0))],
                 component=-1, range=(0, 20))
tertiary = json.loads(tf.to_json())["regions"][0]["tertiary"]
check(tertiary == {"array": "QVAPOR", "component": -1, "range": [0, 20],
                   "opacity": [[0, 0], [8, 0], [8, 1]], "color": [[0, 1, 1, 1], [8, 1, 0, 0]]},
      "tertiary function")
tf.region("box").opacity = 0.25
check(rectangle.opacity == 0.25 and tf.region(2).opacity == 0.25, "one region, several objects")
rectangle.tertiary("QVAPOR", [(0, 1)]).tertiary(None)
check(rectangle.tertiary_state is None, "tertiary function removed")

# What is refused changes nothing, and the text says where and what.
before = tf.to_json()
raises(ValueError, lambda: tf.add_ellipse((0, 0), (0, 1)), "radii[0]", "> 0")
raises(ValueError, lambda: tf.add_ellipse((0, 0, 0), (1, 1)), "center", "2 numbers, got 3")
raises(ValueError, lambda: tf.add_ellipse((float("nan"), 0), (1, 1)), "center", "finite")
raises(ValueError, lambda: tf.add_ellipse((0, 0), (1, 1), opacity=float("inf")), "opacity")
raises(ValueError, lambda: tf.add_rectangle((0, 0), (-1, 1)), "halfsize[0]", "> 0")
raises(ValueError, lambda: tf.add_triangle([(0, 0), (1, 1)]), "points", "3")
raises(ValueError, lambda: tf.add_polygon([(0, 0), (1, 1), (2, 2)]), "points", "one line")
raises(ValueError, lambda: tf.add_ellipse((0, 0), (1, 1), opacity=2), "regions[4].opacity")
raises(ValueError, lambda: tf.add_ellipse((0, 0), (1, 1), falloff="cubic"), "cubic", "smooth")
raises(ValueError, lambda: tf.add_ellipse((0, 0), (1, 1), width=0), "falloff.width", "(0, 1]")
raises(ValueError, lambda: tf.add_ellipse((0, 0), (1, 1), color="nocolour"), "nocolour", "CSS")
raises(TypeError, lambda: tf.add_ellipse((0, 0), (1, 1), colour="red"), "colour")
raises(ValueError, lambda: ellipse.tertiary("Q", []), "at least one")
raises(ValueError, lambda: ellipse.tertiary("Q", [(1, 0), (0, 1)]), "tertiary.opacity[1]")
raises(ValueError, lambda: ellipse.tertiary("Q", [(0, 2)]), "regions[0].tertiary.opacity[0]")
raises(ValueError, lambda: ellipse.tertiary("Q", [(0, 1)], range=(3, 3)), "range", "low < high")
raises(ValueError, lambda: setattr(ellipse, "opacity", -1), "regions[0].opacity")
raises(ValueError, lambda: setattr(tf, "blend", "add"), "blend", "mix")
raises(ValueError, lambda: ellipse.falloff("linear", 3), "falloff.width")
raises(KeyError, lambda: tf.region("eye"), "eye", "2 'box'")
raises(KeyError, lambda: tf.remove("eye"), "eye")
raises(ValueError, lambda: tfc.TransferFunction("", "TC"), "primary.array")
raises(ValueError, lambda: tfc.TransferFunction("P", "TC", primary_range=(2, 1)), "low < high")
raises(ValueError, lambda: tfc.TransferFunction("P", "TC", primary_component=-2), "component")
check(tf.to_json() == before, "refused edits change nothing")

# Ids are never reused.
tf.remove(polygon)
check(tf.add_ellipse((0, 0), (1, 1)).id == 5, "a removed region's id is not given again")
raises(KeyError, lambda: tf.remove(polygon), "no region 4")
tf.remove("box")
tf.remove(5)
check([r.id for r in tf.regions] == [1, 3], "removed by name and id")
check(tf.add_ellipse((0, 0), (1, 1)).id == 6, "an id after the last one given")

# Files.
with tempfile.TemporaryDirectory() as folder:
    path = os.path.join(folder, "state.tfc.json")
    tf.save(path)
    loaded = tfc.load(path)
    check(loaded == tf and loaded.to_json() == tf.to_json(), "saved and loaded")
    with open(path) as file:
        check(file.read() == tf.to_json().rstrip("\n") + "\n", "the file is the plugin's own text")
    check(loaded.region(3).name == triangle.name, "regions of a loaded state keep their ids")
    loaded.remove(6)
    check(loaded.add_ellipse((0, 0), (1, 1)).id == 7, "no id reused after loading and removing")
    check(loaded != tf, "different states differ")
    first = loaded.regions[0]
    first.opacity = 0.125
    check(loaded.region(first.id).opacity == 0.125, "edits of a loaded region")

    with open(path, "w") as file:
        file.write('{"format": "transfer-function-combination", "version": 2}')
    raises(ValueError, lambda: tfc.load(path), path, "version 2 is newer")
    with open(path, "w") as file:
        file.write("not JSON")
    raises(ValueError, lambda: tfc.load(path), path, "valid JSON")
    raises(FileNotFoundError, lambda: tfc.load(os.path.join(folder, "none")), "none")

empty = tfc.TransferFunction.from_json("")
check(repr(empty) == "<TransferFunction ? x ?, mix: 0 regions>", "an empty state has no axes")
raises(TypeError, lambda: hash(tf), "unhashable")
