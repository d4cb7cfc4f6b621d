"""The worst cut of many."""

from report.chapters.section import Facts, Section, ShownFigure, ShownTable
from report.measurements import Measurements
from report.tables.distribution_tables import distribution_table, viewer_cuts_table, viewer_distribution_table


def write(found: Measurements, machine: dict[str, str], facts: Facts) -> list[Section]:
    many, seen = distribution_table(found), viewer_distribution_table(found)
    parts: list = []
    if many.rows:
        parts += ["A player does not notice the median; a frame is dropped by the worst cut. Planes here have random directions and "
                  "go through random places of the inner half of the asteroid's box; each cut is the whole chain, and the median "
                  "of five runs of the same plane, so that the worst is a plane's, not a neighbour's.",
                  ShownFigure("distribution", "Time of the slowest cuts; the right end is the worst of all."),
                  ShownTable(many, "Quantiles of many cuts, ms.", published=True)]
    if seen.rows:
        parts += [ShownFigure("viewer_cuts", "Every cut of the viewer's runs, from the hit to the last uploaded byte, processor time."),
                  ShownTable(seen, "The viewer's cuts, from the hit to the last uploaded byte, ms of processor time.", published=True),
                  ShownTable(viewer_cuts_table(found), "Every one of them.", folded=True)]
    return [Section("distribution", "The worst cut of many", parts)]
