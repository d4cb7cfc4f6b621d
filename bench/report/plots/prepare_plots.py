"""Preparing and then cutting."""

from report.plots.drawing import Drawing
from report.plots.figure import finished, legend_above, log_log, new_figure, series, token
from report.plots.palette import style_of
from report.tables.numbers import count_short, short
from report.tables.table import Table


def prepare(tables: dict[str, Table]) -> Drawing | None:
    """Preparing and then cutting: total time by the number of cuts."""
    table = tables.get("prepare")
    rows = [row for row in table.rows if row.get("cut_ms") is not None] if table else []
    if not rows:
        return None
    size = max(row["triangles"] for row in rows if row["backend"] == "halfedge")
    figure, axes = new_figure()
    cuts = [1, 2, 5, 10, 20, 50, 100, 200, 500, 1000]
    prepared = {str(row["backend"]): row for row in rows if row["triangles"] == size}
    for backend, row in prepared.items():
        series(axes, backend, short(backend) + ", copies", cuts, [row["prepare_ms"] + n * row["cut_ms"] for n in cuts],
               markersize=4)
    balance = tables.get("chain_balance")
    chain = [row for row in balance.rows if row["triangles"] >= 0.9 * size] if balance else []
    if chain:
        for backend, row in prepared.items():
            style = style_of(backend)
            axes.plot([mark["cuts"] for mark in chain],
                      [row["prepare_ms"] + mark[f"{short(backend)}_whole_ms"] for mark in chain],
                      color=style.token, marker=style.marker, markersize=4, linestyle="--",
                      markerfacecolor=token("paper"),
                      label=short(backend) + ", one object")
    log_log(axes, "cuts", f"ms with preparing, {count_short(size)} triangles")
    legend_above(axes, 2)
    return finished("prepare", figure)
