# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
"""What the advice says about the material phantom, where the truth is known.

    pvpython advice_phantom.py [--sizes 128 256] [--seeds 1 2 3]

Prints, as Markdown: the score table, and for several sets of attributes the best Dice coefficient
that any transfer function over them could reach per material, as means over the seeds.
"""

import argparse

from paraview import simple

import tfc

MATERIALS = ("environment", "hull", "filling", "A", "B", "C")
# Axes, then tertiary attributes.
SETS = {
    "x, gradient": ("", "_gradient"),
    "mean, stddev": ("_mean", "_stddev"),
    "x, occlusion": ("", "_occlusion"),
    "mean, stddev, occlusion": ("_mean", "_stddev", "_occlusion"),
    "mean, stddev, occlusion or size": ("_mean", "_stddev", "_occlusion", "_size"),
}
ALL = ("", "_gradient", "_mean", "_stddev", "_occlusion", "_size")


def compute(size, seed):
    """The phantom with all attributes; lengths grow with it, from the paper's at 256."""
    phantom = simple.MaterialPhantom(Dimensions=[size] * 3, Seed=seed)
    return tfc.attributes(
        phantom, "intensity", ["gradient", "statistics", "occlusion", "size"],
        statistics={"MaximumRadius": 10 if size >= 256 else 6},
        occlusion={"Radius": 40 * size // 256, "BoundaryParameter": 1},
        size={"LargestSize": 48 * size / 256, "SmallestSize": 10 * size / 256})


def best_possible(volume, suffixes):
    """Best Dice coefficient per material over these attributes, judged on voxels not used."""
    names = ["intensity" + suffix for suffix in suffixes]
    tf = tfc.TransferFunction(*names[:2])
    for name in names[2:] or [None]:
        # The whole plane: what the regions are does not matter here, only the attributes do.
        region = tf.add_rectangle(center=(0, 0), halfsize=(100, 100))
        if name:
            region.tertiary(name, [(-100, 1), (100, 1)])
    return [row.best_dice for row in tfc.quality(volume, tf, "material").rows]


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("--sizes", type=int, nargs="+", default=[128, 256])
    parser.add_argument("--seeds", type=int, nargs="+", default=[1, 2, 3])
    options = parser.parse_args()
    tfc.load_plugin()
    for size in options.sizes:
        dice = {name: [] for name in SETS}
        scores = []
        for seed in options.seeds:
            volume = compute(size, seed)
            arrays = ["intensity" + suffix for suffix in ALL]
            for pair in (("", "_gradient"), ("_mean", "_stddev")):
                axes = tuple("intensity" + suffix for suffix in pair)
                scores.append((seed, axes, tfc.score(volume, *axes, arrays=arrays)))
            for name, suffixes in SETS.items():
                dice[name].append(best_possible(volume, suffixes))
            for proxy in list(simple.GetSources().values()):
                simple.Delete(proxy)
        print(f"\n## {size}^3\n")
        for seed, axes, rows in scores:
            print(f"\nseed {seed}, axes {axes[0]}, {axes[1]}\n")
            print("| attribute | R | E, bits | score | rank | new information, bits | separation |")
            print("| --- | ---: | ---: | ---: | ---: | ---: | ---: |")
            for row in rows:
                if row.rank:
                    print(f"| {row.attribute} | {row.correlation:.4f} | {row.entropy:.3f} | "
                          f"{row.score:.4f} | {row.rank} | {row.new_information:.3f} | "
                          f"{row.separation:.3f} |")
        print("\n| attributes | " + " | ".join(MATERIALS) + " |")
        print("| --- |" + " ---: |" * len(MATERIALS))
        for name, found in dice.items():
            cells = []
            for values in zip(*found):
                mean = sum(values) / len(values)
                cells.append(f"{mean:.3f} ({max(values) - min(values):.3f})")
            print(f"| {name} | " + " | ".join(cells) + " |")


if __name__ == "__main__":
    main()
