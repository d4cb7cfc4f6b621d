#!/usr/bin/python3
"""Cuts the files of `kerf_peers export` with VTK's vtkClipClosedSurface, once for each side, and prints JSON.

Needs Debian's python3-vtk9. Only the filter's Update() is timed, as processor time of the process; VTK's own mesh is
built before. Answers are checked: each side closed (its points merged by position, every directed edge met by its
reverse) and of the right volume.
"""

import argparse
import json
import sys
import time
from collections import Counter
from pathlib import Path

import numpy
from vtkmodules.util import numpy_support
from vtkmodules.vtkCommonCore import VTK_DOUBLE, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPlane, vtkPlaneCollection, vtkPolyData
from vtkmodules.vtkFiltersGeneral import vtkClipClosedSurface

PEER = "vtk_clip_closed_surface"


def read_surface(folder, name):
    """The mesh as VTK holds it, in doubles."""
    points = numpy.fromfile(folder / f"{name}.points", dtype="<f4").reshape(-1, 3).astype(numpy.float64)
    triangles = numpy.fromfile(folder / f"{name}.triangles", dtype="<u4").reshape(-1, 3)
    cells = numpy.hstack([numpy.full((len(triangles), 1), 3), triangles]).astype(numpy.int64).ravel()
    vtk_points, vtk_cells, surface = vtkPoints(), vtkCellArray(), vtkPolyData()
    vtk_points.SetData(numpy_support.numpy_to_vtk(points, deep=True, array_type=VTK_DOUBLE))
    vtk_cells.SetCells(len(triangles), numpy_support.numpy_to_vtkIdTypeArray(cells, deep=True))
    surface.SetPoints(vtk_points)
    surface.SetPolys(vtk_cells)
    return surface, len(triangles)


def clipped(surface, normal, offset):
    """The side that `normal` points to, closed; and the seconds that took."""
    plane, planes = vtkPlane(), vtkPlaneCollection()
    plane.SetNormal(*normal)
    plane.SetOrigin(*(offset * part for part in normal))
    planes.AddItem(plane)
    clip = vtkClipClosedSurface()
    clip.SetInputData(surface)
    clip.SetClippingPlanes(planes)
    clip.SetGenerateFaces(True)
    clip.SetGenerateOutline(False)
    start = time.process_time()
    clip.Update()
    seconds = time.process_time() - start
    return clip.GetOutput(), seconds


def facts(surface):
    """Signed volume, and whether the surface is closed."""
    points = numpy_support.vtk_to_numpy(surface.GetPoints().GetData()).astype(numpy.float64)
    offsets = numpy_support.vtk_to_numpy(surface.GetPolys().GetOffsetsArray())
    corners = numpy_support.vtk_to_numpy(surface.GetPolys().GetConnectivityArray())
    _, merged = numpy.unique(points, axis=0, return_inverse=True)
    origin = points.mean(axis=0)
    sizes = numpy.diff(offsets)
    volume, edges = 0.0, []
    for size in numpy.unique(sizes):
        starts = offsets[:-1][sizes == size]
        polygons = corners[starts[:, None] + numpy.arange(size)]
        placed = points[polygons] - origin
        for corner in range(1, size - 1):
            volume += numpy.einsum("ij,ij->i", placed[:, 0], numpy.cross(placed[:, corner], placed[:, corner + 1])).sum() / 6
        ids = merged.ravel()[polygons]
        edges += [numpy.stack([ids[:, i], ids[:, (i + 1) % size]], axis=1) for i in range(size)]
    edges = numpy.concatenate(edges)
    edges = edges[edges[:, 0] != edges[:, 1]]
    count = len(points)
    forward = numpy.sort(edges[:, 0].astype(numpy.int64) * count + edges[:, 1])
    backward = numpy.sort(edges[:, 1].astype(numpy.int64) * count + edges[:, 0])
    return volume, bool(numpy.array_equal(forward, backward))


def problem_of(sides, plane, whole, allowed):
    """What is the matter with the two sides; empty when nothing is."""
    (below, is_closed_below), (above, is_closed_above) = (facts(side) for side in sides)
    if not (is_closed_below and is_closed_above):
        return "not closed"
    if abs(below - plane["negative_volume"]) > allowed or abs(below + above - whole) > allowed:
        return "wrong volume"
    return ""


def cut_all(folder, entry, share, budget):
    surface, triangles = read_surface(folder, entry["file"])
    problems, times, planes = Counter(), [], 0
    for plane in entry["planes"]:
        if planes > 0 and sum(times) >= budget:
            break
        normal, offset = plane["normal"], plane["offset"]
        above, taken_above = clipped(surface, normal, offset)
        below, taken_below = clipped(surface, [-part for part in normal], -offset)
        times.append(taken_above + taken_below)
        planes += 1
        problem = problem_of((below, above), plane, entry["volume"], share * abs(entry["volume"]))
        if problem:
            problems[problem] += 1
    verdict = "; ".join(problem if count == planes else f"{problem} in {count}" for problem, count in sorted(problems.items()))
    return {"peer": PEER, "mesh": entry["mesh"], "triangles": triangles, "ms": sum(times) * 1e3 / planes,
            "least_ms": min(times) * 1e3, "most_ms": max(times) * 1e3, "planes": planes,
            "right": planes - sum(problems.values()), "verdict": verdict or "right"}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("inputs", type=Path, help="what kerf_peers export printed, beside the files that it wrote")
    parser.add_argument("--seconds", type=float, default=1.0, help="for each mesh")
    arguments = parser.parse_args()
    with open(arguments.inputs, encoding="utf-8") as file:
        inputs = json.load(file)
    rows = [cut_all(arguments.inputs.parent, entry, inputs["volume_share"], arguments.seconds) for entry in inputs["inputs"]]
    json.dump({"peers": rows}, sys.stdout, indent=1)
    print()


if __name__ == "__main__":
    main()
