"""The report's fifteen models: its times and ours."""

from report import fits
from report.plots.drawing import Drawing
from report.plots.figure import finished, legend_above, log_log, new_figure, token
from report.plots.palette import style_of
from report.tables.numbers import short
from report.tables.table import Table


def times_by_size(tables: dict[str, Table]) -> Drawing | None:
    """Time of a cut by the model's triangles: the report's laptop and ours."""
    cuts, sizes = tables["table2_cuts"], tables["table1"]
    faces = {row["model"]: row["report_faces"] for row in sizes.rows}
    figure, axes = new_figure(height=4.2)
    for column in [column for column in cuts.columns if column.key.endswith("_ms")]:
        name = "report" if column.key == "report_cut_ms" else column.key.removesuffix("_ms")
        points = [(faces[row["model"]], row[column.key]) for row in cuts.rows if row.get(column.key)]
        if not points:
            continue
        style = style_of(name)
        axes.plot([x for x, _ in points], [y for _, y in points], linestyle="none", color=style.token,
                  marker=style.marker,
                  label="the report" if name == "report" else short(name), alpha=0.95)
    log_log(axes, "faces of the model", "ms per cut")
    legend_above(axes, 2)
    return finished("models", figure)


def report_growth(tables: dict[str, Table]) -> Drawing | None:
    """The report's own times with the line that fits them, and a line that grows linearly."""
    cuts, sizes = tables["table2_cuts"], tables["table1"]
    faces = {row["model"]: row["report_faces"] for row in sizes.rows}
    points = [(faces[row["model"]], row["report_cut_ms"]) for row in cuts.rows]
    fitted = fits.exponent(points)
    if not fitted:
        return None
    figure, axes = new_figure()
    style = style_of("report")
    x = sorted(size for size, _ in points)
    axes.plot([size for size, _ in points], [ms for _, ms in points], linestyle="none", color=style.token,
              marker=style.marker)
    axes.plot(x, [fitted.factor * size ** fitted.value for size in x], color=token("vermilion"),
              label=f"faces to the power of {fitted.value:.2f}")
    start = fitted.factor * x[0] ** fitted.value
    axes.plot(x, [start * size / x[0] for size in x], color=token("muted"), linestyle=":", label="linear")
    for row in cuts.rows:
        if row["model"] in ("car", "cube", "bishop", "horse", "pedestal"):
            axes.annotate(str(row["model"]), (faces[row["model"]], row["report_cut_ms"]), xytext=(6, -9),
                          textcoords="offset points", fontsize=9, color=token("muted"))
    log_log(axes, "faces of the model", "ms per cut, the report's laptop")
    legend_above(axes)
    return finished("report_growth", figure)
