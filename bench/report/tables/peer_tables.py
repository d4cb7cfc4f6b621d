"""Other libraries on the same meshes and planes."""

from report.measurements import Measurements
from report.repetitions import median
from report.tables.numbers import count, digits, short, timed
from report.tables.table import Column, Table, Value

NO_CAPS = "makes no caps"  # the verdict on every cut of a method that only divides the surface
CUTTERS = ("baseline/remap", "halfedge")


def peers_by_mesh_table(found: Measurements) -> Table:
    """One row a mesh, one column a cutter: times, and which of them are not right."""
    long = peers_table(found)
    cutters = sorted(dict.fromkeys(str(row["cutter"]) for row in long.rows), key=lambda name: name not in CUTTERS)
    table = Table("peers_by_mesh", [Column("shape", "mesh"), Column("triangles", "triangles", count)] +
                  [Column(f"{cutter}_ms", short(cutter).replace("_", " "), timed) for cutter in cutters] +
                  ([Column("not_right", "not right")] if any(problem_of(row) for row in long.rows) else []))
    meshes = list(dict.fromkeys((row["shape"], row["triangles"]) for row in long.rows))
    for shape, triangles in sorted(meshes, key=lambda mesh: (mesh[0] == "asteroid", mesh[1])):
        own = [row for row in long.rows if (row["shape"], row["triangles"]) == (shape, triangles)]
        problems = [f"{short(str(row['cutter']))}: {problem}" for row in own if (problem := problem_of(row))]
        table.rows.append({"shape": shape, "triangles": triangles}
                          | ({"not_right": "; ".join(problems)} if problems else {}) |
                          {f"{row['cutter']}_ms": row["ms"] for row in own})
    return table


def problem_of(row: dict[str, Value]) -> str:
    """What is the matter with an answer; nothing if it is right, or no answer to the question (a split makes no
    caps)."""
    return "" if row["verdict"] in ("right", NO_CAPS) else str(row["verdict"])


def peers_table(found: Measurements) -> Table:
    """One row a cutter and mesh: time of a cut with both sides, and whether the answer is right. The back ends' answers
    are checked before they are timed, so theirs are right or missing."""
    table = Table("peers", [Column("shape", "mesh"), Column("triangles", "triangles", count),
                            Column("cutter", "cut by"),
                            Column("ms", "ms", timed), Column("least_ms", "least ms", timed),
                            Column("most_ms", "most ms", timed), Column("planes", "planes", digits(0)),
                            Column("right", "right answers"), Column("verdict", "verdict")])
    for (backend, _), c in sorted(found.growth("Geometry", "asteroid").items(), key=lambda item: item[0][1]):
        if found.peers and backend in CUTTERS:
            table.rows.append({"shape": "asteroid", "triangles": c["triangles"][0], "cutter": backend,
                               "ms": c["real_time"][0],
                               "least_ms": c["real_time"][1], "most_ms": c["real_time"][2],
                               "planes": median(c, "cuts_each"), "right": None, "verdict": "right"})
    for name, c in found.bench.items():
        kind, _, rest = name.partition("/")
        backend, _, model = rest.rpartition("/")
        if found.peers and kind == "Cut" and backend in CUTTERS:
            table.rows.append({"shape": model, "triangles": c["triangles"][0], "cutter": backend, "ms": c["cut_ms"][0],
                               "least_ms": c["cut_ms"][1], "most_ms": c["cut_ms"][2], "planes": median(c, "cuts_each"),
                               "right": None, "verdict": "right"})
    for row in found.peers:
        table.rows.append({"shape": row["mesh"], "triangles": row["triangles"], "cutter": row["peer"], "ms": row["ms"],
                           "least_ms": row.get("least_ms"), "most_ms": row.get("most_ms"), "planes": row["planes"],
                           "right": row["right"], "verdict": row["verdict"]})
    return table
