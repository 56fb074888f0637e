# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
"""Follow the advice about attributes on a volume, and see whether the picture gets better.

    pvpython advice.py OUTPUT_DIR chest ct_chest_lidc0314.vti
    pvpython advice.py OUTPUT_DIR stroke mri_stroke_t1_t2_flair.vti
    pvpython advice.py OUTPUT_DIR hurricane sim_cm1_hurricane.vti

Prints the proposed axes with their tertiary attributes and how well each attribute splits one
region of the 2D domain. Writes advice_CASE_before.png, that region alone, and
advice_CASE_after.png, what is left of it when the best attribute cuts it at the proposed value: the
part above, or both parts in two colours.
"""

import argparse
import os

import tfc

ABOVE, BELOW = (0.95, 0.75, 0.35), (0.75, 0.2, 0.22)


class Case:
    """What to show: attributes to compare, axes, one region and the parts of it to keep."""

    def __init__(self, volume, arrays, axes, points, parts, opacity, view, fill=()):
        self.volume, self.arrays, self.axes, self.points = volume, arrays, axes, points
        self.parts, self.opacity, self.view, self.fill = parts, opacity, view, fill

    def make(self, parts=()):
        """A transfer function with the region, or with one region per (colour, function)."""
        tf = tfc.TransferFunction(*self.axes)
        for color, tertiary in parts or [(ABOVE, None)]:
            region = tf.add_polygon(self.points, color=color, opacity=self.opacity,
                                    falloff="smooth", width=0.3)
            if tertiary:
                region.tertiary(**tertiary)
        return tf


def chest(source):
    """Bone, and whatever else is dense: one region of intensity and gradient magnitude."""
    volume = tfc.attributes(source, "HU", ["gradient", "statistics", "occlusion"],
                            statistics={"MaximumRadius": 4},
                            occlusion={"Radius": 12, "BoundaryParameter": 1})
    return Case(volume, ["HU"] + ["HU_" + s for s in ("gradient", "mean", "stddev", "occlusion")],
                ("HU", "HU_gradient"), [(160, 0), (160, 120), (330, 220), (900, 220), (900, 0)],
                ["above"], 0.35,
                {"direction": (0, -1, 0.15), "up": (0, 0, 1), "unit_distance": 3.0})


def stroke(source):
    """Bright in FLAIR: the rim of the lesion, and much healthy tissue."""
    volume = tfc.attributes(source, "FLAIR", ["gradient", "occlusion"],
                            occlusion={"Radius": 12, "BoundaryParameter": 1})
    high = volume.PointData["FLAIR"].GetRange(0)[1]
    return Case(volume, ["FLAIR", "T1", "T2", "FLAIR_gradient", "FLAIR_occlusion"],
                ("FLAIR", "FLAIR_gradient"),
                [(0.55 * high, 0), (high, 0), (high, 30), (0.55 * high, 30)],
                ["above", "below"], 0.2,
                {"direction": (0.2, 0.3, 1), "up": (0, 1, 0), "unit_distance": 2.0},
                [0])  # outside of the brain


def hurricane(source):
    """The middle levels of the atmosphere, by pressure and temperature."""
    return Case(source, ["P", "TC", "QVAPOR", "Speed", "W", "VORTICITY", "DBZ"], ("P", "TC"),
                [(380, -21), (560, -3), (720, 8.5), (720, 18), (560, 6), (380, -9)],
                ["above"], 0.12,
                {"direction": (0, -1, 0.9), "up": (0, 0, 1), "unit_distance": 6.0})


CASES = {"chest": chest, "stroke": stroke, "hurricane": hurricane}


def save(volume, tf, path, direction, up, unit_distance, pixels=(330, 300)):
    """Render a transfer function from a direction."""
    from paraview import simple

    view = simple.CreateRenderView(ViewSize=list(pixels))
    view.UseColorPaletteForBackground = 0
    view.Background = [0.05, 0.06, 0.09]
    view.OrientationAxesVisibility = 0
    tfc.show(volume, tf, view, unit_distance=unit_distance, shade=True)
    bounds = volume.GetDataInformation().GetBounds()
    center = [(bounds[2 * a] + bounds[2 * a + 1]) / 2 for a in range(3)]
    view.CameraFocalPoint = center
    view.CameraPosition = [c + d for c, d in zip(center, direction)]
    view.CameraViewUp = list(up)
    simple.ResetCamera(view)
    view.CameraViewAngle = 19
    simple.SaveScreenshot(path, view, ImageResolution=list(pixels))
    simple.Delete(view)


def main():
    from paraview import simple

    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("output")
    parser.add_argument("case", choices=sorted(CASES))
    parser.add_argument("volume")
    options = parser.parse_args()
    os.makedirs(options.output, exist_ok=True)
    tfc.load_plugin()
    case = CASES[options.case](simple.OpenDataFile(options.volume))
    print("pair | kind | primary, secondary | tertiary: score, new information in bits")
    for row in tfc.suggest(case.volume, arrays=case.arrays, fill_values=case.fill):
        if row.rank <= 2:
            print(f"{row.pair} | {row.kind} | {row.primary}, {row.secondary} | {row.rank}. "
                  f"{row.tertiary}: {row.score:.3f}, {row.new_information:.2f}")
    print("attribute | power | separability | valley | cut | part below")
    rows = tfc.split(case.volume, case.make(), arrays=case.arrays)
    for row in rows:
        print(f"{row.attribute} | {row.power:.3f} | {row.separability:.3f} | {row.valley:.3f} | "
              f"{row.cut:.4g} | {row.below:.3f}")
    parts = {"above": (ABOVE, rows[0].keep_above), "below": (BELOW, rows[0].keep_below)}
    path = os.path.join(options.output, "advice_" + options.case)
    save(case.volume, case.make(), path + "_before.png", **case.view)
    after = case.make([parts[name] for name in case.parts])
    save(case.volume, after, path + "_after.png", **case.view)


if __name__ == "__main__":
    main()
