"""Caps: by how much fans are wrong, the worst of them drawn beside the right caps, and how thin triangles are."""

import statistics

from matplotlib.collections import PolyCollection

from report.plots.drawing import Drawing
from report.plots.figure import finished, legend_above, new_figure, token
from report.tables.numbers import percent
from report.tables.table import Table


def fan_errors(tables: dict[str, Table], mix: str) -> Drawing | None:
    """For each model, the fan's error in every cut: one dot a plane."""
    rows = [row for row in tables["caps_by_plane"].rows if row["planes"] == mix]
    if not rows:
        return None
    models = list(dict.fromkeys(str(row["model"]) for row in rows))
    figure, axes = new_figure(height=4.4)
    for place, model in enumerate(models):
        own = sorted(max(row["fan_error"], 0.0) for row in rows if row["model"] == model)
        # Dots of one model are spread over its row in an order that depends on nothing but their number.
        heights = [place + 0.62 * ((number * 0.618034) % 1.0 - 0.5) for number in range(len(own))]
        axes.scatter([100 * error for error in own], heights, s=9, color=token("vermilion"), alpha=0.55, linewidths=0)
        axes.plot([100 * statistics.median(own)] * 2, [place - 0.36, place + 0.36], color=token("ink"), linewidth=2)
    axes.set_yticks(range(len(models)), models)
    axes.invert_yaxis()
    axes.set_xscale("symlog", linthresh=1.0)
    axes.set_xlim(left=-0.1)
    axes.set_xticks([0, 1, 10, 100, 1000], ["0", "1 %", "10 %", "100 %", "1000 %"])
    axes.minorticks_off()
    axes.set_xlabel("area that the fan covers too much, of the section's")
    return finished(f"fan_errors_{mix}", figure)


def bounds_of(loops: list[list[list[float]]]) -> tuple[float, float, float, float]:
    xs = [x for loop in loops for x, _ in loop]
    ys = [y for loop in loops for _, y in loop]
    return min(xs), max(xs), min(ys), max(ys)


def gallery(tables: dict[str, Table], drawn: list[dict]) -> Drawing | None:
    """Two drawings a row: the fan with the triangles that are turned over marked, and the triangulation."""
    if not drawn:
        return None
    figure, all_axes = new_figure(height=2.0 * len(drawn), rows=len(drawn), columns=2, squeeze=False)
    for axes_of_row, row in zip(all_axes, drawn):
        loops = row["caps"]["loops"]
        lo_x, hi_x, lo_y, hi_y = bounds_of(loops)
        margin = 0.06 * max(hi_x - lo_x, hi_y - lo_y)
        for axes, name in zip(axes_of_row, ("baseline", "halfedge")):
            cap = row["caps"][name]
            triangles = [[cap["points"][corner] for corner in triangle] for triangle in cap["triangles"]]
            forward = [t for t in triangles if signed_area(t) >= 0.0]
            backward = [t for t in triangles if signed_area(t) < 0.0]
            axes.add_collection(PolyCollection(forward, facecolors=token("right"), edgecolors=token("paper"),
                                               linewidths=0.35,
                                               alpha=0.55))
            axes.add_collection(PolyCollection(backward, facecolors=token("wrong"), edgecolors=token("paper"),
                                               linewidths=0.35,
                                               alpha=0.72))
            for loop in loops:
                closed = loop + loop[:1]
                axes.plot([x for x, _ in closed], [y for _, y in closed], color=token("ink"), linewidth=1.2)
            axes.set_xlim(lo_x - margin, hi_x + margin)
            axes.set_ylim(lo_y - margin, hi_y + margin)
            axes.set_aspect("equal")
            axes.axis("off")
        error = percent(row["baseline"]["cap_excess"] / row["covered_area"])
        axes_of_row[0].set_title(f"{row['model']}: fan, {error} too much", fontsize=9)
        axes_of_row[1].set_title("triangulation", fontsize=9)
    return finished("gallery", figure)


def signed_area(t: list[list[float]]) -> float:
    (ax, ay), (bx, by), (cx, cy) = t
    return 0.5 * ((bx - ax) * (cy - ay) - (cx - ax) * (by - ay))


def angles(tables: dict[str, Table]) -> Drawing | None:
    """Share of caps whose smallest angle is below what the axis says, both back ends."""
    table = tables.get("caps_by_plane")
    rows = [row for row in table.rows if row.get("fan_least_angle") is not None] if table else []
    if not rows:
        return None
    figure, axes = new_figure()
    for key, label, colour, dashes in (("fan_least_angle", "fan", "blue", "--"),
                                       ("triangulation_least_angle", "triangulation", "vermilion", "-")):
        values = sorted(max(row[key], 1e-4) for row in rows)
        axes.plot(values, [(number + 1) / len(values) * 100 for number in range(len(values))], color=token(colour),
                  linestyle=dashes, label=label, drawstyle="steps-post")
    axes.set_xscale("log")
    axes.set_xlabel("smallest angle of a cap, degrees")
    axes.set_ylabel("% of caps at most so")
    axes.set_ylim(0, 100)
    axes.minorticks_off()
    legend_above(axes)
    return finished("angles", figure)
