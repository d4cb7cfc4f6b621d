"""The report's fifteen models: its Tables 1 and 2, ours beside them."""

from typing import Sequence

from report import fits
from report.measurements import Measurements, order
from report.names import ASTEROID, PROXIES
from report.repetitions import Counters, median, worst_spread
from report.student_report import report_rows
from report.tables.numbers import count, digits, percent, quoted, short, timed
from report.tables.table import Column, Table, Value


def timed_backends(found: Measurements) -> list[str]:
    return sorted({name.split("/", 1)[1].rsplit("/", 1)[0] for name in found.bench if name.startswith("Cut/")},
                  key=order)


def sizes_table(found: Measurements) -> Table:
    """Table 1: what the report says of its models, and what the models of this project have."""
    table = Table("table1", [Column("model", "model"), Column("report_faces", "faces, report", count),
                             Column("faces", "faces, ours", count),
                             Column("report_vertices", "vertices, report", count),
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
    table = Table("table2_cuts", [Column("model", "model"), Column("report_cut_ms", "report", quoted)] +
                  [Column(f"{backend}_ms", short(backend), timed) for backend in reversed(backends)] +
                  [Column("spread", "worst spread", percent), Column("planes", "planes", digits(0)),
                   Column("repetitions", "repetitions", digits(0))])
    for row in report_rows():
        cells: dict[str, Value] = {"model": row["model"], "report_cut_ms": float(row["cut_ms"])}
        for backend in backends:
            cells[f"{backend}_ms"] = median(found.of_model("Cut", backend, row["model"]), "cut_ms")
        table.rows.append(cells | how_sure([found.of_model("Cut", backend, row["model"]) for backend in backends],
                                           "cut_ms"))
    return table


def how_sure(cells: Sequence[Counters | None], counter: str) -> dict[str, Value]:
    """The worst spread of a row's benchmarks, the planes of each, and how often each was repeated."""
    there = [c for c in cells if c]
    return {"spread": worst_spread((c, counter) for c in there),
            "planes": min((c["cuts_each"][0] for c in there if "cuts_each" in c), default=None),
            "repetitions": min((c["repetitions"][0] for c in there if "repetitions" in c), default=None)}


def hulls_table(found: Measurements) -> Table:
    """Table 2, convex hulls: the report's time and ours for each collision proxy, both fragments together."""
    table = Table("table2_hulls", [Column("model", "model"), Column("report_hull_ms", "report", quoted)] +
                  [Column(f"{kind}_ms", kind.replace("_", " "), timed) for kind in PROXIES] +
                  [Column("halfedge_bounded_hull_ms", "bounded hull, halfedge", timed)] +
                  [Column("full_hull_points", "points, full hull", digits(0)),
                   Column("bounded_hull_points", "points, bounded", digits(0)),
                   Column("spread", "worst spread", percent),
                   Column("planes", "planes", digits(0)), Column("repetitions", "repetitions", digits(0))])
    for row in report_rows():
        proxies = {kind: found.of_model("Proxy", kind, row["model"]) for kind in PROXIES}
        cells: dict[str, Value] = {"model": row["model"], "report_hull_ms": float(row["hull_ms"])}
        cells |= {f"{kind}_ms": median(counters, "proxy_ms") for kind, counters in proxies.items()}
        cells |= {f"{kind}_points": median(proxies[kind], "points") for kind in ("full_hull", "bounded_hull")}
        cells["halfedge_bounded_hull_ms"] = median(found.of_model("Proxy", "halfedge/bounded_hull", row["model"]),
                                                   "proxy_ms")
        table.rows.append(cells | how_sure(list(proxies.values()), "proxy_ms"))
    return table


def frames_table(found: Measurements) -> Table:
    """Table 2, frames per second: the report's peaks and drops, and the viewer's frames while it cuts; a row for each
    model and back end."""
    table = Table("table2_frames", [Column("model", "model"), Column("backend", "back end", short),
                                    Column("report_fps", "fps, report", lambda text: text.replace("-", "–")),
                                    Column("fps_median", "fps, median", digits(0)),
                                    Column("fps_least", "fps, least", digits(0)),
                                    Column("simulate_median_ms", "simulate, median ms", timed),
                                    Column("simulate_most_ms", "simulate, most ms", timed),
                                    Column("cuts", "cuts")])
    for model, fps in [(row["model"], row["fps"]) for row in report_rows()] + [(ASTEROID, None)]:
        for backend in reversed(found.viewer_backends()):
            if run := found.run_of(model, backend):
                frame, simulate = run.times["frame_ms"], run.times["simulate_cpu_ms"]
                table.rows.append({"model": model, "backend": backend, "report_fps": fps, "cuts": len(run.cuts),
                                   "fps_median": 1e3 / frame["median"], "fps_least": 1e3 / frame["max"],
                                   "simulate_median_ms": simulate["median"], "simulate_most_ms": simulate["max"]})
    return table


def worst_frames_table(found: Measurements) -> Table:
    """The frame that simulates and cuts the longest, of every model, one column a back end, and one more for each that
    was run without drawing."""
    backends = list(reversed(found.viewer_backends()))
    undrawn = sorted({run.backend for run in found.undrawn_runs}, key=order, reverse=True)
    table = Table("worst_frames", [Column("model", "model")] +
                  [Column(f"{backend}_undrawn_ms", f"{short(backend)}, not drawn", timed) for backend in undrawn] +
                  [Column(f"{backend}_ms", short(backend), timed) for backend in backends])
    for model in [row["model"] for row in report_rows()] + [ASTEROID]:
        runs = {backend: found.run_of(model, backend) for backend in backends}
        without = {backend: found.undrawn_run_of(model, backend) for backend in undrawn}
        if any(runs.values()) or any(without.values()):
            table.rows.append({"model": model} |
                              {f"{backend}_undrawn_ms": run.times["simulate_cpu_ms"]["max"]
                               for backend, run in without.items() if run} |
                              {f"{backend}_ms": run.times["simulate_cpu_ms"]["max"]
                               for backend, run in runs.items() if run})
    return table


def left_out(rows: list[tuple[str, int, float]]) -> dict[str, Value]:
    """The least and the greatest exponent that leaving out one of the models gives, and which that is."""
    ranked = sorted(((fitted, model) for fitted, (model, _, _) in
                     zip(fits.without_each([(faces, ms) for _, faces, ms in rows]), rows) if fitted),
                    key=lambda pair: pair[0].value)
    if not ranked:
        return {}
    (least, without_least), (most, without_most) = ranked[0], ranked[-1]
    return {"least": least.value, "least_half_width": least.half_width, "least_without": without_least,
            "most": most.value,
            "most_half_width": most.half_width, "most_without": without_most}


def model_exponents_table(found: Measurements) -> Table:
    """How times grow over the fifteen models, the report's and ours: exponents of the number of faces."""
    table = Table("model_exponents", [Column("times", "times", short), Column("exponent", "exponent", digits(2)),
                                      Column("half_width", "± (95 %)", digits(2)),
                                      Column("least", "least, one model left out", digits(2)),
                                      Column("least_half_width", "± (95 %)", digits(2)),
                                      Column("least_without", "without"),
                                      Column("most", "greatest, one left out", digits(2)),
                                      Column("most_half_width", "± (95 %)", digits(2)),
                                      Column("most_without", "without"),
                                      Column("models", "models")])
    faces = {row["model"]: int(row["faces"]) for row in report_rows()}
    cuts, hulls = cuts_table(found), hulls_table(found)
    wanted = [("the report's cut", cuts, "report_cut_ms"), ("the report's hull", hulls, "report_hull_ms")]
    wanted += [(backend, cuts, f"{backend}_ms") for backend in timed_backends(found)]
    for name, source, key in wanted:
        fitted = fits.exponent([(faces[row["model"]], row.get(key) or 0.0) for row in source.rows])
        if fitted:
            table.rows.append({"times": name, "exponent": fitted.value, "half_width": fitted.half_width,
                               "models": fitted.points} |
                              left_out([(str(row["model"]), faces[row["model"]], row.get(key) or 0.0)
                                        for row in source.rows]))
    return table
