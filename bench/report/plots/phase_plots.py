"""Where the time of a cut goes."""

from report.plots.drawing import Drawing
from report.plots.figure import finished, new_figure, token
from report.tables.numbers import count_short, short
from report.tables.table import Table

PHASES = {  # phase -> colour and hatch; the hatches tell apart what a colour-blind reader takes for the same
    "find": ("blue", ""), "walk": ("violet", "//"), "split": ("orange", ""), "copy": ("grey", "xx"),
          "cap": ("vermilion", "\\\\"),
    "rebuild": ("green", ""), "components": ("muted", ".."), "pivot": ("ink", ""), "growth": ("ink", "//"),
    "mass": ("sky", "oo"), "proxy": ("yellow", "--"), "draw": ("grid", "++")}
LEAST_NAMED = 0.5  # %: phases that are less than this everywhere are too thin to be seen, and stay out of the legend


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
        rows = [row for row in table.rows if row["triangles"] == size and row["backend"] in wanted
                and row["total_ms"]][::-1]
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
        axes.set_yticks(range(len(rows)), [f"{short(str(row['backend']))}\n{shown_total(row['total_ms'])} "
                                           f"ms\n{row['upload_bytes'] / 1e6:.2g} MB"
                                           for row in rows])
        axes.grid(axis="y", visible=False)
        axes.set_title(f"{count_short(size)} triangles")
    all_axes[-1, 0].set_xlabel("% of the back end's time")
    named = [phase for phase in PHASES if phase in used]
    all_axes[-1, 0].legend([used[phase] for phase in named], named, loc="upper center", bbox_to_anchor=(0.38, -0.36),
                           ncols=4,
                           handlelength=1.6, handleheight=1.1, columnspacing=1.0)
    return finished("phases", figure)


def shown_total(ms: float) -> str:
    return f"{ms:.0f}" if ms >= 100 else f"{ms:.3g}"
