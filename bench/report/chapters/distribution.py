"""The worst cut of many."""

from report.chapters.section import Facts, Part, Section, ShownFigure, ShownTable
from report.measurements import Measurements
from report.tables.distribution_tables import distribution_table, viewer_cuts_table, viewer_distribution_table


def write(found: Measurements, machine: dict[str, str], facts: Facts) -> list[Section]:
    many, seen = distribution_table(found), viewer_distribution_table(found)
    parts: list[Part] = []
    if many.rows:
        parts.append(ShownFigure("distribution", "Time of the slowest cuts; the right end is the worst of all."))
    if seen.rows:
        parts.append(ShownFigure("viewer_cuts", "Every cut of the viewer's runs, from the hit to the last uploaded "
                                 "byte, processor time."))
    if many.rows:
        parts += ["A player does not notice the median: the worst cut drops a frame. Planes here have random "
                  "directions and go through random places of the inner half of the asteroid's box. Each cut is the "
                  "whole chain, and the median of five runs of the same plane: the worst is a plane's, not a "
                  "neighbour's.",
                  ShownTable(many, "Quantiles of many cuts, ms.", folded=True)]
    if seen.rows:
        parts += [ShownTable(seen, "The viewer's cuts, from the hit to the last uploaded byte, ms of processor time.",
                             folded=True),
                  ShownTable(viewer_cuts_table(found), "Every one of them.", listing=True)]
    return [Section("distribution", "The worst cut of many", parts)]
