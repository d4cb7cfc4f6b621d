"""Objects broken into the cells of points."""

from report import fits
from report.measurements import Measurements
from report.repetitions import Counters, median, worst_spread
from report.tables.numbers import count, digits, percent, short, timed
from report.tables.table import Column, Table

BACKENDS = ("halfedge", "linear")


def fractures_table(found: Measurements) -> Table:
    """A row for each mesh and number of cells: time by back end, of preparing, and for a piece."""
    table = Table("fractures", [Column("mesh", "mesh"), Column("triangles", "triangles", count), Column("cells", "cells", count),
                                Column("pieces", "pieces", count), Column("bonds", "contacts", count),
                                *[Column(f"{backend}_ms", f"{short(backend)}, ms", timed) for backend in BACKENDS],
                                Column("us_per_piece", "half-edge, us a piece", digits(0)),
                                Column("prepare_ms", "preparing, ms", timed), Column("spread", "worst spread", percent)])
    keys = dict.fromkeys((mesh, triangles, cells) for mesh, triangles, cells, _, _ in named(found))
    for mesh, triangles, cells in sorted(keys, key=lambda key: (key[0] != "asteroid", key)):
        own = {backend: c for m, t, n, backend, c in named(found) if (m, t, n) == (mesh, triangles, cells)}
        half = own.get("halfedge")
        any_of_them = half or next(iter(own.values()))
        prepared = found.bench.get(f"Prepare/halfedge/asteroid/{triangles}") if mesh == "asteroid" else None
        half_ms = median(half, "real_time")
        table.rows.append({"mesh": mesh, "triangles": any_of_them["triangles"][0], "cells": cells,
                           "pieces": any_of_them["pieces"][0], "bonds": any_of_them["bonds"][0],
                           "us_per_piece": half_ms * 1e3 / any_of_them["pieces"][0] if half_ms else None,
                           "prepare_ms": median(prepared, "real_time"),
                           "spread": worst_spread((c, "real_time") for c in own.values())} |
                          {f"{backend}_ms": median(own.get(backend), "real_time") for backend in BACKENDS})
    return table


def named(found: Measurements) -> list[tuple[str, int, int, str, Counters]]:
    """Mesh, nominal triangles (0: not round), cells, back end, counters."""
    cells = []
    for name, counters in found.bench.items():
        parts = name.split("/")
        if parts[0] == "Fracture":
            cells.append((parts[2], int(parts[3]), int(parts[4]), parts[1], counters))
        elif parts[0] == "RealFracture":
            cells.append((parts[2], 0, int(parts[3]), parts[1], counters))
    return cells


def fracture_exponents(found: Measurements) -> dict[str, float]:
    """How the half-edge back end's time grows: with the area of contacts at the largest size, and with the triangles for the
    fewest cells."""
    own = [(t, n, c) for m, t, n, b, c in named(found) if m == "asteroid" and b == "halfedge"]
    exponents: dict[str, float] = {}
    if not own:
        return exponents
    largest, fewest = max(t for t, _, _ in own), min(n for _, n, _ in own)
    for what, points in (("cells", [(n, c["real_time"][0]) for t, n, c in own if t == largest]),
                         ("triangles", [(t, c["real_time"][0]) for t, n, c in own if n == fewest])):
        if fitted := fits.exponent(points):
            exponents[what] = fitted.value
    return exponents


def cells_table(found: Measurements) -> Table:
    """The same cells by CGAL's clip, one after the other."""
    table = Table("cells", [Column("mesh", "mesh"), Column("triangles", "triangles", count), Column("cells", "cells", count),
                            Column("by", "by", short), Column("ms", "ms a cell", timed),
                            Column("timed", "cells timed", count), Column("to_halfedge", "to half-edge", digits(0)),
                            Column("verdict", "verdict")])
    for row in found.cells:
        ours = next((c["real_time"][0] / n for m, t, n, b, c in named(found)
                     if m == row["mesh"] and b == "halfedge" and n == row["cells"] and
                     abs(c["triangles"][0] - row["triangles"]) < 1), None)
        table.rows.append({"mesh": row["mesh"], "triangles": row["triangles"], "cells": row["cells"], "by": row["peer"],
                           "ms": row["ms"], "timed": row["planes"], "to_halfedge": row["ms"] / ours if ours else None,
                           "verdict": row["verdict"]})
    return table
