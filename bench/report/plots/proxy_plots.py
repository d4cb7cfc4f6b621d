"""Collision proxies."""

from report.plots.drawing import Drawing
from report.plots.figure import finished, legend_above, new_figure, token
from report.tables.table import Table


def proxies(tables: dict[str, Table]) -> Drawing | None:
    """What each collision proxy costs to build, and how much more or less than the full hull it fills."""
    table = tables.get("proxies")
    rows = [row for row in table.rows if row.get("volume_ratio")] if table else []
    if not rows:
        return None
    figure, axes = new_figure()
    looks = {"every_vertex": ("grey", "x"), "full_hull": ("blue", "s"), "bounded_hull": ("vermilion", "o"),
             "box": ("orange", "^"), "sphere": ("green", "P")}
    for row in rows:
        colour, marker = looks[str(row["kind"])]
        axes.plot([row["build_ms"]], [row["volume_ratio"]], marker=marker, color=token(colour), markersize=9,
                  linestyle="none",
                  label=f"{str(row['kind']).replace('_', ' ')}")
    axes.axhline(1.0, color=token("muted"), linewidth=1, linestyle=":")
    axes.set_xscale("log")
    axes.set_xlabel("ms to build for both fragments, median of the models")
    axes.set_ylabel("volume, full hull = 1")
    axes.minorticks_off()
    legend_above(axes)
    return finished("proxies", figure)
