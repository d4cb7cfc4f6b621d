"""Other libraries on the same meshes and planes."""

from statistics import median

from report.chapters.section import Facts, Section, ShownFigure, ShownTable
from report.measurements import Measurements
from report.tables.numbers import digits
from report.tables.peer_tables import peers_by_mesh_table, peers_table
from report.tables.table import Table


def is_library(row: dict) -> bool:
    return str(row["cutter"]).startswith(("cgal", "vtk"))


def write(found: Measurements, machine: dict[str, str], facts: Facts) -> list[Section]:
    table = peers_table(found)
    if not any(is_library(row) for row in table.rows):
        return []
    return [Section("peers", "Other libraries", [
        ShownFigure("peers", "Geometry only, coherent order: time of a cut with both sides. A ring would mark an "
                    "answer that is not right; `cgal_split` makes no caps."),
        "The same asteroids and models, cut by the same planes, in the same run. `cgal_clip` is CGAL's "
        "`Polygon_mesh_processing::clip` with `clip_volume`, once for each side. `cgal_split` is its `split`, which "
        "divides the surface and makes no caps. `vtk_clip_closed_surface` is VTK's `vtkClipClosedSurface`, once for "
        "each side. Libraries carry no normals and uv through the cut, the back ends do. They keep mesh structures of "
        "their own: building those from triangles is not timed, as preparing is not for ours. Slow ones stop at 100 "
        "000 triangles.",
        "Every answer is checked: both sides closed, volumes that add up to the whole's to within a millionth."
        + spread(table, facts),
        ShownTable(peers_by_mesh_table(found), "ms per cut, mean of the planes. Libraries cut each plane "
                                               "once.", folded=True),
        ShownTable(table, "Each library and mesh, with the number of planes that it had time for; least and most: of "
                   "the planes for libraries, of the repetitions for the back ends.", listing=True)])]


def spread(table: Table, facts: Facts) -> str:
    """How far a library's planes lie apart."""
    ratios = [row["most_ms"] / row["least_ms"] for row in table.rows if is_library(row) and row.get("least_ms")]
    if not ratios:
        return ""
    return (" From plane to plane their times differ by a factor of "
            f"{facts.say('most to least ms of the planes, median', median(ratios), digits(1))} (median), at most "
            f"{facts.say('most to least ms of the planes, most', max(ratios), digits(1))}.")
