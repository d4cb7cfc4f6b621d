"""Other libraries on the same meshes and planes."""

from report.measurements import Measurements
from report.sections import Facts, Section, ShownFigure, ShownTable
from report.tables import peers_by_mesh_table, peers_table


def write(found: Measurements, machine: dict[str, str], facts: Facts) -> list[Section]:
    table = peers_table(found)
    if not any(str(row["cutter"]).startswith(("cgal", "vtk")) for row in table.rows):
        return []
    return [Section("peers", "Other libraries", [
        "The same asteroids and models, cut by the same planes, in the same run. `cgal_clip` is CGAL's "
        "`Polygon_mesh_processing::clip` with `clip_volume`, once for each side; `cgal_split` its `split`, which divides the "
        "surface and makes no caps; `vtk_clip_closed_surface` is VTK's `vtkClipClosedSurface`, once for each side. They carry "
        "no normals and uv through the cut, the back ends do. Libraries keep their own mesh "
        "structures: building those from triangles is left out of the time, as preparing is for ours. Slow ones stop at "
        "100 000 triangles.",
        "Every answer is checked: both sides closed, volumes that add up to the whole's to within a millionth. A ring in the "
        "plot marks an answer that is not right, and the table says what is the matter.",
        ShownFigure("peers", "Geometry only, coherent order: time of a cut with both sides."),
        ShownTable(peers_by_mesh_table(found), "ms per cut, mean of the planes.", published=True),
        ShownTable(table, "Each library and mesh, with the number of planes that it had time for.", folded=True)])]
