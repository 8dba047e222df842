"""Opens the sample run of tests/unit/results/sample_run.hpp with VTK and compares it with what was written."""

import sys

try:
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkIOXdmf2 import vtkXdmfReader
except ImportError:
    sys.exit(77)

FRAMES = 3


def value(frame, field, entry):
    return 1000.0 * frame + 100.0 * field + 0.01 * entry


def expect(what, found, wanted):
    if found != wanted:
        sys.exit(f"{what}: VTK reads {found}, written was {wanted}")


def main():
    reader = vtkXdmfReader()
    reader.SetFileName(sys.argv[1])
    reader.UpdateInformation()
    information = reader.GetOutputInformation(0)
    times = [information.Get(reader.GetExecutive().TIME_STEPS(), i) for i in range(FRAMES)]
    expect("times", times, [0.25 * frame for frame in range(FRAMES)])

    for frame, time in enumerate(times):
        reader.UpdateTimeStep(time)
        cloud = reader.GetOutputDataObject(0)
        particles = 50 + frame % 7
        expect("points", cloud.GetNumberOfPoints(), particles)
        last = particles - 1
        expect("position", cloud.GetPoint(last), (value(frame, 0, 2 * last), value(frame, 0, 2 * last + 1), 0.0))
        fields = cloud.GetPointData()
        for number, (name, components) in enumerate([("velocity", 2), ("stress", 4)], start=1):
            array = vtk_to_numpy(fields.GetArray(name))
            expect(f"shape of {name}", array.shape, (particles, components))
            wanted = [value(frame, number, components * last + i) for i in range(components)]
            expect(name, array[last].tolist(), wanted)
        expect("soil", vtk_to_numpy(fields.GetArray("soil")).tolist(), [frame] * particles)


main()
