"""Objects broken into many pieces at once."""

from report.chapters.section import Facts, Part, Section, ShownTable
from report.measurements import Measurements
from report.tables.fracture_tables import cells_table, fracture_exponents, fractures_table
from report.tables.numbers import count_short, digits, rounded


def write(found: Measurements, machine: dict[str, str], facts: Facts) -> list[Section]:
    table, cells = fractures_table(found), cells_table(found)
    if not table.rows:
        return []
    parts: list[Part] = [
        "`kerf::fracture()` breaks a closed object into the cells of points anywhere in it. The times are of a prepared object "
        "to pieces that are prepared in turn; preparing the whole stands beside it. The linear back end's pieces take no "
        "preparing. `docs/fracture.md` says how it is done.",
        largest(table.rows, facts), growth(found, facts),
        ShownTable(table, "Broken into the cells of 10, 100 and 1 000 points; one thread.", published=True)]
    if cells.rows:
        parts += [by_others(cells.rows, facts),
                  ShownTable(cells, "A copy for each cell, clipped by the planes half way to other points, the nearest first, "
                             "with CGAL's `clip` and `clip_volume`; as many cells as there was time for.", published=True)]
    return [Section("fracture", "Breaking into many pieces", [part for part in parts if part])]


def largest(rows: list[dict], facts: Facts) -> str:
    row = next((r for r in reversed(rows) if r["mesh"] == "asteroid" and r["cells"] == 100 and r.get("halfedge_ms")), None)
    if row is None:
        return ""
    return (f"An asteroid of {facts.say('triangles of the broken asteroid', row['triangles'], count_short)} triangles is in "
            f"{facts.say('pieces of the broken asteroid', row['pieces'], count_short)} pieces after "
            f"{facts.say('ms to break the asteroid', row['halfedge_ms'], rounded)} ms.")


def growth(found: Measurements, facts: Facts) -> str:
    exponents = fracture_exponents(found)
    if len(exponents) < 2:
        return ""
    return (f"Time grows with the number of cells as its power of "
            f"{facts.say('exponent of the cells', exponents['cells'], digits(2))} at the largest mesh, not in proportion: the "
            "area of the contacts grows as its cube root, and most triangles lie in one cell. With the triangles it grows as "
            f"their power of {facts.say('exponent of the triangles', exponents['triangles'], digits(2))}.")


def by_others(rows: list[dict], facts: Facts) -> str:
    known = [row for row in rows if row.get("to_halfedge")]
    if not known:
        return ""
    least, most = (pick(row["to_halfedge"] for row in known) for pick in (min, max))
    return (f"CGAL takes {facts.say('cells by CGAL, least', least, rounded)} to {facts.say('cells by CGAL, most', most, rounded)} "
            "times as long for a cell, by planes and exact predicates, and its cells have contacts of their own.")
