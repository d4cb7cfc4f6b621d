"""The answer, which opens the page: three sentences and one figure."""

from report.chapters.caps import verdict
from report.chapters.growth import at_largest
from report.chapters.section import Facts, Part, Section, ShownFigure
from report.measurements import Measurements
from report.tables.growth_tables import crossovers_table
from report.tables.numbers import count_short, rounded, timed


def write(found: Measurements, machine: dict[str, str], facts: Facts) -> list[Section]:
    sentences = [large(found, facts), small(found, facts), verdict(found) if found.comparisons else ""]
    parts: list[Part] = [sentence for sentence in sentences if sentence]
    if found.growth("Scale", "asteroid"):
        parts.append(ShownFigure("scaling", "Time of a cut by the size of the mesh, with everything that a game needs "
                                 "of the two pieces. Lower is better.", arguments=("Scale", "asteroid"), wide=True,
                                 published=True))
    return [Section("answer", "", parts)]


def large(found: Measurements, facts: Facts) -> str:
    largest = at_largest(found, "Scale")
    if not largest:
        return ""
    size, ours, theirs = largest
    return (f"At **{facts.say('largest size', size, count_short)} triangles** a cut takes "
            f"**{facts.say('halfedge ms', ours, timed)} ms** with the half-edge back end and "
            f"**{facts.say('remap ms', theirs, timed)} ms** with the best linear method, `remap`.")


def small(found: Measurements, facts: Facts) -> str:
    """From which size on the half-edge back end is the faster one."""
    row = next((row for row in crossovers_table(found).rows if str(row["against"]).endswith("remap")
                and (row["extent"], row["input"]) == ("whole chain", "coherent")), None)
    if row is None:
        return ""
    if row["from_triangles"] is None:
        return "`remap` is the faster one at every size that was measured."
    if not row.get("least"):
        return "The half-edge back end is the faster one at every size of the asteroid that was measured."
    return (f"Meshes of fewer than about **{facts.say('crossover', row['from_triangles'], rounded)} triangles** are "
            "cut faster by `remap`, with everything that a game needs of the pieces.")
