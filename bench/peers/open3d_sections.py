#!/usr/bin/python3
"""Sections of the files of `kerf_peers export-sections` by Open3D, and prints JSON.

Needs Debian's python3-open3d. `open3d_slice` is TriangleMesh.slice_plane() of its tensor meshes: it gives segments in no
order. Stacks are one call with many contour values. Timed as processor time of the process, with all of its threads. The
length of the lines is checked.
"""

import argparse
import json
import sys
from pathlib import Path

import numpy
import open3d
from section_rows import rows_of_segments, timed

PEER = "open3d_slice"


def read_mesh(folder, name):
    """The mesh as Open3D holds it, in doubles."""
    points = numpy.fromfile(folder / f"{name}.points", dtype="<f4").reshape(-1, 3).astype(numpy.float64)
    triangles = numpy.fromfile(folder / f"{name}.triangles", dtype="<u4").reshape(-1, 3).astype(numpy.int64)
    mesh = open3d.t.geometry.TriangleMesh()
    mesh.vertex.positions = open3d.core.Tensor(points)
    mesh.triangle.indices = open3d.core.Tensor(triangles)
    return mesh, len(triangles)


def length_of(lines):
    points, ends = lines.point.positions.numpy().astype(numpy.float64), lines.line.indices.numpy()
    return float(numpy.linalg.norm(points[ends[:, 0]] - points[ends[:, 1]], axis=1).sum())


def by_slice(mesh, normal, offset, heights):
    origin = [offset * part for part in normal]
    return timed(lambda: mesh.slice_plane(point=origin, normal=normal, contour_values=heights))


def by_plane(mesh, plane):
    seconds, lines = by_slice(mesh, plane["normal"], plane["offset"], [0.0])
    return seconds, length_of(lines)


def by_heights(mesh, heights):
    seconds, lines = by_slice(mesh, [0.0, 0.0, 1.0], 0.0, heights)
    return seconds, length_of(lines)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("inputs", type=Path, help="what kerf_peers export-sections printed, beside its files")
    parser.add_argument("--seconds", type=float, default=1.0, help="for each mesh")
    arguments = parser.parse_args()
    with open(arguments.inputs, encoding="utf-8") as file:
        inputs = json.load(file)
    rows = []
    for entry in inputs["inputs"]:
        mesh, triangles = read_mesh(arguments.inputs.parent, entry["file"])
        rows += rows_of_segments(PEER, entry, triangles, inputs["length_share"], arguments.seconds,
                                 lambda plane, mesh=mesh: by_plane(mesh, plane),
                                 lambda heights, mesh=mesh: by_heights(mesh, heights))
    json.dump({"sections": rows}, sys.stdout, indent=1)
    print()


if __name__ == "__main__":
    main()
