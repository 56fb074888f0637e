# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
"""Reads the volume of an InVesalius project and writes it as an image that ParaView opens.

An .inv3 file is a compressed tar archive: main.plist describes the raw 16-bit voxels in matrix.dat.
"""

import plistlib
import tarfile

import numpy as np

CT_HEAD = "/usr/share/doc/invesalius-examples/examples/Cranium.inv3"


def read(path):
    """Voxels as an array indexed [z, y, x] and the spacing in mm along x, y and z."""
    try:
        with tarfile.open(path) as archive:
            members = {name.rsplit("/", 1)[-1]: name for name in archive.getnames()}
            project = plistlib.loads(archive.extractfile(members["main.plist"]).read())
            matrix = project["matrix"]
            raw = archive.extractfile(members[matrix["filename"]]).read()
    except (tarfile.TarError, KeyError, plistlib.InvalidFileException) as error:
        raise ValueError(f"{path}: not an InVesalius project: {error}") from None
    voxels = np.frombuffer(raw, dtype=np.dtype(matrix["dtype"]).newbyteorder("<"))
    if voxels.size != np.prod(matrix["shape"]):
        raise ValueError(f"{path}: {voxels.size} voxels, but the shape is {matrix['shape']}")
    return voxels.reshape(matrix["shape"]), tuple(float(s) for s in project["spacing"])


def write_vti(path, voxels, spacing, name):
    """Write voxels, indexed [z, y, x], as a .vti file with one point array."""
    from vtkmodules.util.numpy_support import numpy_to_vtk
    from vtkmodules.vtkCommonDataModel import vtkImageData
    from vtkmodules.vtkIOXML import vtkXMLImageDataWriter

    array = numpy_to_vtk(np.ascontiguousarray(voxels).ravel(), deep=True)
    array.SetName(name)
    image = vtkImageData()
    image.SetDimensions(voxels.shape[::-1])
    image.SetSpacing(spacing)
    image.GetPointData().SetScalars(array)
    writer = vtkXMLImageDataWriter()
    writer.SetFileName(path)
    writer.SetInputData(image)
    # Inline data: Debian 12's libexpat stops VTK's reader at appended data (VTK issue 19258).
    writer.SetDataModeToBinary()
    if not writer.Write():
        raise OSError(f"{path}: cannot be written")
