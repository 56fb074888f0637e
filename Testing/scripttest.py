# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
"""What the tests for pvpython and pvbatch share."""
import os
import subprocess
import sys

SKIPPED = 77


def skip(why):
    """End the script; ctest reports the test as skipped."""
    print("SKIPPED: " + why)
    sys.stdout.flush()
    sys.exit(SKIPPED)


def load_plugin(namespace):
    """Load the plugin that is being tested, and put its proxies into the namespace.

    The wrapped classes come first: else GetClientSideObject() returns bare objects.
    """
    import tfc.vtk.vtkTFCFilters  # noqa: F401
    from paraview import servermanager
    from paraview.simple import LoadPlugin

    # With several processes the plugin must be loaded in all of them.
    several = servermanager.ActiveConnection.GetNumberOfDataPartitions() > 1
    LoadPlugin(os.environ["TFC_PLUGIN"], remote=several, ns=namespace)


def make(cls, **properties):
    """An instance of a wrapped VTK class with Set...() called for each property."""
    instance = cls()
    for name, value in properties.items():
        getattr(instance, "Set" + name)(value)
    return instance


def data_file(name):
    """Path of a real volume; skips the test when there is none."""
    root = os.environ.get("TFC_DATA_ROOT", "")
    if not root:
        skip("set TFC_DATA_ROOT to the folder with the real volumes")
    path = os.path.join(root, name)
    if not os.path.exists(path):
        skip("%s does not exist" % path)
    return path


def check(condition, what):
    """Report one expectation; ends the script with an error when it does not hold."""
    if not condition:
        print("FAILED: " + what)
        sys.stdout.flush()
        sys.stderr.flush()
        # Not sys.exit(): an exception in one process would leave the others waiting.
        os._exit(1)
    print("ok: " + what)


def raises(kind, action, *words):
    """Expect an exception whose text has all of the words."""
    try:
        action()
    except kind as error:
        text = str(error)
        check(all(word in text for word in words), "%s: %s" % (kind.__name__, text))
    else:
        check(False, "expected %s with %s" % (kind.__name__, words))


def check_close(values, expected, tolerance, what):
    """Largest difference relative to the largest expected magnitude; NaN must match NaN."""
    import numpy as np

    values = np.asarray(values, dtype=float)
    expected = np.asarray(expected, dtype=float)
    check(values.shape == expected.shape, "%s: shape %s" % (what, values.shape))
    check(bool((np.isnan(values) == np.isnan(expected)).all()), what + ": NaN at the same places")
    finite = np.isfinite(expected)
    scale = np.abs(expected[finite]).max(initial=0.0)
    error = np.abs(values[finite] - expected[finite]).max(initial=0.0) / (scale or 1.0)
    check(bool(error <= tolerance), "%s: error %.2e <= %.0e" % (what, error, tolerance))


def run_on_ranks(ranks, launcher, program, script, folder):
    """Run `script --write FOLDER` by pvbatch on a number of processes, from pvpython."""
    # pvpython is an MPI process itself; what it inherits would confuse the launcher.
    environment = {name: value for name, value in os.environ.items()
                   if not name.startswith(("OMPI_", "PMIX_", "OPAL_", "ORTE_", "PRTE_"))}
    environment["OMPI_MCA_mpi_yield_when_idle"] = "1"
    finished = subprocess.run(
        [launcher, "--allow-run-as-root", "--oversubscribe", "-np", str(ranks), program, script,
         "--write", folder], env=environment)
    check(finished.returncode == 0, "the run with %d processes" % ranks)


def volume(dataset, name):
    """Point array as numpy array indexed [z, y, x]."""
    from vtkmodules.util.numpy_support import vtk_to_numpy

    values = vtk_to_numpy(dataset.GetPointData().GetArray(name))
    return values.reshape(dataset.GetDimensions()[::-1])


def table(data, columns):
    """Rows of a vtkTable as tuples of the named columns."""
    return [
        tuple(data.GetValueByName(row, name).ToString() if name == "attribute"
              else data.GetValueByName(row, name).ToDouble() for name in columns)
        for row in range(data.GetNumberOfRows())
    ]
