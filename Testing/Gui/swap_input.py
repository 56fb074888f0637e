# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
"""Puts the other one of points.vti and others.vti (see write_volumes.py) behind the calculator, for
MissingArrays.xml."""
from paraview import simple

calculator = simple.FindSource("Calculator1")
points, others = simple.FindSource("points.vti"), simple.FindSource("others.vti")
calculator.Input = others if calculator.Input == points else points
calculator.UpdatePipeline()
simple.SetActiveSource(calculator)
simple.Render()
