# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
"""A line of sight through a volume on several processes.

Run as: mpirun -np N pvbatch mpi_probe.py
"""
import math

from paraview import servermanager, simple
from vtkmodules.vtkParallelCore import vtkMultiProcessController

import scripttest

scripttest.load_plugin(simple.__dict__)
import tfc

ranks = vtkMultiProcessController.GetGlobalController().GetNumberOfProcesses()
wavelet = simple.Wavelet(WholeExtent=[-10, 10] * 3)
distance = simple.Calculator(Input=wavelet, ResultArrayName="R", Function="mag(coords)")
tf = tfc.TransferFunction("RTData", "R", primary_range=(0, 300), secondary_range=(0, 20))
tf.add_rectangle((150, 10), (400, 40), name="fog", opacity=0.05, falloff="constant")

LINES = (((0, 0, 40), (0, 0, -40)), ((40, 3, 2), (-40, 3, 2)), ((20, 21, 22), (-20, -20, -20)))
for start, end in LINES:
    for threshold in (0.01, 0.3, 0.6):
        probe = simple.RayProbe(Input=distance, TransferFunction=tf.to_json(), StartPoint=start,
                                EndPoint=end, Threshold=threshold, SampleDistance=0.25)
        probe.UpdatePipeline()
        table = servermanager.Fetch(probe)
        scripttest.check(table.GetNumberOfRows() == 1, "one row")

        def get(name):
            return table.GetValueByName(0, name).ToDouble()

        direction = [e - s for s, e in zip(start, end)]
        length = math.hypot(*direction)
        inside = [sorted(((low - s) / d, (10 - s) / d))
                  for s, d, low in zip(start, direction, (-10, -10, -10)) if d]
        entry, leave = max(i[0] for i in inside) * length, min(i[1] for i in inside) * length
        total = 1 - 0.95 ** (leave - entry)
        scripttest.check(abs(get("total_opacity") - total) < 1e-6, "opacity %g" % total)
        if threshold < total:
            depth = entry + math.log(1 - threshold) / math.log(0.95)
            scripttest.check(abs(get("distance") - depth) < 0.26, "distance %g" % depth)
        place = [s + d * get("distance") / length for s, d in zip(start, direction)]
        scripttest.check(abs(get("R") - math.hypot(*place)) < 0.2, "value of R")
        regions = servermanager.Fetch(probe, idx=1)
        scripttest.check(regions.GetNumberOfRows() == 1, "one region")
        simple.Delete(probe)
print("%d processes" % ranks)
