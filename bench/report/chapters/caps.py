"""Whether the back ends agree, and whether caps are right."""

from report.chapters.section import Facts, Part, Section, ShownFigure, ShownTable
from report.measurements import Measurements
from report.tables.cap_tables import cap_rows_table, caps_table, gallery_table, least_angles_table
from report.tables.numbers import count, percent
from report.tables.table import Table

FLAT = 1e-3  # degrees
MIXES = {"random": "random planes through the middle", "nasty": "planes through vertices, edges and faces too"}


def write(found: Measurements, machine: dict[str, str], facts: Facts) -> list[Section]:
    if not found.comparisons:
        return []
    by_plane = cap_rows_table(found)
    parts: list[Part] = pictures(found)
    parts += [ShownFigure("fan_errors", f"Error of the fan in each cut, {planes}: a dot a plane, a bar at the median.",
                          arguments=(mix,)) for mix, planes in MIXES.items() if mix in found.comparisons]
    parts += [verdict(found) + " `kerf compare` judges both by code that shares nothing with them: surfaces triangle "
              "by triangle, open edges, volumes by direct integration, caps by area.",
              fans(found, facts)]
    parts += [ShownTable(caps_table(found, mix), f"Caps, {planes}.", published=True, folded=True)
              for mix, planes in MIXES.items() if mix in found.comparisons]
    if found.drawn_caps:
        parts.append(ShownTable(gallery_table(found),
                                "The caps that are drawn. *More than once*: area that two or more "
                                "triangles cover, as a share of the section.", folded=True))
    parts += angles(found, by_plane, facts)
    parts.append(ShownTable(by_plane, "Every cut that was judged.", listing=True))
    return [Section("caps", "Are the results right?", parts)]


def pictures(found: Measurements) -> list[Part]:
    if not found.drawn_caps:
        return []
    return [ShownFigure("gallery", "The worst fans, one a model, beside the caps of the half-edge back end. Blue "
                        "triangles face the right way. Orange ones are turned over: what is under them is covered "
                        "twice, or lies outside of the outline (the dark "
                        "line).", arguments=(found.drawn_caps,), wide=True,
                        published=True)]


def fans(found: Measurements, facts: Facts) -> str:
    wrong = sum(result["total"]["fans_wrong"] for result in found.comparisons.values())
    cuts = sum(result["total"]["cut"] for result in found.comparisons.values())
    bad = sum(result["total"]["caps_wrong"] for result in found.comparisons.values())
    text = ("The report closes a cut with a fan of triangles over the section's mean point, and says that this is "
            f"accurate with convex sections only. Of {facts.say('cuts', cuts, count)} cuts of its own models "
            f"{facts.say('fans wrong', wrong, count)} ({facts.say('share', wrong / max(cuts, 1), percent)}) get a fan "
            "that covers too much: triangles reach over the outline, turn over, and overlap. The half-edge back end "
            "triangulates the outline, holes and islands included. ")
    text += f"Of its caps {facts.say('caps wrong', bad, count)} are WRONG." if bad else "None of its caps is wrong."
    return text + " An error is the sum of the areas of a cap's triangles, less the section's area, as a share of it."


def angles(found: Measurements, by_plane: Table, facts: Facts) -> list[Part]:
    table = least_angles_table(found)
    if not table.rows:
        return []
    rows = [row for row in by_plane.rows if row.get("triangulation_least_angle") is not None]
    cap, fan = (sum(row[key] < FLAT for row in rows) / len(rows)
                for key in ("triangulation_least_angle", "fan_least_angle"))
    return [ShownFigure("angles", "Smallest angle of each cap: the share of all caps whose smallest angle is at most "
                                  "this."),
            "Thin triangles shade badly, and here the triangulation is the worse one: "
            f"{facts.say('triangulations with a flat triangle', cap, percent)} of its caps have a triangle with an "
            f"angle below a thousandth of a degree, of the fans "
            f"{facts.say('fans with a flat triangle', fan, percent)}. It uses the "
            "outline's points and no others, many of which lie on straight lines; the fan adds a point in the middle.",
            ShownTable(table, "Smallest angle of a cap in degrees: medians over the cuts.", folded=True)]


def verdict(found: Measurements) -> str:
    """One sentence on whether the back ends agree."""
    if not found.comparisons:
        return "The comparison was not run."
    cuts = sum(result["total"]["cut"] for result in found.comparisons.values())
    failed = sum(result["total"]["failed"] + sum(len(file["failures"]) for file in result["files"])
                 for result in found.comparisons.values())
    differ = sum(result["total"]["surfaces_differ"] for result in found.comparisons.values())
    if failed == 0 and differ == 0:
        return f"In all {count(cuts)} compared cuts both back ends give the same surface, bit for bit."
    return f"THE BACK ENDS DO NOT AGREE: of {count(cuts)} cuts, {differ} surfaces differ and {failed} checks failed."
