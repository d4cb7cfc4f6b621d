"""Sections of an object that stays whole."""

from report.plots.drawing import Drawing
from report.plots.figure import finished, legend_above, log_log, new_figure, series
from report.tables.numbers import short
from report.tables.table import Table


def sections(tables: dict[str, Table]) -> Drawing | None:
    """Time of one section by the size of the mesh, cuts of copies and other libraries beside it."""
    table, slicers = tables.get("sections"), tables.get("slicers")
    if not table or not table.rows:
        return None
    figure, axes = new_figure()
    lines = [("halfedge", "halfedge", "loops_ms"), ("baseline/remap", "remap", "remap_ms"),
             ("section_by_cut", "cut of a copy", "by_cut_ms")]
    for name, label, key in lines:
        rows = [row for row in table.rows if row.get(key)]
        if rows:
            series(axes, name, label, [row["triangles"] for row in rows], [row[key] for row in rows])
    for name in ("cgal_slicer", "vtk_cutter_loops", "vtk_plane_cutter_loops"):
        rows = [row for row in slicers.rows if row["by"] == name and row["heights"] == 1 and row["mesh"] == "asteroid"] if slicers else []
        if rows:
            series(axes, name, short(name).replace("_", " "), [row["triangles"] for row in rows],
                   [row["ms"] for row in rows])
    log_log(axes, "triangles", "ms per section")
    legend_above(axes, 2)
    return finished("sections", figure)
