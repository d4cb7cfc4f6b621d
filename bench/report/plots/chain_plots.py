"""Chains of cuts: times and draw ranges."""

from report.plots.drawing import Drawing
from report.plots.figure import finished, legend_above, log_log, more_ticks, new_figure, series, token
from report.tables.numbers import count_short, short
from report.tables.table import Table


def chain_rows(tables: dict[str, Table], size: float) -> list[dict]:
    table = tables.get("chain_decades")
    return [row for row in table.rows if row["triangles"] == size] if table else []


def shown_chain(tables: dict[str, Table]) -> float | None:
    """The largest size at which anything was compacted, so that what that does can be seen; else the largest."""
    table = tables.get("chain_decades")
    if not table or not table.rows:
        return None
    compacted = [row["triangles"] for row in table.rows if row["compactions"]]
    return max(compacted or [row["triangles"] for row in table.rows])


def chain_plot(tables: dict[str, Table], key: str, y_label: str, name: str) -> Drawing | None:
    size = shown_chain(tables)
    if size is None:
        return None
    rows = chain_rows(tables, size)
    figure, axes = new_figure()
    for backend, mode in dict.fromkeys((str(row["backend"]), str(row["mode"])) for row in rows):
        own = [row for row in rows if row["backend"] == backend and row["mode"] == mode]
        more = {"markerfacecolor": token("paper")} if mode == "compacted" else {}
        series(axes, backend, short(backend) + (", compacted" if mode == "compacted" else ""),
               [row["cuts"] for row in own],
               [row[key] for row in own], **more)
    log_log(axes, f"cuts so far, {count_short(size)} triangles", y_label)
    more_ticks(axes)
    legend_above(axes, 2)
    return finished(name, figure)


def chain_ranges(tables: dict[str, Table]) -> Drawing | None:
    """Draw ranges of all pieces by the number of cuts."""
    return chain_plot(tables, "ranges_per_piece", "draw ranges a piece", "chain_ranges")


def chain_times(tables: dict[str, Table]) -> Drawing | None:
    """Mean time of a cut by how far the chain has come."""
    return chain_plot(tables, "mean_cut_ms", "ms per cut since the point before", "chain_times")
