# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
"""What a user of pvbatch or a client sees does not depend on the number of processes.

Run as: mpirun -np N pvbatch mpi_fetch.py
"""
from paraview import servermanager
from paraview.simple import *

import scripttest

scripttest.load_plugin(globals())
source = Wavelet(WholeExtent=[-7, 16, 0, 19, 3, 19])
gradient = VolumeGradientMagnitude(Input=source, InputArray=["POINTS", "RTData"])
occlusion = VolumeOcclusion(Input=gradient, InputArray=["POINTS", "RTData"], Radius=17)
score = CombinationScore(Input=occlusion, Primary="RTData")
scores = servermanager.Fetch(score)
rows = scripttest.table(scores, ("attribute", "rank"))
print(rows)
scripttest.check(sorted(rows) == [("RTData", 0.0), ("RTData_gradient", 1.0),
                                  ("RTData_occlusion", 2.0)],
                 "every attribute once")
matrix = servermanager.Fetch(score, idx=1)
scripttest.check(matrix.GetNumberOfRows() == 3 and matrix.GetNumberOfColumns() == 4,
                 "matrix of three attributes")
