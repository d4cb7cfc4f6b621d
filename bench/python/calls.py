#!/usr/bin/env python3
"""What a cut costs that is called from Python, beside the same calls from C++, NumPy, and VTK.

Arrays become a mesh, it is cut by one plane, and both halves become arrays; all in turns in one run. The NumPy rows are
written for this comparison: all triangles at once, no loop but that over the section's edges, which a fan closes.

Both processes keep the memory that they let go of. Otherwise it depends on what else lies in memory whether the C library
gives it back to the system: to get 180 MB anew costs 60 to 80 ms, in either language.
"""

import argparse
import json
import os
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import kerf
import numpy as np

KEEP_MEMORY = "glibc.malloc.trim_threshold=4000000000:glibc.malloc.mmap_threshold=1000000000"
ORIGIN, NORMAL = np.zeros(3), np.array([1.0, 2.0, 3.0])


def cut_by_kerf(vertices, faces):
    """As the README has it."""
    return halves_of(kerf.Mesh(vertices, faces))


def halves_of(mesh):
    return [(half.vertices, half.faces) for half in kerf.cut(mesh, origin=ORIGIN, normal=NORMAL)]


def cut_by_numpy(vertices, faces):
    distance = (vertices - ORIGIN) @ NORMAL
    above = distance >= 0
    return [numpy_half(vertices, faces, distance, side) for side in (above, ~above)]


def numpy_half(vertices, faces, distance, kept):
    """The triangles whose corners are kept, parts of those that cross, and a fan over each loop."""
    corners = kept[faces]
    count = corners.sum(axis=1)
    crossing = np.flatnonzero((count == 1) | (count == 2))
    # Turned until the corner that is alone stands first.
    alone = np.argmax(corners[crossing] == (count[crossing] == 1)[:, None], axis=1)
    turned = faces[crossing[:, None], (alone[:, None] + np.arange(3)) % 3].astype(np.int64)
    a, b, c = turned.T
    n = len(vertices)
    edges = np.concatenate([np.sort(turned[:, [0, 1]], axis=1), np.sort(turned[:, [0, 2]], axis=1)])
    names, which = np.unique(edges[:, 0] * n + edges[:, 1], return_inverse=True)
    low, high = names // n, names % n
    t = (distance[low] / (distance[low] - distance[high]))[:, None]
    points = vertices[low] + t * (vertices[high] - vertices[low])
    ab, ac = n + which[: len(a)], n + which[len(a) :]
    one = count[crossing] == 1
    parts = [
        faces[count == 3],
        np.stack([a, ab, ac], axis=1)[one],
        np.stack([ab, b, c], axis=1)[~one],
        np.stack([ab, c, ac], axis=1)[~one],
    ]
    start = np.where(one, ac, ab)
    end = np.where(one, ab, ac)
    following = dict(zip(start.tolist(), end.tolist()))
    fans = []
    centres = []
    while following:
        first, at = following.popitem()
        loop = [first]
        while at != first:
            loop.append(at)
            at = following.pop(at)
        centre = n + len(points) + len(centres)
        centres.append(points[np.array(loop) - n].mean(axis=0))
        fans += [(centre, loop[i], loop[i - 1]) for i in range(len(loop))]
    parts.append(np.array(fans, dtype=np.int64).reshape(-1, 3))
    everything = np.concatenate([vertices, points, np.array(centres).reshape(-1, 3)])
    triangles = np.concatenate(parts)
    used = np.zeros(len(everything), dtype=bool)
    used[triangles] = True
    number = np.cumsum(used) - 1
    return everything[used], number[triangles]


def vtk_cutter(vertices, faces):
    import vtk
    from vtk.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy

    def cut():
        mesh = vtk.vtkPolyData()
        points = vtk.vtkPoints()
        points.SetData(numpy_to_vtk(vertices))
        mesh.SetPoints(points)
        cells = vtk.vtkCellArray()
        # VTK does not copy them: they must stay until the end.
        starts, corners = np.arange(0, 3 * len(faces) + 1, 3, dtype=np.int64), faces.astype(np.int64).ravel()
        cells.SetData(numpy_to_vtkIdTypeArray(starts), numpy_to_vtkIdTypeArray(corners))
        mesh.SetPolys(cells)
        halves = []
        for sign in (1, -1):
            plane = vtk.vtkPlane()
            plane.SetOrigin(*ORIGIN)
            plane.SetNormal(*(sign * NORMAL))
            planes = vtk.vtkPlaneCollection()
            planes.AddItem(plane)
            clip = vtk.vtkClipClosedSurface()
            clip.SetInputData(mesh)
            clip.SetClippingPlanes(planes)
            clip.Update()
            half = clip.GetOutput()
            halves.append(
                (vtk_to_numpy(half.GetPoints().GetData()), vtk_to_numpy(half.GetPolys().GetConnectivityArray()))
            )
        return halves

    return cut


def volume(half):
    vertices, faces = (np.asarray(array) for array in half)
    a, b, c = vertices.astype(np.float64)[faces.reshape(-1, 3)].transpose(1, 0, 2)
    return float(np.einsum("ni,ni->", a, np.cross(b, c)) / 6)


class SameCalls:
    """The C++ program, which waits for rounds."""

    def __init__(self, program, vertices, faces, folder):
        vertices.tofile(folder / "positions")
        faces.tofile(folder / "indices")
        self.process = subprocess.Popen(
            [program, folder / "positions", folder / "indices"],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
        )

    def milliseconds(self):
        self.process.stdin.write("\n")
        self.process.stdin.flush()
        return float(self.process.stdout.readline().split()[0])


def timed(call):
    began = time.perf_counter()
    result = call()
    # As in C++, where what was made ends within the time.
    del result
    return 1e3 * (time.perf_counter() - began)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", required=True, help="kerf_same_calls")
    parser.add_argument("--triangles", type=int, default=1_000_000)
    parser.add_argument("--rounds", type=int, default=9)
    parser.add_argument("--json", action="store_true", help="print JSON")
    options = parser.parse_args()

    rock = kerf.shape("asteroid", options.triangles)
    # A vertex for each place: the loop in NumPy knows no others.
    _, first = np.unique(rock.vertex_point, return_index=True)
    vertices, faces = rock.vertices[first], rock.vertex_point[rock.faces]
    made = kerf.Mesh(vertices, faces)
    doubles, longs = vertices.astype(np.float64), faces.astype(np.int64)
    with tempfile.TemporaryDirectory() as folder:
        same_calls = SameCalls(options.program, vertices, faces, Path(folder))
        rows = {
            "C++, the same calls": same_calls.milliseconds,
            "kerf, float32 and uint32": lambda: timed(lambda: cut_by_kerf(vertices, faces)),
            "kerf, float64 and int64": lambda: timed(lambda: cut_by_kerf(doubles, longs)),
            "kerf, a mesh made before": lambda: timed(lambda: halves_of(made)),
            "NumPy, with fans": lambda: timed(lambda: cut_by_numpy(doubles, longs)),
        }
        prepared = made.prepare()
        rows["kerf, an object prepared before, both halves as objects"] = lambda: timed_cut(prepared)
        try:
            by_vtk = vtk_cutter(vertices, faces)
            rows["VTK, vtkClipClosedSurface twice"] = lambda: timed(by_vtk)
        except ImportError:
            print("python3-vtk9 is not installed: no row for VTK", file=sys.stderr)
            by_vtk = None

        # They do the same.
        expected = [volume(half) for half in cut_by_kerf(vertices, faces)]
        for halves in [cut_by_numpy(doubles, longs)] + ([by_vtk()] if by_vtk else []):
            found = [volume(half) for half in halves]
            assert np.allclose(found, expected, rtol=1e-4), (found, expected)

        times = {name: [] for name in rows}
        for i in range(options.rounds + 1):
            for name, measure in rows.items():
                took = measure()
                if i > 0:  # the first one warms up
                    times[name].append(took)
    base = times["C++, the same calls"]
    report = []
    for name, took in times.items():
        ratios = [mine / theirs for mine, theirs in zip(took, base)]
        report.append(
            {
                "name": name,
                "ms": statistics.median(took),
                "least_ms": min(took),
                "most_ms": max(took),
                "ratio": statistics.median(ratios),
                "ratios": ratios,
            }
        )
    if options.json:
        print(json.dumps({"triangles": len(faces), "rounds": options.rounds, "rows": report}, indent=1))
        return
    print(f"{len(faces)} triangles, {options.rounds} rounds in turns: median ms (least to most), to the same calls from C++")
    for row in report:
        print(
            f"  {row['name']:<56} {row['ms']:8.1f} ({row['least_ms']:.1f} to {row['most_ms']:.1f})  {row['ratio']:.3f}"
        )


def timed_cut(prepared):
    """The copy, which costs O(n), is not what is timed."""
    rock = prepared.copy()
    return timed(lambda: list(kerf.cut(rock, origin=ORIGIN, normal=NORMAL)))


if __name__ == "__main__":
    if os.environ.get("GLIBC_TUNABLES") != KEEP_MEMORY:
        os.environ["GLIBC_TUNABLES"] = KEEP_MEMORY
        os.execv(sys.executable, [sys.executable, *sys.argv])
    main()
