"""Sections of what stays whole: planes, stacks, and other libraries."""

from report.chapters.section import Facts, Part, Section, ShownFigure, ShownTable
from report.fits import exponent
from report.measurements import Measurements
from report.tables.numbers import count_short, digits, rounded, timed
from report.tables.section_tables import real_sections_table, sections_table, slicers_table, stacks_table
from report.tables.table import Table


def write(found: Measurements, machine: dict[str, str], facts: Facts) -> list[Section]:
    table, stacks, slicers = sections_table(found), stacks_table(found), slicers_table(found)
    if not table.rows:
        return []
    parts: list[Part] = [
        ShownFigure("sections", "One section in ordered, closed loops. What has only segments in no order says so in the "
                    "table.", published=True),
        "`section()` asks what a plane meets, and the object stays whole. It reads the tree that a cut reads, and its "
        "loops are those of a cut, bit for bit.",
        one_section(table, facts), growth(table, facts), of_stacks(stacks, facts), of_libraries(slicers, facts),
        ShownTable(table, "One section: ms, mean of five seeded planes through the middle; preparing, once, in a column "
                   "of its own. The last three: means of twenty planes, which may be anywhere.", published=True)]
    if stacks.rows:
        parts.append(ShownTable(stacks, "Stacks: ms for all heights, loops in order, nesting and areas among it. `remap` "
                                "sweeps over all triangles once.",
                                published=True))
    real = real_sections_table(found)
    if real.rows:
        parts.append(ShownTable(real, "One section of meshes that are not round: ms, with nesting.", published=True))
    if slicers.rows:
        parts.append(ShownTable(
            slicers, "The same planes by other libraries, on one thread. `cgal_slicer` is CGAL's `Polygon_mesh_slicer` with its "
            "tree, `vtk_cutter` VTK's `vtkCutter`, whose segments `vtk_cutter_loops` joins by `vtkStripper`; "
            "`vtk_plane_cutter` is `vtkPlaneCutter` with its sphere tree; `vtk_plane_cutter_loops` merges the points that its "
            "segments do not share, and joins them. `open3d_slice` is Open3D's `slice_plane()`. Lengths and loops are checked. Preparing is what is made before the first section; of heights it is the same.",
            published=True))
    return [Section("sections", "Looking inside without cutting", [part for part in parts if part])]


def one_section(table: Table, facts: Facts) -> str:
    row = table.rows[-1]
    if not row.get("to_cut"):
        return ""
    text = (f"At {facts.say('size', row['triangles'], count_short)} triangles a section takes "
            f"{facts.say('section ms', row['loops_ms'], timed)} ms, and a cut of a copy "
            f"{facts.say('cut / section', row['to_cut'], rounded)} times as long.")
    if row.get("through_vertices_ms") and row.get("along_edges_ms") and row.get("in_faces_ms"):
        text += (f" By planes through three vertices it is {facts.say('vertices ms', row['through_vertices_ms'], timed)} "
                 f"ms, along an edge {facts.say('edges ms', row['along_edges_ms'], timed)}, in a face "
                 f"{facts.say('faces ms', row['in_faces_ms'], timed)}.")
    return text


def growth(table: Table, facts: Facts) -> str:
    rows = [row for row in table.rows if row["triangles"] >= 90_000]
    if len(rows) < 2:
        return ""
    exponents = {}
    for key in ("touched", "nodes", "loops_ms"):
        found = exponent([(row["triangles"], row[key]) for row in rows])
        if found is None:
            return ""
        exponents[key] = found.value
    return (f"From 100 k triangles on, triangles touched grow with the power "
            f"{facts.say('exponent, touched', exponents['touched'], digits(2))} of the mesh, nodes of the tree with "
            f"{facts.say('exponent, nodes', exponents['nodes'], digits(2))}, time with "
            f"{facts.say('exponent, time', exponents['loops_ms'], digits(2))}.")


def of_stacks(stacks: Table, facts: Facts) -> str:
    rows = [row for row in stacks.rows if row["shape"] == "asteroid" and row.get("threads_ms")]
    if not rows:
        return ""
    row = rows[-1]
    return (f"A stack of {facts.say('heights', row['heights'], count_short)} sections of "
            f"{facts.say('stack size', row['triangles'], count_short)} triangles takes "
            f"{facts.say('stack ms', row['halfedge_ms'], timed)} ms on one thread, and "
            f"{facts.say('stack ms, two threads', row['threads_ms'], timed)} ms on two.")


def of_libraries(slicers: Table, facts: Facts) -> str:
    rows = [row for row in slicers.rows if row["mesh"] == "asteroid" and row["heights"] == 1 and row["to_halfedge"]
            and str(row["by"]).startswith(("cgal", "vtk", "open3d"))]
    if not rows:
        return ""
    size = max(row["triangles"] for row in rows)
    told = [f"`{row['by']}` {facts.say(str(row['by']) + ' to halfedge', row['to_halfedge'], rounded)}"
            for row in rows if row["triangles"] == size]
    return (f"Other libraries take, at {facts.say('size of libraries', size, count_short)} triangles, times the half-edge "
            f"back end's: {', '.join(told)}.")
