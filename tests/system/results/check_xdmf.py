"""Follows every reference of an XDMF file into its HDF5 file and compares shape and type; builds each frame as a VTK
point cloud where python3-vtk9 is installed, as a reader would."""

import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path

try:
    import h5py
    import numpy as np
except ImportError:
    sys.exit(77)

FRAMES = 3
KINDS = {"f": "Float", "i": "Int"}


def expect(what, found, wanted):
    if found != wanted:
        sys.exit(f"{what}: found {found}, expected {wanted}")


def heavy_data(folder, item):
    name, path = item.text.split(":")
    with h5py.File(folder / name, "r") as file:
        data = file[path][()]
    expect(f"Dimensions of {path}", tuple(int(n) for n in item.get("Dimensions").split()), data.shape)
    expect(f"NumberType of {path}", item.get("NumberType"), KINDS[data.dtype.kind])
    expect(f"Precision of {path}", int(item.get("Precision")), data.dtype.itemsize)
    return data


def check_in_vtk(position, fields):
    """The cloud that a reader makes of a frame has every field on every point."""
    try:
        from vtkmodules.util.numpy_support import numpy_to_vtk
        from vtkmodules.vtkCommonCore import vtkPoints
        from vtkmodules.vtkCommonDataModel import vtkPolyData
    except ImportError:
        return
    points = vtkPoints()
    points.SetData(numpy_to_vtk(np.column_stack([position, np.zeros(len(position))]), deep=True))
    cloud = vtkPolyData()
    cloud.SetPoints(points)
    for name, values in fields.items():
        array = numpy_to_vtk(values, deep=True)
        array.SetName(name)
        cloud.GetPointData().AddArray(array)
        expect(f"tuples of {name}", array.GetNumberOfTuples(), cloud.GetNumberOfPoints())


def main():
    path = Path(sys.argv[1])
    root = ElementTree.parse(path).getroot()
    expect("version", root.get("Version"), "2.0")
    grids = root.findall("./Domain/Grid[@CollectionType='Temporal']/Grid")
    expect("times", [float(grid.find("Time").get("Value")) for grid in grids], [0.25 * i for i in range(FRAMES)])
    for grid in grids:
        position = heavy_data(path.parent, grid.find("Geometry/DataItem"))
        expect("particles", int(grid.find("Topology").get("NumberOfElements")), len(position))
        fields = {a.get("Name"): heavy_data(path.parent, a.find("DataItem")) for a in grid.findall("Attribute")}
        expect("fields", sorted(fields), ["soil", "stress", "velocity"])
        check_in_vtk(position, fields)


main()
