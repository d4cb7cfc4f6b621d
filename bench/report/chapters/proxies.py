"""Collision proxies, and what the physics costs with them."""

from report.chapters.section import Facts, Section, ShownFigure, ShownTable
from report.measurements import Measurements
from report.tables.numbers import count
from report.tables.proxy_tables import proxies_table, swipes_table
from report.tables.table import Table


def write(found: Measurements, machine: dict[str, str], facts: Facts) -> list[Section]:
    table, swipes = proxies_table(found), swipes_table(found)
    parts: list = []
    if table.rows:
        parts += ["The report ends by proposing simpler proxies than full convex hulls. Times are for both fragments of a cut, "
                  "medians of the fifteen models, by a loop over the fragment's vertices; *of halfedge*: the half-edge "
                  "back end's hulls, whose points it reads off its tree - which on models of a thousand triangles saves little, and "
                  "does not grow with the mesh. Volume compares a proxy with the full hull of the same fragment. Physics is "
                  "a frame's simulation (two ticks) of three hundred pieces in flight with that proxy. " + pairs(table, facts) + "Piece counts differ a little, because what a swipe meets depends on the proxy.",
                  ShownFigure("proxies", "What a proxy costs to build, and how well it fits."),
                  ShownTable(table, "Collision proxies.", published=True)]
    if swipes.rows:
        parts += [ShownTable(swipes, "What the viewer's simulation costs. A swipe is everything from the hit to the last rigid body: cut, mass "
                             "properties, bounded hulls, bodies, momentum.")]
    return [Section("proxies", "Collision proxies and simulation", parts)]


def pairs(table: Table, facts: Facts) -> str:
    """Why simple shapes may cost the physics more than hulls."""
    rows = {row["kind"]: row for row in table.rows if row.get("touching_pairs") is not None}
    if not all(kind in rows for kind in ("bounded_hull", "box", "sphere")) or rows["box"]["frame_ms"] <= rows["bounded_hull"]["frame_ms"]:
        return ""
    said = {kind: facts.say(f"touching pairs, {kind}", rows[kind]["touching_pairs"], count) for kind in ("bounded_hull", "box", "sphere")}
    return (f"Boxes and spheres are the simplest to test, but reach further than the pieces do: {said['box']} and {said['sphere']} pairs "
            f"touch, {said['bounded_hull']} of bounded hulls, and a frame with them takes longer. ")
