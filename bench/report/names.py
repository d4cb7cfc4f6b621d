"""Names that several parts of the report share."""

from enum import Enum

LOOKUPS = ("scan", "two_bucket_hash", "hash", "remap")  # the baseline's ways to find a vertex again, the slowest first
# `linear` is the loop of baseline/remap with right caps, `halfedge/cgal` the half-edge back end with caps by CGAL.
BACKENDS = tuple(f"baseline/{lookup}" for lookup in LOOKUPS) + ("linear", "halfedge/cgal", "halfedge")
QUADRATIC = ("baseline/scan", "baseline/two_bucket_hash")  # they look at many vertices to find one again
SUBQUADRATIC = tuple(name for name in BACKENDS if name not in QUADRATIC)
FASTEST = ("baseline/remap", "linear", "halfedge")
REAL_BACKENDS = ("halfedge", "halfedge/cgal", "linear", "baseline/remap")  # that cut meshes which are not round
SIZES = (1_000, 3_000, 10_000, 30_000, 100_000, 300_000, 1_000_000, 4_000_000, 16_000_000)  # triangles
PROXIES = ("every_vertex", "full_hull", "bounded_hull", "box", "sphere")
ASTEROID = "asteroid"  # the generated model of the viewer's large run, beside the report's fifteen
UNDRAWN = "frames-"  # begins the names of the viewer's stages that draw nothing
GALLERY = "gallery-"  # begins the names of stages that draw caps


class Kind(Enum):
    """Which program a stage runs."""

    BENCH = "bench"
    COMPARE = "compare"
    VIEWER = "viewer"
    PEERS = "peers"  # the program that cuts with CGAL
    VTK = "vtk"  # the script that cuts with VTK
    SLICERS = "slicers"  # the program that cuts with CGAL, asked for sections
    CELLS = "cells"  # the program that cuts with CGAL, asked for the cells of a fracture
    VTK_SECTIONS = "vtk-sections"  # the script that asks VTK for sections
    OPEN3D_SECTIONS = "open3d-sections"  # the script that asks Open3D for sections
