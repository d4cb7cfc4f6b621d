"""How cost grows with the mesh: times, cost by crossing triangle, counters, phases, preparing, peers."""

from report.figures import Drawing, finished, legend_above, log_log, new_figure, token
from report.palette import style_of
from report.tables import Table, count_short, short

PHASES = {  # phase -> colour and hatch; the hatches keep neighbours apart without colour
    "find": ("blue", ""), "walk": ("violet", "//"), "split": ("orange", ""), "copy": ("grey", "xx"), "cap": ("vermilion", ""),
    "rebuild": ("green", ""), "components": ("muted", ".."), "pivot": ("ink", ""), "growth": ("ink", "//"),
    "mass": ("purple", ""), "proxy": ("accent", "\\\\"), "draw": ("grid", "")}


def series(axes, name: str, label: str, x: list[float], y: list[float], **more) -> None:
    style = style_of(name)
    axes.plot(x, y, color=style.token, marker=style.marker, linestyle=style.dashes, label=label, **more)


def scaling(tables: dict[str, Table], kind: str, shape: str, suffix: str = "") -> Drawing | None:
    """Time of a cut by the size of the mesh, one line a back end."""
    table = tables.get(f"scaling_{kind.lower()}_{shape}")
    if not table or not table.rows:
        return None
    sizes = [int(column.key.removeprefix("ms_")) for column in table.columns if column.key.startswith("ms_")]
    figure, axes = new_figure()
    for row in table.rows:
        points = [(size, row[f"ms_{size}"]) for size in sizes if row.get(f"ms_{size}") is not None]
        exponent = f", e = {row['exponent']:.2f}" if row.get("exponent") is not None else ""
        series(axes, str(row["backend"]), short(str(row["backend"])) + exponent, [x for x, _ in points], [y for _, y in points])
    log_log(axes, "triangles", "ms per cut")
    axes.axhline(1e3 / 60, color=token("muted"), linewidth=1)
    axes.text(sizes[0], 1e3 / 60, "a frame, 1/60 s ", color=token("muted"), fontsize=8.5, ha="left", va="bottom")
    legend_above(axes, 2)
    return finished(f"scaling_{kind.lower()}_{shape}{'_' if suffix else ''}{suffix}", figure)


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


def phases(tables: dict[str, Table]) -> Drawing | None:
    """Where the time of a cut goes, one stacked bar a back end, for the largest mesh that they share."""
    table = tables.get("phases")
    if not table or not table.rows:
        return None
    wanted = ("baseline/hash", "baseline/remap", "halfedge")
    sizes = sorted({row["triangles"] for row in table.rows if row["backend"] == "halfedge"})
    chosen = [size for size in sizes if size in (10_000, 100_000, 1_000_000)][-2:]
    if not chosen:
        return None
    figure, all_axes = new_figure(height=2.1 * len(chosen) + 0.9, rows=len(chosen), squeeze=False)
    used: dict[str, object] = {}
    for axes, size in zip(all_axes[:, 0], chosen):
        rows = [row for row in table.rows if row["triangles"] == size and row["backend"] in wanted][::-1]
        for place, row in enumerate(rows):
            left = 0.0
            for phase, (colour, hatch) in PHASES.items():
                value = row.get(f"{phase}_ms") or 0.0
                if value > 0.0:
                    bar = axes.barh(place, value, left=left, color=token(colour), hatch=hatch, edgecolor=token("paper"),
                                    linewidth=0.6, height=0.62)
                    used.setdefault(phase, bar)
                    left += value
            axes.text(left, place, f"  {left:.3g} ms", va="center", fontsize=9)
        widest = max(sum(row.get(f"{phase}_ms") or 0.0 for phase in PHASES) for row in rows)
        axes.set_xlim(0, 1.22 * widest)
        axes.set_yticks(range(len(rows)), [short(str(row["backend"])) for row in rows])
        axes.grid(axis="y", visible=False)
        axes.set_title(f"{count_short(size)} triangles")
    all_axes[-1, 0].set_xlabel("ms, wall clock")
    all_axes[-1, 0].legend(list(used.values()), list(used), loc="upper center", bbox_to_anchor=(0.42, -0.32), ncols=4,
                           handlelength=1.4)
    return finished("phases", figure)


def prepare(tables: dict[str, Table]) -> Drawing | None:
    """Preparing and then cutting: total time by the number of cuts."""
    table = tables.get("prepare")
    rows = [row for row in table.rows if row.get("cut_ms") is not None] if table else []
    if not rows:
        return None
    size = max(row["triangles"] for row in rows if row["backend"] == "halfedge")
    figure, axes = new_figure()
    cuts = [1, 2, 5, 10, 20, 50, 100, 200, 500, 1000]
    for row in rows:
        if row["triangles"] == size:
            series(axes, str(row["backend"]), short(str(row["backend"])), cuts,
                   [row["prepare_ms"] + n * row["cut_ms"] for n in cuts], markersize=4)
    log_log(axes, "cuts", "ms, preparing included")
    axes.set_ylabel(f"ms, preparing included, {count_short(size)} triangles")
    legend_above(axes)
    return finished("prepare", figure)


def peers(tables: dict[str, Table]) -> Drawing | None:
    """Time of a cut by the size of the mesh, other libraries beside the back ends."""
    table = tables.get("peers")
    if not table or not table.rows:
        return None
    figure, axes = new_figure()
    for name in dict.fromkeys(str(row["cutter"]) for row in table.rows):
        rows = [row for row in table.rows if row["cutter"] == name and row.get("ms") is not None and row["shape"] == "asteroid"]
        series(axes, name, short(name).replace("_", " "), [row["triangles"] for row in rows], [row["ms"] for row in rows])
        wrong = [row for row in rows if row["verdict"] != "right"]
        axes.plot([row["triangles"] for row in wrong], [row["ms"] for row in wrong], linestyle="none", marker="o",
                  markersize=12, markerfacecolor="none", markeredgecolor=token("wrong"), markeredgewidth=1.2)
    log_log(axes, "triangles", "ms per cut")
    legend_above(axes, 2)
    return finished("peers", figure)
