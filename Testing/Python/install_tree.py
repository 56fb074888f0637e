# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
"""The install tree, as README says to use it: ParaView finds the plugin by its name through
PV_PLUGIN_PATH, and the Python package imports from PYTHONPATH.

    python3 install_tree.py CMAKE PVPYTHON BUILD_FOLDER LIBRARY_FOLDER PLUGIN_FOLDER PYTHON_FOLDER

installs into a temporary folder, whose named subfolders the package and the plugin are in.
"""
import os
import subprocess
import sys
import tempfile

BY_NAME = """
from paraview.simple import *
LoadDistributedPlugin("TransferFunctionCombinations", remote=False, ns=globals())
source = Wavelet()
source.UpdatePipeline()
gradient = VolumeGradientMagnitude(Input=source)
gradient.UpdatePipeline()
assert "RTData_gradient" in gradient.PointData.keys()
import tfc
assert tfc.__file__.startswith({prefix!r}), tfc.__file__
tf = tfc.TransferFunction("RTData", "RTData_gradient")
tf.add_rectangle((150, 5), (50, 5))
display = tfc.show(gradient, tf, CreateRenderView(ViewSize=[64, 48]))
Render()
assert tfc.score(gradient, "RTData")[0].attribute == "RTData_gradient"
print("loaded by name")
"""

# The package finds the plugin beside itself, without PV_PLUGIN_PATH.
BY_PACKAGE = """
import tfc
tfc.load_plugin()
from paraview.simple import *
ClassifyVolume(Input=Wavelet()).UpdatePipeline()
print("found by the package")
"""


def main():
    cmake, pvpython, build, library, plugin, package = sys.argv[1:]
    environment = {name: value for name, value in os.environ.items()
                   if name not in ("TFC_PLUGIN", "PV_PLUGIN_PATH", "PYTHONPATH",
                                   "LD_LIBRARY_PATH")}
    with tempfile.TemporaryDirectory() as prefix:
        prefix = os.path.realpath(prefix)
        subprocess.run([cmake, "--install", build, "--prefix", prefix], check=True,
                       stdout=subprocess.DEVNULL)
        for path in (library, plugin, package):
            if not os.path.isdir(os.path.join(prefix, path)):
                sys.exit("FAILED: the installation has no folder " + path)
        environment["PYTHONPATH"] = os.path.join(prefix, package)
        for script, by_name in ((BY_NAME, True), (BY_PACKAGE, False)):
            if by_name:
                environment["PV_PLUGIN_PATH"] = os.path.join(prefix, plugin)
            else:
                environment.pop("PV_PLUGIN_PATH")
            path = os.path.join(prefix, "use.py")
            with open(path, "w") as file:
                file.write(script.format(prefix=prefix))
            result = subprocess.run([pvpython, path], env=environment, stdout=subprocess.PIPE,
                                    stderr=subprocess.STDOUT)
            output = result.stdout.decode(errors="replace")
            print(output)
            if result.returncode or "ERR" in output or "Warning" in output:
                sys.exit("FAILED: " + ("by name" if by_name else "by the package"))


main()
