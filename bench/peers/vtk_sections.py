#!/usr/bin/python3
"""Sections of the files of `kerf_peers export-sections` by VTK, and prints JSON.

Needs Debian's python3-vtk9. `vtk_cutter` is vtkCutter: every triangle is looked at, and segments come out in no order.
`vtk_cutter_loops` is the same and vtkStripper, which joins them to loops. `vtk_plane_cutter` is vtkPlaneCutter, whose
sphere tree is made by the first plane, timed apart; its segments share no points, so that `vtk_plane_cutter_loops` is
the same, vtkCleanPolyData and vtkStripper. Stacks are vtkCutter with many values at once, and vtkPlaneCutter one plane
after another. Only Update() is timed, as processor time of the process. The length of the lines is checked, and the
number of loops where there are any.
"""

import argparse
import json
import sys
from collections import Counter
from pathlib import Path

import numpy
from section_rows import has_length, row_of, timed
from vtk_peer import read_surface
from vtkmodules.util import numpy_support
from vtkmodules.vtkCommonCore import vtkSMPTools
from vtkmodules.vtkCommonDataModel import vtkPlane
from vtkmodules.vtkFiltersCore import (vtkAppendPolyData, vtkCleanPolyData, vtkCutter, vtkPlaneCutter, vtkStripper)

def plane_of(normal, offset):
    plane = vtkPlane()
    plane.SetNormal(*normal)
    plane.SetOrigin(*(offset * part for part in normal))
    return plane


def seconds_of(*filters):
    return timed(lambda: [one.Update() for one in filters])[0]


def joined(source):
    strip = vtkStripper()
    strip.SetInputConnection(source.GetOutputPort())
    strip.JoinContiguousSegmentsOn()
    strip.SetMaximumLength(2**30)
    return strip


def length_of(lines):
    """Of all polylines, and how many of them do not end where they begin."""
    points = numpy_support.vtk_to_numpy(lines.GetPoints().GetData()).astype(numpy.float64)
    offsets = numpy_support.vtk_to_numpy(lines.GetLines().GetOffsetsArray())
    path = points[numpy_support.vtk_to_numpy(lines.GetLines().GetConnectivityArray())]
    steps = numpy.linalg.norm(path[1:] - path[:-1], axis=1)
    steps[offsets[1:-1] - 1] = 0.0  # from the end of a line to the next
    ends = offsets[1:] - 1
    open_ones = int((numpy.abs(path[offsets[:-1]] - path[ends]).max(axis=1) > 0).sum())
    return float(steps.sum()), open_ones


def problem_of(lines, expected, share, has_loops):
    length, open_ones = length_of(lines)
    if not has_length(length, expected, share):
        return "wrong length"
    if not has_loops:
        return "segments in no order"
    if open_ones:
        return "loops not closed"
    return "" if lines.GetNumberOfLines() == expected["loops"] else "other loops"


def by_cutter(surface, plane, joins):
    cutter = vtkCutter()
    cutter.SetInputData(surface)
    cutter.SetCutFunction(plane_of(plane["normal"], plane["offset"]))
    last = joined(cutter) if joins else cutter
    return seconds_of(cutter, last) if joins else seconds_of(cutter), last.GetOutput()


def planes_by_cutter(peer, surface, entry, triangles, share, budget, joins):
    times, problems = [], Counter()
    for plane in entry["planes"]:
        if times and sum(times) >= budget:
            break
        seconds, lines = by_cutter(surface, plane, joins)
        times.append(seconds)
        problems.update(filter(None, [problem_of(lines, plane, share, joins)]))
    return row_of(peer, entry, triangles, times, problems)


def joined_parts(parts):
    """vtkPlaneCutter gives a part for each thread, whose segments share no points: merges those, then joins."""
    append, clean, strip = vtkAppendPolyData(), vtkCleanPolyData(), vtkStripper()
    for i in range(parts.GetNumberOfPartitions()):
        append.AddInputData(parts.GetPartition(i))
    clean.SetInputConnection(append.GetOutputPort())
    clean.ToleranceIsAbsoluteOn()
    clean.SetAbsoluteTolerance(0.0)
    strip.SetInputConnection(clean.GetOutputPort())
    strip.JoinContiguousSegmentsOn()
    strip.SetMaximumLength(2**30)
    seconds = seconds_of(strip)
    return seconds, strip.GetOutput()


def planes_by_plane_cutter(surface, entry, triangles, share, budget):
    """Two rows: segments, and loops."""
    cutter = vtkPlaneCutter()
    cutter.SetInputData(surface)
    cutter.BuildTreeOn()
    times, joining, problems, first = [], [], Counter(), None
    for plane in [entry["planes"][0], *entry["planes"]]:  # the first one makes the tree
        if times and sum(times) + sum(joining) >= budget:
            break
        cutter.SetPlane(plane_of(plane["normal"], plane["offset"]))
        seconds = seconds_of(cutter)
        if first is None:
            first = seconds
            continue
        joins, lines = joined_parts(cutter.GetOutputDataObject(0))
        times.append(seconds)
        joining.append(joins)
        problems.update(filter(None, [problem_of(lines, plane, share, True)]))
    prepare_ms = max(first - times[0], 0.0) * 1e3
    in_no_order = Counter({"segments in no order": len(times)})
    return [row_of("vtk_plane_cutter", entry, triangles, times, in_no_order, prepare_ms=prepare_ms),
            row_of("vtk_plane_cutter_loops", entry, triangles, [a + b for a, b in zip(times, joining)], problems,
                   prepare_ms=prepare_ms)]


def stack_by_cutter(surface, entry, triangles, share, stack):
    """All heights in one go; segments in no order, as of one plane."""
    cutter = vtkCutter()
    cutter.SetInputData(surface)
    cutter.SetCutFunction(plane_of((0.0, 0.0, 1.0), 0.0))
    for i, height in enumerate(stack["heights"]):
        cutter.SetValue(i, height)
    seconds = seconds_of(cutter)
    problems = Counter([problem_of(cutter.GetOutput(), stack, share, False)])
    return row_of("vtk_cutter", entry, triangles, [seconds], problems, len(stack["heights"]))


def stack_by_plane_cutter(surface, entry, triangles, share, stack):
    """One height after another, by the tree that the first plane has made; segments, and loops."""
    cutter = vtkPlaneCutter()
    cutter.SetInputData(surface)
    cutter.BuildTreeOn()
    heights = stack["heights"]
    cutter.SetPlane(plane_of((0.0, 0.0, 1.0), heights[0]))
    first = seconds_of(cutter)
    cutting, joining, length, loops, open_ones = [], [], 0.0, 0, 0
    for height in heights:
        cutter.SetPlane(plane_of((0.0, 0.0, 1.0), height))
        cutter.Modified()
        cutting.append(seconds_of(cutter))
        joins, lines = joined_parts(cutter.GetOutputDataObject(0))
        joining.append(joins)
        if lines.GetNumberOfLines() > 0:
            own_length, own_open = length_of(lines)
            length, open_ones, loops = length + own_length, open_ones + own_open, loops + lines.GetNumberOfLines()
    problem = ("wrong length" if not has_length(length, stack, share) else "loops not closed" if open_ones else
               "other loops" if loops != stack["loops"] else "")
    prepare_ms = max(first - cutting[0], 0.0) * 1e3
    return [row_of("vtk_plane_cutter", entry, triangles, [sum(cutting)], Counter(["segments in no order"]), len(heights),
                   prepare_ms),
            row_of("vtk_plane_cutter_loops", entry, triangles, [sum(cutting) + sum(joining)],
                   Counter([problem] if problem else []), len(heights), prepare_ms)]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("inputs", type=Path, help="what kerf_peers export-sections printed, beside its files")
    parser.add_argument("--seconds", type=float, default=1.0, help="for each mesh and filter")
    arguments = parser.parse_args()
    vtkSMPTools.Initialize(1)  # one thread, as all others
    with open(arguments.inputs, encoding="utf-8") as file:
        inputs = json.load(file)
    share, rows = inputs["length_share"], []
    for entry in inputs["inputs"]:
        surface, triangles = read_surface(arguments.inputs.parent, entry["file"])
        for peer, joins in (("vtk_cutter", False), ("vtk_cutter_loops", True)):
            rows.append(planes_by_cutter(peer, surface, entry, triangles, share, arguments.seconds, joins))
        rows += planes_by_plane_cutter(surface, entry, triangles, share, arguments.seconds)
        for stack in entry["stacks"]:
            rows.append(stack_by_cutter(surface, entry, triangles, share, stack))
            rows += stack_by_plane_cutter(surface, entry, triangles, share, stack)
    json.dump({"sections": rows}, sys.stdout, indent=1)
    print()


if __name__ == "__main__":
    main()
