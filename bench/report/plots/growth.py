"""How cost grows with the mesh: times, cost by crossing triangle, counters, phases, preparing, peers."""

from report import fits
from report.figures import Drawing, finished, legend_above, log_log, new_figure, token
from report.palette import style_of
from report.tables import EXTENTS, ORDERS, Table, count_short, problem_of, short

PHASES = {  # phase -> colour and hatch; the hatches tell apart what a colour-blind reader takes for the same
    "find": ("blue", ""), "walk": ("violet", "//"), "split": ("orange", ""), "copy": ("grey", "xx"), "cap": ("vermilion", "\\\\"),
    "rebuild": ("green", ""), "components": ("muted", ".."), "pivot": ("ink", ""), "growth": ("ink", "//"),
    "mass": ("sky", "oo"), "proxy": ("yellow", "--"), "draw": ("grid", "++")}


LEAST_NAMED = 0.5  # %: phases that are less than this everywhere are too thin to be seen, and stay out of the legend


def series(axes, name: str, label: str, x: list[float], y: list[float], **more) -> None:
    style = style_of(name)
    axes.plot(x, y, color=style.token, marker=style.marker, linestyle=style.dashes, label=label, **more)


def scaling(tables: dict[str, Table], kind: str, shape: str, suffix: str = "") -> Drawing | None:
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
        axes.errorbar(x, y, yerr=[[row["ms"] - row["least_ms"] for row in own], [row["most_ms"] - row["ms"] for row in own]],
                      fmt="none", ecolor=style_of(backend).token, elinewidth=1.0, capsize=2.0)
        fitted = fits.exponent([(n, ms) for n, ms in zip(x, y) if n >= fits.FITTED_FROM])
        if backend in ("halfedge", "baseline/hash") and fitted and fitted.points > 3:
            ends = [fits.FITTED_FROM, x[-1]]
            axes.plot(ends, [fitted.factor * n ** fitted.value for n in ends], color=token("ink"), linewidth=0.9, linestyle=":")
    log_log(axes, "triangles", "ms per cut")
    axes.axhline(1e3 / 60, color=token("muted"), linewidth=1)
    axes.text(0.01, 1e3 / 60, "1/60 s", color=token("muted"), fontsize=9, ha="left", va="bottom",
              transform=axes.get_yaxis_transform())
    legend_above(axes, 3)
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
    figure, all_axes = new_figure(height=2.0 * len(chosen) + 1.2, rows=len(chosen), squeeze=False)
    used: dict[str, object] = {}
    for axes, size in zip(all_axes[:, 0], chosen):
        rows = [row for row in table.rows if row["triangles"] == size and row["backend"] in wanted and row["total_ms"]][::-1]
        for place, row in enumerate(rows):
            left = 0.0
            for phase, (colour, hatch) in PHASES.items():
                share = 100.0 * (row.get(f"{phase}_ms") or 0.0) / row["total_ms"]
                if share > 0.0:
                    bar = axes.barh(place, share, left=left, color=token(colour), hatch=hatch, edgecolor=token("paper"),
                                    linewidth=0.6, height=0.62)
                    if share > LEAST_NAMED:
                        used.setdefault(phase, bar)
                    left += share
        axes.set_xlim(0, 100)
        axes.set_yticks(range(len(rows)), [f"{short(str(row['backend']))}\n{shown_total(row['total_ms'])} ms\n{row['upload_bytes'] / 1e6:.2g} MB"
                                           for row in rows])
        axes.grid(axis="y", visible=False)
        axes.set_title(f"{count_short(size)} triangles")
    all_axes[-1, 0].set_xlabel("% of the back end's time")
    named = [phase for phase in PHASES if phase in used]
    all_axes[-1, 0].legend([used[phase] for phase in named], named, loc="upper center", bbox_to_anchor=(0.38, -0.36), ncols=4,
                           handlelength=1.6, handleheight=1.1, columnspacing=1.0)
    return finished("phases", figure)


def shown_total(ms: float) -> str:
    return f"{ms:.0f}" if ms >= 100 else f"{ms:.3g}"


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
        series(axes, backend, short(backend) + ", copies", cuts, [row["prepare_ms"] + n * row["cut_ms"] for n in cuts], markersize=4)
    balance = tables.get("chain_balance")
    chain = [row for row in balance.rows if row["triangles"] >= 0.9 * size] if balance else []
    if chain:
        for backend, row in prepared.items():
            style = style_of(backend)
            axes.plot([mark["cuts"] for mark in chain], [row["prepare_ms"] + mark[f"{short(backend)}_whole_ms"] for mark in chain],
                      color=style.token, marker=style.marker, markersize=4, linestyle="--", markerfacecolor=token("paper"),
                      label=short(backend) + ", one object")
    log_log(axes, "cuts", f"ms with preparing, {count_short(size)} triangles")
    legend_above(axes, 2)
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
        wrong = [row for row in rows if problem_of(row)]
        axes.plot([row["triangles"] for row in wrong], [row["ms"] for row in wrong], linestyle="none", marker="o",
                  markersize=12, markerfacecolor="none", markeredgecolor=token("wrong"), markeredgewidth=1.2)
    log_log(axes, "triangles", "ms per cut")
    legend_above(axes, 2)
    return finished("peers", figure)
