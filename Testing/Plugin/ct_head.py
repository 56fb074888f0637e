# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
"""The CT head: the combination separates brain and skin, which the 2D transfer function cannot.

The truth comes from anatomy and geometry, not from the gradient or the occlusion: the skin is what
is soft and within 5 mm of the air outside, the brain what is soft and can be reached from the
middle of the skull through passages wider than 14 mm.
"""
import os
import sys
import tempfile

import numpy as np

import scripttest

try:
    from scipy import ndimage
except ImportError:
    scripttest.skip("SciPy is not installed")

sys.path.insert(0, sys.argv[1])
import ct_head
import invesalius

if not os.path.exists(invesalius.CT_HEAD):
    scripttest.skip("the package invesalius-examples is not installed")

scripttest.load_plugin(globals())
from paraview import servermanager

voxels, spacing = invesalius.read(invesalius.CT_HEAD)
scripttest.check(voxels.shape == (108, 256, 256) and spacing[2] == 1.5, "size and spacing")

# Every other voxel is enough for the truth.
EVERY = (slice(None, None, 2),) * 3
step = tuple(2 * s for s in spacing[::-1])
hu = ndimage.gaussian_filter(voxels.astype(np.float32), 0.8)[EVERY]


def component(mask, seed=None):
    """The largest connected part of a mask, or the one with a voxel."""
    labels, count = ndimage.label(mask)
    sizes = np.bincount(labels.ravel())
    sizes[0] = 0
    return labels == (labels[seed] if seed else sizes.argmax())


soft = (hu > -10) & (hu < 100)
middle = component(ndimage.distance_transform_edt(soft, step) > 7, (30, 65, 50))
brain = soft & (ndimage.distance_transform_edt(~middle, step) < 7.5)
head = component(ndimage.binary_opening(hu > -300))
head = np.stack([ndimage.binary_fill_holes(part) for part in ndimage.binary_closing(head)])
# The scan ends in the neck: depth counts from the air at the sides only.
outside = ~np.concatenate([head[:1], head])
depth = ndimage.distance_transform_edt(~outside, step)[1:]
skin = head & (depth < 5) & (hu > -150) & (hu < 150)
skin[:8] = False
millilitres = np.prod(step) / 1000
scripttest.check(1100 < brain.sum() * millilitres < 1700,
                 "the brain has %.0f ml" % (brain.sum() * millilitres))
scripttest.check(100 < skin.sum() * millilitres < 600,
                 "the skin has %.0f ml" % (skin.sum() * millilitres))


def classify(source, tf):
    """Which voxels are labelled as brain, and which as skin."""
    filter = ClassifyVolume(Input=source, TransferFunction=tf.to_json())
    region = scripttest.volume(servermanager.Fetch(filter), "tfc_region")[EVERY]
    ids = lambda word: [r.id for r in tf.regions if word in r.name]
    return np.isin(region, ids("brain")), np.isin(region, ids("skin"))


with tempfile.TemporaryDirectory() as folder:
    path = os.path.join(folder, "ct_head.vti")
    invesalius.write_vti(path, voxels, spacing, "HU")
    source = ct_head.make_pipeline(path)
    source.UpdatePipeline()
    found = {}
    for name in ("2d", "combined"):
        tf = getattr(ct_head, "transfer_function_" + name)()
        as_brain, as_skin = classify(source, tf)
        found[name] = {
            "brain found": as_brain[brain].mean(),
            "skin found": as_skin[skin].mean(),
            "skin taken for brain": as_brain[skin].mean(),
            "brain taken for skin": as_skin[brain].mean(),
        }
        print(name + ": " + ", ".join("%s %.1f %%" % (k, 100 * v) for k, v in found[name].items()))

combined, flat = found["combined"], found["2d"]
scripttest.check(combined["brain found"] > 0.9, "the combination finds the brain")
scripttest.check(combined["skin found"] > 0.8, "the combination finds the skin")
scripttest.check(combined["skin taken for brain"] < 0.05, "it takes little skin for brain")
scripttest.check(combined["brain taken for skin"] < 0.02, "it takes little brain for skin")
scripttest.check(flat["skin taken for brain"] > 0.2 and flat["skin found"] < 0.5,
                 "the 2D transfer function confuses them")

rows = ct_head.tfc.score(source, primary="HU")
scripttest.check(rows[0].attribute == "HU_occlusion" and rows[0].rank == 1,
                 "the occlusion is the best attribute")
