#!/usr/bin/python3
"""isocast beside Embree 3 on the mesh that VTK's FlyingEdges extracts from the same volume, on one thread.

usage: compare.py ISOCAST VOLUME.nrrd ISO [ISO...]
needs: Debian's python3-vtk9, python3-numpy, libembree-dev and g++ (EMBREE: a folder with its usr, if elsewhere)

Every frame of isocast has a new iso-value, so its bit masks are made anew in each. Times are the least of
several runs; the two programs take turns.
"""
import json
import os
import subprocess
import sys
import tempfile
import time

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkSMPTools
from vtkmodules.vtkFiltersCore import vtkFlyingEdges3D
from vtkmodules.vtkIOImage import vtkNrrdReader

SIZE, REPEATS, ROUNDS, FOV = 1024, 4, 3, 45


def compile_tracer(folder):
    """The Embree program."""
    prefix = os.environ.get("EMBREE", "")
    source = os.path.join(os.path.dirname(os.path.abspath(__file__)), "trace_mesh.cpp")
    program = os.path.join(folder, "trace_mesh")
    command = ["g++", "-O3", "-march=native", "-std=c++20", source, "-o", program]
    if prefix:
        library = os.path.join(prefix, "usr/lib/x86_64-linux-gnu")
        command += ["-I" + os.path.join(prefix, "usr/include"), "-L" + library, "-Wl,-rpath," + library]
    subprocess.run(command + ["-lembree3", "-ltbb"], check=True)
    return program


def extract(image, iso, file):
    """Writes the mesh of an iso-value; milliseconds of FlyingEdges, triangles, bounds."""
    filter_ = vtkFlyingEdges3D()
    filter_.SetInputData(image)
    filter_.SetValue(0, iso)
    filter_.ComputeNormalsOff()
    filter_.ComputeGradientsOff()
    filter_.ComputeScalarsOff()
    start = time.perf_counter()
    filter_.Update()
    milliseconds = 1e3 * (time.perf_counter() - start)
    mesh = filter_.GetOutput()
    vertices = vtk_to_numpy(mesh.GetPoints().GetData()).astype(numpy.float32)
    indices = vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).astype(numpy.int32)
    with open(file, "wb") as out:
        numpy.array([len(vertices), len(indices) // 3], numpy.int32).tofile(out)
        vertices.tofile(out)
        indices.tofile(out)
    return milliseconds, len(indices) // 3


def camera_of(bounds):
    """Position and target of a camera that shows the whole volume obliquely, as isocast's own does."""
    lo, hi = numpy.array(bounds[0::2]), numpy.array(bounds[1::2])
    target = (lo + hi) / 2
    away = numpy.array([0.5, -1, 0.4])
    reach = 0.5 * numpy.linalg.norm(hi - lo) / numpy.sin(numpy.radians(FOV / 2))
    return target + reach * away / numpy.linalg.norm(away), target


def numbers(values):
    return ["%.17g" % value for value in values]


def isocast_frames(isocast, volume, iso, camera, folder):
    """Milliseconds of frames with iso-values close to each other, and the rays that hit in the last."""
    stats = os.path.join(folder, "stats.json")
    close = iso + 1e-4 * max(abs(iso), 1)
    subprocess.run(
        [isocast, "render", volume, "--threads", "1", "--size", f"{SIZE}x{SIZE}", "--fov", str(FOV),
         "--iso-sweep", f"{iso:.17g}:{close:.17g}:{REPEATS}", "--camera-position=" + ",".join(numbers(camera[0])),
         "--camera-target=" + ",".join(numbers(camera[1])), "-o", os.path.join(folder, "frame.png"),
         "--stats", stats], check=True)
    found = []
    for i in range(REPEATS):
        with open(os.path.join(folder, f"stats_{i:04}.json")) as file:
            found.append(json.load(file))
    return min(frame["ms"]["render"] for frame in found), found[-1]["hits"]


def main():
    isocast, volume, isos = sys.argv[1], sys.argv[2], [float(word) for word in sys.argv[3:]]
    vtkSMPTools.Initialize(1)
    reader = vtkNrrdReader()
    reader.SetFileName(volume)
    reader.Update()
    image = reader.GetOutput()
    camera = camera_of(image.GetBounds())
    print("     iso  triangles |  extract    tree   trace | isocast | frame  change")
    with tempfile.TemporaryDirectory() as folder:
        tracer, mesh = compile_tracer(folder), os.path.join(folder, "mesh")
        for iso in isos:
            extraction = tree = trace = frame = float("inf")
            for _ in range(ROUNDS):
                milliseconds, triangles = extract(image, iso, mesh)
                extraction = min(extraction, milliseconds)
                words = subprocess.run(
                    [tracer, mesh, str(SIZE), str(REPEATS)] + numbers(camera[0]) + numbers(camera[1]) + [str(FOV)],
                    check=True, capture_output=True, text=True).stdout.split()
                tree, trace = min(tree, float(words[0])), min(trace, float(words[1]))
                milliseconds, hits = isocast_frames(isocast, volume, iso, camera, folder)
                frame = min(frame, milliseconds)
                if abs(hits - int(words[2])) > 0.01 * max(hits, 1):
                    print(f"         the pictures differ: {hits} and {words[2]} rays hit")
            print(f"{iso:8g} {triangles:10} | {extraction:8.1f} {tree:7.1f} {trace:7.1f} | {frame:7.1f} | "
                  f"{trace / frame:4.2f}x {(extraction + tree + trace) / frame:6.2f}x")


main()
