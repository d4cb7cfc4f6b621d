"""Where the half-edge back end is not the better choice, from the numbers."""

from report.chapters.prepare import paid_back_in_chains
from report.chapters.section import Facts, Part, Section
from report.chapters.unflattering import frames, longest, tail
from report.measurements import Measurements
from report.tables.chain_tables import chain_decades_table
from report.tables.growth_tables import crossovers_table
from report.tables.model_tables import cuts_table
from report.tables.numbers import count, count_short, digits, rounded, timed
from report.tables.real_tables import model_chains_table, real_chains_table, real_cuts_table
from report.tables.prepare_tables import chain_balance_table, prepare_table


def write(found: Measurements, machine: dict[str, str], facts: Facts) -> list[Section]:
    """What weighs most comes first: the README has the first few."""
    measured = [small_meshes(found, facts), models(found, facts), long_sections(found, facts), memory(found, facts), preparing(found, facts),
                worst(found, facts)]
    parts: list[Part] = [text for text in measured if text]
    if parts:
        parts += [draw_calls(found, facts),
                  "**Flat faces in the plane's direction.** A plane parallel to a large flat face that is not aligned "
                  "with the axes meets the boxes of all its leaves. Finding the section is then linear in that face, "
                  "with a small factor.",
                  "**Connected pieces.** Splitting a side into connected pieces searches all but its largest part; on "
                  "half a torus that is half the mesh. `docs/halfedge.md` lists what else is linear.",
                  "**Licence.** What closes sections that cross or run along themselves is CGAL's triangulation, which is "
                  "under the GPL. A build without it closes them, too, but says that such a cap may be too large."]
    return [Section("limits", "Where the half-edge back end is not the better choice", parts)]


def small_meshes(found: Measurements, facts: Facts) -> str:
    crossing = {(row["extent"], row["input"]): row for row in crossovers_table(found).rows
                if str(row["against"]).endswith("remap")}
    whole, geometry = crossing.get(("whole chain", "coherent")), crossing.get(("geometry only", "coherent"))
    if not whole or not geometry:
        return ""
    return (f"**Small meshes.** Against `remap` in coherent order it is faster {words(whole, facts)} for the whole "
            f"chain, and {words(geometry, facts)} for the geometry alone.")


def words(row: dict, facts: Facts) -> str:
    if row["from_triangles"] is None:
        return "nowhere that was measured"
    name = f"crossover, {row['extent']}"
    text = f"from about {facts.say(name, row['from_triangles'], rounded)} triangles on"
    if row.get("least") and row.get("most"):
        text += (f" ({facts.say(f'{name}, least', row['least'], rounded)} to "
                 f"{facts.say(f'{name}, most', row['most'], rounded)} by the spread of the times)")
    return text


def models(found: Measurements, facts: Facts) -> str:
    rows = [row for row in cuts_table(found).rows if row.get("halfedge_ms") and row.get("baseline/remap_ms")]
    if not rows:
        return ""
    slower = sum(row["halfedge_ms"] >= row["baseline/remap_ms"] for row in rows)
    text = (f"**The report's models.** `remap` cuts {facts.say('models that remap cuts faster', slower, count)} of our "
            f"{facts.say('models', len(rows), count)} imitations faster, if nothing but the pieces' triangles is wanted")
    chains = [row for row in model_chains_table(found).rows if row.get("halfedge_ms") and row.get("baseline/remap_ms")]
    if chains:
        slower = sum(row["halfedge_ms"] >= row["baseline/remap_ms"] for row in chains)
        text += (f", and {facts.say('models that remap cuts faster, whole chain', slower, count)} with everything that a "
                 "game needs")
    return text + "."


def long_sections(found: Measurements, facts: Facts) -> str:
    """Meshes that are not round, of which a linear method with right caps is the faster one."""
    said, by_fans = [], []
    for rows, extent in ((real_cuts_table(found).rows, "cut()"), (real_chains_table(found).rows, "the whole chain")):
        fans = [row["mesh"] for row in rows if row.get("halfedge_ms") and row.get("baseline/remap_ms") and
                row["baseline/remap_ms"] < row["halfedge_ms"]]
        if fans:
            by_fans.append(f"{extent} of {', '.join(fans)}")
        for row in rows:
            ours, linear = row.get("halfedge_ms"), row.get("linear_ms")
            if ours and linear and linear < ours:
                mesh = row["mesh"]
                said.append(f"{mesh}, {extent}: {facts.say(f'{mesh}, {extent}, halfedge ms', ours, timed)} against "
                            f"{facts.say(f'{mesh}, {extent}, linear ms', linear, timed)} ms")
    if not said and not by_fans:
        return ""
    text = "**Sections of a large part of the mesh.** Where a plane crosses much of the mesh there is little to leave alone"
    if said:
        text += f", and `linear` is faster: {'; '.join(said)}"
    if by_fans:
        text += f". `remap` is faster in {'; '.join(by_fans)}, by fans that do not fit such sections"
    return text + "."


def memory(found: Measurements, facts: Facts) -> str:
    rows = prepare_table(found).rows
    held = sorted((row["triangles"], row["bytes_per_triangle"]) for row in rows if row["backend"] == "halfedge")
    linear = [row["bytes_per_triangle"] for row in rows if row["backend"] == "baseline/remap"]
    if not held or not linear:
        return ""
    listed = ", ".join(f"{facts.say(f'bytes a triangle, {size}', held_bytes, digits(0))} at "
                       f"{facts.say(f'size of the bytes, {size}', size, count_short)}" for size, held_bytes in held)
    return (f"**Memory.** It holds more bytes a triangle: {listed} triangles. The linear methods hold "
            f"{facts.say('linear bytes', linear[-1], digits(0))}. The difference is half-edges, the tree, and room "
            "for cuts to come.")


def preparing(found: Measurements, facts: Facts) -> str:
    prepared = {(row["backend"], row["triangles"]): row for row in prepare_table(found).rows}
    size = max((size for backend, size in prepared if backend == "halfedge" and ("baseline/remap", size) in prepared),
               default=None)
    if size is None:
        return ""
    half, linear = prepared[("halfedge", size)], prepared[("baseline/remap", size)]
    return (f"**Preparing.** It takes {facts.say('prepare ms', half['prepare_ms'], rounded)} ms for "
            f"{facts.say('prepared size', size, count_short)} triangles, once; the linear methods need "
            f"{facts.say('linear prepare ms', linear['prepare_ms'], rounded)} ms. {paid_back(half, found, facts)} "
            "What is deformed between cuts must be prepared anew.")


def paid_back(half: dict, found: Measurements, facts: Facts) -> str:
    """How many cuts it takes, of copies and of one object."""
    said = []
    if half.get("paid_back_remap"):
        said.append("Copies of one object, each cut once, pay that back after "
                    f"{facts.say('cuts of copies', half['paid_back_remap'], rounded)} cuts.")
    balance = chain_balance_table(found)
    if balance.rows:
        said.append("One object that is cut to pieces does so late. " + paid_back_in_chains(balance, facts))
    return " ".join(said) or "Few cuts do not pay that back."


def worst(found: Measurements, facts: Facts) -> str:
    said = " ".join(part for part in (frames(found, facts), tail(found, facts), longest(found, facts)) if part)
    return said and f"**The worst cut and the worst frame.** {said}"


def draw_calls(found: Measurements, facts: Facts) -> str:
    return (f"**Draw calls.** A piece is drawn in many runs of a shared buffer until it is compacted, the most after "
            f"the first cuts of a large mesh{most_ranges(found, facts)}. A linear method's pieces are drawn in one "
            "run for each material, and one for the cap.")


def most_ranges(found: Measurements, facts: Facts) -> str:
    rows = [row for row in chain_decades_table(found).rows if row["backend"] == "halfedge" and row["mode"] == "kept"]
    if not rows:
        return ""
    size = max(row["triangles"] for row in rows)
    most = max(row["most_ranges"] for row in rows if row["triangles"] == size)
    return (f" ({facts.say('most draw ranges', most, count)} of "
            f"{facts.say('size of the most draw ranges', size, count_short)} triangles)")
