"""Where the half-edge back end is not the better choice, from the numbers."""

from report.chapters.prepare import paid_back_in_chains
from report.chapters.section import Facts, Section
from report.chapters.unflattering import frames, longest, tail
from report.measurements import Measurements
from report.tables.chain_tables import chain_decades_table
from report.tables.growth_tables import crossovers_table
from report.tables.model_tables import cuts_table
from report.tables.numbers import count, count_short, digits, rounded
from report.tables.prepare_tables import chain_balance_table, prepare_table


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
        parts.append(f"Of our fifteen imitations of the report's models `remap` cuts "
                     f"{facts.say('models that remap cuts faster', len(rows) - faster, count)} faster.")
    prepared = {(row["backend"], row["triangles"]): row for row in prepare_table(found).rows}
    size = max((size for backend, size in prepared if backend == "halfedge"), default=None)
    if size is not None and ("baseline/remap", size) in prepared:
        half, linear = prepared[("halfedge", size)], prepared[("baseline/remap", size)]
        held = [(other, row["bytes_per_triangle"]) for (name, other), row in sorted(prepared.items()) if name == "halfedge"]
        listed = ", ".join(f"{facts.say(f'bytes a triangle, {other}', held_bytes, digits(0))} at "
                           f"{facts.say(f'size of the bytes, {other}', other, count_short)}" for other, held_bytes in held)
        parts.append(f"**Memory.** It holds more bytes a triangle: {listed} triangles, "
                     f"where the linear methods hold {facts.say('linear bytes', linear['bytes_per_triangle'], digits(0))}: "
                     f"half-edges, the tree, and room for cuts to come, which weighs the more the smaller the mesh is.")
        parts.append(f"**Preparing.** {facts.say('prepare ms', half['prepare_ms'], rounded)} ms for "
                     f"{facts.say('prepared size', size, count_short)} triangles, once; the linear methods need "
                     f"{facts.say('linear prepare ms', linear['prepare_ms'], rounded)} ms. {paid_back(half, found, facts)} "
                     f"What is deformed between cuts must be prepared anew.")
    if text := worst(found, facts):
        parts.append(f"**The worst cut and the worst frame.** {text}")
    if parts:
        parts += ["**Draw calls.** A piece is drawn in many runs of a shared buffer until it is compacted, the most after the first "
                  "cuts of a large mesh" + most_ranges(found, facts) + "; a linear method's pieces are drawn in one run for each material, and one for the cap.",
                  "**Flat faces in the plane's direction.** A plane parallel to a large flat face that is not aligned with the axes "
                  "meets the boxes of all its leaves: finding the section is then linear in that face, with a small factor.",
                  "**Connected pieces.** Asked for connected pieces, it searches the smaller parts of a side; where one part is bounded "
                  "by several curves - half of a torus - the search reaches far. `docs/halfedge.md` lists what else is linear.",
                  "**Licence.** Its caps use CGAL's triangulation, which is under the GPL."]
    return [Section("limits", "Where the half-edge back end is not the better choice", parts)]


def paid_back(half: dict, found: Measurements, facts: Facts) -> str:
    """How many cuts it takes, of copies and of one object."""
    said = []
    if half.get("paid_back_remap"):
        said.append(f"Copies of one object, each cut once, pay that back after {facts.say('cuts of copies', half['paid_back_remap'], digits(0))} "
                    f"cuts.")
    balance = chain_balance_table(found)
    if balance.rows:
        said.append("One object that is cut to pieces does so late. " + paid_back_in_chains(balance, facts))
    return " ".join(said) or "Few cuts do not pay that back."


def most_ranges(found: Measurements, facts: Facts) -> str:
    rows = [row for row in chain_decades_table(found).rows if row["backend"] == "halfedge" and row["mode"] == "kept"]
    if not rows:
        return ""
    size = max(row["triangles"] for row in rows)
    return (f" ({facts.say('most draw ranges', max(row['most_ranges'] for row in rows if row['triangles'] == size), count)} "
            f"of {facts.say('size of the most draw ranges', size, count_short)} triangles)")


def worst(found: Measurements, facts: Facts) -> str:
    return " ".join(part for part in (frames(found, facts), tail(found, facts), longest(found, facts)) if part)


def words(row: dict, facts: Facts) -> str:
    if row["from_triangles"] is None:
        return "nowhere that was measured"
    name = f"crossover, {row['extent']}"
    text = f"from about {facts.say(name, row['from_triangles'], rounded)} triangles on"
    if row.get("least") and row.get("most"):
        text += (f" ({facts.say(f'{name}, least', row['least'], rounded)} to {facts.say(f'{name}, most', row['most'], rounded)} by the "
                 "spread of the times)")
    return text
