"""Names that several parts of the report share."""

from enum import Enum

from run_bench import LOOKUPS

BACKENDS = [f"baseline/{lookup}" for lookup in LOOKUPS] + ["halfedge"]
ASTEROID = "asteroid"  # the generated model of the viewer's large run, beside the report's fifteen

GALLERY = "gallery-"  # begins the names of stages that draw caps


class Kind(Enum):
    """Which program a stage runs."""

    BENCH = "bench"
    COMPARE = "compare"
    VIEWER = "viewer"
    PEERS = "peers"  # the program that cuts with CGAL
    VTK = "vtk"  # the script that cuts with VTK
