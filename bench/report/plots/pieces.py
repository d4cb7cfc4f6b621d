"""Chains of cuts, collision proxies, and how the times of many cuts are distributed."""

from report.figures import Drawing, finished, legend_above, log_log, more_ticks, new_figure, token
from report.palette import style_of
from report.plots.growth import series
from report.tables import Table, count_short, short

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
        series(axes, backend, short(backend) + (", compacted" if mode == "compacted" else ""), [row["cuts"] for row in own],
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
        axes.plot([row["build_ms"]], [row["volume_ratio"]], marker=marker, color=token(colour), markersize=9, linestyle="none",
                  label=f"{str(row['kind']).replace('_', ' ')}")
    axes.axhline(1.0, color=token("muted"), linewidth=1, linestyle=":")
    axes.set_xscale("log")
    axes.set_xlabel("ms to build for both fragments, median of the models")
    axes.set_ylabel("volume, full hull = 1")
    axes.minorticks_off()
    legend_above(axes)
    return finished("proxies", figure)


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
