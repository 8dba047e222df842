"""Reads /VTKHDF of a run by the rules of the format for each time (docs.vtk.org, VTKHDF 2.0, UnstructuredGrid with Steps) and compares
with the frames; a run of one frame is also read by VTK's own reader where python3-vtk9 is installed.

    usage: check_vtkhdf.py RUN.h5
"""

import sys

try:
    import h5py
    import numpy as np
except ImportError:
    sys.exit(77)

VERTEX = 1


def expect(what, found, wanted):
    if not np.array_equal(found, wanted):
        sys.exit(f"{what}: found {found}, expected {wanted}")


def part_of(root, step, number):
    """Points, cells and fields of one part of a time, as a reader takes them from the arrays."""
    steps = root["Steps"]
    first = int(steps["PartOffsets"][step])
    sizes = {name: root[name][first : first + number + 1] for name in ("NumberOfPoints", "NumberOfCells", "NumberOfConnectivityIds")}
    begin = {name: int(values[:-1].sum()) for name, values in sizes.items()}
    count = {name: int(values[-1]) for name, values in sizes.items()}
    point = int(steps["PointOffsets"][step]) + begin["NumberOfPoints"]
    cell = int(steps["CellOffsets"][step, 0]) + begin["NumberOfCells"]
    identity = int(steps["ConnectivityIdOffsets"][step, 0]) + begin["NumberOfConnectivityIds"]
    fields = {}
    for name, values in root["PointData"].items():
        start = int(steps["PointDataOffsets"][name][step]) + begin["NumberOfPoints"]
        fields[name] = values[start : start + count["NumberOfPoints"]]
    return {
        "points": root["Points"][point : point + count["NumberOfPoints"]],
        "types": root["Types"][cell : cell + count["NumberOfCells"]],
        "offsets": root["Offsets"][cell + first + number : cell + first + number + count["NumberOfCells"] + 1],
        "connectivity": root["Connectivity"][identity : identity + count["NumberOfConnectivityIds"]],
        "fields": fields,
    }


def padded(values, components):
    return values if values.ndim == 1 else np.pad(values, ((0, 0), (0, components - values.shape[1])))


def check_frame(file, step, name):
    frame, soil = file[f"frames/{name}"], part_of(file["VTKHDF"], step, 0)
    position = frame["position"][()]
    count = len(position)
    expect(f"time {step}", file["VTKHDF/Steps/Values"][step], frame.attrs["time"])
    expect(f"points {step}", soil["points"], padded(position, 3))
    expect(f"types {step}", soil["types"], np.full(count, VERTEX))
    expect(f"offsets {step}", soil["offsets"], np.arange(count + 1))
    expect(f"connectivity {step}", soil["connectivity"], np.arange(count))
    for field in frame:
        if field != "position":
            values = frame[field][()]
            wanted = padded(values, {2: 3, 4: 6}.get(values.shape[-1]) if values.ndim > 1 else 1)
            expect(f"{field} {step}", soil["fields"][field], wanted)


def check_in_vtk(path, frame):
    """What VTK's reader makes of a file of one frame."""
    try:
        from vtkmodules.util.numpy_support import vtk_to_numpy
        from vtkmodules.vtkIOHDF import vtkHDFReader
    except ImportError:
        return
    reader = vtkHDFReader()
    reader.SetFileName(path)
    reader.Update()
    grid = reader.GetOutput()
    count = len(frame["position"])
    if grid is None or grid.GetNumberOfPoints() < count:
        sys.exit(f"VTK reads {grid and grid.GetNumberOfPoints()} points of {count}")
    expect("VTK's points", vtk_to_numpy(grid.GetPoints().GetData())[:count], padded(frame["position"][()], 3))
    expect("VTK's velocity", vtk_to_numpy(grid.GetPointData().GetArray("velocity"))[:count], padded(frame["velocity"][()], 3))
    expect("VTK's cell", [grid.GetCellType(0), grid.GetCell(3).GetPointId(0)], [VERTEX, 3])
    print(f"VTK reads {grid.GetNumberOfPoints()} points in {grid.GetNumberOfCells()} cells")


def main():
    path = sys.argv[1]
    with h5py.File(path, "r") as file:
        expect("version", file["VTKHDF"].attrs["Version"], [2, 0])
        expect("type", file["VTKHDF"].attrs["Type"], b"UnstructuredGrid")
        names = sorted(file["frames"], key=int)
        expect("steps", file["VTKHDF/Steps"].attrs["NSteps"], len(names))
        for step, name in enumerate(names):
            check_frame(file, step, name)
        if len(names) == 1:
            check_in_vtk(path, file[f"frames/{names[0]}"])


main()
