"""How cost grows with the mesh: times, cost by crossing triangle, counters."""

from report import fits
from report.plots.drawing import Drawing
from report.plots.figure import finished, legend_above, log_log, new_figure, series, token
from report.plots.palette import style_of
from report.tables.growth_tables import EXTENTS, ORDERS
from report.tables.numbers import count_short, short
from report.tables.table import Table


def scaling(tables: dict[str, Table], kind: str, shape: str) -> Drawing | None:
    """Time of a cut by the size of the mesh, one line a back end."""
    table = tables.get(f"scaling_{kind.lower()}_{shape}")
    if not table or not table.rows:
        return None
    points = tables["scaling_points"].rows
    what, triangles = (dict(EXTENTS)[kind], dict(ORDERS)[shape])
    figure, axes = new_figure()
    for backend in [str(row["backend"]) for row in table.rows]:
        own = [row for row in points if (row["extent"], row["input"], row["backend"]) == (what, triangles, backend)]
        x, y = [row["triangles"] for row in own], [row["ms"] for row in own]
        series(axes, backend, short(backend), x, y)
        axes.errorbar(x, y, yerr=[[row["ms"] - row["least_ms"] for row in own],
                                  [row["most_ms"] - row["ms"] for row in own]],
                      fmt="none", ecolor=style_of(backend).token, elinewidth=1.0, capsize=2.0)
        fitted = fits.exponent([(n, ms) for n, ms in zip(x, y) if n >= fits.FITTED_FROM])
        if backend in ("halfedge", "baseline/hash") and fitted and fitted.points > 3:
            ends = [fits.FITTED_FROM, x[-1]]
            axes.plot(ends, [fitted.factor * n ** fitted.value for n in ends], color=token("ink"), linewidth=0.9,
                      linestyle=":")
    log_log(axes, "triangles", "ms per cut")
    axes.axhline(1e3 / 60, color=token("muted"), linewidth=1)
    axes.text(0.01, 1e3 / 60, "1/60 s", color=token("muted"), fontsize=9, ha="left", va="bottom",
              transform=axes.get_yaxis_transform())
    legend_above(axes, 3)
    return finished(f"scaling_{kind.lower()}_{shape}", figure)


def crossing(tables: dict[str, Table]) -> Drawing | None:
    """Time by the triangles that the plane crosses."""
    table = tables.get("per_crossing")
    if not table or not table.rows:
        return None
    figure, axes = new_figure()
    x = [row["crossing"] for row in table.rows]
    series(axes, "halfedge", "whole chain", x, [row["ns_per_crossing"] for row in table.rows])
    axes.set_xscale("log")
    axes.set_xticks(x, [count_short(k) for k in x], rotation=35)
    axes.set_ylim(bottom=0)
    axes.set_xlabel("triangles that the plane crosses, k")
    axes.set_ylabel("ns for each of them")
    axes.minorticks_off()
    return finished("crossing", figure)


def counters(tables: dict[str, Table]) -> Drawing | None:
    """Exact counters by the size of the mesh, with the line that would be linear."""
    table = tables.get("counters")
    if not table or not table.rows:
        return None
    figure, axes = new_figure()
    x = [row["triangles"] for row in table.rows]
    looks = {"crossing": ("orange", "s", "triangles crossed"), "touched": ("vermilion", "o", "triangles touched"),
             "nodes": ("green", "^", "tree nodes visited"), "upload_bytes": ("violet", "d", "bytes to upload")}
    for key, (colour, marker, label) in looks.items():
        axes.plot(x, [row[key] for row in table.rows], color=token(colour), marker=marker, label=label)
    axes.plot(x, x, color=token("muted"), linestyle=":", label="all triangles")
    log_log(axes, "triangles", "count in one cut")
    legend_above(axes, 2)
    return finished("counters", figure)
