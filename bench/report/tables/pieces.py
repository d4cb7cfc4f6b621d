"""Chains of cuts, proxies, simulation, and the distribution of many cuts."""

import statistics

from report.measurements import Measurements
from report.names import ASTEROID
from report.tables.core import (Column, Table, Value, count, digits, median, microseconds, milliseconds, percent, short, spread_of,
                                worst_spread)
from run_bench import PROXIES

CHAINS_EACH = 5  # chains of an iteration, chain_bench.cpp
QUANTILES = ("p50", "p90", "p99")


def chains_table(found: Measurements) -> Table:
    """A hundred cuts in a row."""
    table = Table("chains", [Column("backend", "back end", short), Column("triangles", "triangles", count),
                             Column("mean_cut_ms", "mean ms", milliseconds), Column("worst_cut_ms", "worst ms", milliseconds),
                             Column("worst_to_mean", "worst / mean", digits(1)),
                             Column("worst_to_predicted", "worst / predicted", digits(2)),
                             Column("ns_per_crossing", "ns / crossing", digits(0)),
                             Column("most_draw_ranges", "most draw ranges", count), Column("spread", "spread of the mean", percent),
                             Column("chains", "chains", digits(0))])
    for backend, size, c in found.sized("Recut"):
        table.rows.append({"backend": backend, "triangles": size, "mean_cut_ms": c["cut_ms"][0],
                           "worst_cut_ms": c["worst_cut_ms"][0], "worst_to_mean": c["worst_cut_ms"][0] / c["cut_ms"][0],
                           "worst_to_predicted": c["worst_to_predicted"][0], "ns_per_crossing": c["ns_per_crossing"][0],
                           "most_draw_ranges": c["most_draw_ranges"][0], "spread": spread_of(c, "cut_ms"),
                           "chains": CHAINS_EACH * c["repetitions"][0] * c["iterations"][1]})
    return table


def swipes_table(found: Measurements) -> Table:
    """What a swipe costs the viewer's simulation, and its physics with many pieces."""
    table = Table("simulation", [Column("what", "what"), Column("backend", "back end", short),
                                 Column("size", "triangles or pieces", count), Column("ms", "ms", milliseconds),
                                 Column("spread", "spread", percent), Column("repetitions", "repetitions", digits(0))])
    for backend, size, c in found.sized("Swipe"):
        table.rows.append({"what": "swipe", "backend": backend, "size": size, "ms": c["real_time"][0],
                           "spread": spread_of(c, "real_time"), "repetitions": c["repetitions"][0]})
    for name, c in found.bench.items():
        if name.startswith("Pieces/"):
            table.rows.append({"what": f"frame of physics, pieces in a {name.split('/')[1]}" if "heap" in name else
                               "frame of physics, pieces apart", "backend": None, "size": c["bodies"][0],
                               "ms": c["real_time"][0], "spread": spread_of(c, "real_time"), "repetitions": c["repetitions"][0]})
    return table


def viewer_distribution_table(found: Measurements) -> Table:
    """Every cut of the viewer, from the hit to the last uploaded byte: medians hide the frame that is dropped."""
    table = Table("viewer_distribution", [Column("models", "models"), Column("backend", "back end", short), Column("cuts", "cuts"),
                                   Column("median_ms", "median ms", milliseconds), Column("p90_ms", "9 of 10 ms", milliseconds),
                                   Column("worst_ms", "worst ms", milliseconds),
                                   Column("over_frame", "longer than 1/60 s"), Column("worst_model", "worst in")])
    for models, is_in in (("the report's", lambda cut: cut.model != ASTEROID), (ASTEROID, lambda cut: cut.model == ASTEROID)):
        for backend in found.viewer_backends():
            cuts = sorted((cut for run in found.runs if run.backend == backend for cut in run.cuts if is_in(cut)),
                          key=lambda cut: cut.to_upload_ms)
            if not cuts:
                continue
            times = [cut.to_upload_ms for cut in cuts]
            table.rows.append({"models": models, "backend": backend, "cuts": len(cuts), "median_ms": statistics.median(times),
                               "p90_ms": times[(9 * len(times) - 1) // 10], "worst_ms": times[-1],
                               "over_frame": sum(time > 1e3 / 60 for time in times), "worst_model": cuts[-1].model})
    return table


def viewer_cuts_table(found: Measurements) -> Table:
    """Every cut of the viewer, one a row: for the CSV and the plot."""
    table = Table("viewer_cuts", [Column(key, key) for key in ("model", "backend", "triangles", "crossing", "to_upload_ms",
                                                               "upload_bytes")])
    for run in found.runs:
        table.rows += [vars(cut) for cut in run.cuts]
    return table


def distribution_table(found: Measurements) -> Table:
    """Quantiles of the whole chain's time over many planes through the inner half of one mesh."""
    table = Table("distribution", [Column("backend", "back end", short), Column("triangles", "triangles", count),
                                   Column("cuts", "planes", count)] +
                  [Column(f"{quantile}_ms", f"{quantile[1:]} % of cuts, ms", milliseconds) for quantile in QUANTILES] +
                  [Column("worst_ms", "worst ms", milliseconds), Column("over_frame", "longer than 1/60 s", digits(0))])
    for backend, size, c in found.sized("Many"):
        row: dict[str, Value] = {"backend": backend, "triangles": size, "cuts": c["cuts"][0], "worst_ms": c["worst_ms"][0],
                                 "over_frame": c["over_frame"][0]}
        table.rows.append(row | {f"{quantile}_ms": c[f"{quantile}_ms"][0] for quantile in QUANTILES})
    return table


def chain_decades_table(found: Measurements) -> Table:
    """Chains of a thousand cuts at a few marks: cost since the mark before, and draw ranges."""
    table = Table("chain_decades", [Column("backend", "back end", short), Column("mode", "mode"),
                                    Column("triangles", "triangles", count), Column("cuts", "cuts so far", count),
                                    Column("mean_cut_ms", "mean ms", milliseconds), Column("worst_cut_ms", "worst ms", milliseconds),
                                    Column("ranges_per_piece", "draw ranges a piece", digits(1)),
                                    Column("most_ranges", "most of a piece", count),
                                    Column("compactions", "compactions so far", count),
                                    Column("compact_ms", "compacting so far, ms", milliseconds)])
    for variant, size, c in found.sized("Chain"):
        mode, _, backend = variant.partition("/")
        marks = sorted(int(key.removeprefix("mean_ms_")) for key in c if key.startswith("mean_ms_"))
        for mark in marks:
            table.rows.append({"backend": backend, "mode": mode, "triangles": size, "cuts": mark,
                               "mean_cut_ms": c[f"mean_ms_{mark}"][0], "worst_cut_ms": c[f"worst_ms_{mark}"][0],
                               "ranges_per_piece": c[f"ranges_{mark}"][0] / (mark + 1), "most_ranges": c[f"most_ranges_{mark}"][0],
                               "compactions": c[f"compactions_{mark}"][0], "compact_ms": c[f"compact_ms_{mark}"][0]})
    return table


def proxies_table(found: Measurements) -> Table:
    """Collision proxies over the fifteen models: time to build, points, fit; and a frame's physics with each."""
    table = Table("proxies", [Column("kind", "proxy", lambda kind: str(kind).replace("_", " ")),
                              Column("build_ms", "build, median ms", microseconds),
                              Column("worst_build_ms", "build, worst model, ms", microseconds),
                              Column("halfedge_build_ms", "of halfedge, median ms", microseconds),
                              Column("points", "points, median", digits(0)),
                              Column("volume_ratio", "volume / full hull, median", digits(3)),
                              Column("least_volume_ratio", "least", digits(3)), Column("most_volume_ratio", "most", digits(3)),
                              Column("frame_ms", "physics of a frame, ms", milliseconds),
                              Column("touching_pairs", "pairs that touch", digits(0)), Column("pieces", "pieces", digits(0)),
                              Column("spread", "worst spread", percent), Column("repetitions", "repetitions", digits(0))])
    for kind in PROXIES:
        own = [c for name, c in found.bench.items() if name.startswith(f"Proxy/{kind}/")]
        if not own:
            continue
        times = [c["proxy_ms"][0] for c in own]
        ratios = [c["volume_ratio"][0] for c in own if "volume_ratio" in c]
        row: dict[str, Value] = {"kind": kind, "build_ms": statistics.median(times), "worst_build_ms": max(times),
                                 "points": statistics.median(c["points"][0] for c in own)}
        if ratios:
            row |= {"volume_ratio": statistics.median(ratios), "least_volume_ratio": min(ratios), "most_volume_ratio": max(ratios)}
        physics = next((c for name, c in found.bench.items() if name.startswith(f"Physics/{kind}/")), None)
        row |= {"frame_ms": median(physics, "real_time"), "pieces": median(physics, "bodies"),
                "touching_pairs": median(physics, "touching_pairs")}
        row |= {"spread": worst_spread([(c, "proxy_ms") for c in own] + [(physics, "real_time")]),
                "repetitions": min(c["repetitions"][0] for c in own)}
        of_tree = [c["proxy_ms"][0] for name, c in found.bench.items() if name.startswith(f"Proxy/halfedge/{kind}/")]
        if of_tree:
            row["halfedge_build_ms"] = statistics.median(of_tree)
        table.rows.append(row)
    return table
