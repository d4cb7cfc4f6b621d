"""Other libraries beside the back ends."""

from report.plots.drawing import Drawing
from report.plots.figure import finished, legend_above, log_log, new_figure, series, token
from report.tables.numbers import short
from report.tables.peer_tables import problem_of
from report.tables.table import Table


def peers(tables: dict[str, Table]) -> Drawing | None:
    """Time of a cut by the size of the mesh, other libraries beside the back ends."""
    table = tables.get("peers")
    if not table or not table.rows:
        return None
    figure, axes = new_figure()
    for name in dict.fromkeys(str(row["cutter"]) for row in table.rows):
        rows = [row for row in table.rows if row["cutter"] == name and row.get("ms") is not None
                and row["shape"] == "asteroid"]
        series(axes, name, short(name).replace("_", " "), [row["triangles"] for row in rows],
               [row["ms"] for row in rows])
        wrong = [row for row in rows if problem_of(row)]
        axes.plot([row["triangles"] for row in wrong], [row["ms"] for row in wrong], linestyle="none", marker="o",
                  markersize=12, markerfacecolor="none", markeredgecolor=token("wrong"), markeredgewidth=1.2)
    log_log(axes, "triangles", "ms per cut")
    legend_above(axes, 2)
    return finished("peers", figure)
