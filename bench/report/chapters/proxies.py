"""Collision proxies, and what the physics costs with them."""

from report.measurements import Measurements
from report.sections import Facts, Section, ShownFigure, ShownTable
from report.tables import proxies_table, swipes_table


def write(found: Measurements, machine: dict[str, str], facts: Facts) -> list[Section]:
    table, swipes = proxies_table(found), swipes_table(found)
    parts: list = []
    if table.rows:
        parts += ["The report ends by proposing simpler proxies than full convex hulls. Times are for both fragments of a cut, "
                  "medians of the fifteen models; the half-edge back end reads the bounded hull's points off its tree, "
                  "whatever the fragment's size. Volume compares a proxy with the full hull of the same fragment. Physics is "
                  "a frame's simulation (two ticks) of three hundred pieces in flight with that proxy.",
                  ShownFigure("proxies", "What a proxy costs to build, and how well it fits."),
                  ShownTable(table, "Collision proxies.", published=True)]
    if swipes.rows:
        parts += ["A swipe is everything from the hit to the last rigid body: cut, mass properties, bounded hulls, bodies, "
                  "momentum.", ShownTable(swipes, "What the viewer's simulation costs.")]
    return [Section("proxies", "Collision proxies and simulation", parts)]
