"""Sections of an object that stays whole: one by one, in stacks, of meshes that are not round, and by other libraries."""

from report.measurements import Measurements
from report.repetitions import Counters, median
from report.tables.numbers import count, digits, percent, timed
from report.tables.table import Column, Table, Value

WAYS = ("loops", "nested", "filled", "by_cut", "through_vertices", "along_edges", "in_faces")
BACKENDS = ("halfedge", "baseline/remap")


def each_ms(counters: Counters | None) -> float | None:
    """Of one section: an iteration is a round over several planes."""
    return None if counters is None else counters["real_time"][0] / median(counters, "sections_each")


def prepare_ms(found: Measurements, backend: str, size: int) -> float | None:
    counters = found.bench.get(f"Prepare/{backend}/asteroid/{size}")
    return None if counters is None else counters["real_time"][0]


def sections_table(found: Measurements) -> Table:
    """One section, ms, each way to have it."""
    columns = [Column("triangles", "triangles", count), Column("crossing", "crossing k", count),
               Column("loops_ms", "loops", timed), Column("nested_ms", "and nesting", timed),
               Column("filled_ms", "and triangles", timed), Column("by_cut_ms", "cut of a copy", timed),
               Column("to_cut", "cut / loops", timed), Column("touched", "triangles touched", count),
               Column("nodes", "nodes", count), Column("remap_ms", "remap, loops", timed),
               Column("prepare_ms", "preparing", timed),
               Column("through_vertices_ms", "loops, through three vertices", timed),
               Column("along_edges_ms", "along an edge", timed), Column("in_faces_ms", "in a face", timed)]
    table = Table("sections", columns)
    for (variant, size), c in sorted(found.growth("Section", "asteroid").items(), key=lambda cell: cell[0][1]):
        if variant != "loops/halfedge":
            continue
        own = {way: each_ms(found.bench.get(f"Section/{way}/halfedge/asteroid/{size}")) for way in WAYS}
        row: dict[str, Value] = {f"{way}_ms": ms for way, ms in own.items()}
        table.rows.append(row | {
            "triangles": c["triangles"][0], "crossing": c["crossing_triangles"][0], "touched": c["triangles_touched"][0],
            "nodes": c["nodes_visited"][0], "prepare_ms": prepare_ms(found, "halfedge", size),
            "to_cut": own["by_cut"] / own["loops"] if own["by_cut"] and own["loops"] else None,
            "remap_ms": each_ms(found.bench.get(f"Section/loops/baseline/remap/asteroid/{size}"))})
    return table


def stacks_table(found: Measurements) -> Table:
    """Stacks of parallel planes, ms for all of a stack with nesting and areas."""
    table = Table("section_stacks", [Column("shape", "mesh"), Column("triangles", "triangles", count),
                                     Column("heights", "heights", count), Column("halfedge_ms", "halfedge", timed),
                                     Column("threads_ms", "on two threads", timed), Column("remap_ms", "remap", timed),
                                     Column("each_us", "halfedge, µs each", timed),
                                     Column("loops", "loops", count)])
    for name, c in found.bench.items():
        parts = name.split("/")
        if len(parts) < 4 or parts[0] not in ("Stack", "RealStack") or parts[1] != "halfedge":
            continue
        tail, ms = "/".join(parts[2:]), c["real_time"][0]
        threads = found.bench.get(f"StackThreads/2/halfedge/{tail}")
        linear = found.bench.get(f"{parts[0]}/baseline/remap/{tail}")
        table.rows.append({"shape": parts[2], "triangles": c["triangles"][0], "heights": c["heights"][0],
                           "halfedge_ms": ms, "each_us": ms * 1e3 / c["heights"][0], "loops": c["loops"][0],
                           "threads_ms": threads["real_time"][0] if threads else None,
                           "remap_ms": linear["real_time"][0] if linear else None})
    table.rows.sort(key=lambda row: (row["shape"] != "asteroid", row["shape"], row["triangles"], row["heights"]))
    return table


def real_sections_table(found: Measurements) -> Table:
    """One section of a mesh that is not round, nesting among it."""
    table = Table("real_sections", [Column("mesh", "mesh"), Column("triangles", "triangles", count),
                                    Column("crossing", "crossing k", count), Column("loops", "loops", count),
                                    Column("halfedge_ms", "halfedge", timed), Column("remap_ms", "remap", timed)])
    for name, c in found.bench.items():
        kind, _, mesh = name.partition("/halfedge/")
        if kind != "RealSection":
            continue
        table.rows.append({"mesh": mesh, "triangles": c["triangles"][0], "crossing": c["crossing_triangles"][0],
                           "loops": c["loops"][0], "halfedge_ms": each_ms(c),
                           "remap_ms": each_ms(found.bench.get(f"RealSection/baseline/remap/{mesh}"))})
    return table


def slicers_table(found: Measurements) -> Table:
    """Other libraries beside the back ends on the same planes: one row a mesh, number of heights and way."""
    table = Table("slicers", [Column("mesh", "mesh"), Column("triangles", "triangles", count),
                              Column("heights", "heights", count), Column("by", "by"),
                              Column("prepare_ms", "preparing, ms", timed), Column("ms", "ms", timed),
                              Column("to_halfedge", "to halfedge", timed), Column("verdict", "answer")])
    if not found.slicers:
        return table
    rows = own_sections(found)
    asked = {(row["mesh"], row["triangles"], row["heights"]) for row in found.slicers}
    rows = [row for row in rows if (row["mesh"], row["triangles"], row["heights"]) in asked]
    rows += [{"mesh": row["mesh"], "triangles": row["triangles"], "heights": row["heights"], "by": row["peer"],
              "ms": row["ms"], "prepare_ms": row["prepare_ms"], "verdict": row["verdict"]} for row in found.slicers]
    ours = {(row["mesh"], row["triangles"], row["heights"]): row["ms"] for row in rows if row["by"] == "halfedge"}
    for row in rows:
        own = ours.get((row["mesh"], row["triangles"], row["heights"]))
        row["to_halfedge"] = row["ms"] / own if own and row["ms"] and row["by"] != "halfedge" else None
    table.rows = sorted((row for row in rows if row["ms"]),
                        key=lambda row: (row["mesh"] != "asteroid", row["mesh"], row["heights"], row["triangles"]))
    return table


def own_sections(found: Measurements) -> list[dict[str, Value]]:
    """What the back ends took for what other libraries are asked for."""
    rows: list[dict[str, Value]] = []
    for row in sections_table(found).rows:
        for name, ms in (("halfedge", row["loops_ms"]), ("baseline/remap", row["remap_ms"])):
            rows.append({"mesh": "asteroid", "triangles": row["triangles"], "heights": 1, "by": name, "ms": ms,
                         "prepare_ms": row["prepare_ms"] if name == "halfedge" else 0.0})
    for row in real_sections_table(found).rows:
        for name, ms in (("halfedge", row["halfedge_ms"]), ("baseline/remap", row["remap_ms"])):
            rows.append({"mesh": row["mesh"], "triangles": row["triangles"], "heights": 1, "by": name, "ms": ms})
    for row in stacks_table(found).rows:
        for name, ms in (("halfedge", row["halfedge_ms"]), ("baseline/remap", row["remap_ms"])):
            rows.append({"mesh": row["shape"], "triangles": row["triangles"], "heights": row["heights"], "by": name,
                         "ms": ms})
    return [row | {"verdict": "right"} for row in rows]
