# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
"""Finding and loading the ParaView plugin."""

import glob
import os

NAME = "TransferFunctionCombinations"


def is_loaded():
    """Whether the plugin's filters are known to the current session."""
    # Importing paraview.simple connects to the built-in server when there is no connection.
    from paraview import servermanager, simple  # noqa: F401

    manager = servermanager.ProxyManager()
    return manager.SMProxyManager.HasDefinition("filters", "CombinationScore")


def _candidates():
    """Paths where the library may be, best first."""
    if os.environ.get("TFC_PLUGIN"):
        yield os.environ["TFC_PLUGIN"]
    for folder in os.environ.get("PV_PLUGIN_PATH", "").split(os.pathsep):
        if folder:
            yield os.path.join(folder, NAME, NAME + ".so")
            yield os.path.join(folder, NAME + ".so")
    # <prefix>/lib/python3/dist-packages/tfc/plugin.py beside <prefix>/lib/paraview-x.y/plugins
    library = os.path.abspath(os.path.join(os.path.dirname(__file__), *[os.pardir] * 3))
    yield from glob.glob(os.path.join(library, "paraview-*", "plugins", NAME, NAME + ".so"))


def _load(path):
    """Load the library into every process of the session."""
    from paraview import servermanager, simple

    connection = servermanager.ActiveConnection
    if connection.IsRemote():
        simple.LoadPlugin(path, remote=True)
        simple.LoadPlugin(path, remote=False)
    else:
        # A batch program on several processes: all of them are its server.
        simple.LoadPlugin(path, remote=connection.GetNumberOfDataPartitions() > 1)


def load_plugin():
    """Load the plugin into the current session, in all processes of the server too, unless it is
    there. It is looked for in the environment variables TFC_PLUGIN (the file) and PV_PLUGIN_PATH,
    and beside this package in an install tree. Raises RuntimeError when it is not found.
    """
    from paraview import simple

    if is_loaded():
        # By someone else, perhaps into another namespace only: LoadPlugin(path, ns=globals()).
        if not hasattr(simple, "CombinationScore"):
            simple._add_functions(vars(simple))
        return
    tried = []
    for path in _candidates():
        tried.append(path)
        if os.path.isfile(path):
            _load(path)
            if is_loaded():
                return
    raise RuntimeError(
        f"the ParaView plugin {NAME} is not loaded and was not found; looked for: "
        + (", ".join(tried) or "nothing")
        + ". Set PV_PLUGIN_PATH to the folder that contains it, or call LoadPlugin(path) first."
    )
