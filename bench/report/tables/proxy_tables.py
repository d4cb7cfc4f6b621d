"""Collision proxies, and what the simulation costs with them."""

import statistics

from report.measurements import Measurements
from report.names import PROXIES
from report.repetitions import median, spread_of, worst_spread
from report.tables.numbers import count, digits, percent, short, timed
from report.tables.table import Column, Table, Value


def proxies_table(found: Measurements) -> Table:
    """Collision proxies over the fifteen models: time to build, points, fit; and a frame's physics with each."""
    table = Table("proxies", [Column("kind", "proxy", lambda kind: str(kind).replace("_", " ")),
                              Column("build_ms", "build, median ms", timed),
                              Column("worst_build_ms", "build, worst model, ms", timed),
                              Column("halfedge_build_ms", "of halfedge, median ms", timed),
                              Column("points", "points, median", digits(0)),
                              Column("volume_ratio", "volume / full hull, median", digits(3)),
                              Column("least_volume_ratio", "least", digits(3)),
                              Column("most_volume_ratio", "most", digits(3)),
                              Column("frame_ms", "physics of a frame, ms", timed),
                              Column("touching_pairs", "pairs that touch", digits(0)),
                              Column("pieces", "pieces", digits(0)),
                              Column("spread", "worst spread", percent),
                              Column("repetitions", "repetitions", digits(0))])
    for kind in PROXIES:
        own = [c for name, c in found.bench.items() if name.startswith(f"Proxy/{kind}/")]
        if not own:
            continue
        times = [c["proxy_ms"][0] for c in own]
        ratios = [c["volume_ratio"][0] for c in own if "volume_ratio" in c]
        row: dict[str, Value] = {"kind": kind, "build_ms": statistics.median(times), "worst_build_ms": max(times),
                                 "points": statistics.median(c["points"][0] for c in own)}
        if ratios:
            row |= {"volume_ratio": statistics.median(ratios), "least_volume_ratio": min(ratios),
                    "most_volume_ratio": max(ratios)}
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


def swipes_table(found: Measurements) -> Table:
    """What a swipe costs the viewer's simulation, and its physics with many pieces."""
    table = Table("simulation", [Column("what", "what"), Column("backend", "back end", short),
                                 Column("size", "triangles or pieces", count), Column("ms", "ms", timed),
                                 Column("spread", "spread", percent), Column("repetitions", "repetitions", digits(0))])
    for backend, size, c in found.sized("Swipe"):
        table.rows.append({"what": "swipe", "backend": backend, "size": size, "ms": c["real_time"][0],
                           "spread": spread_of(c, "real_time"), "repetitions": c["repetitions"][0]})
    for name, c in found.bench.items():
        if name.startswith("Pieces/"):
            table.rows.append({"what": f"frame of physics, pieces in a {name.split('/')[1]}" if "heap" in name else
                               "frame of physics, pieces apart", "backend": None, "size": c["bodies"][0],
                               "ms": c["real_time"][0], "spread": spread_of(c, "real_time"),
                               "repetitions": c["repetitions"][0]})
    return table
