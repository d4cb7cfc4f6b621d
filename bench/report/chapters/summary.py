"""The page in a few sentences."""

import statistics

from report.chapters.caps import verdict
from report.chapters.growth import headline
from report.chapters.models import lookup_factors
from report.chapters.section import Facts, Section, ShownFigure
from report.chapters.unflattering import unflattering
from report.measurements import Measurements
from report.tables.model_tables import cuts_table
from report.tables.numbers import count, digits, percent


def write(found: Measurements, machine: dict[str, str], facts: Facts) -> list[Section]:
    parts: list = []
    if text := headline(found, facts):
        parts.append("**Growth.** " + text)
    rows = [row for row in cuts_table(found).rows if row.get("halfedge_ms") and row.get("baseline/remap_ms")]
    if rows:
        slower = statistics.median(row["halfedge_ms"] / row["baseline/remap_ms"] for row in rows)
        parts.append(f"**Small meshes.** On our imitations of the report's fifteen models a good linear method wins: the half-edge back end "
                     f"takes {facts.say('halfedge to remap, median', slower, digits(1))} times as long (median).")
        if factors := lookup_factors(found, facts):
            parts[-1] += f" What made the report's program slow is not the loop but how it looks up vertices: {factors}."
    if found.comparisons:
        wrong = sum(result["total"]["fans_wrong"] for result in found.comparisons.values())
        cuts = sum(result["total"]["cut"] for result in found.comparisons.values())
        parts.append(f"**Right?** {verdict(found)} The report's fan of triangles closes {facts.say('fans wrong', wrong, count)} of them "
                     f"({facts.say('share', wrong / max(cuts, 1), percent)}) with a cap that covers too much; none of the triangulated "
                     f"caps does." if not any(result["total"]["caps_wrong"] for result in found.comparisons.values()) else
                     f"**Right?** {verdict(found)}")
    if text := unflattering(found, facts):
        parts.append("**Not flattering.** " + text)
    if found.growth("Scale", "asteroid"):
        parts.append(ShownFigure("scaling", "Time of a cut with everything a game needs of it - two closed pieces, mass properties, "
                                 "collision hulls, draw ranges - by the size of the mesh. Lower is better.",
                                 arguments=("Scale", "asteroid", "summary"), wide=True))
    return [Section("summary", "In short", parts)]
