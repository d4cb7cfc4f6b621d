"""How cost grows with the mesh."""

from report import fits
from report.measurements import Counters, Measurements, order
from report.tables.core import Column, Table, Value, count, digits, median, milliseconds, percent, short
from run_bench import crossover

EXTENTS = (("Scale", "whole chain"), ("Geometry", "geometry only"))
ORDERS = (("asteroid", "coherent"), ("shuffled", "random"))


def scaling_table(found: Measurements, kind: str, shape: str) -> Table:
    """Time by triangles for each back end, with the fitted exponents."""
    cells = found.growth(kind, shape)
    sizes = sorted({size for _, size in cells})
    table = Table(f"scaling_{kind.lower()}_{shape}", [Column("backend", "back end", short)] +
                  [Column(f"ms_{size}", count(size), milliseconds) for size in sizes] +
                  [Column("exponent", "exponent", digits(2)), Column("exponent_half_width", "± (95 %)", digits(2)),
                   Column("exponent_points", "sizes fitted"), Column("spread", "spread", percent)])
    for backend in sorted({backend for backend, _ in cells}, key=order):
        own = {size: counters for (name, size), counters in cells.items() if name == backend}
        row: dict[str, Value] = {"backend": backend}
        row |= {f"ms_{size}": median(own.get(size), "real_time") for size in sizes}
        fitted = growth_exponent(own)
        if fitted:
            row |= {"exponent": fitted.value, "exponent_half_width": fitted.half_width, "exponent_points": fitted.points}
        # Without repetitions there is no spread to tell.
        row["spread"] = max((c["real_time"][2] - c["real_time"][1]) / c["real_time"][0] for c in own.values()) or None
        table.rows.append(row)
    return table


def growth_exponent(own: dict[int, Counters], counter: str = "real_time") -> fits.Exponent | None:
    return fits.exponent([(c["triangles"][0], c[counter][0]) for c in own.values() if c["triangles"][0] >= fits.FITTED_FROM])


def crossovers_table(found: Measurements) -> Table:
    """From which size on the half-edge back end takes less time than the linear ones that are worth it."""
    table = Table("crossovers", [Column("extent", "what"), Column("input", "order of triangles"),
                                 Column("against", "half-edge against", short),
                                 Column("from_triangles", "faster from", count), Column("verdict", "in words")])
    for kind, extent in EXTENTS:
        for shape, input_order in ORDERS:
            cells = found.growth(kind, shape)
            for slower in ("baseline/hash", "baseline/remap"):
                sizes = sorted(size for name, size in cells if name == "halfedge" and (slower, size) in cells)
                if not sizes:
                    continue
                size = crossover(cells, slower, "halfedge")
                smallest = cells[("halfedge", sizes[0])]["triangles"][0]
                verdict = (f"never, up to {count(sizes[-1])}" if size is None else
                           "at every size measured" if size <= smallest else f"from about {count(size)} triangles")
                table.rows.append({"extent": extent, "input": input_order, "against": slower, "from_triangles": size,
                                   "verdict": verdict})
    return table


def crossing_table(found: Measurements) -> Table:
    """What the half-edge back end's whole chain costs for each triangle that the plane crosses."""
    table = Table("per_crossing", [Column("triangles", "triangles", count), Column("crossing", "crossing k", count),
                                   Column("ns_per_crossing", "ns / k", digits(0)),
                                   Column("touched_per_crossing", "touched / k", digits(1)),
                                   Column("nodes_per_crossing", "nodes / k", digits(2)),
                                   Column("bytes_per_crossing", "bytes to upload / k", digits(0))])
    own = {size: c for (name, size), c in found.growth("Scale", "asteroid").items() if name == "halfedge"}
    for _, c in sorted(own.items()):
        k = c["crossing"][0]
        table.rows.append({"triangles": c["triangles"][0], "crossing": k, "ns_per_crossing": c["ns_per_crossing"][0],
                           "touched_per_crossing": c["touched"][0] / k, "nodes_per_crossing": c["nodes"][0] / k,
                           "bytes_per_crossing": c["upload_bytes"][0] / k})
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
                  [Column(f"{name}_ms", name, milliseconds) for name in names] +
                  [Column("upload_bytes", "bytes to upload", count)])
    for (backend, size), c in sorted(cells.items(), key=lambda item: (item[0][1], order(item[0][0]))):
        row: dict[str, Value] = {"backend": backend, "triangles": size, "upload_bytes": c["upload_bytes"][0]}
        row |= {f"{name}_ms": median(c, f"ms_{name}") for name in names}
        table.rows.append(row)
    return table


def prepare_table(found: Measurements) -> Table:
    """Preparing a mesh once, the memory it takes, and after how many cuts the half-edge back end has made up for it."""
    table = Table("prepare", [Column("backend", "back end", short), Column("triangles", "triangles", count),
                              Column("prepare_ms", "prepare ms", milliseconds),
                              Column("ns_per_triangle", "ns / triangle", digits(0)),
                              Column("bytes_per_triangle", "bytes / triangle", digits(0)),
                              Column("cut_ms", "a cut, ms", milliseconds),
                              Column("paid_back_remap", "paid back against remap, cuts", digits(1)),
                              Column("paid_back_hash", "against hash, cuts", digits(1))])
    scale = found.growth("Scale", "asteroid")
    prepared = {(backend, size): c for backend, size, c in found.sized("Prepare")}
    for (backend, size), c in prepared.items():
        row: dict[str, Value] = {"backend": backend, "triangles": size, "prepare_ms": c["real_time"][0],
                                 "ns_per_triangle": c["ns_per_triangle"][0],
                                 "bytes_per_triangle": c["bytes_per_triangle"][0]}
        row["cut_ms"] = median(scale.get((backend, size)), "real_time")
        linear = prepared.get(("baseline/remap", size))  # all lookups prepare alike
        for lookup in ("remap", "hash"):
            cut, other = scale.get((backend, size)), scale.get((f"baseline/{lookup}", size))
            if backend == "halfedge" and linear and cut and other:
                row[f"paid_back_{lookup}"] = fits.cuts_to_pay_back(c["real_time"][0], linear["real_time"][0],
                                                                  cut["real_time"][0], other["real_time"][0])
        table.rows.append(row)
    return table
