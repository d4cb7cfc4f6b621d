"""Cuts in a row."""

from report.chapters.section import Facts, Section, ShownFigure, ShownTable
from report.measurements import Measurements
from report.tables.chain_tables import chain_decades_table, chains_table
from report.tables.numbers import count, count_short, digits, milliseconds, rounded
from report.tables.table import Table


def write(found: Measurements, machine: dict[str, str], facts: Facts) -> list[Section]:
    chains, decades = chains_table(found), chain_decades_table(found)
    parts: list = []
    if chains.rows:
        parts += ["A game cuts pieces of pieces. Here always the largest piece is cut through its centre of mass, a hundred "
                  "times. *Worst / predicted* is the cut that costs the most compared with what its crossing triangles "
                  "predict, by a line through all cuts of the chain; each cut is the median of five chains, so that what is "
                  "left is the cut's own. Times are those of cut() alone, without mass properties and hulls, in which a linear method "
                  "takes longer; a preparing that the half-edge back end needs first is left out (above).",
                  ShownTable(chains, "Chains of a hundred cuts.", published=True)]
    if decades.rows:
        parts += [ranges(decades, facts),
                  ShownFigure("chain_times", "Time of a cut in a chain of a thousand, cut() alone.", published=True),
                  ShownFigure("chain_ranges", "Draw ranges a piece, mean of all pieces, after so many cuts.", published=True),
                  ShownTable(decades, "Chains of a thousand cuts: cut times since the mark before, draw ranges at the mark.",
                             folded=True)]
    return [Section("chains", "A hundred and a thousand cuts in a row", parts)]


def ranges(decades: Table, facts: Facts) -> str:
    """What becomes of draw ranges and times on the way, from the table."""
    size = max(row["triangles"] for row in decades.rows)
    rows = {(row["backend"], row["mode"], row["triangles"], row["cuts"]): row for row in decades.rows}
    first, last = (rows.get(("halfedge", "kept", size, cuts)) for cuts in (1, 1000))
    text = ("Pieces of the half-edge back end share one index buffer. A cut of the whole breaks it into the most runs, two for each place "
            "where the section crosses the buffer's order")
    if first and last:
        text += (f": at {facts.say('size of the ranges', size, count_short)} triangles a piece has "
                 f"{facts.say('ranges after one cut', first['ranges_per_piece'], digits(0))} after one cut and "
                 f"{facts.say('ranges after a thousand', last['ranges_per_piece'], digits(0))} after a thousand, because smaller pieces have "
                 f"shorter sections. All pieces together have ever more")
    text += (". *Compacted* moves a piece into buffers of its own when it asks for that - when most of its buffers is dead - off the timed path. "
             "What that saves is less the ranges than the cut at which the reserved room is used up and buffers move.")
    done = {row["triangles"]: row for row in decades.rows if row["mode"] == "compacted" and row["cuts"] == 1000}
    if done:
        text += " Compactions within the thousand cuts: " + ", ".join(
            f"{facts.say(f'compactions, {n}', row['compactions'], count)} at {facts.say(f'size of compactions, {n}', n, count_short)} triangles "
            f"({facts.say(f'compacting ms, {n}', row['compact_ms'], rounded)} ms)" for n, row in sorted(done.items())) + "."
        text += " The figures show the largest size at which there were any."
    middle, end = (rows.get(("baseline/remap", "kept", size, cuts)) for cuts in (100, 1000))
    if middle and end and end["mean_cut_ms"] > middle["mean_cut_ms"]:
        text += (f" `remap` gets dearer again after a hundred cuts, {facts.say('remap ms to the hundredth cut', middle['mean_cut_ms'], milliseconds)} "
                 f"to {facts.say('remap ms to the thousandth cut', end['mean_cut_ms'], milliseconds)} ms, although pieces shrink. We have not "
                 "found out why.")
    return text
