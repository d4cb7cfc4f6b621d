"""Where the half-edge back end is not the better choice, from the numbers."""

from report.measurements import Measurements
from report.sections import Facts, Section
from report.tables import count, crossovers_table, cuts_table, digits, milliseconds, prepare_table


def write(found: Measurements, machine: dict[str, str], facts: Facts) -> list[Section]:
    parts: list = []
    crossing = {(row["extent"], row["input"]): row for row in crossovers_table(found).rows
                if str(row["against"]).endswith("remap")}
    whole, geometry = crossing.get(("whole chain", "coherent")), crossing.get(("geometry only", "coherent"))
    if whole and geometry:
        parts.append(f"**Small meshes.** Against `remap` in coherent order it is faster {words(whole, facts)} for the whole chain, "
                     f"and {words(geometry, facts)} for the geometry alone. The report's models are all smaller than that.")
    rows = [row for row in cuts_table(found).rows if row.get("halfedge_ms") and row.get("baseline/remap_ms")]
    if rows:
        faster = sum(row["halfedge_ms"] < row["baseline/remap_ms"] for row in rows)
        parts.append(f"Of the report's fifteen models `remap` cuts {facts.say('models that remap cuts faster', len(rows) - faster, count)} "
                     f"faster.")
    prepared = {(row["backend"], row["triangles"]): row for row in prepare_table(found).rows}
    size = max((size for backend, size in prepared if backend == "halfedge"), default=None)
    if size is not None and ("baseline/remap", size) in prepared:
        half, linear = prepared[("halfedge", size)], prepared[("baseline/remap", size)]
        parts.append(f"**Memory.** It holds {facts.say('bytes a triangle', half['bytes_per_triangle'], digits(0))} bytes a triangle "
                     f"where the linear methods hold {facts.say('linear bytes', linear['bytes_per_triangle'], digits(0))}: "
                     f"half-edges, the tree, and room for cuts to come.")
        parts.append(f"**Preparing.** {facts.say('prepare ms', half['prepare_ms'], milliseconds)} ms for "
                     f"{facts.say('prepared size', size, count)} triangles, once; the linear methods need "
                     f"{facts.say('linear prepare ms', linear['prepare_ms'], milliseconds)} ms. What is cut once or twice does "
                     f"not pay that back, and what is deformed between cuts must be prepared anew.")
    if parts:
        parts += ["**Draw calls.** A piece that was cut often is drawn in many runs of a shared buffer until it is compacted; "
                  "a linear method's pieces are drawn in one run for each material, and one for the cap.",
                  "**Flat faces in the plane's direction.** A plane parallel to a large flat face that is not aligned with the axes "
                  "meets the boxes of all its leaves: finding the section is then linear in that face, with a small factor.",
                  "**Connected pieces.** Asked for connected pieces, it searches the smaller parts of a side; where one part is bounded "
                  "by several curves - half of a torus - the search reaches far. `docs/halfedge.md` lists what else is linear.",
                  "**Licence.** Its caps use CGAL's triangulation, which is under the GPL."]
    return [Section("limits", "Where the half-edge back end is not the better choice", parts)]


def words(row: dict, facts: Facts) -> str:
    if row["from_triangles"] is None:
        return "nowhere that was measured"
    name = f"crossover, {row['extent']}"
    return f"from {facts.say(name, row['from_triangles'], count)} triangles on"
