"""How the times of many cuts are distributed."""

import statistics

from report.measurements import Measurements
from report.names import ASTEROID
from report.tables.numbers import count, digits, short, timed
from report.tables.table import Column, Table, Value

QUANTILES = ("p50", "p90", "p99")


def distribution_table(found: Measurements) -> Table:
    """Quantiles of the whole chain's time over many planes through the inner half of one mesh."""
    table = Table("distribution", [Column("backend", "back end", short), Column("triangles", "triangles", count),
                                   Column("cuts", "planes", count)] +
                  [Column(f"{quantile}_ms", f"{quantile[1:]} % of cuts, ms", timed) for quantile in QUANTILES] +
                  [Column("worst_ms", "worst ms", timed), Column("over_frame", "longer than 1/60 s", digits(0))])
    for backend, size, c in found.sized("Many"):
        row: dict[str, Value] = {"backend": backend, "triangles": size, "cuts": c["cuts"][0],
                                 "worst_ms": c["worst_ms"][0],
                                 "over_frame": c["over_frame"][0]}
        table.rows.append(row | {f"{quantile}_ms": c[f"{quantile}_ms"][0] for quantile in QUANTILES})
    return table


def viewer_distribution_table(found: Measurements) -> Table:
    """Every cut of the viewer, from the hit to the last uploaded byte: medians hide the frame that is dropped."""
    table = Table("viewer_distribution", [Column("models", "models"), Column("backend", "back end", short),
                                          Column("cuts", "cuts"),
                                   Column("median_ms", "median ms", timed), Column("p90_ms", "9 of 10 ms", timed),
                                   Column("worst_ms", "worst ms", timed),
                                   Column("over_frame", "longer than 1/60 s"), Column("worst_model", "worst in")])
    for models, is_in in (("the report's", lambda cut: cut.model != ASTEROID),
                          (ASTEROID, lambda cut: cut.model == ASTEROID)):
        for backend in found.viewer_backends():
            cuts = sorted((cut for run in found.runs if run.backend == backend for cut in run.cuts if is_in(cut)),
                          key=lambda cut: cut.to_upload_ms)
            if not cuts:
                continue
            times = [cut.to_upload_ms for cut in cuts]
            table.rows.append({"models": models, "backend": backend, "cuts": len(cuts),
                               "median_ms": statistics.median(times),
                               "p90_ms": times[(9 * len(times) - 1) // 10], "worst_ms": times[-1],
                               "over_frame": sum(time > 1e3 / 60 for time in times), "worst_model": cuts[-1].model})
    return table


def viewer_cuts_table(found: Measurements) -> Table:
    """Every cut of the viewer, one a row: for the CSV and the plot."""
    keys = ("model", "backend", "triangles", "crossing", "to_upload_ms", "upload_bytes")
    table = Table("viewer_cuts", [Column(key, key) for key in keys])
    for run in found.runs:
        table.rows += [vars(cut) for cut in run.cuts]
    return table
