"""The report's fifteen models: its Tables 1 and 2, ours beside them."""

from report import fits
from report.measurements import Measurements, order
from report.names import ASTEROID
from report.tables.core import Column, Table, Value, count, digits, median, milliseconds, short
from run_bench import PROXIES, report_rows


def timed_backends(found: Measurements) -> list[str]:
    return sorted({name.split("/", 1)[1].rsplit("/", 1)[0] for name in found.bench if name.startswith("Cut/")}, key=order)


def sizes_table(found: Measurements) -> Table:
    """Table 1: what the report says of its models, and what the models of this project have."""
    table = Table("table1", [Column("model", "model"), Column("report_faces", "faces, report", count),
                             Column("faces", "faces, ours", count), Column("report_vertices", "vertices, report", count),
                             Column("vertices", "vertices, ours", count)])
    for row in report_rows():
        ours = next((counters for backend in timed_backends(found)
                     if (counters := found.of_model("Cut", backend, row["model"]))), None)
        faces, vertices = median(ours, "triangles"), median(ours, "vertices")
        table.rows.append({"model": row["model"], "report_faces": int(row["faces"]), "faces": faces,
                           "report_vertices": int(row["vertices"]), "vertices": vertices})
    return table


def cuts_table(found: Measurements) -> Table:
    """Table 2, cutting: the report's time and ours for each vertex lookup and the half-edge back end."""
    backends = timed_backends(found)
    table = Table("table2_cuts", [Column("model", "model"), Column("report_cut_ms", "report", milliseconds)] +
                  [Column(f"{backend}_ms", short(backend), milliseconds) for backend in backends])
    for row in report_rows():
        cells: dict[str, Value] = {"model": row["model"], "report_cut_ms": float(row["cut_ms"])}
        for backend in backends:
            cells[f"{backend}_ms"] = median(found.of_model("Cut", backend, row["model"]), "cut_ms")
        table.rows.append(cells)
    return table


def hulls_table(found: Measurements) -> Table:
    """Table 2, convex hulls: the report's time and ours for each collision proxy, both fragments together."""
    table = Table("table2_hulls", [Column("model", "model"), Column("report_hull_ms", "report", milliseconds)] +
                  [Column(f"{kind}_ms", kind.replace("_", " "), milliseconds) for kind in PROXIES] +
                  [Column("full_hull_points", "points, full hull", digits(0)),
                   Column("bounded_hull_points", "points, bounded", digits(0))])
    for row in report_rows():
        proxies = {kind: found.of_model("Proxy", kind, row["model"]) for kind in PROXIES}
        cells: dict[str, Value] = {"model": row["model"], "report_hull_ms": float(row["hull_ms"])}
        cells |= {f"{kind}_ms": median(counters, "proxy_ms") for kind, counters in proxies.items()}
        cells |= {f"{kind}_points": median(proxies[kind], "points") for kind in ("full_hull", "bounded_hull")}
        table.rows.append(cells)
    return table


def frames_table(found: Measurements) -> Table:
    """Table 2, frames per second: the report's peaks and drops, and the viewer's frames while it cuts."""
    backends = found.viewer_backends()
    columns = [Column("model", "model"), Column("report_fps", "fps, report", lambda text: text.replace("-", "–"))]
    for backend in backends:
        columns += [Column(f"{backend}_cuts", f"cuts, {short(backend)}"),
                    Column(f"{backend}_simulate_least_ms", "simulate, least ms", milliseconds),
                    Column(f"{backend}_simulate_most_ms", "most ms", milliseconds),
                    Column(f"{backend}_fps_median", "fps, median", digits(0)),
                    Column(f"{backend}_fps_least", "fps, least", digits(0))]
    table = Table("table2_frames", columns)
    for model, fps in [(row["model"], row["fps"]) for row in report_rows()] + [(ASTEROID, None)]:
        cells: dict[str, Value] = {"model": model, "report_fps": fps}
        for backend in backends:
            if run := found.run_of(model, backend):
                frame, simulate = run.times["frame_ms"], run.times["simulate_cpu_ms"]
                cells |= {f"{backend}_cuts": len(run.cuts), f"{backend}_simulate_least_ms": simulate["min"],
                          f"{backend}_simulate_most_ms": simulate["max"], f"{backend}_fps_median": 1e3 / frame["median"],
                          f"{backend}_fps_least": 1e3 / frame["max"]}
        if len(cells) > 2 or fps:
            table.rows.append(cells)
    return table


def model_exponents_table(found: Measurements) -> Table:
    """How times grow over the fifteen models, the report's and ours: exponents of the number of faces."""
    table = Table("model_exponents", [Column("times", "times", short), Column("exponent", "exponent", digits(2)),
                                      Column("half_width", "± (95 %)", digits(2)), Column("models", "models")])
    faces = {row["model"]: int(row["faces"]) for row in report_rows()}
    cuts, hulls = cuts_table(found), hulls_table(found)
    wanted = [("the report's cut", cuts, "report_cut_ms"), ("the report's hull", hulls, "report_hull_ms")]
    wanted += [(backend, cuts, f"{backend}_ms") for backend in timed_backends(found)]
    for name, source, key in wanted:
        fitted = fits.exponent([(faces[row["model"]], row.get(key) or 0.0) for row in source.rows])
        if fitted:
            table.rows.append({"times": name, "exponent": fitted.value, "half_width": fitted.half_width, "models": fitted.points})
    return table
