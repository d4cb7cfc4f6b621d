"""Cuts in a row."""

from report.measurements import Measurements
from report.repetitions import spread_of
from report.tables.numbers import count, digits, percent, short, timed
from report.tables.table import Column, Table

CHAINS_EACH = 5  # chains of an iteration, chain_bench.cpp


def chains_table(found: Measurements) -> Table:
    """A hundred cuts in a row."""
    table = Table("chains", [Column("backend", "back end", short), Column("triangles", "triangles", count),
                             Column("mean_cut_ms", "mean ms", timed), Column("worst_cut_ms", "worst ms", timed),
                             Column("worst_to_mean", "worst / mean", timed),
                             Column("worst_to_predicted", "worst / predicted", timed),
                             Column("ns_per_crossing", "ns / crossing", timed),
                             Column("most_draw_ranges", "most draw ranges", count),
                             Column("spread", "spread of the mean", percent),
                             Column("chains", "chains", digits(0))])
    for backend, size, c in found.sized("Recut"):
        table.rows.append({"backend": backend, "triangles": size, "mean_cut_ms": c["cut_ms"][0],
                           "worst_cut_ms": c["worst_cut_ms"][0], "worst_to_mean": c["worst_cut_ms"][0] / c["cut_ms"][0],
                           "worst_to_predicted": c["worst_to_predicted"][0], "ns_per_crossing": c["ns_per_crossing"][0],
                           "most_draw_ranges": c["most_draw_ranges"][0], "spread": spread_of(c, "cut_ms"),
                           "chains": CHAINS_EACH * c["repetitions"][0] * c["iterations"][1]})
    return table


def long_chains_table(found: Measurements) -> Table:
    """Chains of a thousand cuts: the cut that takes longest, and the one that costs most for what it crosses."""
    table = Table("long_chains", [Column("backend", "back end", short), Column("mode", "mode"),
                                  Column("triangles", "triangles", count), Column("worst_cut_ms", "worst ms", timed),
                                  Column("worst_to_predicted", "worst / predicted", digits(2)),
                                  Column("worst_at", "it is cut number", count),
                                  Column("chains", "chains", digits(0))])
    for variant, size, c in found.sized("Chain"):
        if "worst_to_predicted" not in c:
            continue
        mode, _, backend = variant.partition("/")
        table.rows.append({"backend": backend, "mode": mode, "triangles": size,
                           "worst_cut_ms": max(value[0] for key, value in c.items() if key.startswith("worst_ms_")),
                           "worst_to_predicted": c["worst_to_predicted"][0],
                           "worst_at": c["worst_to_predicted_at"][0], "chains": c["chains"][0] * c["repetitions"][0]})
    return table


def chain_decades_table(found: Measurements) -> Table:
    """Chains of a thousand cuts at a few marks: cost since the mark before, and draw ranges."""
    table = Table("chain_decades", [Column("backend", "back end", short), Column("mode", "mode"),
                                    Column("triangles", "triangles", count), Column("cuts", "cuts so far", count),
                                    Column("mean_cut_ms", "mean ms", timed), Column("worst_cut_ms", "worst ms", timed),
                                    Column("ranges_per_piece", "draw ranges a piece", digits(1)),
                                    Column("most_ranges", "most of a piece", count),
                                    Column("compactions", "compactions so far", count),
                                    Column("compact_ms", "compacting so far, ms", timed)])
    for variant, size, c in found.sized("Chain"):
        mode, _, backend = variant.partition("/")
        marks = sorted(int(key.removeprefix("mean_ms_")) for key in c if key.startswith("mean_ms_"))
        for mark in marks:
            table.rows.append({"backend": backend, "mode": mode, "triangles": size, "cuts": mark,
                               "mean_cut_ms": c[f"mean_ms_{mark}"][0], "worst_cut_ms": c[f"worst_ms_{mark}"][0],
                               "ranges_per_piece": c[f"ranges_{mark}"][0] / (mark + 1),
                               "most_ranges": c[f"most_ranges_{mark}"][0],
                               "compactions": c[f"compactions_{mark}"][0], "compact_ms": c[f"compact_ms_{mark}"][0]})
    return table
