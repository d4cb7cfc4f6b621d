"""Measurements that are known exactly, for the tests of the report."""

import importlib.util
import math

from report.measurements import Cut, Measurements, Run
from report.names import BACKENDS, PROXIES
from report.student_report import report_rows

HAS_MATPLOTLIB = importlib.util.find_spec("matplotlib") is not None


def repeated(**counters):
    """Counters of a benchmark whose repetitions lie 10 % below and above."""
    return {key: (value, 0.9 * value, 1.1 * value) for key, value in counters.items()} | {"repetitions": (3,) * 3,
                                                                                       "iterations": (1,) * 3}


def some_measurements():
    """A linear and a half-edge back end whose times are known exactly: n / 1000 and sqrt(n) / 10 ms."""
    found = Measurements()
    for size in (1_000, 10_000, 30_000, 100_000, 1_000_000):
        for backend, ms in (("baseline/remap", size / 1000), ("halfedge", math.sqrt(size) / 10)):
            counters = {"real_time": ms, "triangles": size, "crossing": math.sqrt(size),
                        "touched": 10 * math.sqrt(size),
                        "nodes": math.sqrt(size), "upload_bytes": 200 * math.sqrt(size),
                        "ns_per_crossing": 1e6 * ms / math.sqrt(size),
                        "ms_find": ms / 2, "ms_cap": ms / 2, "repetitions": 1, "iterations": 1}
            for kind in ("Scale", "Geometry"):
                found.bench[f"{kind}/{backend}/asteroid/{size}"] = {key: (v, v, v) for key, v in counters.items()}
    return found


def whole_measurements():
    """Something of every kind of stage. Of the report's models the half-edge back end takes 2 ms, `remap` 1 ms."""
    found = some_measurements()
    add_models(found)
    add_pieces(found)
    add_viewer(found)
    found.peers = [{"mesh": "asteroid", "triangles": 1_000, "peer": "cgal_clip", "ms": 3.0, "least_ms": 2.0,
                    "most_ms": 8.0,
                    "planes": 5, "right": 4, "verdict": "volumes do not add up"},
                   {"mesh": "rook", "triangles": 926, "peer": "cgal_split", "ms": 1.0, "least_ms": 1.0, "most_ms": 1.0,
                    "planes": 5, "right": 0, "verdict": "makes no caps"}]
    add_sections(found)
    add_fractures(found)
    found.stages = [{"stage": "cuts", "kind": "bench", "date": "2024-02-29 12:00", "commit": "abc", "seconds": 7.0,
                     "command": ["kerf_bench", "^Cut/", "3", "0.01"], "load": [0.5, 1.0]}]
    return found


def add_models(found):
    times = {"baseline/scan": 8.0, "baseline/two_bucket_hash": 16.0, "baseline/hash": 4.0, "baseline/remap": 1.0,
             "halfedge": 2.0}
    for row in report_rows():
        for backend, ms in times.items():
            found.bench[f"Cut/{backend}/{row['model']}"] = repeated(
                cut_ms=ms, triangles=int(row["faces"]), vertices=int(row["vertices"]), cuts_each=10)
        for number, kind in enumerate(PROXIES, 1):
            found.bench[f"Proxy/{kind}/{row['model']}"] = repeated(proxy_ms=number / 10, points=number,
                                                                   volume_ratio=number / 2)
        found.bench[f"Proxy/halfedge/bounded_hull/{row['model']}"] = repeated(proxy_ms=0.05, points=3)


def add_pieces(found):
    size = 100_000
    for backend, ms in (("baseline/remap", 10.0), ("halfedge", 100.0)):
        found.bench[f"Prepare/{backend}/asteroid/{size}"] = repeated(real_time=ms, ns_per_triangle=10 * ms,
                                                                     bytes_per_triangle=ms)
        found.bench[f"Recut/{backend}/asteroid/{size}"] = repeated(
            cut_ms=ms / 100, worst_cut_ms=ms / 20, worst_to_predicted=1.5, ns_per_crossing=300.0, most_draw_ranges=4)
        found.bench[f"Many/{backend}/asteroid/{size}"] = repeated(
            cuts=200, p50_ms=1.0, p90_ms=2.0, p99_ms=ms / 20, worst_ms=ms / 10, over_frame=1)
        found.bench[f"Swipe/{backend}/asteroid/{size}"] = repeated(real_time=ms)
        for mode in ("kept", "compacted") if backend == "halfedge" else ("kept",):
            marks = {f"{key}_{mark}": value for mark in (1, 100, 1000) for key, value in {
                "mean_ms": ms / 100, "worst_ms": ms / 10, "whole_ms": 2e4 / ms * mark / 1000,
                "cutting_ms": 1e4 / ms * mark / 1000,
                "ranges": 10 * (mark + 1), "most_ranges": 20, "compactions": 5 if mode == "compacted" else 0,
                "compact_ms": 1.0}.items()}
            found.bench[f"Chain/{mode}/{backend}/asteroid/{size}"] = repeated(triangles=size, **marks)
    found.bench["Pieces/heap/300"] = repeated(real_time=5.0, bodies=300)
    for kind in PROXIES:
        found.bench[f"Physics/{kind}/300"] = repeated(real_time=9.0 if kind == "box" else 5.0, bodies=300,
                                                      touching_pairs=7)


def add_sections(found):
    """Sections of asteroids take sqrt(n) / 1000 ms, n / 1000 by `remap`, and a hundred times as long by cuts of copies."""
    for size in (10_000, 100_000, 1_000_000):
        root = math.sqrt(size)
        shared = {"triangles": size, "crossing_triangles": root, "triangles_touched": 20 * root,
                  "nodes_visited": 10 * root, "sections_each": 5}
        for way, backend, ms in (("loops", "halfedge", root / 1000), ("nested", "halfedge", 2 * root / 1000),
                                 ("filled", "halfedge", 3 * root / 1000), ("by_cut", "halfedge", root / 10),
                                 ("through_vertices", "halfedge", root / 900), ("along_edges", "halfedge", root / 800),
                                 ("in_faces", "halfedge", root / 700), ("loops", "baseline/remap", size / 1000)):
            found.bench[f"Section/{way}/{backend}/asteroid/{size}"] = repeated(real_time=5 * ms, **shared)
        for heights in (10, 1000):
            for name, ms in (("Stack/halfedge", root), ("StackThreads/2/halfedge", root / 2),
                             ("Stack/baseline/remap", float(size))):
                found.bench[f"{name}/asteroid/{size}/{heights}"] = repeated(
                    real_time=heights * ms / 1000, triangles=size, heights=heights, crossing_triangles=heights * root,
                    loops=heights)
    for backend, ms in (("halfedge", 1.0), ("baseline/remap", 4.0)):
        found.bench[f"RealSection/{backend}/sponge"] = repeated(real_time=5 * ms, triangles=9_000, crossing_triangles=700,
                                                                loops=3, sections_each=5)
    found.slicers = [{"mesh": "asteroid", "triangles": 1_000_000, "heights": heights, "peer": peer, "ms": ms,
                      "least_ms": ms, "most_ms": ms, "planes": 5, "right": 5, "verdict": verdict, "prepare_ms": 9.0}
                     for peer, heights, ms, verdict in (("cgal_slicer", 1, 8.0, "right"),
                                                        ("vtk_cutter", 1000, 9000.0, "segments in no order"))]


def add_fractures(found):
    """Twice the time for ten times the cells, ten times for ten times the triangles; CGAL takes 100 ms a cell."""
    for backend, factor in (("halfedge", 1.0), ("linear", 0.5)):
        for triangles in (10_000, 100_000, 1_000_000):
            for cells, more in ((10, 1), (100, 2), (1000, 4)):
                found.bench[f"Fracture/{backend}/asteroid/{triangles}/{cells}"] = repeated(
                    real_time=factor * more * triangles / 10_000, triangles=triangles, cells=cells, pieces=cells,
                    bonds=5 * cells, contact_area=1.0, piece_triangles=2 * triangles)
    found.bench["RealFracture/halfedge/sponge/100"] = repeated(
        real_time=50.0, triangles=9_000, cells=100, pieces=130, bonds=300, contact_area=2.0, piece_triangles=20_000)
    found.cells = [{"mesh": "asteroid", "triangles": 10_000, "cells": 100, "peer": "cgal_clip", "ms": 100.0, "least_ms": 90.0,
                    "most_ms": 120.0, "planes": 7, "right": 7, "verdict": "right"}]


def add_viewer(found):
    """A run of each back end with the rook, one with the asteroid; the half-edge back end has the longer frames."""
    for model in ("rook", "asteroid"):
        for number, backend in enumerate(BACKENDS, 1):
            cuts = [Cut(model, backend, 1000 * n, 10 * n, number * n, 100 * n) for n in (1, 2, 20)]
            times = {"min": 1.0, "median": 10.0 * number, "max": 20.0 * number}
            found.runs.append(Run(model, backend, "a card", cuts, {name: times for name in (
                "frame_ms", "simulate_cpu_ms", "submit_cpu_ms", "cut_to_upload_cpu_ms")}))
    for backend, most in (("halfedge", 1.0), ("baseline/remap", 2.0)):
        found.undrawn_runs.append(Run("rook", backend, "a card", [], {"simulate_cpu_ms": {"max": most}}))
