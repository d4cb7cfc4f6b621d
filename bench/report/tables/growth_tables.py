"""How cost grows with the mesh."""

from report import fits
from report.measurements import Measurements, order
from report.repetitions import Counters, median, spread_of, worst_spread
from report.tables.numbers import count, digits, percent, rounded, short, timed
from report.tables.table import Column, Table, Value

EXTENTS = (("Scale", "whole chain"), ("Geometry", "geometry only"))
ORDERS = (("asteroid", "coherent"), ("shuffled", "random"))


def scaling_table(found: Measurements, kind: str, shape: str) -> Table:
    """Time by triangles for each back end, with the fitted exponents."""
    cells = found.growth(kind, shape)
    sizes = sorted({size for _, size in cells})
    table = Table(f"scaling_{kind.lower()}_{shape}", [Column("backend", "back end", short)] +
                  [Column(f"ms_{size}", count(size), timed) for size in sizes] +
                  [Column("exponent", "exponent", digits(2)), Column("exponent_half_width", "± (95 %)", digits(2)),
                   Column("exponent_points", "sizes fitted"), Column("least_slope", "least slope", digits(2)),
                   Column("most_slope", "greatest slope", digits(2)), Column("spread", "spread", percent),
                   Column("planes", "planes", digits(0)), Column("repetitions", "repetitions", digits(0)),
                   Column("least_cuts", "cuts timed, at least", digits(0))])
    for backend in sorted({backend for backend, _ in cells}, key=order):
        own = {size: counters for (name, size), counters in cells.items() if name == backend}
        row: dict[str, Value] = {"backend": backend}
        row |= {f"ms_{size}": median(own.get(size), "real_time") for size in sizes}
        fitted = growth_exponent(own)
        if fitted:
            row |= {"exponent": fitted.value, "exponent_half_width": fitted.half_width,
                    "exponent_points": fitted.points}
        local = fits.slopes(fitted_points(own))
        if len(local) > 1:
            row |= {"least_slope": min(local), "most_slope": max(local)}
        row["spread"] = worst_spread((c, "real_time") for c in own.values())
        row |= how_often(own)
        table.rows.append(row)
    return table


def scaling_points_table(found: Measurements) -> Table:
    """Every time of the scaling tables with its repetitions: the range, and how many cuts it rests on."""
    table = Table("scaling_points", [Column("extent", "what"), Column("input", "order of triangles"),
                                     Column("backend", "back end", short),
                                     Column("triangles", "triangles", count), Column("ms", "ms", timed),
                                     Column("least_ms", "least ms", timed), Column("most_ms", "most ms", timed),
                                     Column("planes", "planes", digits(0)), Column("rounds", "rounds", digits(0)),
                                     Column("repetitions", "repetitions", digits(0))])
    for kind, extent in EXTENTS:
        for shape, input_order in ORDERS:
            for (backend, size), c in sorted(found.growth(kind, shape).items(),
                                             key=lambda item: (order(item[0][0]), item[0][1])):
                middle, lowest, highest = c["real_time"]
                table.rows.append({"extent": extent, "input": input_order, "backend": backend,
                                   "triangles": c["triangles"][0],
                                   "ms": middle, "least_ms": lowest, "most_ms": highest,
                                   "planes": median(c, "cuts_each"),
                                   "rounds": median(c, "iterations"), "repetitions": median(c, "repetitions")})
    return table


def how_often(own: dict[int, Counters]) -> dict[str, Value]:
    """Planes of each size, repetitions, and the cuts that the time of the size rests on that was timed least often."""
    rounds = [c for c in own.values() if "cuts_each" in c]
    if not rounds:
        return {}
    return {"planes": min(c["cuts_each"][0] for c in rounds), "repetitions": min(c["repetitions"][0] for c in rounds),
            "least_cuts": min(c["repetitions"][0] * c["iterations"][1] * c["cuts_each"][0] for c in rounds)}


def fitted_points(own: dict[int, Counters], counter: str = "real_time") -> list[tuple[float, float]]:
    """Triangles and a counter, of the sizes that exponents are fitted to."""
    return [(c["triangles"][0], c[counter][0]) for c in own.values() if c["triangles"][0] >= fits.FITTED_FROM]


def growth_exponent(own: dict[int, Counters], counter: str = "real_time") -> fits.Exponent | None:
    return fits.exponent(fitted_points(own, counter))


def crossovers_table(found: Measurements) -> Table:
    """From which size on the half-edge back end takes less time than the linear ones that are worth it."""
    table = Table("crossovers", [Column("extent", "what"), Column("input", "order of triangles"),
                                 Column("against", "half-edge against", short),
                                 Column("from_triangles", "faster from", rounded),
                                 Column("least", "by the spread, at least", rounded),
                                 Column("most", "at most", rounded), Column("verdict", "in words")])
    for kind, extent in EXTENTS:
        for shape, input_order in ORDERS:
            cells = found.growth(kind, shape)
            for slower in ("baseline/hash", "baseline/remap"):
                sizes = sorted(size for name, size in cells if name == "halfedge" and (slower, size) in cells)
                if not sizes:
                    continue
                size = fits.crossover(cells, slower, "halfedge")
                smallest = cells[("halfedge", sizes[0])]["triangles"][0]
                verdict = (f"never, up to {count(sizes[-1])}" if size is None else
                           "at every size measured" if size <= smallest else f"from about {rounded(size)} triangles")
                row: dict[str, Value] = {"extent": extent, "input": input_order, "against": slower,
                                         "from_triangles": size,
                                         "verdict": verdict}
                if size is not None and size > smallest:
                    # The quickest repetition of one with the slowest of the other, and the reverse.
                    row |= {"least": fits.crossover(extreme(cells, slower, 2, 1), slower, "halfedge"),
                            "most": fits.crossover(extreme(cells, slower, 1, 2), slower, "halfedge")}
                table.rows.append(row)
    return table


def extreme(cells: dict[tuple[str, int], Counters], slower: str, of_slower: int,
            of_half_edge: int) -> dict[tuple[str, int], Counters]:
    """Cells with the lowest (1) or highest (2) time of the repetitions in place of the median."""
    chosen = {slower: of_slower, "halfedge": of_half_edge}
    return {(name, size): c | {"real_time": (c["real_time"][chosen[name]],) * 3}
            for (name, size), c in cells.items() if name in chosen}


def crossing_table(found: Measurements) -> Table:
    """What the half-edge back end's whole chain costs for each triangle that the plane crosses."""
    table = Table("per_crossing", [Column("triangles", "triangles", count), Column("crossing", "crossing k", count),
                                   Column("ns_per_crossing", "ns / k", timed),
                                   Column("touched_per_crossing", "touched / k", digits(1)),
                                   Column("nodes_per_crossing", "nodes / k", digits(2)),
                                   Column("bytes_per_crossing", "bytes to upload / k", digits(0)),
                                   Column("spread", "spread of ns", percent), Column("planes", "planes", digits(0)),
                                   Column("repetitions", "repetitions", digits(0))])
    own = {size: c for (name, size), c in found.growth("Scale", "asteroid").items() if name == "halfedge"}
    for _, c in sorted(own.items()):
        k = c["crossing"][0]
        table.rows.append({"triangles": c["triangles"][0], "crossing": k, "ns_per_crossing": c["ns_per_crossing"][0],
                           "touched_per_crossing": c["touched"][0] / k, "nodes_per_crossing": c["nodes"][0] / k,
                           "bytes_per_crossing": c["upload_bytes"][0] / k, "spread": spread_of(c, "ns_per_crossing"),
                           "planes": median(c, "cuts_each"), "repetitions": c["repetitions"][0]})
    return table


def counters_table(found: Measurements) -> Table:
    """Exact counters of the half-edge back end's cuts, mean of the planes."""
    keys = ("crossing", "touched", "nodes", "upload_bytes")
    table = Table("counters", [Column("triangles", "triangles", count)] +
                  [Column(key, key.replace("_", " "), digits(1)) for key in keys])
    own = {size: c for (name, size), c in found.growth("Scale", "asteroid").items() if name == "halfedge"}
    for _, c in sorted(own.items()):
        table.rows.append({"triangles": c["triangles"][0]} | {key: c[key][0] for key in keys})
    return table


def counter_exponents_table(found: Measurements) -> Table:
    """Exponents of the exact counters: the same on every run and machine."""
    own = {size: c for (name, size), c in found.growth("Scale", "asteroid").items() if name == "halfedge"}
    table = Table("counter_exponents", [Column("counter", "counter"), Column("exponent", "exponent", digits(3)),
                                        Column("half_width", "± (95 %)", digits(3)), Column("points", "sizes fitted")])
    for counter, name in (("crossing", "triangles crossed"), ("touched", "triangles touched"),
                          ("nodes", "tree nodes visited"), ("upload_bytes", "bytes to upload")):
        if fitted := growth_exponent(own, counter):
            table.rows.append({"counter": name, "exponent": fitted.value, "half_width": fitted.half_width,
                               "points": fitted.points})
    return table


def phases_table(found: Measurements) -> Table:
    """Milliseconds of each phase of the whole chain, by back end and size."""
    cells = found.growth("Scale", "asteroid")
    names = list(dict.fromkeys(key[3:] for counters in cells.values() for key in counters if key.startswith("ms_")))
    table = Table("phases", [Column("backend", "back end", short), Column("triangles", "triangles", count)] +
                  [Column(f"{name}_ms", name, timed) for name in names] +
                  [Column("total_ms", "all phases", timed), Column("upload_bytes", "bytes to upload", count)])
    for (backend, size), c in sorted(cells.items(), key=lambda item: (item[0][1], order(item[0][0]))):
        row: dict[str, Value] = {"backend": backend, "triangles": size, "upload_bytes": c["upload_bytes"][0]}
        row |= {f"{name}_ms": median(c, f"ms_{name}") for name in names}
        row["total_ms"] = sum(median(c, f"ms_{name}") or 0.0 for name in names)
        table.rows.append(row)
    return table
