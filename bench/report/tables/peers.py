"""Other libraries on the same meshes and planes."""

from report.measurements import Measurements
from report.tables.core import Column, Table, count, milliseconds

CUTTERS = ("halfedge", "baseline/remap")


def peers_table(found: Measurements) -> Table:
    """One row a cutter and mesh: time of a cut with both sides, and whether the answer is right."""
    table = Table("peers", [Column("shape", "mesh"), Column("triangles", "triangles", count), Column("cutter", "cut by"),
                            Column("ms", "ms", milliseconds), Column("planes", "planes"), Column("right", "right answers"),
                            Column("verdict", "verdict")])
    for (backend, _), c in sorted(found.growth("Geometry", "asteroid").items(), key=lambda item: item[0][1]):
        if found.peers and backend in CUTTERS:
            table.rows.append({"shape": "asteroid", "triangles": c["triangles"][0], "cutter": backend, "ms": c["real_time"][0],
                               "planes": None, "right": None, "verdict": "right"})
    for row in found.peers:
        table.rows.append({"shape": row["mesh"], "triangles": row["triangles"], "cutter": row["peer"], "ms": row["ms"],
                           "planes": row["planes"], "right": row["right"], "verdict": row["verdict"]})
    return table
