"""How the times of many cuts are distributed."""

from report.plots.drawing import Drawing
from report.plots.figure import finished, legend_above, log_log, more_ticks, new_figure, series, token
from report.plots.palette import style_of
from report.tables.numbers import count_short, short
from report.tables.table import Table


def distribution(tables: dict[str, Table]) -> Drawing | None:
    """Quantiles of many cuts of one mesh: the line's right end is the worst."""
    table = tables.get("distribution")
    if not table or not table.rows:
        return None
    figure, axes = new_figure()
    size = max(row["triangles"] for row in table.rows)
    for row in table.rows:
        if row["triangles"] != size:
            continue
        shares = [(float(column.key.removeprefix("p").removesuffix("_ms").replace("_", ".")), row[column.key])
                  for column in table.columns if column.key.startswith("p") and row.get(column.key) is not None]
        shares.append((100.0, row["worst_ms"]))
        # The axis stretches towards the worst: a decade for each nine.
        series(axes, str(row["backend"]), short(str(row["backend"])), [max(100.0 - share, 0.05) for share, _ in shares],
               [ms for _, ms in shares], markersize=4)
    log_log(axes, "of all cuts, the slowest …", f"ms per cut, {count_short(size)} triangles")
    more_ticks(axes)
    axes.invert_xaxis()
    axes.set_xticks([50, 10, 1, 0.05], ["half", "10 %", "1 %", "worst"])
    axes.axhline(1e3 / 60, color=token("muted"), linewidth=1)
    axes.text(50, 1e3 / 60, " a frame, 1/60 s", color=token("muted"), fontsize=9, ha="left", va="bottom")
    legend_above(axes)
    return finished("distribution", figure)


def viewer_cuts(tables: dict[str, Table]) -> Drawing | None:
    """Every cut of the viewer: time from the hit to the last byte by the size of what was cut."""
    table = tables.get("viewer_cuts")
    if not table or not table.rows:
        return None
    figure, axes = new_figure()
    for backend in dict.fromkeys(str(row["backend"]) for row in table.rows):
        style = style_of(backend)
        rows = [row for row in table.rows if row["backend"] == backend]
        axes.plot([row["triangles"] for row in rows], [row["to_upload_ms"] for row in rows], linestyle="none",
                  color=style.token, marker=style.marker, markersize=3.5, alpha=0.65, label=short(backend))
    log_log(axes, "triangles of the piece", "ms, from the hit to the last byte")
    axes.axhline(1e3 / 60, color=token("muted"), linewidth=1)
    legend_above(axes)
    return finished("viewer_cuts", figure)
