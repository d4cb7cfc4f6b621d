"""Meshes that are not round, scanned and modelled ones among them, and the whole chain of the report's models."""

import math

from report.measurements import Measurements
from report.names import REAL_BACKENDS
from report.repetitions import Counters, median, worst_spread
from report.student_report import report_rows
from report.tables.numbers import count, digits, percent, short, timed
from report.tables.table import Column, Table, Value


def time_columns() -> list[Column]:
    return [Column(f"{backend}_ms", short(backend), timed) for backend in REAL_BACKENDS]


def times_of(found: Measurements, kind: str, name: str) -> dict[str, Value]:
    own = {backend: found.of_model(kind, backend, name) for backend in REAL_BACKENDS}
    return ({f"{backend}_ms": median(counters, "real_time") for backend, counters in own.items()} |
            {"spread": worst_spread((c, "real_time") for c in own.values() if c)})


def meshes(found: Measurements) -> list[tuple[str, Counters]]:
    """What was cut, with the half-edge back end's counters, in the order in which it was."""
    kinds = [(name.split("/"), counters) for name, counters in found.bench.items()]
    return [(parts[2], counters) for parts, counters in kinds if parts[:2] == ["Real", "halfedge"] and len(parts) == 3]


def asteroid_ns(found: Measurements, triangles: float) -> float | None:
    """Nanoseconds for each crossing triangle that the half-edge back end takes to cut an asteroid of that size, between
    the sizes that were timed."""
    own = sorted((c["triangles"][0], c["ns_per_crossing"][0])
                 for (backend, _), c in found.growth("Geometry", "asteroid").items() if backend == "halfedge")
    for (small, of_small), (large, of_large) in zip(own, own[1:]):
        if small <= triangles <= large:
            share = math.log(triangles / small) / math.log(large / small)
            return of_small + share * (of_large - of_small)
    return None


def real_cuts_table(found: Measurements) -> Table:
    """cut() alone, and how it compares with an asteroid of the same size."""
    table = Table("real_cuts", [Column("mesh", "mesh"), Column("triangles", "triangles", count),
                                Column("crossing", "crossing k", count), *time_columns(),
                                Column("ns_per_crossing", "halfedge, ns / k", timed),
                                Column("to_asteroid", "to an asteroid of that size", digits(2)),
                                Column("spread", "worst spread", percent), Column("planes", "planes", digits(0)),
                                Column("repetitions", "repetitions", digits(0))])
    for name, half in meshes(found):
        triangles, ns = half["triangles"][0], half["ns_per_crossing"][0]
        round_one = asteroid_ns(found, triangles)
        table.rows.append({"mesh": name, "triangles": triangles, "crossing": half["crossing"][0],
                           "ns_per_crossing": ns, "to_asteroid": ns / round_one if round_one else None,
                           "planes": median(half, "cuts_each"), "repetitions": half["repetitions"][0]} |
                          times_of(found, "Real", name))
    return table


def real_chains_table(found: Measurements) -> Table:
    """The whole chain on the same meshes."""
    table = Table("real_chains", [Column("mesh", "mesh"), *time_columns(), Column("spread", "worst spread", percent)])
    table.rows += [{"mesh": name} | times_of(found, "RealChain", name) for name, _ in meshes(found)
                   if found.of_model("RealChain", "halfedge", name)]
    return table


def model_chains_table(found: Measurements) -> Table:
    """The whole chain on the report's fifteen models."""
    table = Table("model_chains", [Column("model", "model"), *time_columns(),
                                   Column("spread", "worst spread", percent)])
    names = [row["model"] for row in report_rows()]
    table.rows += [{"model": name} | times_of(found, "ModelChain", name) for name in names
                   if found.of_model("ModelChain", "halfedge", name)]
    return table
