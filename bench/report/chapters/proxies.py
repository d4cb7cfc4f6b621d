"""Collision proxies, and what the physics costs with them."""

from report.chapters.section import Facts, Part, Section, ShownFigure, ShownTable
from report.measurements import Measurements
from report.tables.numbers import count
from report.tables.proxy_tables import proxies_table, swipes_table
from report.tables.table import Table


def write(found: Measurements, machine: dict[str, str], facts: Facts) -> list[Section]:
    table, swipes = proxies_table(found), swipes_table(found)
    parts: list[Part] = []
    if table.rows:
        parts += [ShownFigure("proxies", "What a proxy costs to build, and how well it fits."),
                  "The report ends by proposing simpler proxies than full convex hulls. Times are for both fragments "
                  "of a cut, medians of the fifteen models, by a loop over the fragment's vertices. *Of halfedge*: "
                  "its points are read off the half-edge back end's tree, which saves little on models of a thousand "
                  "triangles and does not grow with the mesh. Volume compares a proxy with the full hull of the same "
                  "fragment.",
                  "Physics is a frame's simulation (two ticks) of three hundred pieces in flight with that proxy. "
                  + pairs(table, facts) + "Piece counts differ a little: what a swipe meets depends on the proxy.",
                  ShownTable(table, "Collision proxies.")]
    if swipes.rows:
        parts.append(ShownTable(swipes, "What the viewer's simulation costs. A swipe is everything from the hit to "
                                "the last rigid body: cut, mass properties, bounded hulls, bodies, momentum."))
    return [Section("proxies", "Collision proxies and simulation", parts)]


def pairs(table: Table, facts: Facts) -> str:
    """Why simple shapes may cost the physics more than hulls."""
    kinds = ("bounded_hull", "box", "sphere")
    rows = {row["kind"]: row for row in table.rows if row.get("touching_pairs") is not None}
    if not all(kind in rows for kind in kinds) or rows["box"]["frame_ms"] <= rows["bounded_hull"]["frame_ms"]:
        return ""
    said = {kind: facts.say(f"touching pairs, {kind}", rows[kind]["touching_pairs"], count) for kind in kinds}
    return (f"Boxes and spheres are the simplest to test, but reach further than the pieces do: {said['box']} and "
            f"{said['sphere']} pairs touch, {said['bounded_hull']} of bounded hulls, and a frame with them takes "
            "longer. ")
