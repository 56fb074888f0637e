# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
"""Properties and scores of real volumes, against NumPy and SciPy."""
import scripttest

head = scripttest.data_file("ct_head_invesalius.vti")
hurricane = scripttest.data_file("sim_cm1_hurricane.vti")
try:
    import numpy as np
    import scipy.ndimage
except ImportError as error:
    scripttest.skip("needs SciPy (Debian: python3-scipy): %s" % error)

from paraview import servermanager
from paraview.simple import *

scripttest.load_plugin(globals())

source = OpenDataFile(head)
source.UpdatePipeline()
name = source.PointData.keys()[0]
gradient = VolumeGradientMagnitude(Input=source, InputArray=["POINTS", name])
occlusion = VolumeOcclusion(Input=gradient, InputArray=["POINTS", name], Radius=10)
result = servermanager.Fetch(occlusion)
values = scripttest.volume(result, name).astype(float)
spacing = result.GetSpacing()
slopes = np.gradient(values, spacing[2], spacing[1], spacing[0])
scripttest.check_close(scripttest.volume(result, name + "_gradient"),
                       np.sqrt(sum(s ** 2 for s in slopes)), 1e-6, "gradient of the CT head")
span = values.max() - values.min()
squared = sum(s ** 2 for s in np.gradient(values / span))
mean = scipy.ndimage.uniform_filter(values, 21, mode="constant")
mean /= scipy.ndimage.uniform_filter(np.ones(values.shape), 21, mode="constant")
scripttest.check_close(scripttest.volume(result, name + "_occlusion"),
                       mean * 0.005 ** 2 / (squared + 0.005 ** 2), 1e-5, "occlusion of the CT head")

source = OpenDataFile(hurricane)
source.UpdatePipeline()
score = CombinationScore(Input=source)
data = servermanager.Fetch(source)
rows = scripttest.table(servermanager.Fetch(score), ("attribute", "correlation"))
names = [key for key in source.PointData.keys()
         if source.PointData[key].GetNumberOfComponents() == 1]
scripttest.check(sorted(row[0] for row in rows) == sorted(names), "attributes %s" % names)
flat = {key: scripttest.volume(data, key).ravel().astype(float) for key in names}
for key, r in rows:
    both = np.isfinite(flat[key]) & np.isfinite(flat[names[0]])
    scripttest.check_close([r], [np.corrcoef(flat[key][both], flat[names[0]][both])[0, 1]], 1e-9,
                           "correlation of %s and %s" % (key, names[0]))

# Every attribute of every volume: present, finite where the data are, within what it can be.
VOLUMES = [("ct_head_invesalius.vti", "HU"), ("ct_chest_lidc0314.vti", "HU"),
           ("mri_stroke_t1_t2_flair.vti", "T1"), ("sim_cm1_hurricane.vti", "QVAPOR")]
for path, array in VOLUMES:
    volume = OpenDataFile(scripttest.data_file(path))
    for filter, properties in ((VolumeGradientMagnitude, {}), (VolumeLocalStatistics, {}),
                               (VolumeOcclusion, {"Radius": 12, "Neighborhood": "Sphere"}),
                               (VolumeFeatureSize, {"LargestSize": 12})):
        volume = filter(Input=volume, InputArray=["POINTS", array], **properties)
    volume.UpdatePipeline()
    result = servermanager.Fetch(volume)
    original = scripttest.volume(result, array).astype(float)
    low, high = np.nanmin(original), np.nanmax(original)
    bounds = {"gradient": (0, np.inf), "mean": (low, high), "stddev": (0, high - low),
              "radius": (1, 6), "occlusion": (min(low, 0), max(high, 0)), "size": (0, 12 * 1.2)}
    for suffix, (least, most) in bounds.items():
        values = scripttest.volume(result, array + "_" + suffix)
        scripttest.check(bool((np.isfinite(values) == np.isfinite(original)).all()),
                         "%s: %s is finite where the data are" % (path, suffix))
        slack = 1e-5 * (high - low)
        inside = np.nanmin(values) >= least - slack and np.nanmax(values) <= most + slack
        scripttest.check(bool(inside), "%s: %s between %g and %g" % (
            path, suffix, np.nanmin(values), np.nanmax(values)))
        scripttest.check(np.nanstd(values) > 0, "which varies")
