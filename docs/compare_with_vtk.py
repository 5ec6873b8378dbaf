#!/usr/bin/env python3
"""From an iso-value to its picture: the viewer beside VTK's FlyingEdges with rasterising, on the same machine.

usage: xvfb-run -a -s "-screen 0 1600x1200x24" /usr/bin/python3 docs/compare_with_vtk.py PROGRAM FOLDER [BONSAI.vti]

Needs python3-vtk9 and python3-numpy. Makes its volumes in FOLDER. Both sides draw 1024 x 1024 pixels; their runs
take turns, and the least of each is printed, in milliseconds.
"""
import json
import os
import subprocess
import sys
import time

import vtk

SIZE = 1024
SURFACES = {
    "sphere": ("sqrt(x^2+y^2+z^2)", [0.5, 0.55, 0.6, 0.65, 0.7]),
    "gyroid": ("sin(12*x)*cos(12*y)+sin(12*y)*cos(12*z)+sin(12*z)*cos(12*x)", [-0.2, -0.1, 0.0, 0.1, 0.2]),
}


def contour_window(file):
    """A pipeline from the file to an off-screen picture, with its contour filter."""
    if file.endswith(".vti"):
        reader = vtk.vtkXMLImageDataReader()
    else:
        n = int(file.split("_")[-2].split("x")[0])
        reader = vtk.vtkImageReader2()
        reader.SetFileDimensionality(3)
        reader.SetDataExtent(0, n - 1, 0, n - 1, 0, n - 1)
        reader.SetDataScalarTypeToFloat()
        reader.SetDataByteOrderToLittleEndian()
    reader.SetFileName(file)
    reader.Update()
    contour = vtk.vtkFlyingEdges3D()
    contour.SetInputConnection(reader.GetOutputPort())
    contour.ComputeNormalsOn()
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputConnection(contour.GetOutputPort())
    mapper.ScalarVisibilityOff()
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    renderer = vtk.vtkRenderer()
    renderer.AddActor(actor)
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(0)
    window.SetSize(SIZE, SIZE)
    window.AddRenderer(renderer)
    return contour, renderer, window


def vtk_ms(file, values):
    contour, renderer, window = contour_window(file)
    contour.SetValue(0, values[0])
    renderer.ResetCamera()
    window.Render()
    times = []
    for value in values:
        start = time.perf_counter()
        contour.SetValue(0, value)
        window.Render()
        pixels = vtk.vtkUnsignedCharArray()
        window.GetRGBACharPixelData(0, 0, SIZE - 1, SIZE - 1, 1, pixels)  # waits until it is drawn
        times.append(1e3 * (time.perf_counter() - start))
    return times


def viewer_ms(program, folder, file, values):
    script = os.path.join(folder, "slider.txt")
    with open(script, "w") as lines:
        lines.write("wait\n" + "".join(f"iso {value}\nwait\n" for value in values) + "quit\n")
    out = subprocess.run(
        [program, "view", file, "--iso", str(values[-1]), "--size", f"{SIZE}x{SIZE}", "--script", script, "--stats", "-"],
        capture_output=True, text=True, check=True).stdout
    return json.loads(out)


def row(program, folder, name, file, values):
    ours_first, ours_complete, late, theirs = [], [], 0, []
    for _ in range(2):
        stats = viewer_ms(program, folder, file, values)
        ours_first.append(stats["latency_ms"]["first"]["median"])
        ours_complete.append(stats["latency_ms"]["complete"]["least"])
        late += stats["preview_ms"]["late"]
        theirs += vtk_ms(file, values)
    ratio = min(theirs) / min(ours_complete)
    print(f"| {name} | {min(ours_first):.0f} | {min(ours_complete):.0f} | {min(theirs):.0f} | {ratio:.1f} | {late} |", flush=True)


def main():
    program, folder = sys.argv[1:3]
    print("| volume | viewer: first picture | viewer: complete | VTK | VTK / complete | late previews |")
    print("|---|---|---|---|---|---|")
    for n in (128, 256, 512):
        for name, (formula, values) in SURFACES.items():
            file = os.path.join(folder, f"{name}_{n}x{n}x{n}_float32.raw")
            if not os.path.exists(file):
                subprocess.run([program, "sample", formula, "--resolution", str(n), "--type", "f32", "-o", file],
                               check=True, capture_output=True)
            row(program, folder, f"{name} {n}^3", file, values)
    if len(sys.argv) > 3:
        row(program, folder, "bonsai", sys.argv[3], [40, 60, 80, 100, 120])


if __name__ == "__main__":
    main()
