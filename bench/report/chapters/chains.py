"""Cuts in a row."""

from report.chapters.section import Facts, Part, Section, ShownFigure, ShownTable
from report.measurements import Measurements
from report.tables.chain_tables import chain_decades_table, chains_table, long_chains_table
from report.tables.numbers import count, count_short, digits, rounded, timed
from report.tables.table import Table


def write(found: Measurements, machine: dict[str, str], facts: Facts) -> list[Section]:
    chains, decades, long = chains_table(found), chain_decades_table(found), long_chains_table(found)
    parts: list[Part] = []
    if decades.rows:
        parts += [ShownFigure("chain_times", "Time of a cut in a chain of a thousand, cut() alone."),
                  ShownFigure("chain_ranges", "Draw ranges a piece, mean of all pieces, after so many cuts."),
                  ranges(decades, facts), smooth(long, facts), compacted(decades, facts), dearer(decades, facts)]
    if chains.rows:
        parts += ["A game cuts pieces of pieces. Here the largest piece is cut through its centre of mass, a hundred "
                  "times. *Worst / predicted* is the cut that costs the most compared with what its crossing "
                  "triangles predict, by a line through all cuts of the chain. Each cut is the median of five chains. "
                  "Times are those of cut() alone, without mass properties and hulls, in which a linear method takes "
                  "longer, and without preparing.",
                  ShownTable(chains, "Chains of a hundred cuts.")]
    if long.rows:
        parts.append(ShownTable(long, "Chains of a thousand cuts: the longest cut, and the one that costs most compared with "
                                "what its crossing triangles predict. Each cut is the median of five chains.", published=True))
    if decades.rows:
        parts.append(ShownTable(decades, "Chains of a thousand cuts: cut times since the mark before, draw ranges at "
                                         "the mark.",
                                folded=True))
    return [Section("chains", "A hundred and a thousand cuts in a row", [part for part in parts if part])]


def rows_by_mark(decades: Table) -> dict[tuple[str, str, float, float], dict]:
    return {(row["backend"], row["mode"], row["triangles"], row["cuts"]): row for row in decades.rows}


def ranges(decades: Table, facts: Facts) -> str:
    """What becomes of draw ranges on the way."""
    size = max(row["triangles"] for row in decades.rows)
    first, last = (rows_by_mark(decades).get(("halfedge", "kept", size, cuts)) for cuts in (1, 1000))
    text = ("Pieces of the half-edge back end share one index buffer. The first cut breaks it into the most runs, two "
            "for each place where the section crosses the buffer's order.")
    if first and last:
        text += (f" At {facts.say('size of the ranges', size, count_short)} triangles a piece has "
                 f"{facts.say('ranges after one cut', first['ranges_per_piece'], digits(0))} after one cut and "
                 f"{facts.say('ranges after a thousand', last['ranges_per_piece'], digits(0))} after a thousand, "
                 "because smaller pieces have shorter sections. All pieces together have ever more.")
    return text


def smooth(long: Table, facts: Facts) -> str:
    """How far a cut of a chain is from what its section predicts."""
    rows = [row for row in long.rows if (row["backend"], row["mode"]) == ("halfedge", "kept")]
    if not rows:
        return ""
    row = max(rows, key=lambda row: row["triangles"])
    text = (f"Of a thousand cuts of {facts.say('size of the long chain', row['triangles'], count_short)} triangles none costs "
            f"more than {facts.say('worst of a thousand to predicted', row['worst_to_predicted'], digits(2))} times what its "
            "crossing triangles predict: what a cut adds to the buffers comes in small pages, and large buffers never move.")
    other = max(rows, key=lambda row: row["worst_to_predicted"])
    if other["worst_to_predicted"] > 2 * row["worst_to_predicted"]:
        text += (f" Those of small meshes do: at {facts.say('size of the worst chain', other['triangles'], count_short)} triangles "
                 f"one cut costs {facts.say('worst to predicted, any size', other['worst_to_predicted'], rounded)} times that, "
                 f"{facts.say('worst, any size, ms', other['worst_cut_ms'], timed)} ms, unless pieces are compacted.")
    return text


def compacted(decades: Table, facts: Facts) -> str:
    """What compacting pieces saves."""
    done = {row["triangles"]: row for row in decades.rows if row["mode"] == "compacted" and row["cuts"] == 1000}
    if not done:
        return ""
    said = ", ".join(f"{facts.say(f'compactions, {n}', row['compactions'], count)} at "
                     f"{facts.say(f'size of compactions, {n}', n, count_short)} triangles "
                     f"({facts.say(f'compacting ms, {n}', row['compact_ms'], rounded)} ms)" for n,
                     row in sorted(done.items()))
    return ("*Compacted* moves a piece into buffers of its own when most of its buffers is dead, off the timed path. "
            "That saves less in ranges than in the cut at which the reserved room is used up and buffers move. "
            f"Compactions within the thousand cuts: {said}. The figures show the largest size at which there were any.")


def dearer(decades: Table, facts: Facts) -> str:
    """That the linear method gets slower again although pieces shrink."""
    size = max(row["triangles"] for row in decades.rows)
    middle, end = (rows_by_mark(decades).get(("baseline/remap", "kept", size, cuts)) for cuts in (100, 1000))
    if not middle or not end or end["mean_cut_ms"] <= middle["mean_cut_ms"]:
        return ""
    return (f"`remap` gets dearer again after a hundred cuts, "
            f"{facts.say('remap ms to the hundredth cut', middle['mean_cut_ms'], timed)} to "
            f"{facts.say('remap ms to the thousandth cut', end['mean_cut_ms'], timed)} ms, although pieces shrink. We "
            "have not found out why.")
